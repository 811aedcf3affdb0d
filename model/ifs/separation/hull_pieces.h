// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

// The segment that is the convex hull of an attractor on a line, or the box around that of maps without
// turns, and its images, known without rounding. docs/mathematics.md, "Separation".
namespace ifs {

struct HullPieces {
    int dimension = 0; // of the affine hull of the attractor, in which the segment or box has an inside
    // No two images of this inside have a common point, and none is flat: the open set condition holds with
    // it.
    bool haveDisjointInsides = false;
    bool areDisjoint = false;        // no two images have any common point
    bool coverHull = false;          // the images are all of the segment or box: it is the attractor
    std::optional<double> area = {}; // of the box, rounded; plane only
};

// nullopt where the attractor is of another kind, or this would take too much work. The maps must have an
// attractor.
template <int Dim> std::optional<HullPieces> piecesOfHull(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
