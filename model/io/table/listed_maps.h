// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace io {

// Notation of a text with maps.
enum class Notation {
    Lists, // of JSON, Python and their like
    Yaml,
    Gimp, // IFS Fractal of GIMP
    LatexTable,
    HtmlTable,
    MarkdownTable,
    WikiTable,
    LatexMatrices,
    Equations,
};

// A list beside maps that would hold their weights if it had as many numbers as there are maps.
struct UnusedWeights {
    QString name; // empty: there is none
    std::size_t numbers = 0;
};

// A system that stands in another notation, as a table.
struct ListedMaps {
    QString name;  // as the text calls it; may be empty
    QString table; // for readTable(): a row for every map, with a header where the text says what is what
    qsizetype maps = 0;
    Notation notation = Notation::Lists;
    std::vector<int> lines; // of the text, from 1, for every line of `table`; empty where it is not known
    UnusedWeights unused{};
    std::optional<std::size_t> withoutWeight{}; // the first of the maps, from 0, where others have one
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
