// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace attractor {

namespace {

constexpr double degree = std::numbers::pi / 180;

ifs::Vector<3> towardsEye(const OrbitCamera& camera) {
    return camera.orientation.toRotationMatrix().col(2);
}

double elevationOf(const OrbitCamera& camera) {
    return std::asin(std::clamp(towardsEye(camera).y(), -1.0, 1.0)) / degree;
}

} // namespace

OrbitCamera orbited(OrbitCamera camera, const ifs::Vector<3>& pivot, double azimuth, double elevation) {
    const double present = elevationOf(camera);
    const double change = std::clamp(present + elevation, -90.0, 90.0) - present;
    const Orientation before = camera.orientation;
    camera.orientation = (orbit(azimuth, 0) * before * orbit(0, change)).normalized();
    const Orientation turn = camera.orientation * before.conjugate();
    camera.target = pivot + turn * (camera.target - pivot);
    return camera;
}

OrbitCamera turnedTo(OrbitCamera camera, double azimuth, double elevation) {
    camera.orientation = orbit(azimuth, elevation);
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
        // The eye stays where it is, so what the new plane shows has another height.
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
