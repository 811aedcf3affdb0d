// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/separation/hull_pieces.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/separation/piece_contacts.h"
#include "ifs/system/affine_map.h"

#include <cstddef>
#include <optional>
#include <span>

namespace ifs {

enum class OpenSetCondition { Unknown, Holds, Fails };

struct HausdorffDimension {
    enum class Proof {
        OpenSetCondition,
        FiniteType,
        Convex, // the attractor is its convex hull
    };

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
    std::optional<HausdorffDimension> dimension{}; // similarities, and attractors that are their hulls
};

// `contacts`, and `graph` where it is known, are those of the same maps.
template <int Dim>
OpenSetFacts openSetFacts(std::span<const AffineMap<Dim>> maps, const PieceContacts& contacts,
                          const NeighbourGraph* graph);

// The same where it is proved that an open set has disjoint images in itself: so have the inner points of an
// attractor with an area and Σ|det A_i| = 1.
template <int Dim>
void settleByOpenSet(OpenSetFacts& facts, std::span<const AffineMap<Dim>> maps, Certainty certainty);

// The same where the inside of a segment, or of an upright box, has disjoint images, which separate the
// pieces where they do not even touch; where images fill more
// than the affine hull, OSC fails; and where they fill the segment or the box, this is the attractor.
// `pieces` are those of these maps; `certainty` is that of facts that are proved for the stored coefficients.
template <int Dim>
void settleByHull(OpenSetFacts& facts, PieceContacts& contacts, std::span<const AffineMap<Dim>> maps,
                  const std::optional<HullPieces>& pieces, Certainty certainty);

// Says that the attractor is its convex hull, which has this dimension.
void settleConvex(OpenSetFacts& facts, PieceContacts& contacts, int dimension, Certainty certainty);

} // namespace ifs
