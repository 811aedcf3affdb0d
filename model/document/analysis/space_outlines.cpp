// SPDX-License-Identifier: MIT
#include "document/analysis/space_outlines.h"

#include "document/fractal/space_geometry.h"
#include "ifs/extent/convex_hull_3d.h"
#include "ifs/linear/symmetric_matrices.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace document {

namespace {

using Points = std::vector<ifs::Vector<3>>;

constexpr std::size_t maxOutlines = 1024;
constexpr double hullTolerance = 5e-3;     // share of the attractor's radius; not visible
constexpr double cylinderTolerance = 3e-2; // coarser, because cylinders are many and small

// The edges of the hull of a support function, none where two facets lie in one plane.
SpaceOutline hullOf(const ifs::SupportFunction<3>& support, double tolerance,
                    const ifs::AffineMap<3>& placed) {
    const ifs::ConvexHull3 hull = ifs::convexHull(support, tolerance * support.radius());
    SpaceOutline shape{Outline::Hull, {}, {}, {}};
    for (const ifs::Vector<3>& vertex : hull.vertices)
        shape.points.push_back(placed(vertex));
    std::map<std::pair<int, int>, ifs::Vector<3>> normals; // normal of the facet to the left of each edge
    for (const auto& facet : hull.facets) {
        const ifs::Vector<3>& first = hull.vertices[std::size_t(facet[0])];
        const ifs::Vector<3> normal = (hull.vertices[std::size_t(facet[1])] - first)
                                          .cross(hull.vertices[std::size_t(facet[2])] - first)
                                          .normalized();
        for (std::size_t k = 0; k < 3; ++k)
            normals[{facet[k], facet[(k + 1) % 3]}] = normal;
    }
    constexpr double inOnePlane = 1 - 1e-5; // cosine of the angle between normals
    for (const auto& [edge, normal] : normals) {
        const auto other = normals.find({edge.second, edge.first});
        const bool isOpen = other == normals.end();
        if (isOpen || (edge.first < edge.second && normal.dot(other->second) < inOnePlane))
            shape.edges.push_back({edge.first, edge.second});
    }
    return shape;
}

SpaceOutline box(const ifs::BoundingBox<3>& found) {
    SpaceOutline shape{Outline::Box, {}, {}, {}};
    for (int k = 0; k < 8; ++k)
        shape.points.push_back({(k & 1) != 0 ? found.max.x() : found.min.x(),
                                (k & 2) != 0 ? found.max.y() : found.min.y(),
                                (k & 4) != 0 ? found.max.z() : found.min.z()});
    for (int k = 0; k < 8; ++k)
        for (const int axis : {1, 2, 4})
            if ((k & axis) == 0) shape.edges.push_back({k, k | axis});
    return shape;
}

SpaceOutline tetrahedron(const ifs::CanonicalSimplex<3>& simplex) {
    SpaceOutline shape{Outline::Simplex, {simplex.vertices.begin(), simplex.vertices.end()}, {}, {}};
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b)
            shape.edges.push_back({a, b});
    return shape;
}

// The ellipsoid in which an even mass has the same mean and covariance, by its three principal ellipses:
// {x : (x − m)ᵀ C⁻¹ (x − m) = 5}.
SpaceOutline ellipsoid(const ifs::Moments<3>& moments) {
    constexpr int corners = 72;
    const auto [values, axes] = ifs::symmetricEigenvalues<3>(moments.covariance);
    const ifs::Matrix<3> shape = std::sqrt(5.0) * axes * values.cwiseMax(0).cwiseSqrt().asDiagonal();
    SpaceOutline result{Outline::Ellipse, {}, {}, {}};
    for (int across = 0; across < 3; ++across)
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners;
            ifs::Vector<3> at = ifs::Vector<3>::Zero();
            at[(across + 1) % 3] = std::cos(angle);
            at[(across + 2) % 3] = std::sin(angle);
            const int first = across * corners;
            result.points.emplace_back(moments.mean + shape * at);
            result.edges.push_back({first + k, first + (k + 1) % corners});
        }
    return result;
}

// The images of the hull under all words of one length, at most so long that there are few enough to see.
void addCylinders(std::vector<SpaceOutline>& shapes, const SpaceFacts& facts, int depth,
                  const std::vector<attractor::Rgba>& colours) {
    const auto& maps = facts.displayed.active.maps;
    if (!facts.code.support || maps.empty()) return;
    std::vector<SpaceOutline> level{hullOf(*facts.code.support, cylinderTolerance, facts.placed)};
    level.front().kind = Outline::Cylinders;
    for (int k = 0; k < depth && level.size() * maps.size() <= maxOutlines; ++k) {
        std::vector<SpaceOutline> next;
        for (std::size_t i = 0; i < maps.size(); ++i)
            for (const SpaceOutline& shorter : level) {
                SpaceOutline shape{
                    Outline::Cylinders, {}, shorter.edges, colours[facts.displayed.active.index[i]]};
                for (const ifs::Vector<3>& corner : shorter.points)
                    shape.points.push_back(maps[i](corner));
                next.push_back(std::move(shape));
            }
        level = std::move(next);
    }
    shapes.insert(shapes.end(), level.begin(), level.end());
}

} // namespace

std::vector<SpaceOutline> spaceOutlines(const SpaceFacts& facts, const Fractal& fractal,
                                        const std::set<Outline>& outlines, int cylinderDepth) {
    const auto wants = [&](Outline kind) { return outlines.contains(kind); };
    std::vector<attractor::Rgba> colours;
    const System3& system = *system3(fractal);
    for (std::size_t k = 0; k < system.maps.size(); ++k)
        colours.push_back(attractor::mapColour(fractal.appearance, system.maps[k].id, k));
    const ifs::Facts<3>& displayed = facts.displayed;
    std::vector<SpaceOutline> shapes;
    if (wants(Outline::Cylinders)) addCylinders(shapes, facts, cylinderDepth, colours);
    if (wants(Outline::Box) && displayed.box) shapes.push_back(box(*displayed.box));
    if (wants(Outline::Simplex) && displayed.simplex) shapes.push_back(tetrahedron(*displayed.simplex));
    if (wants(Outline::Hull) && facts.code.support)
        shapes.push_back(hullOf(*facts.code.support, hullTolerance, facts.placed));
    if (wants(Outline::Ellipse) && displayed.moments) {
        shapes.push_back(ellipsoid(*displayed.moments));
        shapes.push_back({Outline::Ellipse, {displayed.moments->mean}, {}, {}});
    }
    if (wants(Outline::FixedPoints))
        for (std::size_t k = 0; k < displayed.active.maps.size(); ++k)
            if (const auto fixed = ifs::fixedPoint(displayed.active.maps[k]))
                shapes.push_back({Outline::FixedPoints, {*fixed}, {}, colours[displayed.active.index[k]]});
    return shapes;
}

std::optional<SpaceOutline> hullOutline(const Fractal& fractal) {
    const auto support = spaceSupport(fractal);
    const auto cage = support ? spaceCage(fractal) : std::nullopt;
    if (!cage || ifs::bends(*cage)) return std::nullopt;
    return hullOf(*support, hullTolerance, ifs::displayMap(*cage));
}

} // namespace document
