// SPDX-License-Identifier: MIT
#include "ifs/separation/graph_proof.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace ifs {

namespace {

// The maps on the affine hull of the attractor; nullopt where they are no similarities of one ratio there.
std::optional<std::vector<SurdMap>> similarities(std::span<const SurdMap> typed, std::span<const int> axes) {
    std::vector<SurdMap> result;
    std::optional<Surd> ratio;
    for (const SurdMap& map : typed) {
        const auto inside = axes.empty() ? std::optional(map) : restricted(map, axes);
        if (!inside) return std::nullopt;
        const auto ofMap = squaredRatio(*inside);
        if (!ofMap || ofMap->sign() <= 0 || (ratio && !(*ratio == *ofMap))) return std::nullopt;
        ratio = ofMap;
        result.push_back(*inside);
    }
    return result;
}

} // namespace

bool isGraphOf(const NeighbourGraph& graph, std::span<const SurdMap> typed) {
    if (typed.empty() || typed.size() != graph.maps()) return false;
    const auto maps = similarities(typed, graph.axes());
    if (!maps) return false;
    std::vector<SurdMap> inverses;
    for (const SurdMap& map : *maps)
        inverses.push_back(inverse(map));
    std::vector<std::optional<SurdMap>> known(graph.found());
    known[0] = identity(maps->front().dimension());
    // The first step to each map comes from a map found before it.
    for (const auto& [from, i, j, to] : graph.steps()) {
        if (!known[from]) return false;
        SurdMap image = inverses[i] * (*known[from] * (*maps)[j]);
        if (!image.hasValue() || (known[to] && !(*known[to] == image))) return false;
        known[to] = std::move(image);
    }
    for (std::size_t k = 0; k < known.size(); ++k)
        for (std::size_t l = 0; l <= k; ++l)
            if (!known[k] || (l < k && *known[k] == *known[l])) return false;
    return true;
}

void prove(PieceContacts& contacts, std::span<const SurdMap> typed, bool isGraphProved) {
    if (typed.empty()) return;
    for (Overlap& overlap : contacts.overlaps) {
        const SurdMap first = word(typed, overlap.first), second = word(typed, overlap.second);
        overlap.isExact = first.hasValue() && first == second;
    }
    // Proved for the stored coefficients without rounding, and therefore for others.
    if (contacts.connectedness == Connectedness::Connected && typed.size() > 1 && !isGraphProved)
        contacts.connectedness = Connectedness::ConnectedToRounding;
}

void proveDimension(OpenSetFacts& facts, std::span<const SurdMap> typed) {
    using Proof = HausdorffDimension::Proof;
    if (typed.empty() || !facts.dimension || facts.dimension->proof != Proof::OpenSetCondition) return;
    const bool areSimilarities =
        std::ranges::all_of(typed, [](const SurdMap& map) { return squaredRatio(map).has_value(); });
    facts.dimension->certainty = areSimilarities ? facts.certainty : Certainty::ToRounding;
}

} // namespace ifs
