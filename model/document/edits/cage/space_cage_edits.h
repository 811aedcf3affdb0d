// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/cage/cage_fits.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/support_function.h"

#include <QString>

#include <optional>
#include <vector>

// Cages fitted to an entry in space as functions from fractal to fractal. cage_edits.h has the functions for
// both dimensions, which call these for an entry in space.
namespace document {

// Why no cage can be fitted around the picture of an entry in space; empty when one can.
QString spaceFitObstacle(const Fractal& fractal);
// The displayed picture held by its smallest tetrahedron with three equal legs along the axes, over all eight
// orientations or for one; nullopt without an attractor or while the placement is flat.
std::optional<Fractal> withTetrahedronFitted(const Fractal& fractal,
                                             const std::optional<ifs::Orientation<3>>& orientation = {});
// The displayed picture held by the corner of its certified bounding box with the least coordinates and its
// three neighbours, whose edges span the box.
std::optional<Fractal> withBoxFitted(const Fractal& fractal);

// The same picture held by other vertices; nullopt while the placement is flat.
std::optional<Fractal> withCageThrough(const Fractal& fractal, const std::vector<ifs::Vector<3>>& vertices);

// The vertices of such a polyhedron around an attractor with that extent, to within extentTolerance() of its
// size, with at most so many corners if it is a hull.
std::vector<ifs::Vector<3>> verticesAround(const ifs::IteratedFunctionSystem<3>& system,
                                           const ifs::SupportFunction<3>& support, SpacePolyhedron choice,
                                           int corners = 16);
// The displayed picture held by these vertices; cages with more than four bend it once they are moved.
// nullopt without an attractor, while the placement is flat or bent, and where the polyhedron would be too
// thin.
std::optional<Fractal> withPolyhedronFitted(const Fractal& fractal, SpacePolyhedron choice, int corners = 16);

} // namespace document
