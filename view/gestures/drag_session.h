// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edit_gesture.h"
#include "gestures/pointer.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <cstddef>
#include <optional>

class QKeyEvent;

namespace view {

// A drag on a canvas, by the pointer or by an arrow key for as long as it is held down: an edit that is shown
// live and leaves one undo step, or none.
class DragSession : public QObject {
    Q_OBJECT

public:
    explicit DragSession(document::Document& document);

    void press(const QPointF& position); // pixels; starts no drag yet
    const QPointF& pressedAt() const { return m_press; }
    bool isDrag(const QPointF& position); // false while a click might only have shaken

    // Begins the edit, or begins it again as it was before.
    void open(const QString& text);
    bool isOpen() const { return m_gesture && m_gesture->isOpen(); } // false after an undo has ended it
    document::EditGesture& gesture() { return *m_gesture; }
    const document::EditGesture& gesture() const { return *m_gesture; }
    const QString& text() const { return m_text; } // text of the gesture at its opening
    // The text of the step, now that its values are known. Runs of one handle, however it is numbered, that
    // follow each other closely become one step.
    void describe(const QString& text, std::size_t handle);
    enum class Outcome {
        None,      // no open gesture
        Committed, // possibly without a step
        Abandoned, // gesture ended by another change of the document
    };
    Outcome finish();
    void cancel(); // restores the state before the gesture

    // The mode that keys pressed after the button ask for; nullopt where the mode stays. Some window managers
    // keep a press with Ctrl or Alt for themselves. Letting go of the key changes nothing.
    std::optional<DragMode> turnedInto(DragMode asked, DragMode mode) const;

    // The run of an arrow key. It goes on when the key repeats, which an X server reports as going up and
    // down at the same time; runEnded() is sent when the key has really gone up.
    bool isRunning() const { return m_isRunning; }
    void beginRun() { m_isRunning = true; }
    void endRun(); // ends the run at once
    void keepRun(const QKeyEvent& press);
    bool releaseRun(const QKeyEvent& release); // false if the key does not belong to the run

signals:
    void runEnded(); // sent before the edit is committed

private:
    std::optional<document::EditGesture> m_gesture;
    document::Document& m_document;
    QPointF m_press;
    QString m_text;
    bool m_hasMoved = false;
    bool m_isRunning = false;
    QTimer m_released;          // delay that tells the release of an arrow key from its auto-repeat
    quint64 m_releaseStamp = 0; // time stamp of the release
};

} // namespace view
