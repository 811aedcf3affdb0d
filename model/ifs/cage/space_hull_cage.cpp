// SPDX-License-Identifier: MIT
#include "ifs/cage/space_hull_cage.h"

#include "ifs/cage/cage_surface.h"
#include "ifs/extent/extent.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ifs {

namespace {

struct HalfSpace { // ⟨normal, x⟩ ≤ offset
    Vector<3> normal;
    double offset = 0;
};

struct Polyhedron {
    std::vector<Vector<3>> corners;
    double volume = 0;
};

constexpr double flatSolid = 1e-3; // relative thickness given to flat sets

BoundingBox<3> certifiedBox(const SupportFunction<3>& support, double tolerance) {
    BoundingBox<3> box = boundingBox(support, tolerance);
    const auto known = [&box](double x) { return std::abs(x) <= 2 * box.error ? 0 : x; };
    box.min = (box.min.array() - box.error).unaryExpr(known);
    box.max = (box.max.array() + box.error).unaryExpr(known);
    const double room = std::max(flatSolid * (box.max - box.min).maxCoeff(), 1e-300);
    for (int axis = 0; axis < 3; ++axis)
        if (box.max[axis] - box.min[axis] < room) {
            const double middle = (box.min[axis] + box.max[axis]) / 2;
            box.min[axis] = middle - room / 2;
            box.max[axis] = middle + room / 2;
        }
    return box;
}

double volumeOf(const std::vector<Vector<3>>& corners, const CageSurface& surface) {
    double six = 0;
    for (const std::vector<int>& face : surface.faces) {
        const Vector<3> a = corners[std::size_t(face[0])] - corners[0];
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            six += a.dot((corners[std::size_t(face[k])] - corners[0])
                             .cross(corners[std::size_t(face[k + 1])] - corners[0]));
    }
    return six / 6;
}

// The intersection of the half-spaces, each of whose corners lies on three planes. nullopt where its corners
// lie too close to each other to hold coordinates.
std::optional<Polyhedron> intersection(const std::vector<HalfSpace>& all, double size) {
    const double room = 1e-8 * size;
    Polyhedron result;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            for (std::size_t k = j + 1; k < all.size(); ++k) {
                Matrix<3> normals;
                normals << all[i].normal.transpose(), all[j].normal.transpose(), all[k].normal.transpose();
                if (std::abs(normals.determinant()) < 1e-6) continue;
                const Vector<3> at =
                    normals.inverse() * Vector<3>(all[i].offset, all[j].offset, all[k].offset);
                const bool isInside = std::ranges::all_of(all, [&](const HalfSpace& half) {
                    return half.normal.dot(at) <= half.offset + 1e-9 * size;
                });
                const bool isNew = std::ranges::none_of(
                    result.corners, [&](const Vector<3>& known) { return (known - at).norm() < room; });
                if (isInside && isNew) result.corners.push_back(at);
            }
    const auto surface = convexSurface(result.corners);
    if (!surface) return std::nullopt;
    result.volume = volumeOf(result.corners, *surface);
    return result;
}

} // namespace

std::vector<Vector<3>> boxCage(const SupportFunction<3>& support, double tolerance) {
    const BoundingBox<3> box = certifiedBox(support, tolerance);
    std::vector<Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? box.max.x() : box.min.x(),
                             (k & 2) != 0 ? box.max.y() : box.min.y(),
                             (k & 4) != 0 ? box.max.z() : box.min.z());
    return corners;
}

std::vector<Vector<3>> octahedronCage(const SupportFunction<3>& support, double tolerance) {
    const BoundingBox<3> box = certifiedBox(support, tolerance);
    const Vector<3> middle = (box.min + box.max) / 2;
    double reach = 0;
    for (int k = 0; k < 8; ++k) {
        const Vector<3> across((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
        const auto value = support(across, tolerance);
        reach = std::max(reach, value.value + value.error - across.dot(middle));
    }
    std::vector<Vector<3>> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-reach, reach})
            corners.emplace_back(middle + side * Vector<3>::Unit(axis));
    return corners;
}

std::vector<Vector<3>> hullCage(const SupportFunction<3>& support, int corners, double tolerance) {
    const BoundingBox<3> box = certifiedBox(support, tolerance);
    const double size = (box.max - box.min).norm();
    const Vector<3> middle = (box.min + box.max) / 2;
    std::vector<HalfSpace> halves;
    for (int axis = 0; axis < 3; ++axis) {
        halves.push_back({Vector<3>::Unit(axis), box.max[axis]});
        halves.push_back({-Vector<3>::Unit(axis), -box.min[axis]});
    }
    Polyhedron best{boxCage(support, tolerance), (box.max - box.min).prod()};
    for (bool isSmaller = true; isSmaller;) {
        isSmaller = false;
        HalfSpace cut;
        Polyhedron least = best;
        for (const Vector<3>& corner : best.corners) {
            // Scaled to a cube, so that a long box loses its corners evenly.
            const Vector<3> scaled = (corner - middle).cwiseQuotient(box.max - box.min);
            const Vector<3> normal = scaled.cwiseQuotient(box.max - box.min).normalized();
            const auto reach = support(normal, tolerance);
            std::vector<HalfSpace> more = halves;
            more.push_back({normal, reach.value + reach.error});
            const auto next = intersection(more, size);
            if (!next || int(next->corners.size()) > corners || !(next->volume < 0.999 * least.volume))
                continue;
            least = *next;
            cut = more.back();
            isSmaller = true;
        }
        if (!isSmaller) break;
        halves.push_back(cut);
        best = std::move(least);
    }
    // Enlarged, because corners that were too close have been merged.
    constexpr double larger = 1e-4;
    for (Vector<3>& corner : best.corners)
        corner += larger * (corner - middle);
    return best.corners;
}

} // namespace ifs
