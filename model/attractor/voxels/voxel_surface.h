// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/voxels/voxel_grid.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace attractor {

// Triangles between points of a lattice, seen counter-clockwise from outside.
struct SurfaceMesh {
    static constexpr std::size_t maxTriangles = 12'000'000;

    using Point = std::array<std::int32_t, 3>;
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<Point> points;
    std::vector<Triangle> triangles;
};

// Points of the lattice per voxel; where voxels touch in an edge or a corner alone, bars one such step thick
// join them.
constexpr int latticePerVoxel = 8;

// The boundary of the filled voxels, and of bars around those edges and corners in which the boundary of the
// voxels alone would not be a surface. Closed, and a surface everywhere, for every grid.
// docs/mathematics.md, "Voxels". nullopt when it has more than maxTriangles.
std::optional<SurfaceMesh> voxelSurface(const VoxelGrid& grid);

enum class SurfaceFlaw {
    None,
    Open,        // some edge has no second triangle
    NotManifold, // more than two triangles meet in an edge, or more than one fan in a corner
};
// The defect of a mesh, if any: every edge must be used once in each direction, and the triangles around a
// point must be one ring.
SurfaceFlaw flawOf(const SurfaceMesh& mesh);

double enclosedVolume(const SurfaceMesh& mesh); // volume in units of the lattice

} // namespace attractor
