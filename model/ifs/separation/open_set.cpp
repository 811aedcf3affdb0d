// SPDX-License-Identifier: MIT
#include "ifs/separation/open_set.h"

#include "ifs/dimension/dimension.h"
#include "ifs/existence/exact_similarity.h"
#include "ifs/linear/rounding.h"
#include "ifs/separation/determinant_sum.h"
#include "ifs/separation/hull_pieces.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

struct Condition {
    OpenSetCondition condition = OpenSetCondition::Unknown;
    Certainty certainty = Certainty::Exact;
};

template <int Dim>
Condition conditionOf(std::span<const AffineMap<Dim>> maps, const PieceContacts& contacts,
                      const NeighbourGraph* graph) {
    using enum OpenSetCondition;
    const auto& overlaps = contacts.overlaps;
    if (std::ranges::any_of(overlaps, &Overlap::isExact)) return {Fails};
    if (contacts.separation == Separation::Strong) return {Holds};
    const auto excess = excessOnHull<Dim>(maps);
    if (excess && excess->dimension == Dim && excess->value > excess->rounding) return {Fails};
    if (graph) return {graph->overlap() ? Fails : Holds, graph->certainty()};
    if (!overlaps.empty()) return {Fails, Certainty::ToRounding};
    return {};
}

template <int Dim>
std::optional<HausdorffDimension> dimensionByCondition(std::span<const AffineMap<Dim>> maps,
                                                       Certainty certainty) {
    const auto dimension = similarityDimension<Dim>(maps);
    if (!dimension || !(*dimension <= Dim * (1 + 1e-9))) return std::nullopt;
    if (!squaredRatios<Dim>(maps)) certainty = Certainty::ToRounding;
    return HausdorffDimension{.value = std::min(*dimension, double(Dim)),
                              .error = similarityDimensionError<Dim>(maps, *dimension),
                              .certainty = certainty};
}

// ln κ / −ln r for the growth κ of the number of different maps.
std::optional<HausdorffDimension> dimensionByType(const NeighbourGraph& graph) {
    const auto growth = graph.growth();
    if (!growth || !(growth->least >= 1)) return std::nullopt;
    const double rate = -std::log(graph.ratio());
    const double least = std::log(growth->least) / rate, most = std::log(growth->most) / rate;
    HausdorffDimension result{.value = (least + most) / 2,
                              .proof = HausdorffDimension::Proof::FiniteType,
                              .certainty = graph.certainty()};
    result.error = (most - least) / 2 + 16 * roundingUnit * (result.value + 1) * (1 + 1 / rate);
    return result;
}

} // namespace

template <int Dim>
OpenSetFacts openSetFacts(std::span<const AffineMap<Dim>> maps, const PieceContacts& contacts,
                          const NeighbourGraph* graph) {
    OpenSetFacts result;
    if (maps.size() < 2) {
        result.condition = OpenSetCondition::Holds;
        return result;
    }
    const auto [condition, certainty] = conditionOf<Dim>(maps, contacts, graph);
    result.condition = condition;
    result.certainty = certainty;
    if (graph) result.neighbours = graph->neighbours();
    if (condition == OpenSetCondition::Holds)
        result.dimension = dimensionByCondition<Dim>(maps, certainty);
    else if (graph && graph->overlap())
        result.dimension = dimensionByType(*graph);
    return result;
}

template <int Dim>
void settleByOpenSet(OpenSetFacts& facts, std::span<const AffineMap<Dim>> maps, Certainty certainty) {
    using enum OpenSetCondition;
    const bool isBetter =
        facts.condition == Holds && facts.certainty == Certainty::ToRounding && certainty == Certainty::Exact;
    if (facts.condition != Unknown && !isBetter) return;
    facts.condition = Holds;
    facts.certainty = certainty;
    facts.dimension = dimensionByCondition<Dim>(maps, certainty);
}

template <int Dim>
void settleByHull(OpenSetFacts& facts, PieceContacts& contacts, std::span<const AffineMap<Dim>> maps,
                  const std::optional<HullPieces>& pieces, Certainty certainty) {
    // What touches within rounding error stays so, though the stored numbers leave a gap.
    const bool mayTouch = contacts.separation != Separation::Unknown || facts.neighbours.value_or(0) > 0 ||
                          contacts.connectedness == Connectedness::ConnectedToRounding;
    if (pieces && pieces->areDisjoint && !mayTouch && certainty == Certainty::Exact) {
        contacts.separation = Separation::Strong;
        contacts.connectedness = Connectedness::Disconnected;
        settleByOpenSet<Dim>(facts, maps, certainty);
    }
    if (pieces && pieces->haveDisjointInsides) settleByOpenSet<Dim>(facts, maps, certainty);
    if (facts.condition == OpenSetCondition::Unknown)
        if (const auto excess = excessOnHull<Dim>(maps); excess && excess->value > excess->rounding) {
            facts.condition = OpenSetCondition::Fails;
            facts.certainty = certainty;
        }
    if (pieces && pieces->coverHull) settleConvex(facts, contacts, pieces->dimension, certainty);
}

void settleConvex(OpenSetFacts& facts, PieceContacts& contacts, int dimension, Certainty certainty) {
    if (contacts.connectedness == Connectedness::Unknown ||
        (contacts.connectedness == Connectedness::ConnectedToRounding && certainty == Certainty::Exact))
        contacts.connectedness =
            certainty == Certainty::Exact ? Connectedness::Connected : Connectedness::ConnectedToRounding;
    if (!facts.dimension)
        facts.dimension = HausdorffDimension{
            .value = double(dimension), .proof = HausdorffDimension::Proof::Convex, .certainty = certainty};
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template OpenSetFacts openSetFacts<Dim>(std::span<const AffineMap<Dim>>, const PieceContacts&,           \
                                            const NeighbourGraph*);                                          \
    template void settleByOpenSet<Dim>(OpenSetFacts&, std::span<const AffineMap<Dim>>, Certainty);           \
    template void settleByHull<Dim>(OpenSetFacts&, PieceContacts&, std::span<const AffineMap<Dim>>,          \
                                    const std::optional<HullPieces>&, Certainty);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
