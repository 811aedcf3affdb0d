// SPDX-License-Identifier: MIT
#pragma once

#include "messages/message_banner.h"

#include <QPointer>

#include <array>

class QPushButton;

// Six short steps through the window itself: a banner that says what to do and a frame around the place to do
// it. Nothing is locked meanwhile. Deletes itself when closed; what the tour opened is then as before.
class Tour : public MessageBanner {
    Q_OBJECT

public:
    // The newest tour of the window, from its first step.
    static void start(QMainWindow* window);
    // Asks once in the life of the settings whether one would like to; false afterwards.
    static bool offer(QMainWindow* window);

    int step() const { return m_step; } // -1: asking
    QWidget* target() const { return m_target; }

protected:
    QPoint topLeft() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    explicit Tour(QMainWindow* host);
    ~Tour() override;

    void showStep(int step);
    QPoint freeCorner() const; // of the canvas, with no handle of the cage below the banner where possible
    void keepSize(bool asking);
    void leaveStep();

    QPointer<QWidget> m_mark; // the frame around the target
    QPointer<QWidget> m_target;
    int m_step = -1;
    std::array<int, 4> m_room{}; // for which the place was chosen
    QPoint m_place;
    bool m_barWasHidden = false;
    QLabel* m_progress;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_close;
};
