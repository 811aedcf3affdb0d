// SPDX-License-Identifier: MIT
#include "document/edits/coupled_entries.h"

#include "document/fractal_geometry.h"

#include <algorithm>

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

// Positions among the maps that take part; the copies of a map under a symmetry stay together.
std::optional<std::vector<std::size_t>> positions(std::span<const std::size_t> order,
                                                  const std::vector<std::size_t>& indices) {
    std::vector<std::size_t> result;
    for (const std::size_t index : order) {
        const auto copies = std::ranges::equal_range(indices, index);
        if (copies.empty() || result.size() + copies.size() > indices.size()) return std::nullopt;
        for (auto copy = copies.begin(); copy != copies.end(); ++copy)
            result.push_back(std::size_t(copy - indices.begin()));
    }
    for (std::size_t k = 0; order.empty() && k < indices.size(); ++k)
        result.push_back(k);
    auto sorted = result;
    std::ranges::sort(sorted);
    const bool isEach = sorted.size() == indices.size() && std::ranges::adjacent_find(sorted) == sorted.end();
    return isEach ? std::optional(result) : std::nullopt;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& positions) {
    std::vector<Value> result;
    for (const std::size_t position : positions)
        result.push_back(values[position]);
    return result;
}

} // namespace

CouplingOutcome coupled(const Fractal& from, const Fractal& to, std::span<const std::size_t> order) {
    Shown f = shownOf(from), g = shownOf(to);
    CouplingOutcome outcome;
    outcome.fromCount = f.active.maps.size();
    outcome.toCount = g.active.maps.size();
    const auto failed = [&](CouplingFlaw flaw, bool isOfSecond) {
        outcome.flaw = flaw;
        outcome.isOfSecond = isOfSecond;
        return outcome;
    };
    if (f.flaw) return failed(*f.flaw, false);
    if (g.flaw) return failed(*g.flaw, true);
    if (outcome.fromCount != outcome.toCount) return failed(CouplingFlaw::Counts, false);
    const auto places = positions(order, f.active.index);
    if (!places) return failed(CouplingFlaw::Order, false);
    auto fromAttractor = ifs::SupportFunction<2>::of(picked(f.active.maps, *places));
    if (!fromAttractor) return failed(CouplingFlaw::NoAttractor, false);
    auto toAttractor = ifs::SupportFunction<2>::of(picked(g.active.maps, *places));
    if (!toAttractor) return failed(CouplingFlaw::NoAttractor, true);
    outcome.entries = CoupledEntries{std::move(f.fractal),
                                     std::move(g.fractal),
                                     std::move(*fromAttractor),
                                     std::move(*toAttractor),
                                     picked(f.active.probabilities, *places),
                                     picked(f.active.index, *places)};
    return outcome;
}

} // namespace document
