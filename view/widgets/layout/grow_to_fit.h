// SPDX-License-Identifier: MIT
#pragma once

#include <QLayout>
#include <QWidget>

namespace view {

// Makes a window higher when its layout needs more room than it has, as after a text has grown.
inline void growToFit(QWidget& window) {
    if (!window.isVisible()) return;
    window.layout()->activate();
    const int needed = window.layout()->totalHeightForWidth(window.width());
    if (window.height() < needed) window.resize(window.width(), needed);
}

} // namespace view
