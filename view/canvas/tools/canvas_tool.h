// SPDX-License-Identifier: MIT
#pragma once

#include "gestures/pointer.h"

#include <QCursor>
#include <QObject>

class QKeyEvent;

namespace view {

// A mode of the left button. A tool decides what a gesture means and tells the document.
class CanvasTool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    virtual void press(const Pointer& pointer) = 0;
    virtual void move(const Pointer& pointer) = 0; // called with and without a button down
    virtual void release(const Pointer& pointer) = 0;
    virtual void leave() {}                                   // called when the pointer leaves the canvas
    virtual bool keyPress(const QKeyEvent&) { return false; } // returns true if the key had an effect
    virtual bool keyRelease(const QKeyEvent&) { return false; }
    virtual bool cancel() = 0;       // restores the state before the gesture; false if there was none
    virtual bool isBusy() const = 0; // true within a gesture
    virtual void start() {}          // called when the tool comes into use
    virtual void stop() {}           // called when another tool takes over
    virtual QCursor cursor(const Pointer& pointer) const = 0;

signals:
    void message(const QString& sentence);
    void cursorChanged();
    void finished(); // sent when the tool has completed its task
};

} // namespace view
