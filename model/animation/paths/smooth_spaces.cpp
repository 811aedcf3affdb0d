// SPDX-License-Identifier: MIT
#include "animation/paths/smooth_spaces.h"

#include "attractor/arithmetic/arithmetic.h"

#include <cmath>

namespace animation {

namespace {

constexpr double small = 1e-5; // limit below which differences lose their digits, and series do not

} // namespace

Rotations::Step Rotations::between(const attractor::Orientation& from, const attractor::Orientation& to) {
    attractor::Orientation turn = from.conjugate() * to;
    if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    if (sine < small) return (2 + sine * sine / 3) * turn.vec();
    return 2 * std::atan2(sine, turn.w()) / sine * turn.vec();
}

attractor::Orientation Rotations::moved(const attractor::Orientation& from, const Step& step) {
    const double half = step.norm() / 2;
    const double share = half < small ? (1 - half * half / 6) / 2 : std::sin(half) / (2 * half);
    const Step axis = share * step;
    return (from * attractor::Orientation(std::cos(half), axis.x(), axis.y(), axis.z())).normalized();
}

template <int Dim>
typename Framings<Dim>::Step Framings<Dim>::between(const Framing<Dim>& from, const Framing<Dim>& to) {
    const double ratio = to.height / from.height, zoom = attractor::naturalLogarithm(ratio);
    const double share = std::abs(zoom) < small ? 1 - zoom / 2 + zoom * zoom / 12 : zoom / (ratio - 1);
    Step step;
    step << zoom, share / from.height * (to.centre - from.centre);
    return step;
}

template <int Dim> Framing<Dim> Framings<Dim>::moved(const Framing<Dim>& from, const Step& step) {
    const double zoom = step[0], ratio = attractor::exponential(zoom);
    const double share = std::abs(zoom) < small ? 1 + zoom / 2 + zoom * zoom / 6 : (ratio - 1) / zoom;
    return {from.height * ratio, from.centre + from.height * share * step.template tail<Dim>()};
}

template struct Framings<2>;
template struct Framings<3>;

} // namespace animation
