// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/branch.h"

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

namespace ifs {

// An address σ of a point near x: a point of w_σ(A) lies within `distance` of x.
struct AddressMatch {
    Word address;
    double distance = 0;
};

// Looked for among the addresses that start with `beginning`; there all lengths are `scale` times as long.
template <int Dim> struct AddressQueryIn {
    Vector<Dim> x;
    double scale = 1;
    Word beginning{};
};
using AddressQuery = AddressQueryIn<2>;

// The address of the point of the attractor nearest to x, as far as pieces wider than `width` go, at least
// one symbol. Where pieces overlap, one of a piece whose enclosing ball is nearest. nullopt when no point
// lies within `reach` of x, or when the search is given up after `maxNodes` words within reach. Best first,
// over the balls w_σ(Ball) ⊃ w_σ(A). docs/mathematics.md, "Branches".
template <int Dim>
std::optional<AddressMatch> addressNear(const SupportFunction<Dim>& attractor,
                                        std::type_identity_t<std::span<const AddressQueryIn<Dim>>> sought,
                                        double reach, double width, int maxNodes = 20'000);

} // namespace ifs
