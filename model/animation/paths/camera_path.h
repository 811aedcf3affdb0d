// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <type_traits>

namespace animation {

// The camera stored in a key. In space, the size of the raster is ignored.
template <int Dim> using CameraPose = std::conditional_t<Dim == 2, attractor::View, attractor::OrbitCamera>;

// Interpolates between two views, exact at both ends. The visible height h grows by a constant factor, and
// the centre moves in proportion to it: with r = h₁/h₀ the share of the way is (rᵘ − 1)/(r − 1), and u where
// r = 1. So a point seen at both ends moves evenly over the picture. The plane turns evenly, the shorter way;
// in space the orientation takes the shorter great circle. docs/mathematics.md, "Animation".
attractor::View between(const attractor::View& from, const attractor::View& to, double share);
attractor::OrbitCamera between(const attractor::OrbitCamera& from, const attractor::OrbitCamera& to,
                               double share);

// The shorter way from one rotation of the plane to another, at most half a turn either way.
double turnBetween(double from, double to);

// A turn of the camera in space about an axis, counter-clockwise seen from its tip. The axis goes through the
// pivot, or through the target of the camera where there is none.
struct CameraTurn {
    double degrees = 0;
    ifs::Vector<3> axis = ifs::Vector<3>::UnitY(); // unit length
    std::optional<ifs::Vector<3>> pivot{};

    friend bool operator==(const CameraTurn&, const CameraTurn&) = default;
};

// The camera after one turn, or after several in their order.
attractor::OrbitCamera orbited(attractor::OrbitCamera camera, const CameraTurn& turn);
attractor::OrbitCamera orbited(attractor::OrbitCamera camera, std::span<const CameraTurn> turns);
// The camera before these turns.
attractor::OrbitCamera orbitedBack(attractor::OrbitCamera camera, std::span<const CameraTurn> turns);

// The motion that takes a camera, and what it sees, through turns that all have a pivot; nullopt where one
// goes about the target.
std::optional<ifs::AffineMap<3>> motionOf(std::span<const CameraTurn> turns);

} // namespace animation
