// SPDX-License-Identifier: MIT
#pragma once

#include <QStringView>

#include <array>
#include <optional>

namespace io {

// An expression such as 0.85x + 0.04*y − 1/3: the factors of x, y and z, and the constant.
struct AffineExpression {
    std::array<double, 3> factors{};
    double shift = 0;
    bool usesZ = false;
    qsizetype end = 0; // end of its part of the text

    bool isConstant() const { return factors == std::array<double, 3>{}; }
};

// The longest one at the beginning of the text. The letters may have indices or marks (xₙ, x_n, xn, x[n],
// x_old); a product sign may be missing. nullopt: none begins there, or one that is not affine.
std::optional<AffineExpression> affineExpression(QStringView text);

} // namespace io
