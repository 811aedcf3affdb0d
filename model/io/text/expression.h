// SPDX-License-Identifier: MIT
#pragma once

#include <QStringView>

#include <optional>

namespace io {

// The value of a number as people write it: 1/2, sqrt(3)/6, cos(36°), −2π, 3^2. Operators + − * / ^ and
// parentheses; pi, e and the golden ratio phi; ° for degrees; the functions sin cos tan asin acos atan atan2
// sinh cosh tanh sqrt cbrt exp ln log log2 abs min max. Angles are in radians, and sines and cosines of whole
// degrees are exact where they are rational. Always with a decimal point; no more than maxExpression
// characters. nullopt where there is none or it is not finite.
std::optional<double> evaluate(QStringView text);

// Whether it is a whole expression whose value is not finite, such as 1/0 or sqrt(-1).
bool isWithoutValue(QStringView text);

constexpr qsizetype maxExpression = 200; // characters

} // namespace io
