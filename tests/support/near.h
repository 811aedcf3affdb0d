// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace support {

inline bool near(double a, double b, double tolerance = 1e-9) {
    return std::abs(a - b) <= tolerance;
}

// No value is near nothing.
inline bool near(const std::optional<double>& a, double b, double tolerance = 1e-9) {
    return a && near(*a, b, tolerance);
}

inline bool near(const std::vector<double>& a, const std::vector<double>& b, double tolerance = 1e-9) {
    return std::ranges::equal(a, b, [=](double x, double y) { return near(x, y, tolerance); });
}

template <int Dim>
bool near(const Eigen::Matrix<double, Dim, 1>& a, const Eigen::Matrix<double, Dim, 1>& b,
          double tolerance = 1e-9) {
    return (a - b).norm() <= tolerance;
}

} // namespace support
