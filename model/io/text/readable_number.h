// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

namespace io {

// A number as a paper prints it.
struct ReadableNumber {
    QByteArray latex;       // LaTeX for mathematics: 0.85, \frac{1}{3}, \frac{\sqrt{3}}{6}, 1.5\cdot 10^{-5}
    bool isRounded = false; // true if rounded to six significant digits
};

// A decimal with six digits at most, a fraction, or (a + b √n) / c with small numbers where the value is one
// but for rounding errors; 0 of what is no more than such an error beside 1. Anything else is rounded.
ReadableNumber readableNumber(double value);

} // namespace io
