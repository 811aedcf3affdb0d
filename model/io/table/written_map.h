// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <vector>

namespace io {

// A map as a text writes it: its matrix, row by row, then its vector; 6 numbers in the plane, 12 in space.
struct WrittenMap {
    std::vector<double> numbers;
    std::optional<double> weight;
    int line = 0; // line of the text, 1-based
};

// A map that is written but not understood.
struct UnreadMap {
    int row = 0;  // among the maps, 1-based
    int line = 0; // line of the text, 1-based; 0 if unknown
    QString text;
};

// Maps are complete only where none is unread.
struct WrittenMaps {
    std::vector<WrittenMap> maps;
    std::optional<UnreadMap> unread{};
};

// Rows for readTable() under a header. A map in the plane among those of space makes them none.
QString tableOf(const std::vector<WrittenMap>& maps);

// The weights that stand between the maps: `between` is the text before the first, between each two, and
// behind the last. "p = 0.85", "probability 85%", "(85 %)"; or bounds of a random number, "r < 0.86". Some
// are missing where at least half of the maps have one; else none has.
std::vector<std::optional<double>> weightsBetween(const QStringList& between);

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

} // namespace io
