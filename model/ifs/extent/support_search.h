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
    std::vector<int> address; // best address: indices among all maps, outermost first
    Vector<Dim> start;        // point of the attractor that the maps of `address` take farthest out
    // Direction whose point in the container is `start`; nullopt: a point of the outline.
    std::optional<std::size_t> direction{};
    double upperBound = 0;   // bound of h_A(u), without rounding
    int depth = 0;           // length of the longest address considered
    bool isFinished = false; // true if the best is within the tolerance
};

// Branch and bound over addresses until the best is within `tolerance` or `maxNodes` words are open. States
// whose first `mergeBits` bits agree count as equal, at a price that the bound includes. A known outline of
// the attractor shortens the search in the plane. u must be finite and not 0. docs/mathematics.md, "Support
// function".
template <int Dim>
FoundAddress<Dim> searchAddresses(const SupportContainer<Dim>& container, const Outline* known,
                                  const Vector<Dim>& u, double tolerance, int mergeBits, int maxNodes);

} // namespace ifs
