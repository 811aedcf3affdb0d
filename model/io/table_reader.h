// SPDX-License-Identifier: MIT
#pragma once

#include "document/problem.h"
#include "ifs/iterated_function_system.h"

#include <QString>

#include <vector>

namespace io {

// Rows of numbers as people paste them: blanks, tabs, commas or semicolons between 6 or 7 numbers a row,
// optional label and header, Fractint order "a b c d e f [p]".
struct Table {
    std::vector<ifs::WeightedMap<2>> rows; // without ids
    document::Problems problems;           // any error: nothing is to be pasted
};
Table readTable(const QString& text);

// Tab-separated rows a b c d e f p.
QString writeTable(const std::vector<ifs::WeightedMap<2>>& rows);

} // namespace io
