// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/layout/fit_screen.h"

#include <QLayout>
#include <QWidget>

#include <algorithm>

namespace view {

// Makes a window higher when its layout needs more room than it has, as after a text has grown, as far as the
// screen goes.
inline void growToFit(QWidget& window) {
    if (!window.isVisible()) return;
    window.layout()->activate();
    const int wrapped = window.layout()->totalHeightForWidth(window.width()); // −1: nothing wraps
    const int needed = wrapped < 0 ? window.layout()->totalSizeHint().height() : wrapped;
    const int wanted = std::min(needed, roomOnScreen(window).height());
    if (window.height() < wanted) window.resize(window.width(), wanted);
}

} // namespace view
