// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/table_cells.h"
#include "io/table/table_columns.h"

#include <QList>
#include <QStringList>

#include <optional>
#include <vector>

// Contents of the rows of a table besides the numbers of its maps.
namespace io {

// Returns true for a word that is not meant as a number: w1, ƒ1, "f(1)", 1: — and neither O.5 nor nan.
bool looksLikeLabel(const QString& text);
// Words behind the numbers: two letters at least, and neither nan nor a mistyped number.
bool looksLikeWords(const QString& text);
// A line that only parts the rows: ---, ===, +---+---+.
bool isRule(const Row& cells);

// The cells with a sign, and with "%", "°" or "deg", that a blank parts from their number, in the same field.
// A lone sign between blanks may be a cell of its own.
Row withSignsJoined(Row cells, const Dialect& dialect);

// The cells between two separators each; between blanks every cell by itself.
QList<Row> fieldsOf(const Row& cells);
QStringList textsOf(const Row& cells);  // text of each cell
QStringList namesOf(const Row& header); // name of each field, words joined

// Names of the columns a … l of a map in space, alone, or with its weight or the sum up to it behind them.
enum class SpaceHeader { None, Plain, Weighted, Cumulative };
SpaceHeader spaceHeader(const QStringList& names);
// Returns true if these are the columns of a map, in the plane or in space.
bool nameAllColumns(const QStringList& names);

// Fields that hold the columns of a map, in a table with others.
struct Picks {
    TableColumns columns; // columns of a map in the plane, one for each field
    SpaceHeader space = SpaceHeader::None;
    std::vector<qsizetype> fields;
    qsizetype width = 0; // number of fields of the header

    bool isSpace() const { return space != SpaceHeader::None; }
    bool areAdjacent() const { return fields.back() - fields.front() + 1 == qsizetype(fields.size()); }
};
// Picks by name: every column once, and any others. Beside weights, their running sum is another. nullopt if
// the names do not say it.
std::optional<Picks> pickedByName(const QStringList& names);

// Returns true if the first row names the columns. Above rows named a to f, A to F are names of maps.
bool areColumnsNamed(const QList<Row>& table);
// "Table 1. Codes of the Barnsley fern", "Source: …, p. 86": different words and hardly a number, as no map
// has; without a number, a sentence.
bool isProse(const Row& cells, const Dialect& dialect, int fewestNumbers);
// "Sum: 1.00" below a table.
bool isSum(const Row& cells);
// Returns true if all rows begin with a number that counts them, before six numbers or twelve:
// "1 .5 0 0 .5 0 0". As a coefficient, it would expand. Two rows are enough under a header of six names.
bool countMaps(const QList<Row>& table, const Dialect& dialect);
// Picks by the chosen order, which may hold TableColumn::Other.
Picks pickedByOrder(const TableColumns& columns);

} // namespace io
