// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"

#include <QList>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace io {

// Notation of a text with maps.
enum class Notation {
    Lists, // lists of JSON, Python and similar languages
    Yaml,
    Gimp, // IFS Fractal plug-in of GIMP
    LatexTable,
    HtmlTable,
    MarkdownTable,
    WikiTable,
    LatexMatrices,
    Equations,
};

// A list beside maps that would hold their weights if it had as many numbers as there are maps.
struct UnusedWeights {
    QString name; // empty: none
    std::size_t numbers = 0;
};

// A system that stands in another notation, as a table.
struct ListedMaps {
    QString name;  // name in the text; may be empty
    QString table; // table for readTable(): a row for each map, with a header if the text names its columns
    qsizetype maps = 0;
    Notation notation = Notation::Lists;
    std::vector<int> lines; // 1-based lines of the text for the lines of `table`; empty if unknown
    UnusedWeights unused{};
    // 0-based index of the first map without weight, if others have one.
    std::optional<std::size_t> withoutWeight{};
    std::optional<UnreadMap> unread{}; // a map that is not understood: none is read, for none may be lost
};

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
