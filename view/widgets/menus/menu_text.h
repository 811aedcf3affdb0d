// SPDX-License-Identifier: MIT
#pragma once

#include <QFontMetrics>
#include <QString>

namespace view {

// A name as the text of a menu: its middle is left out where it would make the menu wide, and “&” is no
// mnemonic.
inline QString menuText(const QString& name, const QFontMetrics& metrics) {
    constexpr int widest = 60; // characters of average width
    return metrics.elidedText(name, Qt::ElideMiddle, widest * metrics.averageCharWidth())
        .replace(u'&', QLatin1String("&&"));
}

} // namespace view
