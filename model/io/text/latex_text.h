// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringView>

namespace io {

// LaTeX as plain text in which numbers can be read: \tfrac14 becomes 1/4, \frac{\sqrt3}{2} becomes
// ((sqrt(3))/(2)), 0{,}5 becomes 0.5, \cos 30^\circ becomes cos(30°). What only sets or hides (\phantom{-},
// \hline, $, \mathbf) is dropped; of other commands the arguments stay.
QString plainLatex(QStringView source);

// The same text with blanks in place of its comments, so that positions and lines stay.
QString withoutLatexComments(QString source);

} // namespace io
