// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QByteArray>
#include <QWidget>

namespace support {

// The button of this name below `parent`. Ends the test program where there is none.
inline QAbstractButton* button(const QObject& parent, const char* name) {
    auto* found = parent.findChild<QAbstractButton*>(QLatin1String(name));
    if (!found) qFatal("there is no button %s", name);
    return found;
}

// The action of this name below `parent`, which is no command of a window: see command(). Ends the test
// program where there is none.
inline QAction* action(const QObject& parent, const QByteArray& name) {
    auto* found = parent.findChild<QAction*>(QString::fromLatin1(name));
    if (!found) qFatal("there is no action %s", name.constData());
    return found;
}

} // namespace support
