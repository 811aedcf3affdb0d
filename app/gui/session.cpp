// SPDX-License-Identifier: MIT
#include "session.h"

#include "main_window.h"
#include "settings.h"

#include <QApplication>
#include <QFileInfo>

namespace session {

namespace {

const QString key = QStringLiteral("session/files");

QStringList shown() {
    QStringList paths;
    for (const MainWindow* window : windows())
        if (window->isVisible() && !window->path().isEmpty())
            paths << QFileInfo(window->path()).absoluteFilePath();
    return paths;
}

} // namespace

QList<MainWindow*> windows() {
    QList<MainWindow*> found;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<MainWindow*>(widget)) found << window;
    return found;
}

QStringList files() {
    QStringList paths = view::stored(key).toStringList();
    paths.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return paths;
}

void remember() {
    // Also while others are open: if the program ends without a farewell, this is the best that is known.
    view::store(key, shown());
}

void quit() {
    const QStringList paths = shown();
    QApplication::closeAllWindows();
    for (const MainWindow* window : windows())
        if (window->isVisible()) return;
    view::store(key, paths);
}

} // namespace session
