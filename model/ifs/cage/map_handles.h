// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"
#include "ifs/existence/attractor_existence.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

// Maps taken by the images w(V_j) of the rest vertices. docs/mathematics.md, "Map handles".
namespace ifs {

// w(x) + λ(x)·offset: the image of vertex `vertex` moves by `offset`, a change of rank one. λ is affine, 1 at
// the vertex and 0 at the two others that form the largest triangle with it, whose images stay. The rest
// vertices must be those of a valid cage. With offset 0 exactly the map itself.
AffineMap<2> withHandleMoved(const AffineMap<2>& map, std::span<const Vector<2>> rest, std::size_t vertex,
                             const Vector<2>& offset);

// The same in space, with the tetrahedron's own coordinate for λ: the images of its other vertices stay. The
// rest must be an affine basis.
AffineMap<3> withHandleMoved(const AffineMap<3>& map, const Simplex<3>& rest, std::size_t vertex,
                             const Vector<3>& offset);

// The placement to first order at x, a point in coordinates of the code; the whole placement when it is
// affine.
AffineMap<2> firstOrder(const Placement& placement, const Vector<2>& x);

// The point that is displayed at `displayed`, sought from `start`. nullopt when the placement is flat or,
// bent, takes no point there.
std::optional<Vector<2>> preimage(const Placement& placement, const Vector<2>& displayed,
                                  const Vector<2>& start);

// Returns true if the maps are proved to have an attractor.
bool hasAttractor(const Existence& existence);

// The part of a change that keeps a certified attractor.
template <int Dim> struct SafeWay {
    double share = 1; // share of the way, within 1e-4, up to which there is an attractor
    // The maps just past it, without a known attractor; empty when share is 1.
    std::vector<AffineMap<Dim>> past{};
    Existence verdict{}; // verdict on the maps in `past`
};
// Searches `mapsAt(t)`, t from 0 to 1, for the place where the maps stop having a certified attractor: by
// bisection, so that there is none just past the share returned, though there may be one again farther on.
// share 1 when mapsAt(1) has one, or mapsAt(0) has none to keep. Verdicts are those of a search as short as a
// drag allows.
template <int Dim> SafeWay<Dim> safeWay(const std::function<std::vector<AffineMap<Dim>>(double)>& mapsAt);

} // namespace ifs
