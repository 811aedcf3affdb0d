// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_camera.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

using ifs::Vector;

double halfTangent(const OrbitCamera& camera) {
    return sineOfDegrees(camera.fieldOfView / 2) / cosineOfDegrees(camera.fieldOfView / 2);
}

double aspect(const OrbitCamera& camera) {
    return static_cast<double>(camera.size.width) / camera.size.height;
}

// Extent of a set along two opposite normals of the pyramid or the box of view.
struct Span {
    double high = 0; // h(u)
    double low = 0;  // h(−u)
    double middle() const { return (high - low) / 2; }
    double half() const { return (high + low) / 2; }
};

Span spanOf(const Support& support, const Vector<3>& u, const Vector<3>& tilt) {
    return {support(tilt + u), support(tilt - u)};
}

} // namespace

Orientation orbit(double azimuth, double elevation, double roll) {
    const auto about = [](double angle, const Vector<3>& axis) {
        const Vector<3> part = sineOfDegrees(angle / 2) * axis;
        return Orientation(cosineOfDegrees(angle / 2), part.x(), part.y(), part.z());
    };
    return about(azimuth, Vector<3>::UnitY()) * about(-elevation, Vector<3>::UnitX()) *
           about(-roll, Vector<3>::UnitZ());
}

bool isUsable(const OrbitCamera& camera) {
    const double length = camera.orientation.squaredNorm();
    return camera.size.width > 0 && camera.size.height > 0 && camera.target.allFinite() &&
           camera.height > 0 && std::isfinite(camera.height) && std::isfinite(pixelsPerUnit(camera)) &&
           camera.fieldOfView > 0 && camera.fieldOfView < 180 && std::abs(length - 1) < 1e-6;
}

double eyeDistance(const OrbitCamera& camera) {
    return camera.height / (2 * halfTangent(camera));
}

double pixelsPerUnit(const OrbitCamera& camera) {
    return camera.size.height / camera.height;
}

ifs::AffineMap<3> worldToCamera(const OrbitCamera& camera) {
    const ifs::Matrix<3> axes = camera.orientation.toRotationMatrix();
    ifs::AffineMap<3> result;
    result.linear.row(0) = axes.col(0).transpose();
    result.linear.row(1) = axes.col(1).transpose();
    result.linear.row(2) = -axes.col(2).transpose();
    result.translation = -(result.linear * camera.target);
    return result;
}

ScreenPoint toScreen(const OrbitCamera& camera, const Vector<3>& world) {
    const Vector<3> seen = worldToCamera(camera).linear * (world - camera.target);
    double scale = pixelsPerUnit(camera);
    if (camera.projection == OrbitCamera::Projection::Perspective) {
        const double distance = eyeDistance(camera);
        const double away = distance + seen.z();
        scale = away > 0 ? scale * distance / away : HUGE_VAL;
    }
    return {{camera.size.width / 2.0 + scale * seen.x(), camera.size.height / 2.0 - scale * seen.y()},
            seen.z()};
}

Vector<3> toWorld(const OrbitCamera& camera, const ScreenPoint& point) {
    double unit = 1 / pixelsPerUnit(camera);
    if (camera.projection == OrbitCamera::Projection::Perspective) {
        const double distance = eyeDistance(camera);
        unit *= (distance + point.depth) / distance;
    }
    const Vector<3> seen((point.pixel.x() - camera.size.width / 2.0) * unit,
                         (camera.size.height / 2.0 - point.pixel.y()) * unit, point.depth);
    return camera.target + worldToCamera(camera).linear.transpose() * seen;
}

OrbitCamera fitted(OrbitCamera camera, const Support& support, double margin) {
    const ifs::Matrix<3> axes = camera.orientation.toRotationMatrix();
    const Vector<3> right = axes.col(0);
    const Vector<3> up = axes.col(1);
    const Vector<3> back = axes.col(2);
    const double room = 1 - 2 * margin;
    const Span depth = spanOf(support, back, Vector<3>::Zero());
    // Seen from far away, then in the projection of the camera: with the eye at (x, y, z), the set lies in
    // the pyramid |X − x| ≤ t (z − Z), so that h(±right + t·back) ≤ ±x + t·z.
    const Span across = spanOf(support, right, Vector<3>::Zero());
    const Span along = spanOf(support, up, Vector<3>::Zero());
    Vector<3> middle(across.middle(), along.middle(), depth.middle());
    double height = 2 * std::max(along.half(), across.half() / aspect(camera)) / room;
    const double size = std::max({std::abs(middle.x()), std::abs(middle.y()), std::abs(middle.z())});
    if (camera.projection == OrbitCamera::Projection::Perspective && height > 1e-12 * size) {
        const double tangent = halfTangent(camera);
        const double y = room * tangent;
        const double x = y * aspect(camera);
        const Span wide = spanOf(support, right, x * back);
        const Span high = spanOf(support, up, y * back);
        const double eye = std::max(wide.half() / x, high.half() / y);
        middle = {wide.middle(), high.middle(), depth.middle()};
        height = 2 * tangent * (eye - middle.z());
    }
    if (!middle.allFinite()) return camera;
    camera.target = axes * middle;
    // Single point up to rounding: magnified, it would lie outside the picture.
    if (height > 1e-12 * size && std::isfinite(height)) camera.height = height;
    return camera;
}

OrbitCamera fitted(const OrbitCamera& camera, const ifs::SupportFunction<3>& attractor,
                   const ifs::AffineMap<3>& placement, double margin) {
    constexpr double fine = 1e-4; // relative tolerance
    const double tolerance = fine * attractor.radius();
    const auto support = [&](const Vector<3>& u) {
        const Vector<3> inner = placement.linear.transpose() * u;
        const auto value = attractor(inner, tolerance * inner.norm(), 20'000);
        return value.value + value.error + u.dot(placement.translation);
    };
    return fitted(camera, support, margin);
}

OrbitCamera fitted(const OrbitCamera& camera, const Vector<3>& min, const Vector<3>& max, double margin) {
    const auto support = [&](const Vector<3>& u) {
        return std::max(u.x() * min.x(), u.x() * max.x()) + std::max(u.y() * min.y(), u.y() * max.y()) +
               std::max(u.z() * min.z(), u.z() * max.z());
    };
    return fitted(camera, support, margin);
}

} // namespace attractor
