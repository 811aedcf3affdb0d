// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace support {

inline bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

template <int Dim>
bool near(const Eigen::Matrix<double, Dim, 1>& a, const Eigen::Matrix<double, Dim, 1>& b, double tolerance) {
    return (a - b).norm() <= tolerance;
}

} // namespace support
