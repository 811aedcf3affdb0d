// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

namespace io {

// A system that stands in lists, as a table.
struct ListedMaps {
    QString name;  // as the text calls it; may be empty
    QString table; // for readTable(): a row for every map, with a header where the text says what is what
    qsizetype maps = 0;
};

// The systems of affine maps in a text of lists (JSON, Python and their like): lists whose items all are
// maps. A map is 6 or 7 numbers (12 or 13 in space); numbers under the names of columns, such as a, b, c, d,
// e, f and p; a matrix and a vector; or rows of a matrix that holds the vector as its last column. Weights
// may be a list beside it. Rows of a Markdown or LaTeX table are taken, too.
QList<ListedMaps> listedMaps(const QString& text);

} // namespace io
