// SPDX-License-Identifier: MIT
#pragma once

#include <QLayout>
#include <QWidget>

namespace view {

// Makes a window higher when its layout needs more room than it has, as after a text has grown.
inline void growToFit(QWidget& window) {
    if (!window.isVisible()) return;
    window.layout()->activate();
    const int wrapped = window.layout()->totalHeightForWidth(window.width()); // −1: nothing wraps
    const int needed = wrapped < 0 ? window.layout()->totalSizeHint().height() : wrapped;
    if (window.height() < needed) window.resize(window.width(), needed);
}

} // namespace view
