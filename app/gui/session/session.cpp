// SPDX-License-Identifier: MIT
#include "session/session.h"

#include "desktop/settings.h"
#include "document/text/text.h"
#include "io/file/slow_disk.h"
#include "messages/window_messages.h"

#include <QApplication>
#include <QFileInfo>
#include <QPointer>
#include <QVariant>

#include <algorithm>

namespace session {

namespace {

const QString filesKey = QStringLiteral("session/files");
const QString placesKey = QStringLiteral("session/restart");
constexpr char toReopen[] = "filesToReopen"; // property of the application

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

bool isSameFile(const QString& a, const QString& b) {
    const auto areOne = [a, b] {
        const QString file = QFileInfo(a).canonicalFilePath();
        return !file.isEmpty() && file == QFileInfo(b).canonicalFilePath();
    };
    return a == b || io::answerSoon(areOne).value_or(false);
}

void bringForward(SessionWindow& window) {
    window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
    window.raise();
    window.activateWindow();
}

// Panels that float are windows as well: to close them before the user has agreed would lose them.
bool mayCloseAll() {
    QList<QPointer<SessionWindow>> asked;
    for (SessionWindow* window : shown())
        asked << window;
    for (const QPointer<SessionWindow>& window : asked) {
        using Leaving = SessionWindow::Leaving;
        if (!window || window->mayClose(window == asked.last() ? Leaving::Program : Leaving::Window))
            continue;
        for (const QPointer<SessionWindow>& other : asked)
            if (other) other->closingIsOff();
        return false;
    }
    return true;
}

// Stores the files they had, also those that were saved on the way, and returns them; nullopt when one stays
// open. A window is deleted once all of them have closed.
std::optional<QStringList> closeAll() {
    if (!mayCloseAll()) return std::nullopt;
    const QList<SessionWindow*> closing = shown();
    QApplication::closeAllWindows();
    if (!shown().isEmpty()) return std::nullopt;
    const QStringList paths = filesOf(closing);
    view::store(filesKey, paths);
    return paths;
}

} // namespace

QList<SessionWindow*> windows() {
    QList<SessionWindow*> found;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<SessionWindow*>(widget)) found << window;
    return found;
}

bool allAreClosed() {
    return shown().isEmpty();
}

bool showOther(const QString& path, const QWidget* window) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QList<SessionWindow*> others = shown();
    const auto found = std::ranges::find_if(others, [&](const SessionWindow* other) {
        return other != window && !other->path().isEmpty() && isSameFile(other->path(), absolute);
    });
    if (found == others.end()) return false;
    bringForward(**found);
    if (auto* messages = (*found)->findChild<WindowMessages*>())
        messages->say(Text::tr("%1 is already open in this window.").arg(QFileInfo(path).fileName()));
    return true;
}

QStringList files() {
    return io::withoutGone(view::stored(filesKey).toStringList());
}

void remember() {
    // Stored early, while other windows are open: the program may be killed before they close.
    view::store(filesKey, filesOf(shown()));
}

void quit() {
    closeAll();
}

void restart() {
    QVariantList places; // before a closing window ends its lesson
    for (const SessionWindow* window : shown())
        places << window->restartPlace();
    const std::optional<QStringList> files = closeAll();
    if (!files) return;
    view::store(placesKey, places);
    qApp->setProperty(toReopen, *files);
}

QList<QVariantMap> takeRestartPlaces() {
    QList<QVariantMap> places;
    for (const QVariant& place : view::stored(placesKey).toList())
        places << place.toMap();
    if (!places.isEmpty()) view::store(placesKey, QVariant());
    return places;
}

std::optional<QStringList> filesToReopen() {
    const QVariant files = qApp->property(toReopen);
    return files.isValid() ? std::optional(files.toStringList()) : std::nullopt;
}

} // namespace session
