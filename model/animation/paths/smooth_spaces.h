// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"

// Spaces of smooth curves in which a step is not a difference of coordinates; the others are Flat.
// docs/mathematics.md, "Smooth ways".
namespace animation {

// Rotations in space, by the shorter way. A step is a rotation vector in the coordinates that are turned.
struct Rotations {
    using Step = ifs::Vector<3>;
    static Step between(const attractor::Orientation& from, const attractor::Orientation& to);
    static attractor::Orientation moved(const attractor::Orientation& from, const Step& step);
};

template <int Dim> struct Framing {
    double height; // height of the view, > 0
    ifs::Vector<Dim> centre;
};

// Framings z ↦ centre + height·z, by what zooms and pans evenly as it is seen: a step holds ln of the factor
// of the height, then the pan in heights of the picture. What the straight path of a camera does is one step.
template <int Dim> struct Framings {
    using Step = Eigen::Matrix<double, Dim + 1, 1>;
    static Step between(const Framing<Dim>& from, const Framing<Dim>& to);
    static Framing<Dim> moved(const Framing<Dim>& from, const Step& step);
};

} // namespace animation
