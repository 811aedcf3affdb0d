// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/mean_value_coordinates.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

// Cages of more than four vertices in space. docs/mathematics.md, "Generalized coordinates".
namespace ifs {

constexpr std::size_t maxSpaceCorners = 64;

// The surface of a convex polyhedron: the corners of every face, counter-clockwise seen from outside. Faces
// are whole: a cube has six.
struct CageSurface {
    std::vector<std::vector<int>> faces;

    std::vector<std::array<int, 2>> edges() const; // each edge once, smaller index first
};
// nullopt unless the points are the corners of a convex polyhedron, 4 to 64 of them, by 1e-9 of its size.
std::optional<CageSurface> convexSurface(std::span<const Vector<3>> vertices);

// Mean value coordinates with respect to a convex polyhedron. A face of more than three corners has one more
// vertex at their mean, whose weight goes back to them in equal shares; so what the polyhedron is symmetric
// under, the coordinates are, too.
class CageCoordinates {
public:
    explicit CageCoordinates(std::span<const Vector<3>> vertices); // requires a convexSurface()

    std::size_t size() const { return m_count; } // number of vertices
    std::span<const Vector<3>> vertices() const { return m_surface.vertices().first(m_count); }
    // size() numbers for every point, one after the other; their sum is 1.
    std::vector<double> at(std::span<const Vector<3>> points) const;

private:
    struct Surface {
        std::vector<Vector<3>> corners; // vertices, then the means of faces
        std::vector<std::array<int, 3>> triangles;
        std::vector<std::vector<int>> meanOf; // corners of which each mean is the mean
    };
    static Surface surfaceOf(std::span<const Vector<3>> vertices);
    CageCoordinates(std::size_t count, Surface surface);

    std::size_t m_count = 0;
    std::vector<std::vector<int>> m_meanOf;
    MeanValueCoordinates m_surface;
};

// x ↦ Σ λ_j(x) v_j′: takes the polyhedron v to the vertices v′. Exactly the affine fit when v′ is an affine
// image of v.
class CageDeformation {
public:
    // Both cages must have equally many vertices, and `from` a convexSurface().
    CageDeformation(std::span<const Vector<3>> from, std::span<const Vector<3>> to);
    CageDeformation(std::shared_ptr<const CageCoordinates> from, std::span<const Vector<3>> to);

    std::vector<double> coordinates(const Vector<3>& x) const; // one for each vertex; their sum is 1
    Vector<3> operator()(const Vector<3>& x) const;            // finite for finite x
    const AffineMap<3>& fit() const { return m_fit; }
    const std::shared_ptr<const CageCoordinates>& rest() const { return m_rest; }
    std::span<const Vector<3>> residuals() const { return m_residuals; } // v_j′ − fit(v_j)

private:
    std::shared_ptr<const CageCoordinates> m_rest;
    AffineMap<3> m_fit;
    std::vector<Vector<3>> m_residuals;
};

} // namespace ifs
