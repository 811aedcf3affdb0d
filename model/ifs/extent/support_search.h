// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/outline.h"
#include "ifs/extent/support_container.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ifs {

// Bits of a state of the search that must agree for it to stand for another: the rest is rounding.
inline constexpr int exactMerging = 43;

// The farthest point of the attractor in a direction u, as found by a search over addresses. Everything is
// relative to the centre of the container.
template <int Dim> struct FoundAddress {
    std::vector<int> address;               // the best one: indices among all maps, outermost first
    Vector<Dim> start;                      // its maps take this point of the attractor farthest out
    std::optional<std::size_t> direction{}; // whose point in the container `start` is, unless of the outline
    double upperBound = 0;                  // of h_A(u), apart from rounding
    int depth = 0;                          // length of the longest address that was considered
    bool isFinished = false;                // the best is within the tolerance
};

// Branch and bound over addresses until the best is within `tolerance` or `maxNodes` words are open. States
// whose first `mergeBits` bits agree count as equal, at a price that the bound includes. A known outline of
// the attractor shortens the search in the plane. u must be finite and not 0. docs/mathematics.md, "Support
// function".
template <int Dim>
FoundAddress<Dim> searchAddresses(const SupportContainer<Dim>& container, const Outline* known,
                                  const Vector<Dim>& u, double tolerance, int mergeBits, int maxNodes);

} // namespace ifs
