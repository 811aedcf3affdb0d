// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/branch.h"

#include <span>
#include <vector>

namespace ifs {

// A branch σ that changes inside itself: it is shown elsewhere, and so is σ inside it, and so on, but nothing
// beside it. The set shown is M = change(w_σ(M)) ∪ w_τ(A) over the words τ that leave σ. The same as branches
// that are moved once, σ, σσ, σσσ …, until they are too small to be seen, too long or too badly conditioned.
// Only σ itself where change∘w_σ does not contract: then there is no such set. Words are over `maps`.
// docs/mathematics.md, "Branches".
template <int Dim>
std::vector<MovedBranch<Dim>> recurring(const MovedBranch<Dim>& branch, std::span<const AffineMap<Dim>> maps);

} // namespace ifs
