// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/facts.h"

#include <array>
#include <optional>
#include <set>
#include <vector>

namespace document {

// Results of an analysis that can be drawn over the picture.
enum class Outline { Box, Hull, Simplex, FixedPoints, Ellipse, Cylinders };

// A shape in space, in displayed coordinates: pairs of its points are joined; without any pairs, points
// alone.
struct SpaceOutline {
    Outline kind;
    std::vector<ifs::Vector<3>> points;
    std::vector<std::array<int, 2>> edges;
    std::optional<attractor::Rgba> colour; // same meaning as in OutlineShape
    bool isSelected = false;               // true: thick lines
};

// Facts of an entry in space, for drawing over its picture. `code` are those of the code, `displayed` those
// of the picture, to which the affine map `placed` takes it.
struct SpaceFacts {
    const ifs::Facts<3>& code;
    const ifs::Facts<3>& displayed;
    ifs::AffineMap<3> placed;
};
// Outlines of the entry `fractal`; the addresses of its cylinders have `cylinderDepth` symbols.
std::vector<SpaceOutline> spaceOutlines(const SpaceFacts& facts, const Fractal& fractal,
                                        const std::set<Outline>& outlines, int cylinderDepth);

// The edges of the convex hull of the attractor as it is displayed; nullopt without one, and where the cage
// bends.
std::optional<SpaceOutline> hullOutline(const Fractal& fractal);

} // namespace document
