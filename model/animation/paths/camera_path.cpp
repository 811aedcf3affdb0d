// SPDX-License-Identifier: MIT
#include "animation/paths/camera_path.h"

#include "attractor/arithmetic/arithmetic.h"

#include <cmath>
#include <numbers>

namespace animation {

namespace {

struct Zoom {
    double height;
    double share; // share of the way of the centre
};

Zoom zoom(double from, double to, double u) {
    const double ratio = to / from;
    if (ratio == 1) return {from, u};
    const double logarithm = attractor::naturalLogarithm(ratio);
    const double power = attractor::exponential(u * logarithm);
    // Series for r near 1, where both differences lose their digits: u(1 + (u − 1)·ln r/2 + …).
    constexpr double small = 1e-5;
    const double share =
        std::abs(logarithm) < small ? u * (1 + (u - 1) * logarithm / 2) : (power - 1) / (ratio - 1);
    return {from * power, share};
}

// Adding and multiplying only: what decides a pixel is the same on every machine.
attractor::Orientation rotationOf(const CameraTurn& turn) {
    const ifs::Vector<3> axis = attractor::sineOfDegrees(turn.degrees / 2) * turn.axis;
    return {attractor::cosineOfDegrees(turn.degrees / 2), axis.x(), axis.y(), axis.z()};
}

} // namespace

double turnBetween(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);
}

attractor::View between(const attractor::View& from, const attractor::View& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    const Zoom now = zoom(from.height, to.height, share);
    attractor::View view = from;
    view.height = now.height;
    view.centre = from.centre + now.share * (to.centre - from.centre);
    if (from.rotation != to.rotation) view.rotation += share * turnBetween(from.rotation, to.rotation);
    return view;
}

attractor::OrbitCamera between(const attractor::OrbitCamera& from, const attractor::OrbitCamera& to,
                               double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    const Zoom now = zoom(from.height, to.height, share);
    attractor::OrbitCamera camera = from;
    camera.height = now.height;
    camera.target = from.target + now.share * (to.target - from.target);
    camera.orientation = from.orientation.slerp(share, to.orientation).normalized();
    camera.fieldOfView = (1 - share) * from.fieldOfView + share * to.fieldOfView;
    return camera;
}

attractor::OrbitCamera orbited(attractor::OrbitCamera camera, const CameraTurn& turn) {
    if (turn.degrees == 0) return camera;
    const attractor::Orientation rotation = rotationOf(turn);
    camera.orientation = rotation * camera.orientation;
    if (turn.pivot) camera.target = *turn.pivot + rotation * (camera.target - *turn.pivot);
    return camera;
}

attractor::OrbitCamera orbited(attractor::OrbitCamera camera, std::span<const CameraTurn> turns) {
    for (const CameraTurn& turn : turns)
        camera = orbited(camera, turn);
    return camera;
}

attractor::OrbitCamera orbitedBack(attractor::OrbitCamera camera, std::span<const CameraTurn> turns) {
    for (std::size_t i = turns.size(); i-- > 0;)
        camera = orbited(camera, CameraTurn{-turns[i].degrees, turns[i].axis, turns[i].pivot});
    return camera;
}

std::optional<ifs::AffineMap<3>> motionOf(std::span<const CameraTurn> turns) {
    ifs::AffineMap<3> motion;
    for (const CameraTurn& turn : turns) {
        if (!turn.pivot) return std::nullopt;
        if (turn.degrees == 0) continue;
        const ifs::Matrix<3> rotation = rotationOf(turn).toRotationMatrix();
        motion = ifs::AffineMap<3>{rotation, *turn.pivot - rotation * *turn.pivot} * motion;
    }
    return motion;
}

} // namespace animation
