// SPDX-License-Identifier: MIT
#include "document/edits/coupled_entries.h"

#include "document/fractal/fractal_geometry.h"

#include <algorithm>
#include <utility>

namespace document {

namespace {

// An entry as it is shown, or why not.
struct Shown {
    Fractal fractal;
    ifs::ActiveMaps<2> active;
    std::optional<CouplingFlaw> flaw{};
};

Shown shownOf(const Fractal& fractal) {
    Shown shown{fractal, {}, std::nullopt};
    Shape<2>* shape = plane(shown.fractal);
    if (shape == nullptr) return {fractal, {}, CouplingFlaw::NotInPlane};
    const auto system = effectiveSystem(fractal);
    if (!system) return {fractal, {}, CouplingFlaw::BentCage};
    *shape = {*system};
    shown.active = ifs::activeMaps(*system);
    if (shown.active.isLinked()) shown.flaw = CouplingFlaw::Linked;
    if (shown.active.maps.empty()) shown.flaw = CouplingFlaw::NoMaps;
    return shown;
}

struct Pair {
    Shown from, to;
    std::vector<std::size_t> places; // positions of the maps of `from` in the order
};

// nullopt where something is evidently wrong, which the outcome says.
std::optional<Pair> pairOf(const Fractal& from, const Fractal& to, std::span<const std::size_t> order,
                           CouplingOutcome& outcome) {
    Pair pair{shownOf(from), shownOf(to), {}};
    outcome.fromCount = pair.from.active.maps.size();
    outcome.toCount = pair.to.active.maps.size();
    const auto failed = [&](CouplingFlaw flaw, bool isOfSecond) {
        outcome.flaw = flaw;
        outcome.isOfSecond = isOfSecond;
        return std::nullopt;
    };
    if (pair.from.flaw) return failed(*pair.from.flaw, false);
    if (pair.to.flaw) return failed(*pair.to.flaw, true);
    if (outcome.fromCount != outcome.toCount) return failed(CouplingFlaw::Counts, false);
    auto places = placesInOrder(order, pair.from.active.index);
    if (!places) return failed(CouplingFlaw::Order, false);
    pair.places = std::move(*places);
    return pair;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& positions) {
    std::vector<Value> result;
    for (const std::size_t position : positions)
        result.push_back(values[position]);
    return result;
}

} // namespace

std::optional<std::vector<std::size_t>> placesInOrder(std::span<const std::size_t> order,
                                                      const std::vector<std::size_t>& indices) {
    std::vector<std::size_t> result;
    for (const std::size_t index : order) {
        const auto [first, last] = std::equal_range(indices.begin(), indices.end(), index);
        if (first == last || result.size() + std::size_t(last - first) > indices.size()) return std::nullopt;
        for (auto copy = first; copy != last; ++copy)
            result.push_back(std::size_t(copy - indices.begin()));
    }
    for (std::size_t k = 0; order.empty() && k < indices.size(); ++k)
        result.push_back(k);
    auto sorted = result;
    std::ranges::sort(sorted);
    const bool isEach = sorted.size() == indices.size() && std::ranges::adjacent_find(sorted) == sorted.end();
    return isEach ? std::optional(result) : std::nullopt;
}

CouplingOutcome coupled(const Fractal& from, const Fractal& to, std::span<const std::size_t> order,
                        const std::optional<CoupledEntries>& before) {
    CouplingOutcome outcome;
    const std::optional<Pair> pair = pairOf(from, to, order, outcome);
    if (!pair) return outcome;
    const auto& [f, g, places] = *pair;
    outcome.flaw = CouplingFlaw::NoAttractor;
    auto fromAttractor = ifs::SupportFunction<2>::of(picked(f.active.maps, places));
    if (!fromAttractor) return outcome;
    const std::vector<ifs::AffineMap<2>> maps = picked(g.active.maps, places);
    const bool isKnown = before && before->to == g.fractal && before->toAttractor.maps() == maps;
    auto toAttractor = isKnown ? before->toAttractor : ifs::SupportFunction<2>::of(maps);
    outcome.isOfSecond = !toAttractor;
    if (!toAttractor) return outcome;
    outcome.entries = CoupledEntries{f.fractal,
                                     isKnown ? before->to : g.fractal,
                                     std::move(*fromAttractor),
                                     std::move(*toAttractor),
                                     picked(f.active.probabilities, places),
                                     picked(f.active.index, places)};
    return outcome;
}

std::optional<CouplingOutcome> evidentFlaw(const Fractal& from, const Fractal& to,
                                           std::span<const std::size_t> order) {
    CouplingOutcome outcome;
    if (pairOf(from, to, order, outcome)) return std::nullopt;
    return outcome;
}

} // namespace document
