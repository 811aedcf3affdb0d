// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/numbers/surd.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace notation {

// The value of a number as people write it, in UTF-8: 1/2, sqrt(3)/6, cos(36°), −2π, 3^2. Operators + − * / ^
// and parentheses; pi, e and the golden ratio phi; ° for degrees; the functions sin cos tan asin acos atan
// atan2 sinh cosh tanh sqrt cbrt exp ln log log2 abs min max. Angles are in radians, and sines and cosines of
// whole degrees are exact where they are rational. Always with a decimal point; no more than maxExpression
// characters. nullopt where there is none or it is not finite.
std::optional<double> evaluate(std::string_view text);

// What a number field or a column of a table holds.
enum class NumberUnit { None, Degrees };

// As many degrees as an angle has that people write where degrees are expected. A plain number such as 45 or
// 360/7 is degrees, and ° marks them: 90° is 90. What carries pi or is the result of asin, acos, atan or
// atan2 is in radians and is converted once: pi/2 is 90. Sums add up degrees: 90° + pi/4 and 90 + pi/4 are
// 135. Angles cancel: acos(0.8)*180/pi is 36.87. The arguments of functions and their other results are those
// of evaluate(): cos(60°) is 0.5. NumberUnit::None is evaluate().
std::optional<double> evaluate(std::string_view text, NumberUnit unit);

// The value of evaluate() without rounding; nullopt where it is none of the numbers that ifs::Surd can hold,
// and of a plain number, which means the double that is stored for it.
std::optional<ifs::Surd> evaluateExactly(std::string_view text);

// Whether the expression is an angle by itself, by ° or in radians, which a field of degrees shows as a
// number.
bool isAngle(std::string_view text);

// Whether it is a whole expression whose value is not finite, such as 1/0 or sqrt(-1).
bool isWithoutValue(std::string_view text);

constexpr std::size_t maxExpression = 200; // characters

} // namespace notation
