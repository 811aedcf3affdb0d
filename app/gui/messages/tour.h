// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_view.h"
#include "docks/panels.h"
#include "document/document.h"
#include "messages/message_banner.h"

#include <QPointer>

#include <array>
#include <optional>

class QPushButton;

// Six short steps in the window itself, then three about what lies behind them, and a goodbye: a banner with
// one sentence says what to do, a frame is around the place to do it, and the next step comes when it is
// done. Nothing is locked meanwhile. Deletes itself when closed; tool, panels and columns that the tour chose
// are then as before.
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
    int widthFor(int room) const override;
    QPoint topLeft() override;
    void closeEvent(QCloseEvent* event) override;

private:
    Tour(QMainWindow* host, document::Document* document, const Panels& panels);
    ~Tour() override;

    void connectDeeds();
    void followDocument(const document::Change& change);
    void done(int step); // called when the user has done it
    void showStep(int step);
    void point(int step); // shows what the step speaks of, and frames it
    void showPanel(QDockWidget* dock);
    QRect pointed() const;    // the target, in the window
    bool isAtPanel() const;   // the target is no canvas
    QPoint freePlace() const; // in the canvas, with nothing of interest below the banner where possible
    void keepSize();
    void leaveStep();
    void followExports();
    void tellStep(); // what to do, as things are now
    QString textOf(int step) const;
    void bringBack(); // what the steps have changed to be seen
    int coveredAt(const QPoint& place) const;
    bool isFlat() const;        // the cage
    bool isContracting() const; // every map that is on

    document::Document* m_document;
    Panels m_panels;
    QPointer<QWidget> m_mark; // frame around the target
    QPointer<QWidget> m_target;
    int m_step = -1;
    bool m_isDragging = false;
    bool m_wasFlat = false;
    bool m_hasUndone = false;
    int m_index = 0;             // in the history
    std::array<int, 4> m_room{}; // for which the place was chosen
    struct Found {
        view::CanvasView::Tool tool{};
        bool areOverlaysVisible = true;
        std::optional<int> scrolled = {}; // the table of maps, before a column was shown
        bool isColumnHidden = false;
        QList<QPointer<QDockWidget>> hidden = {};  // panels
        QList<QPointer<QDockWidget>> inFront = {}; // of panels that the tour has shown
    };
    Found m_found;
    QPoint m_place;
    QLabel* m_progress;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_close;
};
