// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"

#include <QList>
#include <QString>

namespace io {

// The systems of affine maps in a text.
// In lists of JSON, Python and their like, and in YAML: lists whose items all are maps. A map is 6 or 7
// numbers (12 or 13 in space); numbers under the names of columns, such as a, b, c, d, e, f and p; a matrix
// and a vector; or rows of a matrix that holds the vector as its last column. Weights may be a list beside
// it. Or a list of numbers for each of these names. Or maps one after the other, each with a name of its own.
// Rows may stand between semicolons. In tables of LaTeX, HTML, Markdown and wikis; if none of
// them can be read, the first that nearly can. Matrices and vectors in LaTeX, and equations. Tables one below
// the other; and numbers each behind its name.
QList<ListedMaps> listedMaps(const QString& text);

// Why the weights beside the maps are not theirs; empty where they are, or there are none.
QString unusedWeightsRemark(const ListedMaps& listed);

// The text itself where it is a table by itself; else the table of the first system in it, if there is one.
QString tableIn(const QString& text);

} // namespace io
