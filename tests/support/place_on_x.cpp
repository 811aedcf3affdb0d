// SPDX-License-Identifier: MIT
#include "support/place_on_x.h"

#include <QRect>
#include <QWidget>

#include <memory>

// After Qt: it defines words like None and Bool.
#include <X11/Xlib.h>

namespace support {

bool isInPlace(const QWidget* window) {
    static const std::unique_ptr<Display, int (*)(Display*)> display(XOpenDisplay(nullptr), XCloseDisplay);
    if (!display || !window->isActiveWindow()) return false;
    const Window id = window->internalWinId();
    Window child = 0, focused = 0;
    int afterwards = 0;
    XGetInputFocus(display.get(), &focused, &afterwards);
    if (focused != id) return false;
    int x = 0, y = 0;
    XWindowAttributes found;
    if (!XTranslateCoordinates(display.get(), id, DefaultRootWindow(display.get()), 0, 0, &x, &y, &child) ||
        !XGetWindowAttributes(display.get(), id, &found))
        return false;
    const double ratio = window->devicePixelRatioF();
    const QRect believed((QPointF(window->mapToGlobal(QPoint())) * ratio).toPoint(),
                         (QSizeF(window->size()) * ratio).toSize());
    return QRect(x, y, found.width, found.height) == believed;
}

} // namespace support
