// SPDX-License-Identifier: MIT
#include "ifs/system/map_interpolation.h"

#include "ifs/system/decomposition.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ifs {

namespace {

Matrix<2> between(const Matrix<2>& from, const Matrix<2>& to, double t) {
    const auto angleOf = [](const Matrix<2>& rotation) { return std::atan2(rotation(1, 0), rotation(0, 0)); };
    double turn = std::remainder(angleOf(to) - angleOf(from), 2 * std::numbers::pi);
    if (turn <= -std::numbers::pi) turn = std::numbers::pi;
    return Eigen::Rotation2Dd(angleOf(from) + t * turn).toRotationMatrix();
}

Matrix<3> between(const Matrix<3>& from, const Matrix<3>& to, double t) {
    return Eigen::Quaterniond(from).slerp(t, Eigen::Quaterniond(to)).toRotationMatrix();
}

} // namespace

AffineMap<2> swung(const AffineMap<2>& map, const Vector<2>& root, double angle) {
    if (angle == 0) return map;
    const Vector<2> pivot = map(root);
    const Matrix<2> rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    return {rotation * map.linear, pivot + rotation * (map.translation - pivot)};
}

double Swing::angle(double time) const {
    return amplitude * std::sin(2 * std::numbers::pi * frequency * time + phase);
}

template <int Dim>
AffineMap<Dim> interpolated(const AffineMap<Dim>& from, const AffineMap<Dim>& to, double t,
                            const Vector<Dim>& reference) {
    if (t <= 0) return from;
    if (t >= 1) return to;
    const auto [first, last] = polarPair<Dim>(from.linear, to.linear);
    const Matrix<Dim> linear =
        between(first.rotation, last.rotation, t) * ((1 - t) * first.stretch + t * last.stretch);
    const Vector<Dim> image = (1 - t) * from(reference) + t * to(reference);
    return {linear, image - linear * reference};
}

template <int Dim> bool mirrors(const AffineMap<Dim>& from, const AffineMap<Dim>& to) {
    return determinant<Dim>(from.linear) * determinant<Dim>(to.linear) < 0;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template AffineMap<Dim> interpolated<Dim>(const AffineMap<Dim>&, const AffineMap<Dim>&, double,          \
                                              const Vector<Dim>&);                                           \
    template bool mirrors<Dim>(const AffineMap<Dim>&, const AffineMap<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
