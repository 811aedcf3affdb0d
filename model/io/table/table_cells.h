// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/expression.h"

#include <QList>
#include <QString>
#include <QStringView>

#include <optional>

// The cells of a table that people paste or a spreadsheet writes, and the numbers in them.
namespace io {

inline constexpr qsizetype maxTableRows = 250'000; // rows of one table

struct Cell {
    QString text; // text without surrounding quotation marks
    int line = 0;
    int column = 0; // 1-based like `line`; counts bytes of the UTF-8 text
    bool isContinued =
        false; // true: only blanks separate it from the previous cell, although the table has separators
};
using Row = QList<Cell>;

enum class Separator { Semicolon, Tab, Comma, Blank };

struct Dialect {
    Separator separator = Separator::Blank;
    bool decimalComma = false;
    bool isMixed = false; // true: blanks separate other numbers, so that nothing more is guessed
};

// The text with blanks for what stands before numbers and is none of them: "[1,]" of R, bullets, DATA and REM
// of BASIC, and the "4×7 Matrix{Float64}:" of Julia.
QString withoutOrnaments(QString text);

// The ways in which the text can be understood: one, or two when some numbers are parted by commas and others
// by blanks. Semicolons or tabs between all numbers of a row leave the comma free to be the decimal one.
// Fewer semicolons begin a comment, as in Fractint's files. `text` has lines that end in LF.
QList<Dialect> dialectsOf(QStringView text);

// The cells of one line. Between two separators stands a cell, be it empty; only at the end of a line empty
// cells mean nothing. Blanks inside a cell part numbers as well. Quotation marks as in RFC 4180, within a
// line. No more than `most` cells are taken. Behind the numbers of a map, "#", "%", "//" and "-- " begin a
// comment, as ";" does everywhere.
Row cellsOf(QStringView text, int line, const Dialect& dialect, qsizetype most);

// A decimal number, a fraction like 1/3 or ½, or another expression: evaluate(). Any dash is a minus sign.
std::optional<double> numberIn(const Cell& cell, const Dialect& dialect, NumberUnit unit = NumberUnit::None);

} // namespace io
