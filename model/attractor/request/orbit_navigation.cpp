// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace attractor {

namespace {

constexpr double degree = std::numbers::pi / 180;

ifs::Vector<3> towardsEye(const OrbitCamera& camera) {
    return camera.orientation.toRotationMatrix().col(2);
}

double elevationOf(const OrbitCamera& camera, UpAxis up) {
    const ifs::Vector<3> eye = towardsEye(camera);
    return std::asin(std::clamp(up == UpAxis::Y ? eye.y() : eye.z(), -1.0, 1.0)) / degree;
}

// About the pivot.
OrbitCamera withOrientation(OrbitCamera camera, const Orientation& orientation, const ifs::Vector<3>& pivot) {
    const Orientation turn = orientation * camera.orientation.conjugate();
    camera.orientation = orientation;
    camera.target = pivot + turn * (camera.target - pivot);
    return camera;
}

} // namespace

Orientation standing(UpAxis up) {
    return up == UpAxis::Y ? Orientation(1, 0, 0, 0) : orbit(0, -90); // rotation from y to z and z to −y
}

Direction directionOf(const OrbitCamera& camera, UpAxis up) {
    const ifs::Vector<3> eye = standing(up).conjugate() * towardsEye(camera);
    const double across = std::hypot(eye.x(), eye.z());
    // Azimuth from the direction of the upper edge, for views along the pole.
    const ifs::Vector<3> above = standing(up).conjugate() * camera.orientation.toRotationMatrix().col(1);
    const ifs::Vector<3> ahead = across > 1e-9 ? eye : eye.y() > 0 ? ifs::Vector<3>(-above) : above;
    return {std::atan2(ahead.x(), ahead.z()) / degree, std::atan2(eye.y(), across) / degree};
}

OrbitCamera orbited(OrbitCamera camera, const ifs::Vector<3>& pivot, double azimuth, double elevation,
                    UpAxis up) {
    const double present = elevationOf(camera, up);
    const double change = std::clamp(present + elevation, -90.0, 90.0) - present;
    Orientation about = orbit(azimuth, 0);
    if (up != UpAxis::Y) about = standing(up) * about * standing(up).conjugate();
    return withOrientation(camera, (about * camera.orientation * orbit(0, change)).normalized(), pivot);
}

OrbitCamera tumbled(OrbitCamera camera, const ifs::Vector<3>& pivot, double right, double upwards) {
    const double angle = std::hypot(right, upwards);
    if (!(angle > 0)) return camera;
    const ifs::Vector<3> axis = sineOfDegrees(angle / 2) / angle * ifs::Vector<3>(-upwards, right, 0);
    const Orientation turn(cosineOfDegrees(angle / 2), axis.x(), axis.y(), axis.z());
    return withOrientation(camera, (camera.orientation * turn).normalized(), pivot);
}

OrbitCamera turnedTo(OrbitCamera camera, double azimuth, double elevation, UpAxis up) {
    camera.orientation = orbit(azimuth, elevation);
    if (up != UpAxis::Y) camera.orientation = (standing(up) * camera.orientation).normalized();
    return camera;
}

OrbitCamera stoodUp(OrbitCamera camera, UpAxis from, UpAxis to) {
    if (from != to)
        camera.orientation = (standing(to) * standing(from).conjugate() * camera.orientation).normalized();
    return camera;
}

OrbitCamera panned(OrbitCamera camera, const ifs::Vector<2>& delta) {
    const ifs::Vector<2> middle(camera.size.width / 2.0, camera.size.height / 2.0);
    camera.target = toWorld(camera, {middle - delta, 0});
    return camera;
}

OrbitCamera zoomedAt(OrbitCamera camera, const ifs::Vector<2>& pixel, double factor) {
    const ifs::Vector<3> fixed = toWorld(camera, {pixel, 0});
    OrbitCamera zoomed = camera;
    zoomed.height = camera.height / factor;
    zoomed.target = fixed + (camera.target - fixed) / factor;
    return isUsable(zoomed) ? zoomed : camera;
}

OrbitCamera centredOn(OrbitCamera camera, const ifs::Vector<3>& point) {
    if (camera.projection == OrbitCamera::Projection::Perspective) {
        // New height for the fixed eye: the plane of the target has moved.
        const double distance = eyeDistance(camera);
        const double away = distance + toScreen(camera, point).depth;
        if (away > 0) camera.height *= away / distance;
    }
    camera.target = point;
    return camera;
}

Ray rayThrough(const OrbitCamera& camera, const ifs::Vector<2>& pixel) {
    const ifs::Vector<3> seen = toWorld(camera, {pixel, 0});
    if (camera.projection == OrbitCamera::Projection::Orthographic) return {seen, -towardsEye(camera)};
    const ifs::Vector<3> eye = camera.target + eyeDistance(camera) * towardsEye(camera);
    return {eye, (seen - eye).normalized()};
}

} // namespace attractor
