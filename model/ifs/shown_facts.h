// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/facts.h"
#include "ifs/system/branch.h"

#include <span>
#include <vector>

namespace ifs {

// Facts of what is shown of an attractor whose branches are moved, the union of change(w_σ(A)) over `pieces`
// (words over the active maps): its box, simplex, hull, mean and covariance. Everything else remains that of
// the maps, and the long-run covariance is 0: no orbit runs there. In space no hull is known, and of linked
// maps none of these. `placement` moves all pieces; `facts` are those of the code that it has moved.
template <int Dim>
Facts<Dim> shown(Facts<Dim> facts, const Facts<Dim>& code, const AffineMap<Dim>& placement,
                 std::span<const MovedBranch<Dim>> pieces);

} // namespace ifs
