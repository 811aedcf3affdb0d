// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "ifs/extent/support_function.h"

#include <Eigen/Geometry>

#include <functional>

namespace attractor {

// Turns coordinates of the camera (right, up, towards the eye) into those of the world. A unit quaternion.
using Orientation = Eigen::Quaternion<double, Eigen::DontAlign>;

// A camera that looks at a target in space, y up. A value; pixel (0, 0) is the top left corner of the top
// left pixel. docs/mathematics.md, "Camera in space".
struct OrbitCamera {
    enum class Projection { Orthographic, Perspective };

    ifs::Vector<3> target = ifs::Vector<3>::Zero(); // centre of the picture
    Orientation orientation = Orientation::Identity();
    double height = 1; // > 0, world units from the lower to the upper edge, in the plane of the target
    Projection projection = Projection::Orthographic;
    double fieldOfView = 40; // degrees between the lower and the upper edge, in (0, 180)
    RasterSize size;

    friend bool operator==(const OrbitCamera& a, const OrbitCamera& b) {
        return a.target == b.target && a.orientation.coeffs() == b.orientation.coeffs() &&
               a.height == b.height && a.projection == b.projection && a.fieldOfView == b.fieldOfView &&
               a.size == b.size;
    }
};

// Degrees: azimuth from +z towards +x, elevation upwards, roll turns the camera clockwise. The same bits on
// every machine.
Orientation orbit(double azimuth, double elevation, double roll = 0);

bool isUsable(const OrbitCamera& camera); // true if there are pixels and all numbers are in range

// The distance of the eye from the target: height/(2 tan(fieldOfView/2)). For an orthographic camera, that of
// the perspective one which shows the plane of the target alike.
double eyeDistance(const OrbitCamera& camera);
double pixelsPerUnit(const OrbitCamera& camera); // pixels per world unit in the plane of the target

// World → (to the right, upwards, away from the eye), 0 at the target, in world units.
ifs::AffineMap<3> worldToCamera(const OrbitCamera& camera);

struct ScreenPoint {
    ifs::Vector<2> pixel;
    double depth = 0; // world units along the view away from the eye; 0 in the plane of the target
};
// Points behind the eye of a perspective camera have no finite pixel.
ScreenPoint toScreen(const OrbitCamera& camera, const ifs::Vector<3>& world);
// The world point seen at a pixel in a depth; toScreen()'s inverse.
ifs::Vector<3> toWorld(const OrbitCamera& camera, const ScreenPoint& point);

// The support function max over x of ⟨u, x⟩ of what a camera is to show.
using Support = std::function<double(const ifs::Vector<3>& u)>;

// The camera of the same size and orientation that shows the silhouette as large as leaves a margin of
// `margin` times the picture, the target in its middle. What has no extent is shown at a scale of its own.
OrbitCamera fitted(OrbitCamera camera, const Support& support, double margin = 0.05);
// The same around the image of an attractor: certified, because every value includes its error.
OrbitCamera fitted(const OrbitCamera& camera, const ifs::SupportFunction<3>& attractor,
                   const ifs::AffineMap<3>& placement, double margin = 0.05);
OrbitCamera fitted(const OrbitCamera& camera, const ifs::Vector<3>& min, const ifs::Vector<3>& max,
                   double margin = 0.05);

} // namespace attractor
