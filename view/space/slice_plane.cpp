// SPDX-License-Identifier: MIT
#include "space/slice_plane.h"

#include "attractor/request/orbit_navigation.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Sin 8°, below which a line of sight hardly determines the position along the line.
constexpr double minSine = 0.14;

// Parameter on the line through the centre at which the line of sight through a pixel comes closest.
double closest(const attractor::OrbitCamera& camera, const SlicePlane& plane, const ifs::Vector<2>& pixel) {
    const attractor::Ray ray = rayThrough(camera, pixel);
    const ifs::Vector<3> between = plane.centre - ray.origin;
    const double along = plane.normal.dot(ray.direction);
    const double sine2 = 1 - along * along;
    return (along * ray.direction.dot(between) - plane.normal.dot(between)) / sine2;
}

} // namespace

SlicePlane slicePlane(const attractor::SpaceClip& clip, const std::vector<ifs::Vector<3>>& around) {
    ifs::Vector<3> middle = ifs::Vector<3>::Zero();
    for (const ifs::Vector<3>& point : around)
        middle += point / double(around.size());
    double reach = 0;
    for (const ifs::Vector<3>& point : around)
        reach = std::max(reach, (point - middle).norm());
    SlicePlane plane;
    const double length = clip.normal.norm();
    plane.normal = clip.normal / length;
    const bool isSlice = std::isfinite(clip.lowest) && std::isfinite(clip.highest);
    const double offset = isSlice                      ? (clip.lowest + clip.highest) / 2
                          : std::isfinite(clip.lowest) ? clip.lowest
                                                       : clip.highest;
    plane.centre = middle + plane.normal * (offset / length - plane.normal.dot(middle));
    int least = 0; // axis farthest from the normal
    plane.normal.cwiseAbs().minCoeff(&least);
    const ifs::Vector<3> side = plane.normal.cross(ifs::Vector<3>::Unit(least)).normalized() * reach;
    const ifs::Vector<3> other = plane.normal.cross(side);
    plane.corners = {plane.centre + side + other, plane.centre - side + other, plane.centre - side - other,
                     plane.centre + side - other};
    return plane;
}

attractor::SpaceClip slid(attractor::SpaceClip clip, double distance) {
    const double by = distance * clip.normal.norm();
    clip.lowest += by;
    clip.highest += by;
    return clip;
}

double slideBetween(const attractor::OrbitCamera& camera, const SlicePlane& plane, const ifs::Vector<2>& from,
                    const ifs::Vector<2>& to) {
    const ifs::Vector<3> towardsEye = camera.orientation * ifs::Vector<3>::UnitZ();
    const double along = plane.normal.dot(towardsEye);
    if (1 - along * along < minSine * minSine)
        return (to.y() - from.y()) / pixelsPerUnit(camera) * (along < 0 ? -1 : 1);
    return closest(camera, plane, to) - closest(camera, plane, from);
}

} // namespace view
