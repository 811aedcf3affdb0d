// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/separation/neighbour_graph.h"
#include "ifs/separation/piece_contacts.h"
#include "ifs/system/affine_map.h"

#include <cstddef>
#include <optional>
#include <span>

namespace ifs {

enum class OpenSetCondition { Unknown, Holds, Fails };

struct HausdorffDimension {
    enum class Proof { OpenSetCondition, FiniteType };

    double value = 0;
    double error = 0; // error bound
    Proof proof = Proof::OpenSetCondition;
    Certainty certainty = Certainty::Exact;
};

// Proved facts about the relative positions of the pieces. docs/mathematics.md, "Neighbours".
struct OpenSetFacts {
    OpenSetCondition condition = OpenSetCondition::Unknown;
    Certainty certainty = Certainty::Exact; // meaningless if `condition` is Unknown
    // Number of maps h = w_σ⁻¹w_τ ≠ 1 between pieces that meet, if of finite type.
    std::optional<std::size_t> neighbours{};
    std::optional<HausdorffDimension> dimension{}; // similarities only
};

// `contacts`, and `graph` where it is known, are those of the same maps.
template <int Dim>
OpenSetFacts openSetFacts(std::span<const AffineMap<Dim>> maps, const PieceContacts& contacts,
                          const NeighbourGraph* graph);

// The same where it is proved that the attractor has an area and Σ|det A_i| = 1: its inner points are the
// open set.
template <int Dim>
void settleByArea(OpenSetFacts& facts, std::span<const AffineMap<Dim>> maps, Certainty certainty);

} // namespace ifs
