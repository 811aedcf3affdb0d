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
    virtual void move(const Pointer& pointer) = 0; // with or without the button
    virtual void release(const Pointer& pointer) = 0;
    virtual void leave() {}                                   // the pointer has left the canvas
    virtual bool keyPress(const QKeyEvent&) { return false; } // whether the key meant something
    virtual bool keyRelease(const QKeyEvent&) { return false; }
    virtual bool cancel() = 0;       // back to where the gesture began; false when none was under way
    virtual bool isBusy() const = 0; // in the middle of a gesture
    virtual void start() {}          // has become the tool in use
    virtual void stop() {}           // another tool takes over
    virtual QCursor cursor(const Pointer& pointer) const = 0;

signals:
    void message(const QString& sentence);
    void cursorChanged();
    void finished(); // has done what it is for
};

} // namespace view
