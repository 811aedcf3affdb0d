// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"
#include "ifs/system/link_graph.h"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

// Linked maps: which maps the chaos game may apply after which. After map i, map j has the probability
// p_j P_ij / Σ_k p_k P_ik. A word σ₁σ₂… (outermost map first) is admissible when P_{σ₂σ₁}, P_{σ₃σ₂}, … are
// positive. docs/mathematics.md, "Linked maps".
namespace ifs {

// P_ij by rows, over all maps of the system; 1 where no link is given, 0 where one is negative or not finite.
template <int Dim> std::vector<double> linkMatrix(const IteratedFunctionSystem<Dim>& system);

// The weight 1 removes the link.
template <int Dim> void setLink(IteratedFunctionSystem<Dim>& system, Link link);
// Sets the links from a matrix for all maps of the system, row by row.
template <int Dim> void setLinks(IteratedFunctionSystem<Dim>& system, std::span<const double> matrix);
// Copies links: each copy follows, and is followed by, the same maps as its original, and the copies each
// other as the originals do. Both lists have the same length.
template <int Dim>
void copyLinks(IteratedFunctionSystem<Dim>& system, std::span<const MapId> originals,
               std::span<const MapId> copies);
// Removes what names a map that the system does not have.
template <int Dim> void dropStaleLinks(IteratedFunctionSystem<Dim>& system);

// Gives the maps that links name the ids that they have become; drops links of maps that are not in the
// table.
template <int Dim> void renumberLinks(IteratedFunctionSystem<Dim>& system, const std::map<MapId, MapId>& ids);

template <int Dim> std::vector<LinkState> linkStates(const IteratedFunctionSystem<Dim>& system);

// The Markov chain of the maps applied, when it has run for long; each array by rows.
struct Transitions {
    std::size_t size = 0;
    std::vector<double> forward;                  // T_ij: map j follows map i
    std::vector<double> stationary;               // π_i, sum 1
    std::vector<double> backward;                 // π_i T_ij / π_j at (j, i): map i came before map j
    std::vector<std::vector<std::size_t>> closed; // parts that the chain never leaves; each map is in one
};
// Stationary chain of the active maps. If it has several closed parts, each gets the weights of its maps.
// Unlinked maps give π = p.
template <int Dim> Transitions transitions(const ActiveMaps<Dim>& active);

} // namespace ifs
