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
        Trailing,   // a number and more: what C takes for one, leaving the rest
        NotFinite,  // inf, nan
        Huge,       // beyond the floats
        NotANumber, // hexadecimal ones included, which programs read differently
    };
    Kind kind = Kind::NotANumber;
    double value = 0; // of a good one; Trailing: what C reads of it
};
Number readNumber(std::string_view token);

// nan for a token that is no good number. A decimal comma is one comma in front of a digit, without a point.
double valueOf(std::string_view token, bool decimalComma);

// Returns true if a number can end with this character.
bool isNumberEnd(char c);

// Number of numbers in a row.
struct RowShape {
    int rowLength = 0;            // 6, 7, 12 or 13; 0 when the numbers fill no rows
    bool isMarkMissing = false;   // three-dimensional without (3D)
    bool isLineLengthOdd = false; // rows of 7 that disagree with the lines: each line has 6, or 13
};
// The shape that fits the numbers of each line that has any.
RowShape rowShape(const std::vector<std::size_t>& perLine, bool isMarked3D);

} // namespace notation
