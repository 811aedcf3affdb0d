// SPDX-License-Identifier: MIT
#pragma once

#include "document/problem.h"
#include "io/table/table_columns.h"

#include <QString>

#include <algorithm>
#include <optional>
#include <vector>

namespace io {

// Rows of numbers as people paste them or a spreadsheet writes them: blanks, tabs, commas or semicolons
// between 6 or 7 numbers a row (12 or 13 of a map in space), with or without a label and a header; one column
// per map when the rows are labelled a, b, c …; or a count followed, for every map, by its weight and a 3×3
// matrix. The order of the columns is the one given, else the header's, else Fractint's "a b c d e f [p]". A
// row that is not understood in one way alone is an error.
struct Table {
    std::vector<ifs::WeightedMap<2>> rows;      // maps without ids
    std::vector<ifs::WeightedMap<3>> spaceRows; // maps in space, in place of `rows`
    std::vector<int> lines;                     // 1-based line of the text for each row
    document::Problems problems;                // any error: nothing can be pasted
    bool isTable = false;                       // true if there was a readable row, or a header over one
    bool isCumulative = false; // true if weights were running sums; their differences are stored
    bool isOrdered = false;    // true if the text or the caller named the columns
};
enum class TableMaps { Plane, PlaneOrSpace }; // accepted maps; others are an error
Table readTable(const QString& text, const std::optional<TableColumns>& columns = std::nullopt,
                TableMaps wanted = TableMaps::Plane);
inline bool hasErrors(const Table& table) {
    return std::ranges::any_of(table.problems, [](const document::Problem& problem) {
        return problem.severity == document::Problem::Severity::Error;
    });
}
// Returns true if the text is a table that does not say what its columns are, and can be read once they are
// given.
bool isOrderOpen(const QString& text);

constexpr qsizetype maxTable = 64 * 1024 * 1024; // characters

// Returns true if a text is a table whose numbers Fractint would take for other rows: a count and matrices,
// or semicolons between the numbers, where they begin comments.
bool isTableToFractintUnknown(const QString& beginning);

} // namespace io
