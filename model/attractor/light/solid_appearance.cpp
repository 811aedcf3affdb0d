// SPDX-License-Identifier: MIT
#include "attractor/light/solid_appearance.h"

namespace attractor {

namespace {

ViewVector viewVector(const ifs::Vector<3>& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

} // namespace

ViewVector lampAt(double azimuth, double elevation) {
    return viewVector(orbit(azimuth, elevation) * ifs::Vector<3>::UnitZ());
}

SolidAppearance appearanceOf(Look look) {
    SolidAppearance result;
    result.look = look;
    if (look == Look::Ink) {
        result.plain = {24, 26, 32, 255};
        result.background = {255, 255, 255, 255};
    }
    if (look == Look::Depth) result.background = {0, 0, 0, 255};
    if (look == Look::Normals) result.background = {0, 0, 0, 0};
    return result;
}

SolidView solidView(const OrbitCamera& camera, double lowest, double highest) {
    SolidView view;
    view.unitsPerPixel = 1 / pixelsPerUnit(camera);
    view.upward = viewVector(camera.orientation.conjugate() * ifs::Vector<3>::UnitY());
    if (camera.projection == OrbitCamera::Projection::Perspective) view.eyeDistance = eyeDistance(camera);
    view.lowest = lowest - camera.target.y();
    view.highest = highest - camera.target.y();
    return view;
}

} // namespace attractor
