// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/cage_surface.h"

#include <optional>

namespace ifs {

// ∂bend/∂x by differences, good to about half of the digits.
Matrix<3> derivative(const CageDeformation& bend, const Vector<3>& x);

// A point that the bend takes to `displayed`, to about 1e-10 of the cage's size, sought from `start` by
// Newton's method with steps that come nearer. nullopt where that ends before it is found.
std::optional<Vector<3>> preimage(const CageDeformation& bend, const Vector<3>& displayed,
                                  const Vector<3>& start);

} // namespace ifs
