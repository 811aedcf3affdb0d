// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/numbers/surd.h"

#include <QStringView>

#include <optional>

namespace io {

// The value of a number as people write it: 1/2, sqrt(3)/6, cos(36°), −2π, 3^2. Operators + − * / ^ and
// parentheses; pi, e and the golden ratio phi; ° for degrees; the functions sin cos tan asin acos atan atan2
// sinh cosh tanh sqrt cbrt exp ln log log2 abs min max. Angles are in radians, and sines and cosines of whole
// degrees are exact where they are rational. Always with a decimal point; no more than maxExpression
// characters. nullopt where there is none or it is not finite.
std::optional<double> evaluate(QStringView text);

// Quantity in a number field or a column of a table.
enum class NumberUnit { None, Degrees };

// Evaluates an angle in degrees, as people write them. A plain number such as 45 or 360/7 is degrees, and °
// marks them: 90° is 90. Terms with pi and the results of asin, acos, atan and atan2 are radians and are
// converted once: pi/2 is 90. Sums add up degrees: 90° + pi/4 and 90 + pi/4 are 135. Angles cancel:
// acos(0.8)*180/pi is 36.87. The arguments of functions and their other results are those of evaluate():
// cos(60°) is 0.5. NumberUnit::None is evaluate().
std::optional<double> evaluate(QStringView text, NumberUnit unit);

// The value of evaluate() without rounding; nullopt where it is none of the numbers that ifs::Surd can hold,
// and of a plain number, which means the double that is stored for it.
std::optional<ifs::Surd> evaluateExactly(QStringView text);

// Returns true if the expression is an angle by itself, by ° or in radians, which a field of degrees shows as
// a number.
bool isAngle(QStringView text);

// Returns true for a complete expression whose value is not finite, such as 1/0 or sqrt(-1).
bool isWithoutValue(QStringView text);

constexpr qsizetype maxExpression = 200; // characters

} // namespace io
