// SPDX-License-Identifier: MIT
#include "session.h"

#include "desktop/settings.h"
#include "io/file/slow_disk.h"

#include <QApplication>
#include <QFileInfo>
#include <QVariant>

namespace session {

namespace {

const QString key = QStringLiteral("session/files");
constexpr char toReopen[] = "filesToReopen"; // a property of the application

QStringList filesOf(const QList<SessionWindow*>& windows) {
    QStringList paths;
    for (const SessionWindow* window : windows)
        if (!window->path().isEmpty()) paths << QFileInfo(window->path()).absoluteFilePath();
    return paths;
}

QList<SessionWindow*> shown() {
    QList<SessionWindow*> found = windows();
    erase_if(found, [](const SessionWindow* window) { return !window->isVisible(); });
    return found;
}

// Stores the files they had, also those that were saved on the way, and returns them; nullopt when one stays
// open. A window is deleted once all of them have closed.
std::optional<QStringList> closeAll() {
    const QList<SessionWindow*> closing = shown();
    QApplication::closeAllWindows();
    if (!shown().isEmpty()) return std::nullopt;
    const QStringList paths = filesOf(closing);
    view::store(key, paths);
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
    view::store(key, filesOf(shown()));
}

void quit() {
    closeAll();
}

void restart() {
    if (const std::optional<QStringList> files = closeAll()) qApp->setProperty(toReopen, *files);
}

std::optional<QStringList> filesToReopen() {
    const QVariant files = qApp->property(toReopen);
    return files.isValid() ? std::optional(files.toStringList()) : std::nullopt;
}

} // namespace session
