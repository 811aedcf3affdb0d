// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/branch.h"
#include "ifs/support_function.h"

#include <cstddef>
#include <optional>

namespace ifs {

// An address σ of a point near x: a point of w_σ(A) lies within `distance` of x.
struct Addressed {
    Word address;
    double distance = 0;
};

// The address of the point of the attractor nearest to x, as far as pieces wider than `width` go, at least
// one symbol. Where pieces overlap, that of the piece whose enclosing ball is nearest. nullopt when no point
// lies within `reach` of x, or when the search is given up after `maxNodes` words. Only addresses that start
// with `beginning` are looked at. Best first, over the balls w_σ(Ball) ⊃ w_σ(A). docs/mathematics.md,
// "Branches".
std::optional<Addressed> addressNear(const SupportFunction<2>& attractor, const Vector<2>& x, double reach,
                                     double width, const Word& beginning = {}, int maxNodes = 20'000);

} // namespace ifs
