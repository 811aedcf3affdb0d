// SPDX-License-Identifier: MIT
#include "space/spatial_drag.h"

#include "attractor/request/orbit_navigation.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace view {

namespace {

using attractor::OrbitCamera;
using ifs::Vector;

// Below this angle between an axis and the line of sight, or a plane and the line of sight, a pixel would be
// a leap.
const double minSlope = std::sin(8 * std::numbers::pi / 180);

// Lengths in pixels: a rotation or scaling pressed nearer to its middle than `minLever` acts as if it were
// held at `lever`.
constexpr double minLever = 20, lever = 80;

Vector<3> awayFromEye(const OrbitCamera& camera) {
    return -camera.orientation.toRotationMatrix().col(2);
}

// Moves in the plane through `start` that is parallel to the screen.
Vector<3> acrossView(const OrbitCamera& camera, const Vector<3>& start, const Vector<2>& motion) {
    if (motion.isZero(0)) return start; // bit for bit
    attractor::ScreenPoint seen = toScreen(camera, start);
    const Vector<3> from = toWorld(camera, seen);
    seen.pixel += motion;
    return start + (toWorld(camera, seen) - from);
}

// Motion of a point on the screen, in pixels, when it moves by 1 along a direction.
Vector<2> onScreen(const OrbitCamera& camera, const Vector<3>& at, const Vector<3>& direction) {
    const double little = 1e-6 * camera.height;
    return (toScreen(camera, at + little * direction).pixel -
            toScreen(camera, at - little * direction).pixel) /
           (2 * little);
}

// The line of sight through the point once it has followed the pointer.
attractor::Ray sight(const OrbitCamera& camera, const Vector<3>& start, const Vector<2>& motion) {
    return rayThrough(camera, toScreen(camera, start).pixel + motion);
}

// Moves along an axis in one of two ways, chosen where the drag began, so that the point never jumps.
Vector<3> alongAxis(const OrbitCamera& camera, const Vector<3>& start, const Vector<2>& motion,
                    const Vector<3>& direction) {
    const Vector<3> pressed = sight(camera, start, Vector<2>::Zero()).direction;
    if (direction.cross(pressed).norm() < minSlope) {
        const Vector<2> shown = onScreen(camera, start, direction);
        const double scale = pixelsPerUnit(camera);
        if (!(shown.norm() > 1e-9 * scale)) return start; // seen as a point
        return start + motion.dot(shown) / (shown.norm() * scale) * direction;
    }
    const attractor::Ray ray = sight(camera, start, motion);
    const Vector<3> normal = direction.cross(ray.direction);
    const double square = normal.squaredNorm();
    if (!(square > 0)) return start;
    return start + (ray.origin - start).cross(ray.direction).dot(normal) / square * direction;
}

Vector<3> inPlane(const OrbitCamera& camera, const Vector<3>& start, const Vector<2>& motion, int axis) {
    const Vector<3> normal = Vector<3>::Unit(axis);
    const attractor::Ray ray = sight(camera, start, motion);
    const double sine = ray.direction.dot(normal);
    if (std::abs(sight(camera, start, Vector<2>::Zero()).direction.dot(normal)) < minSlope ||
        std::abs(sine) < minSlope / 2) { // seen from its edge
        Vector<3> moved = acrossView(camera, start, motion);
        moved[axis] = start[axis];
        return moved;
    }
    Vector<3> moved = ray.origin + (start - ray.origin).dot(normal) / sine * ray.direction;
    moved[axis] = start[axis];
    return moved;
}

Vector<3> moved(const SpatialDrag& drag, const Pull& pull, const AxisLock& lock) {
    const Vector<3>& start = drag.vertices[drag.held];
    const Vector<2> motion = pull.pointer - drag.press;
    Vector<3> push = pull.away * awayFromEye(drag.camera);
    const auto along = [&](const Vector<3>& direction) {
        const Vector<3> pushed = start + push.dot(direction) * direction;
        if (motion.isZero(0)) return pushed;
        return Vector<3>(pushed + (alongAxis(drag.camera, start, motion, direction) - start));
    };
    switch (lock.kind) {
    case AxisLock::Kind::View:
        return acrossView(drag.camera, start, motion) + push;
    case AxisLock::Kind::Axis:
        return along(Vector<3>::Unit(lock.axis));
    case AxisLock::Kind::Normal:
        return along(drag.normal);
    case AxisLock::Kind::Plane:
        push[lock.axis] = 0;
        return push + (motion.isZero(0) ? start : inPlane(drag.camera, start, motion, lock.axis));
    }
    return start;
}

Vector<3> middleOf(const std::vector<Vector<3>>& points) {
    Vector<3> sum = Vector<3>::Zero();
    for (const Vector<3>& point : points)
        sum += point;
    return sum / double(points.size());
}

} // namespace

SpatialDrag faceDrag(std::vector<Vector<3>> vertices, const std::vector<int>& corners) {
    SpatialDrag drag;
    drag.vertices = std::move(vertices);
    drag.together = corners;
    drag.held = drag.vertices.size();
    Vector<3> middle = Vector<3>::Zero();
    for (const int corner : corners)
        middle += drag.vertices[std::size_t(corner)] / double(corners.size());
    Vector<3> normal = Vector<3>::Zero(); // mean normal, for faces that are not plane
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto spoke = [&](std::size_t i) {
            return Vector<3>(drag.vertices[std::size_t(corners[i % corners.size()])] - middle);
        };
        normal += spoke(k).cross(spoke(k + 1));
    }
    if (normal.norm() > 0) drag.normal = normal.normalized();
    drag.vertices.push_back(middle);
    return drag;
}

std::vector<Vector<3>> dragged(const SpatialDrag& drag, const Pull& pull, const AxisLock& lock) {
    std::vector<Vector<3>> result = drag.vertices;
    if (drag.mode == SpatialDrag::Mode::Move) {
        result[drag.held] = moved(drag, pull, lock);
        const Vector<3> offset = result[drag.held] - drag.vertices[drag.held];
        for (const int vertex : drag.together)
            result[std::size_t(vertex)] += offset;
        return result;
    }
    if (pull.pointer == drag.press) return result;
    const Vector<3> middle = middleOf(drag.vertices);
    Vector<2> centre = toScreen(drag.camera, middle).pixel;
    // Limits the effect of a pixel.
    if ((drag.press - centre).norm() < minLever) centre.x() = drag.press.x() - lever;
    const auto spoke = [&](const Vector<2>& pixel) {
        return std::complex<double>(pixel.x() - centre.x(), centre.y() - pixel.y()); // y up
    };
    const std::complex<double> from = spoke(drag.press);
    const std::complex<double> change = spoke(pull.pointer) / from;
    const ifs::Matrix<3> linear =
        drag.mode == SpatialDrag::Mode::Scale
            ? ifs::Matrix<3>(ifs::Matrix<3>::Identity() * std::abs(change))
            : Eigen::AngleAxisd(std::arg(change), -awayFromEye(drag.camera)).toRotationMatrix();
    for (Vector<3>& vertex : result)
        vertex = middle + linear * (vertex - middle);
    return result;
}

std::optional<int> nearestAxis(const OrbitCamera& camera, const Vector<3>& at, const Vector<2>& motion) {
    std::optional<int> nearest;
    double best = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector<2> shown = onScreen(camera, at, Vector<3>::Unit(axis));
        const double length = shown.norm();
        if (!(length > 1e-9 * pixelsPerUnit(camera))) continue;
        const double along = std::abs(motion.dot(shown)) / length;
        if (along > best) {
            best = along;
            nearest = axis;
        }
    }
    return nearest;
}

} // namespace view
