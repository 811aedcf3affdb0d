// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/mask.h"
#include "collage/target/nearest_cells.h"

#include "ifs/system/affine_map.h"

#include <cstdint>
#include <vector>

namespace collage {

// Square cells over a part of the plane. In grid coordinates a cell has side 1, x runs to the right from the
// left edge and y downwards from the top edge.
struct Grid {
    double left = 0;
    double top = 0;
    double cell = 1; // side of a cell
    int width = 0;
    int height = 0;

    ifs::AffineMap<2> toGrid() const;
    ifs::AffineMap<2> fromGrid() const;
};
// The same map in the coordinates of the grid, and back.
ifs::AffineMap<2> inGrid(const Grid& grid, const ifs::AffineMap<2>& map);
ifs::AffineMap<2> fromGrid(const Grid& grid, const ifs::AffineMap<2>& map);

// A shape on a grid, prepared for the questions of a fit. In the plane, the height of the picture is 1 unit,
// y is up and the middle of the picture is the origin.
struct Target {
    Grid grid;
    Mask mask;
    FeatureTransform features;
    std::vector<std::int32_t> cells;  // cells of the shape, in increasing order
    std::vector<float> columns, rows; // grid coordinates of their centres
    double size = 0;                  // longer side of the shape's box, in units of the plane
    ifs::Vector<2> mean;              // mean of the centres, in grid coordinates
    ifs::Matrix<2> spread;            // second moments of the centres about the mean
};

// Makes a target with a cell for `factor` × `factor` pixels, over the box of the shape and, on each side, the
// share `margin` of the longer side of that box. A cell is set when the shape fills half of it, or when it
// meets the shape and no such cell is next to it, so that thin lines stay. The mask must not be empty.
Target target(const Mask& picture, int factor, double margin);

// The smallest factor with which the longer side of the box has at most `side` cells.
int factorFor(const Mask& picture, int side);

} // namespace collage
