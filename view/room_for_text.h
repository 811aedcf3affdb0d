// SPDX-License-Identifier: MIT
#pragma once

#include <QLayout>
#include <QWidget>

namespace view {

// Makes the window higher where a text that has come since it was shown would be cut.
inline void growForText(QWidget& window) {
    if (!window.isVisible()) return;
    window.layout()->activate();
    const int needed = window.layout()->totalHeightForWidth(window.width());
    if (window.height() < needed) window.resize(window.width(), needed);
}

} // namespace view
