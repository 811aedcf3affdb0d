// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "notation/rows/row_reader.h"

#include <QByteArray>
#include <QByteArrayList>

#include <optional>
#include <vector>

// A system as rows of numbers, whatever its dimension, and texts that an entry can hold.
namespace io::fractint {

using notation::maxLine;

struct Row {
    ifs::MapId id = ifs::MapId::None;
    std::vector<double> coefficients; // 6, or 12: the matrix row by row, then the vector
    std::optional<double> weight;     // 0 for a map that is off; nullopt for a map without weight
    // The number in the row: the probability where a map that takes part has no weight, so that every program
    // draws the same.
    double written = 0;
    double probability = 0;
};

std::vector<Row> rowsOf(const document::Fractal& fractal); // empty for an entry without a system

QByteArray numberText(double value); // finite text within the range that readers accept

// The number of a row that begins a second line, where one line cannot hold all of them.
std::size_t secondLine(std::size_t numbers);

// Rows as lines without line ends, columns aligned to the right.
QByteArrayList alignedRows(const std::vector<std::vector<QByteArray>>& rows);
// The same, each row on two lines.
QByteArrayList rowsOnTwoLines(const std::vector<std::vector<QByteArray>>& rows);
// Rows broken into two lines where one would be longer than maxLine.
QByteArrayList brokenRows(const std::vector<std::vector<QByteArray>>& rows);
// Rows like alignedRows, but with single blanks.
QByteArrayList closeRows(const std::vector<std::vector<QByteArray>>& rows);

QString storedName(const QString& name);       // one word without brace, comment or prefix
QString storedComment(const QString& comment); // one line that cannot be mistaken for one of Barycage's own

} // namespace io::fractint
