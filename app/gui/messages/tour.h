// SPDX-License-Identifier: MIT
#pragma once

#include "docks/panels.h"
#include "document/document.h"
#include "messages/message_banner.h"

#include <QPointer>

#include <array>

class QPushButton;

// Six short steps in the window itself, then three about what lies behind them: a banner with one sentence
// says what to do, a frame is around the place to do it, and the next step comes when it is done. Nothing is
// locked meanwhile. Deletes itself when closed; a bar that the tour opened is then as before.
class Tour : public MessageBanner {
    Q_OBJECT

public:
    // The newest tour of the window, from its first step.
    static void start(QMainWindow* window, document::Document* document, const Panels& panels);

    static constexpr int handSteps = 6;    // steps that the user does; the tour then asks whether to go on
    static constexpr int rest = handSteps; // step that asks
    int step() const { return m_step; }
    QWidget* target() const { return m_target; }

protected:
    QPoint topLeft() override;

private:
    Tour(QMainWindow* host, document::Document* document, const Panels& panels);
    ~Tour() override;

    void connectDeeds();
    void followDocument(const document::Change& change);
    void done(int step); // called when the user has done it
    void showStep(int step);
    void point(int step); // shows the target of the step and frames it
    // Corner of the canvas, if possible one where the banner covers no handle of the cage.
    QPoint freeCorner() const;
    void keepSize();
    void leaveStep();
    bool isFlat() const; // true if the cage is flat

    document::Document* m_document;
    Panels m_panels;
    QPointer<QWidget> m_mark; // frame around the target
    QPointer<QWidget> m_target;
    int m_step = -1;
    bool m_isDragging = false;
    bool m_wasFlat = false;
    int m_index = 0;             // index in the history
    std::array<int, 4> m_room{}; // room for which the place was chosen
    QPoint m_place;
    QLabel* m_progress;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_close;
};
