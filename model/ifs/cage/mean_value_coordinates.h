// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ifs {

// Mean value coordinates in space with respect to a closed surface of triangles whose corners run
// counter-clockwise seen from outside. What an edge contributes is worked out once for both triangles at it.
// docs/mathematics.md, "Generalized coordinates".
class MeanValueCoordinates {
public:
    MeanValueCoordinates(std::span<const Vector<3>> vertices, std::span<const std::array<int, 3>> triangles);

    std::size_t size() const { return m_vertices.size(); }
    std::span<const Vector<3>> vertices() const { return m_vertices; }
    // size() numbers for every point, one after the other; finite, and their sum is 1.
    void at(std::span<const Vector<3>> points, std::span<double> result) const;

private:
    struct Triangle {
        std::array<std::size_t, 3> corner;
        std::array<std::size_t, 3> edge; // edge opposite to each corner
        std::array<double, 3> sense;     // ±1: direction in which the triangle runs through the edge
        Vector<3> normal;                // twice as long as the area
    };
    struct SeenVertex {
        Vector<3> direction;
        double distance = 0;
    };
    struct SeenEdge {
        Vector<3> normal;   // normal of the plane through the edge and the point
        Vector<3> weighted; // normal times α / (2 sin α)
    };
    struct Seen { // view from one point
        std::vector<SeenVertex> vertices;
        std::vector<SeenEdge> edges;
    };
    void add(const Vector<3>& x, Seen& seen, std::span<double> result) const;

    std::vector<Vector<3>> m_vertices;
    std::vector<std::array<std::size_t, 2>> m_edges;
    std::vector<Triangle> m_triangles;
    double m_size = 0;
};

// The same for a single point.
std::vector<double> meanValueCoordinates(std::span<const Vector<3>> vertices,
                                         std::span<const std::array<int, 3>> triangles, const Vector<3>& x);

} // namespace ifs
