// SPDX-License-Identifier: MIT
#include "session/window_place.h"

#include "session/session.h"

#include <QApplication>
#include <QByteArray>
#include <QScreen>
#include <QStyle>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace {

constexpr int step = 32; // pixels between two windows, about the height of a title bar
constexpr QSize usualSize(1440, 900);
constexpr double maxShare = 0.95; // share of the screen, before the user has chosen a size

QRect movedInto(const QRect& room, QRect place) {
    place.moveRight(std::min(place.right(), room.right()));
    place.moveBottom(std::min(place.bottom(), room.bottom()));
    place.moveLeft(std::max(place.left(), room.left()));
    place.moveTop(std::max(place.top(), room.top()));
    return place;
}

bool isTaken(const QPoint& corner, const QList<QRect>& others) {
    return std::ranges::any_of(others, [&](const QRect& other) {
        const QPoint apart = other.topLeft() - corner;
        return std::abs(apart.x()) < step / 2 && std::abs(apart.y()) < step / 2;
    });
}

// The first step from `place` on where no other window begins, as far as it is in the room.
std::optional<QRect> freeFrom(QRect place, const QList<QRect>& others, const QRect& room,
                              const QSize& least) {
    for (;; place.translate(step, step)) {
        const QRect inside = place & room;
        if (inside.size().boundedTo(least) != least) return std::nullopt;
        if (!isTaken(inside.topLeft(), others)) return inside;
    }
}

// The room on a screen; of a window that is not shown yet only the inside is known.
QRect roomOn(const QScreen& screen, const QMainWindow& window) {
    const int titleBar = window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window);
    return screen.availableGeometry().adjusted(0, titleBar, 0, 0);
}

QList<QRect> placesOfOthers(const QMainWindow* window) {
    QList<QRect> places;
    for (const SessionWindow* other : session::windows())
        if (other != window && other->isVisible() && !other->isMinimized()) places << other->geometry();
    return places;
}

} // namespace

QRect placeBeside(const QRect& wanted, const QList<QRect>& others, const QRect& room, const QSize& least) {
    const QRect first = movedInto(room, wanted);
    if (!isTaken(first.topLeft(), others)) return first;
    const QRect atCorner(room.topLeft(), first.size());
    for (const QRect& start : {first, atCorner})
        if (const auto place = freeFrom(start, others, room, first.size())) return *place;
    return freeFrom(atCorner, others, room, least.boundedTo(first.size())).value_or(first);
}

void placeWindow(QMainWindow* window, const QByteArray& stored) {
    const bool isRestored = window->restoreGeometry(stored);
    if (window->isMaximized() || window->isFullScreen()) return;
    const QWidget* active = QApplication::activeWindow();
    const QScreen* screen = active && !isRestored ? active->screen() : window->screen();
    if (isRestored) {
        const QScreen* there = QGuiApplication::screenAt(window->geometry().center());
        screen = there ? there : screen;
    }
    const QRect room = roomOn(*screen, *window);
    QRect wanted = window->geometry();
    if (!isRestored) {
        wanted.setSize(usualSize.boundedTo(room.size() * maxShare));
        wanted.moveCenter(room.center());
    }
    const QSize least = window->minimumSizeHint().expandedTo(window->minimumSize());
    window->setGeometry(placeBeside(wanted, placesOfOthers(window), room, least));
}
