// SPDX-License-Identifier: MIT
#include "ifs/copies/copy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace ifs {

AffineMap<2> thickened(const AffineMap<2>& map, const Vector<2>& centre, double least) {
    const auto& m = map.linear;
    // A = R(φ)·diag(s, t)·R(ψ), from A z = αz + βz̄.
    const std::complex<double> alpha((m(0, 0) + m(1, 1)) / 2, (m(1, 0) - m(0, 1)) / 2);
    const std::complex<double> beta((m(0, 0) - m(1, 1)) / 2, (m(1, 0) + m(0, 1)) / 2);
    const double s = std::abs(alpha) + std::abs(beta);
    const double t = std::abs(alpha) - std::abs(beta);
    if (std::abs(t) >= least) return map;
    const Eigen::Rotation2D<double> outer((std::arg(alpha) + std::arg(beta)) / 2);
    const Eigen::Rotation2D<double> inner((std::arg(alpha) - std::arg(beta)) / 2);
    const Vector<2> thickness(std::max(s, least), std::copysign(least, t));
    AffineMap<2> thick;
    thick.linear = outer.toRotationMatrix() * thickness.asDiagonal() * inner.toRotationMatrix();
    thick.translation = map(centre) - thick.linear * centre;
    return thick;
}

} // namespace ifs
