// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/separation/neighbour_graph.h"
#include "ifs/separation/open_set.h"
#include "ifs/separation/piece_contacts.h"
#include "ifs/separation/surd_map.h"

#include <span>

// Proofs for typed coefficients of what was found to rounding error for the stored ones.
namespace ifs {

// Returns true if the graph, found for the rounded maps, is that of the typed ones: they are similarities of
// one ratio, and each of its steps h ↦ w_i⁻¹ h w_j leads exactly to the map that it names, no two of which
// are the same.
bool isGraphOf(const NeighbourGraph& graph, std::span<const SurdMap> typed);

// Tells of each overlap whether its words have the same map, and leaves connectedness proved only where the
// graph that it comes from is.
void prove(PieceContacts& contacts, std::span<const SurdMap> typed, bool isGraphProved);

// Tells whether a dimension by the open set condition is that of similarities without rounding.
void proveDimension(OpenSetFacts& facts, std::span<const SurdMap> typed);

} // namespace ifs
