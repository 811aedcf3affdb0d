// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/table_columns.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace io {

// Tab-separated rows a b c d e f p, as they are.
QString writeTable(const std::vector<ifs::WeightedMap<2>>& rows);

// A whole system with a header and a weight in every row (0: switched off), lines end in LF; RFC 4180 for
// commas.
enum class TableSeparator { Comma, Tab };
QByteArray writeTable(const ifs::IteratedFunctionSystem<2>& system, const TableColumns& columns,
                      TableSeparator separator);
// Columns a … i of the matrix, row by row, j k l of the vector, and p.
QByteArray writeTable(const ifs::IteratedFunctionSystem<3>& system, TableSeparator separator);

} // namespace io
