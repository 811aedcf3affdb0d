// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QTextDocument>

namespace view {

// A tool tip that shows a text as it is written, whatever a file has put into it: Qt takes what looks like
// markup for markup, and reads the pictures that it names.
inline QString plainTip(const QString& text) {
    return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal) : text;
}

} // namespace view
