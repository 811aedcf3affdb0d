// SPDX-License-Identifier: MIT
#include "session.h"

#include "desktop/settings.h"
#include "io/file/slow_disk.h"

#include <QApplication>
#include <QFileInfo>

namespace session {

namespace {

const QString key = QStringLiteral("session/files");

QStringList shown() {
    QStringList paths;
    for (const SessionWindow* window : windows())
        if (window->isVisible() && !window->path().isEmpty())
            paths << QFileInfo(window->path()).absoluteFilePath();
    return paths;
}

} // namespace

QList<SessionWindow*> windows() {
    QList<SessionWindow*> found;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<SessionWindow*>(widget)) found << window;
    return found;
}

QStringList files() {
    return io::withoutGone(view::stored(key).toStringList());
}

void remember() {
    // Also while other windows are open: the program may be killed before they close.
    view::store(key, shown());
}

void quit() {
    const QStringList paths = shown();
    QApplication::closeAllWindows();
    for (const SessionWindow* window : windows())
        if (window->isVisible()) return;
    view::store(key, paths);
}

} // namespace session
