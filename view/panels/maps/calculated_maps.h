// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/affine_map.h"

#include <optional>

// Maps that nobody has typed: those of a moment of an animation, and those that act under the current cage.
namespace view {

// The map that displays the code; nullopt if no code would show the same: while the placement is flat or
// bends.
template <int Dim> std::optional<ifs::AffineMap<Dim>> displayOf(const document::Shape<Dim>& shape);

// The map as it acts on the picture that `display` shows; nullopt if that is flat.
template <int Dim>
std::optional<ifs::AffineMap<Dim>> effectiveMap(const ifs::AffineMap<Dim>& display,
                                                const ifs::AffineMap<Dim>& map);

// The map with 0 where rounding has left −3.5e−18 of it. `reach` is the size of the numbers from which the
// translation was calculated, if that is larger than its own and that of the linear part, which has moved a
// point of a picture of size 1.
template <int Dim> ifs::AffineMap<Dim> withoutResidue(const ifs::AffineMap<Dim>& map, double reach = 0);

} // namespace view
