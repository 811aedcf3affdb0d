// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "canvas/canvas_view.h"
#include "document/document.h"
#include "document/fractal/fractal.h"
#include "space/space_input.h"

#include <QDeadlineTimer>
#include <QStatusBar>

class QLabel;

// A single quiet line: the position of the pointer or the last message, whether there is an attractor, what
// was drawn; and that unsaved work is not kept for recovery yet, when that takes too long. Text that does not
// fit ends in dots, and is whole in a tool tip. Esc removes the message in the window that has the focus, and
// so does the next step or Undo: what was said of the one before is no longer true.
class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    void follow(document::Document& document);
    void showPointer(const view::PointerPosition& position);
    void showSpacePointer(const view::SpacePosition& position);
    void clearPointer();
    void showVerdict(const document::Fractal& fractal);
    void showTime(double milliseconds); // for pictures without points
    void showFrame(const attractor::Frame& frame);
    void showRotation(double degrees); // rotation of the view in the plane; hidden for 0
    void showRecovery(bool isLate);    // hidden unless late

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QRect messageRoom() const;
    QString shownMessage() const; // as much as there is room for
    void noteMessage();
    void takeStep();

    QLabel* m_pointer;
    QLabel* m_recovery;
    QLabel* m_rotation;
    QLabel* m_verdict;
    QLabel* m_frame;
    QDeadlineTimer m_toRead; // for reading the last message
    bool m_isNew = false;    // it came with the event that is being handled
    bool m_isOfDrag = false; // it came in the middle of a gesture, whose end is a step
    bool m_isLive = false;   // a gesture is going on
};
