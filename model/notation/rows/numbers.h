// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

// The numbers of a Fractint entry, one token each, and the rows that they fill. docs/formats.md, "Reading one
// entry".
namespace notation {

struct Number {
    enum class Kind {
        Good,
        Trailing,   // number and more: C accepts the beginning and leaves the rest
        NotFinite,  // inf, nan
        Huge,       // beyond the range of float
        NotANumber, // includes hexadecimal ones, which programs read differently
    };
    Kind kind = Kind::NotANumber;
    double value = 0; // value of a good number; Trailing: of its beginning
};
Number readNumber(std::string_view token);

// nan for a token that is no good number. A decimal comma is one comma in front of a digit, without a point.
double valueOf(std::string_view token, bool decimalComma);

// Returns true if a number can end with this character.
bool isNumberEnd(char c);

// Number of numbers in a row.
struct RowShape {
    int rowLength = 0;            // 6, 7, 12 or 13; 0 if the numbers fill no rows
    bool isMarkMissing = false;   // true for three-dimensional rows without (3D)
    bool isLineLengthOdd = false; // true if rows of 7 disagree with the lines, which have 6 or 13 each
};
// The shape that fits the numbers of each line that has any.
RowShape rowShape(const std::vector<std::size_t>& perLine, bool isMarked3D);

} // namespace notation
