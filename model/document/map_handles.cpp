// SPDX-License-Identifier: MIT
#include "document/map_handles.h"

#include "ifs/map_handles.h"
#include "ifs/support_function.h"
#include "ifs/weaving.h"

#include <algorithm>
#include <utility>

namespace document {

using ifs::AffineMap;
using ifs::Vector;

namespace {

std::vector<ifs::MapId> idsOf(const System2& system, const ifs::Word& places) {
    std::vector<ifs::MapId> word;
    for (const int place : places)
        word.push_back(system.maps[std::size_t(place)].id);
    return word;
}

AffineMap<2> changeOf(const Fractal& fractal, const std::vector<ifs::MapId>& word) {
    const auto moved = std::ranges::find(fractal.moved, word, &MovedBranch::word);
    return moved == fractal.moved.end() ? AffineMap<2>{} : moved->change;
}

// Of the branches around this one.
AffineMap<2> changeAround(const Fractal& fractal, const std::vector<ifs::MapId>& word) {
    AffineMap<2> change;
    for (std::size_t length = 0; length < word.size(); ++length)
        change = change * changeOf(fractal, {word.begin(), word.begin() + std::ptrdiff_t(length)});
    return change;
}

} // namespace

MapHandles::MapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<2>& cage,
                       const AffineMap<2>& within)
    : m_fractal(std::move(fractal)), m_cage(cage), m_placement(placement(*m_fractal)), m_within(within) {}

MapHandles MapHandles::ofBranch(const std::shared_ptr<const Fractal>& fractal,
                                const ifs::ControlCage<2>& cage, const ifs::Word& branch) {
    MapHandles handles(fractal, cage);
    AffineMap<2> map;
    for (const int place : branch)
        map = map * system2(*fractal)->maps[std::size_t(place)].map;
    const std::vector<ifs::MapId> word = idsOf(*system2(*fractal), branch);
    handles.m_within = changeAround(*fractal, word); // moves it too, and stays as it is
    handles.m_branch = word;
    handles.m_branchMap = {{word.back(), changeOf(*fractal, word) * map, {}}};
    return handles;
}

std::vector<Vector<2>> MapHandles::corners(std::size_t place) const {
    std::vector<Vector<2>> result;
    for (const Vector<2>& vertex : m_cage.rest)
        result.push_back(m_placement(m_within(maps()[place].map(vertex))));
    return result;
}

std::vector<Vector<2>> MapHandles::outline(std::size_t place) const {
    if (!bends()) return corners(place);
    constexpr int parts = 12; // of an edge
    std::vector<Vector<2>> result;
    for (std::size_t i = 0; i < m_cage.rest.size(); ++i) {
        const Vector<2>& from = m_cage.rest[i];
        const Vector<2> edge = m_cage.rest[(i + 1) % m_cage.rest.size()] - from;
        for (int k = 0; k < parts; ++k)
            result.push_back(m_placement(m_within(maps()[place].map(from + edge * (double(k) / parts)))));
    }
    return result;
}

std::vector<Box> MapHandles::boxes() const {
    Vector<2> low = m_cage.rest.front(), high = low;
    for (const Vector<2>& vertex : m_cage.rest) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const Vector<2> centre = (low + high) / 2, half = (high - low) / 2;
    const AffineMap<2> seen = m_placement.affine() * m_within;
    std::vector<Box> result;
    result.reserve(count());
    for (const ifs::WeightedMap<2>& map : maps()) {
        const Vector<2> at = map.map(centre);
        const Vector<2> middle = bends() ? m_placement(m_within(at)) : seen(at);
        const Vector<2> reach = (seen.linear * map.map.linear).cwiseAbs() * half;
        result.push_back({middle - reach, middle + reach});
    }
    return result;
}

bool MapHandles::canBeTaken() const {
    return (bends() || ifs::isInvertible(m_cage)) && ifs::inverse(m_within) &&
           (m_branch.empty() || ifs::inverse(m_branchMap.front().map));
}

AffineMap<2> MapHandles::around(std::size_t place) const {
    Vector<2> middle = Vector<2>::Zero();
    for (const Vector<2>& vertex : m_cage.rest)
        middle += m_within(maps()[place].map(vertex)) / double(m_cage.rest.size());
    return ifs::firstOrder(m_placement, middle) * m_within;
}

Fractal MapHandles::changed() const {
    Fractal fractal = *m_fractal;
    if (m_branch.empty()) fractal.cage = m_cage;
    return fractal;
}

void MapHandles::change(Fractal& fractal, std::size_t place, const AffineMap<2>& change) const {
    if (m_branch.empty()) {
        AffineMap<2>& map = system2(fractal)->maps[place].map;
        map = change * map;
        return;
    }
    const auto moved = std::ranges::find(fractal.moved, m_branch, &MovedBranch::word);
    if (moved == fractal.moved.end())
        fractal.moved.push_back({m_branch, change});
    else
        moved->change = change * moved->change;
}

void MapHandles::changeDisplayed(Fractal& fractal, std::size_t place, const AffineMap<2>& displayed) const {
    const auto back = ifs::inverse(around(place));
    if (const auto inCode = back ? ifs::conjugate(*back, displayed) : std::nullopt)
        change(fractal, place, *inCode);
}

Fractal MapHandles::withCornerMoved(std::size_t place, std::size_t corner, const Vector<2>& offset) const {
    const auto inCode = ifs::inverse(around(place));
    const auto outOf = ifs::inverse(m_within);
    if (offset.isZero(0) || !inCode || !outOf) return *m_fractal;
    const Vector<2> held = maps()[place].map(m_cage.rest[corner]);
    const Vector<2> seen = m_within(held);
    const auto target = ifs::preimage(m_placement, m_placement(seen) + offset, seen);
    Fractal fractal = changed();
    Vector<2> moved = inCode->linear * offset;
    if (target) moved = outOf->linear * (*target - seen);
    const AffineMap<2>& map = maps()[place].map;
    if (m_branch.empty()) {
        system2(fractal)->maps[place].map = ifs::withHandleMoved(map, m_cage.rest, corner, moved);
        return fractal;
    }
    std::vector<Vector<2>> polygon;
    for (const Vector<2>& vertex : m_cage.rest)
        polygon.push_back(map(vertex));
    change(fractal, place, ifs::withHandleMoved({}, polygon, corner, moved));
    return fractal;
}

Fractal MapHandles::withMapsMoved(std::span<const std::size_t> places, const Vector<2>& offset) const {
    if (offset.isZero(0)) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t place : places)
        if (const auto inCode = ifs::inverse(around(place)))
            change(fractal, place, {ifs::Matrix<2>::Identity(), inCode->linear * offset});
    return fractal;
}

Fractal MapHandles::withMapsChanged(std::span<const std::size_t> places, const AffineMap<2>& change) const {
    if (change == AffineMap<2>{}) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t place : places)
        changeDisplayed(fractal, place, change);
    return fractal;
}

Fractal MapHandles::withMapsSwung(std::span<const std::size_t> places, const Vector<2>& root,
                                  double angle) const {
    if (angle == 0) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t place : places)
        changeDisplayed(fractal, place,
                        ifs::swung({}, m_placement(m_within(maps()[place].map(root))), angle));
    return fractal;
}

namespace {

// The system over the cut set of the branch, whose maps have the colours of the maps they begin with. Maps
// that take no part stay, at the end.
Fractal withBranchAsMap(const Fractal& fractal, const ifs::Word& letters) {
    const System2& before = *system2(fractal);
    const ifs::ActiveMaps<2> active = ifs::activeMaps(before);
    Fractal result = fractal;
    System2 system = ifs::withBranchChanged<2>(before, letters, {});
    attractor::MapColours& colours = result.appearance.mapColours = {};
    colours.reserve(system.maps.size());
    std::size_t made = 0;
    const auto keepColour = [&](std::size_t place) { // for the next map
        colours[system.maps[made++].id] =
            attractor::mapColour(fractal.appearance, before.maps[place].id, place);
    };
    const auto keepColourOf = [&](int letter) { keepColour(active.index[std::size_t(letter)]); };
    keepColourOf(letters.front());
    for (const auto& [kept, symbol] : ifs::departures(letters, active.maps.size()))
        keepColourOf(kept > 0 ? letters.front() : symbol);
    for (std::size_t place = 0; place < before.maps.size(); ++place) {
        if (std::ranges::binary_search(active.index, place)) continue;
        system.maps.push_back(before.maps[place]);
        system.maps.back().id = ifs::MapId{std::uint32_t(system.maps.size())};
        keepColour(place);
    }
    result.moved.clear();
    for (const auto& [word, change] : ifs::overMaps<2>(movedBranches(fractal), active.index))
        for (const ifs::Word& over : ifs::overCutSet(word, letters, active.maps.size()))
            result.moved.push_back({idsOf(system, over), change});
    result.system = std::move(system);
    return result;
}

} // namespace

std::optional<BranchHandles> branchHandles(const std::shared_ptr<const Fractal>& fractal,
                                           const ifs::ControlCage<2>& cage, const ifs::Word& branch,
                                           BranchEdit edit) {
    if (branch.empty() || system2(*fractal) == nullptr) return std::nullopt;
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*system2(*fractal));
    auto letters = ifs::overMaps(branch, active.index);
    if (!letters) return std::nullopt;
    if (edit == BranchEdit::Display) return BranchHandles{MapHandles::ofBranch(fractal, cage, branch), 0};
    const std::vector<ifs::MapId> word = idsOf(*system2(*fractal), branch);
    const AffineMap<2> moved = changeAround(*fractal, word) * changeOf(*fractal, word);
    if (branch.size() == 1) return BranchHandles{{fractal, cage, moved}, std::size_t(branch.front())};
    if (edit == BranchEdit::OwnMap)
        return BranchHandles{
            {std::make_shared<const Fractal>(withBranchAsMap(*fractal, *letters)), cage, moved}, 0};
    letters->pop_back();
    return BranchHandles{{fractal, cage, moved * ifs::composed<2>(active.maps, *letters)},
                         std::size_t(branch.back())};
}

bool isMoved(const Fractal& fractal, const ifs::Word& branch) {
    const System2* system = system2(fractal);
    return !fractal.moved.empty() && system && std::ranges::all_of(branch, [&](int place) {
        return std::size_t(place) < system->maps.size();
    }) && std::ranges::find(fractal.moved, idsOf(*system, branch), &MovedBranch::word) != fractal.moved.end();
}

Fractal withBranchPutBack(Fractal fractal, const ifs::Word& branch) {
    if (isMoved(fractal, branch))
        std::erase_if(fractal.moved, [word = idsOf(*system2(fractal), branch)](const MovedBranch& moved) {
            return moved.word == word;
        });
    return fractal;
}

std::optional<Vector<2>> root(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return std::nullopt;
    const auto attractor = ifs::SupportFunction<2>::of(ifs::activeMaps(*system).maps);
    if (!attractor) return std::nullopt;
    const AffineMap<2> seen = ifs::firstOrder(placement(fractal), attractor->centre());
    const Vector<2> down = seen.linear.transpose() * Vector<2>(0, -1);
    return (*attractor)(down, 1e-9 * attractor->radius() * down.norm()).point;
}

} // namespace document
