// SPDX-License-Identifier: MIT
#include "collage/fit/constraints.h"

#include "ifs/linear/singular_vectors.h"

#include <cmath>
#include <numbers>

namespace collage {

namespace {

constexpr double flattest = 0.05; // singular value ratio that a map about to mirror keeps
constexpr double rounding = 1e-12;

ifs::Matrix<2> withoutMirror(const ifs::Matrix<2>& a) {
    if (ifs::determinant<2>(a) >= 0) return a;
    const auto [left, values, right] = ifs::singularVectors<2>(a);
    const ifs::Vector<2> mirrorless(values[0], -flattest * values[0]);
    return left * mirrorless.asDiagonal() * right.transpose();
}

ifs::Matrix<2> withAngle(const ifs::Matrix<2>& a, int degrees) {
    const ifs::Matrix<2> turn = turnOf(a);
    const double step = degrees * std::numbers::pi / 180;
    const double angle = std::atan2(turn(1, 0), turn(0, 0));
    const double nearest = step * std::round(angle / step);
    if (std::abs(angle - nearest) < rounding) return a;
    const double difference = nearest - angle;
    ifs::Matrix<2> rotation;
    rotation << std::cos(difference), -std::sin(difference), std::sin(difference), std::cos(difference);
    return rotation * a;
}

ifs::Matrix<2> flattened(const ifs::Matrix<2>& a) {
    const auto [left, values, right] = ifs::singularVectors<2>(a);
    if (values[1] <= rounding * values[0]) return a;
    return values[0] * left.col(0) * right.col(0).transpose();
}

} // namespace

ifs::Matrix<2> turnOf(const ifs::Matrix<2>& a) {
    const auto [left, values, right] = ifs::singularVectors<2>(a);
    return left * right.transpose();
}

ifs::AffineMap<2> constrained(const Constraints& constraints, std::size_t index, ifs::AffineMap<2> map,
                              const ifs::Vector<2>& centre) {
    const ifs::Matrix<2> before = map.linear;
    const ifs::Vector<2> image = map(centre);
    if (constraints.isStem(index)) {
        map.linear = flattened(map.linear);
    } else {
        if (constraints.mirrors == Mirrors::Excluded) map.linear = withoutMirror(map.linear);
        if (constraints.angleStep > 0) map.linear = withAngle(map.linear, constraints.angleStep);
    }
    if (map.linear != before) map.translation = image - map.linear * centre;
    return map;
}

} // namespace collage
