// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/orbit_camera.h"

#include <type_traits>

namespace animation {

// What a key of the camera holds; in space, the raster's size means nothing.
template <int Dim> using CameraPose = std::conditional_t<Dim == 2, attractor::View, attractor::OrbitCamera>;

// Between two views, exact at both ends. The visible height h grows by a constant factor, and what is in the
// middle moves in proportion to it: with r = h₁/h₀ the share of the way is (rᵘ − 1)/(r − 1), and u where
// r = 1. So a point seen at both ends moves evenly over the picture. The plane turns evenly, the shorter way;
// in space the orientation takes the shorter great circle. docs/mathematics.md, "Animation".
attractor::View between(const attractor::View& from, const attractor::View& to, double share);
attractor::OrbitCamera between(const attractor::OrbitCamera& from, const attractor::OrbitCamera& to,
                               double share);

// The shorter way from one rotation of the plane to another, at most half a turn either way.
double turnBetween(double from, double to);

// The camera gone round its target about the vertical axis, counter-clockwise seen from above, in degrees.
attractor::OrbitCamera orbited(attractor::OrbitCamera camera, double degrees);

} // namespace animation
