// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"

namespace attractor {

// Ways to move a camera in space. Angles in degrees.

// The axis that is vertical while the view turns. With z up, as in CAD programs, azimuth 0 looks along y.
enum class UpAxis { Y, Z };
// The rotation from directions with y up to those with this axis up.
Orientation standing(UpAxis up);

// The direction from which a camera looks, regardless of its roll.
struct Direction {
    double azimuth = 0;
    double elevation = 0;
};
Direction directionOf(const OrbitCamera& camera, UpAxis up = UpAxis::Y);

// Turntable: turned about the vertical axis through the pivot, then up or down about its own axis to the
// right, the pivot staying at its pixel. A positive azimuth moves the eye to the right, a positive elevation
// up, never past the pole.
OrbitCamera orbited(OrbitCamera camera, const ifs::Vector<3>& pivot, double azimuth, double elevation,
                    UpAxis up = UpAxis::Y);

// Trackball: turned about axes of the screen, over the poles as well. The eye moves to the right and upwards
// by that many degrees together.
OrbitCamera tumbled(OrbitCamera camera, const ifs::Vector<3>& pivot, double right, double upwards);

// Looking at the same target from there.
OrbitCamera turnedTo(OrbitCamera camera, double azimuth, double elevation, UpAxis up = UpAxis::Y);

// The same view of a world that stands otherwise.
OrbitCamera stoodUp(OrbitCamera camera, UpAxis from, UpAxis to);

// Pans so that the point of the target's plane seen at a pixel is seen at pixel + delta.
OrbitCamera panned(OrbitCamera camera, const ifs::Vector<2>& delta);

// Zooms by `factor`; the point of the target's plane seen at the pixel stays there.
OrbitCamera zoomedAt(OrbitCamera camera, const ifs::Vector<2>& pixel, double factor);

// The same view with the target in the depth of `point` and in the middle.
OrbitCamera centredOn(OrbitCamera camera, const ifs::Vector<3>& point);

// The line of sight through a pixel: origin + t·direction, a unit vector away from the eye.
struct Ray {
    ifs::Vector<3> origin = ifs::Vector<3>::Zero();
    ifs::Vector<3> direction = ifs::Vector<3>::UnitZ();
};
Ray rayThrough(const OrbitCamera& camera, const ifs::Vector<2>& pixel);

} // namespace attractor
