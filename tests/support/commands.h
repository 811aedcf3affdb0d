// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QTest>
#include <QWidget>

namespace support {

// A command of a window by its id. Ends the test program where there is none.
inline QAction* command(const QWidget& window, const char* id) {
    for (QAction* action : window.actions())
        if (action->objectName() == QLatin1String(id)) return action;
    qFatal("there is no command %s", id);
    return nullptr;
}

} // namespace support
