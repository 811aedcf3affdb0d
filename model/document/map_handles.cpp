// SPDX-License-Identifier: MIT
#include "document/map_handles.h"
#include "document/branch_as_map.h"
#include "document/fractal_geometry.h"
#include "document/recurring_branches.h"

#include "ifs/cage/map_handles.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/map_interpolation.h"

#include <algorithm>
#include <utility>

namespace document {

using ifs::AffineMap;
using ifs::Vector;

namespace {

std::vector<ifs::MapId> idsOf(const System2& system, const ifs::Word& indices) {
    std::vector<ifs::MapId> word;
    for (const int index : indices)
        word.push_back(system.maps[std::size_t(index)].id);
    return word;
}

const MovedBranch<2>* find(const Fractal& fractal, const std::vector<ifs::MapId>& word) {
    const auto& branches = plane(fractal)->moved;
    const auto moved = std::ranges::find(branches, word, &MovedBranch<2>::word);
    return moved == branches.end() ? nullptr : &*moved;
}

// What moves exactly this branch; what is inside it moves more.
AffineMap<2> shownChange(std::span<const ifs::MovedBranch<2>> moved, const ifs::Word& branch) {
    AffineMap<2> change;
    for (const ifs::MovedBranch<2>& one : moved)
        if (one.word == branch) change = change * one.change;
    return change;
}

// Of the branches around this one, as they are shown.
AffineMap<2> changeAround(std::span<const ifs::MovedBranch<2>> moved, const ifs::Word& branch) {
    AffineMap<2> change;
    for (std::size_t length = 0; length < branch.size(); ++length)
        change = change * shownChange(moved, {branch.begin(), branch.begin() + std::ptrdiff_t(length)});
    return change;
}

} // namespace

MapHandles::MapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<2>& cage,
                       const AffineMap<2>& within)
    : m_fractal(std::move(fractal)), m_cage(cage), m_placement(placement(*m_fractal)), m_within(within) {}

MapHandles MapHandles::ofBranch(const std::shared_ptr<const Fractal>& fractal,
                                const ifs::ControlCage<2>& cage, const ifs::Word& branch, bool recurs) {
    MapHandles handles(fractal, cage);
    AffineMap<2> map;
    for (const int index : branch)
        map = map * system2(*fractal)->maps[std::size_t(index)].map;
    const std::vector<ifs::MovedBranch<2>> moved = movedBranches(*fractal);
    std::vector<ifs::MapId> word = idsOf(*system2(*fractal), branch);
    const ifs::MapId last = word.back();
    handles.m_within = changeAround(moved, branch); // moves it too, and stays as it is
    AffineMap<2> change = shownChange(moved, branch);
    if (const MovedBranch<2>* once = recurs ? find(*fractal, word) : nullptr) {
        const auto back = ifs::inverse(once->change);
        if (back) change = *back * change;
        handles.m_within = handles.m_within * once->change;
    }
    handles.m_branch = recurs ? recurringWord(std::move(word)) : std::move(word);
    handles.m_branchMap = {{last, change * map, {}}};
    return handles;
}

std::vector<Vector<2>> MapHandles::corners(std::size_t index) const {
    std::vector<Vector<2>> result;
    for (const Vector<2>& vertex : m_cage.rest)
        result.push_back(m_placement(m_within(maps()[index].map(vertex))));
    return result;
}

std::vector<Vector<2>> MapHandles::outline(std::size_t index) const {
    if (!bends()) return corners(index);
    constexpr int parts = 12; // of an edge
    std::vector<Vector<2>> result;
    for (std::size_t i = 0; i < m_cage.rest.size(); ++i) {
        const Vector<2>& from = m_cage.rest[i];
        const Vector<2> edge = m_cage.rest[(i + 1) % m_cage.rest.size()] - from;
        for (int k = 0; k < parts; ++k)
            result.push_back(m_placement(m_within(maps()[index].map(from + edge * (double(k) / parts)))));
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

bool MapHandles::canBeMoved() const {
    return (bends() || ifs::isInvertible(m_cage)) && ifs::inverse(m_within) &&
           (m_branch.empty() || ifs::inverse(m_branchMap.front().map));
}

AffineMap<2> MapHandles::around(std::size_t index) const {
    Vector<2> middle = Vector<2>::Zero();
    for (const Vector<2>& vertex : m_cage.rest)
        middle += m_within(maps()[index].map(vertex)) / double(m_cage.rest.size());
    return ifs::firstOrder(m_placement, middle) * m_within;
}

Fractal MapHandles::changed() const {
    Fractal fractal = *m_fractal;
    if (m_branch.empty()) plane(fractal)->cage = m_cage;
    return fractal;
}

void MapHandles::change(Fractal& fractal, std::size_t index, const AffineMap<2>& change) const {
    if (m_branch.empty()) {
        AffineMap<2>& map = system2(fractal)->maps[index].map;
        map = change * map;
        return;
    }
    auto& branches = plane(fractal)->moved;
    const auto moved = std::ranges::find(branches, m_branch, &MovedBranch<2>::word);
    if (moved == branches.end())
        branches.push_back({m_branch, change});
    else
        moved->change = change * moved->change;
}

void MapHandles::changeDisplayed(Fractal& fractal, std::size_t index, const AffineMap<2>& displayed) const {
    const auto back = ifs::inverse(around(index));
    if (const auto inCode = back ? ifs::conjugate(*back, displayed) : std::nullopt)
        change(fractal, index, *inCode);
}

Fractal MapHandles::withCornerMoved(std::size_t index, std::size_t corner, const Vector<2>& offset) const {
    const auto inCode = ifs::inverse(around(index));
    const auto outOf = ifs::inverse(m_within);
    if (offset.isZero(0) || !inCode || !outOf) return *m_fractal;
    const Vector<2> held = maps()[index].map(m_cage.rest[corner]);
    const Vector<2> seen = m_within(held);
    const auto target = ifs::preimage(m_placement, m_placement(seen) + offset, seen);
    Fractal fractal = changed();
    Vector<2> moved = inCode->linear * offset;
    if (target) moved = outOf->linear * (*target - seen);
    const AffineMap<2>& map = maps()[index].map;
    if (m_branch.empty()) {
        system2(fractal)->maps[index].map = ifs::withHandleMoved(map, m_cage.rest, corner, moved);
        return fractal;
    }
    std::vector<Vector<2>> polygon;
    for (const Vector<2>& vertex : m_cage.rest)
        polygon.push_back(map(vertex));
    change(fractal, index, ifs::withHandleMoved({}, polygon, corner, moved));
    return fractal;
}

Fractal MapHandles::withMapsMoved(std::span<const std::size_t> indices, const Vector<2>& offset) const {
    return withMapsMoved(indices, std::vector<Vector<2>>(indices.size(), offset));
}

Fractal MapHandles::withMapsMoved(std::span<const std::size_t> indices,
                                  std::span<const Vector<2>> offsets) const {
    const auto isZero = [](const Vector<2>& offset) { return offset.isZero(0); };
    if (std::ranges::all_of(offsets, isZero)) return *m_fractal;
    Fractal fractal = changed();
    for (std::size_t k = 0; k < indices.size(); ++k)
        if (const auto inCode = ifs::inverse(around(indices[k])); inCode && !isZero(offsets[k]))
            change(fractal, indices[k], {ifs::Matrix<2>::Identity(), inCode->linear * offsets[k]});
    return fractal;
}

Fractal MapHandles::withMapsChanged(std::span<const std::size_t> indices, const AffineMap<2>& change) const {
    if (change == AffineMap<2>{}) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t index : indices)
        changeDisplayed(fractal, index, change);
    return fractal;
}

Fractal MapHandles::withMapsSwung(std::span<const std::size_t> indices, const Vector<2>& root,
                                  double angle) const {
    if (angle == 0) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t index : indices)
        changeDisplayed(fractal, index,
                        ifs::swung({}, m_placement(m_within(maps()[index].map(root))), angle));
    return fractal;
}

std::optional<BranchHandles> branchHandles(const std::shared_ptr<const Fractal>& fractal,
                                           const ifs::ControlCage<2>& cage, const ifs::Word& branch,
                                           BranchEdit edit) {
    if (branch.empty() || system2(*fractal) == nullptr) return std::nullopt;
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*system2(*fractal));
    auto letters = ifs::overMaps(branch, active.index);
    if (!letters) return std::nullopt;
    if (keepsCode(edit))
        return BranchHandles{MapHandles::ofBranch(fractal, cage, branch, edit == BranchEdit::Inside), 0};
    const std::vector<ifs::MovedBranch<2>> branches = movedBranches(*fractal);
    const AffineMap<2> moved = changeAround(branches, branch) * shownChange(branches, branch);
    if (branch.size() == 1) return BranchHandles{{fractal, cage, moved}, std::size_t(branch.front())};
    if (edit == BranchEdit::OwnMap && active.isLinked())
        return std::nullopt; // the maps that divide the others would have links of their own
    if (edit == BranchEdit::OwnMap)
        return BranchHandles{
            {std::make_shared<const Fractal>(withBranchAsMap<2>(*fractal, *letters)), cage, moved}, 0};
    letters->pop_back();
    return BranchHandles{{fractal, cage, moved * ifs::composed<2>(active.maps, *letters)},
                         std::size_t(branch.back())};
}

bool isMoved(const Fractal& fractal, const ifs::Word& branch) {
    const Shape<2>* shape = plane(fractal);
    if (!shape || shape->moved.empty()) return false;
    const auto isMap = [&](int index) { return std::size_t(index) < shape->system.maps.size(); };
    if (!std::ranges::all_of(branch, isMap)) return false;
    const std::vector<ifs::MapId> word = idsOf(shape->system, branch);
    return find(fractal, word) || find(fractal, recurringWord(word));
}

AffineMap<2> recurringMap(const Fractal& fractal, const ifs::Word& branch) {
    const System2& system = *system2(fractal);
    const MovedBranch<2>* moved = find(fractal, recurringWord(idsOf(system, branch)));
    return (moved ? moved->change : AffineMap<2>{}) * ifs::composed<2>(ifs::mapsOf(system), branch);
}

Fractal withBranchPutBack(Fractal fractal, const ifs::Word& branch) {
    if (!isMoved(fractal, branch)) return fractal;
    const std::vector<ifs::MapId> word = idsOf(*system2(fractal), branch), recurring = recurringWord(word);
    std::erase_if(plane(fractal)->moved,
                  [&](const MovedBranch<2>& moved) { return moved.word == word || moved.word == recurring; });
    return fractal;
}

std::optional<Vector<2>> root(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return std::nullopt;
    if (const auto linked = linkedExtent(fractal)) {
        const AffineMap<2> seen = ifs::firstOrder(placement(fractal), linked->centre());
        return (*linked)(seen.linear.transpose() * Vector<2>(0, -1), 1e-9 * linked->radius()).point;
    }
    const auto attractor = supportFunction(fractal);
    if (!attractor) return std::nullopt;
    const AffineMap<2> seen = ifs::firstOrder(placement(fractal), attractor->centre());
    const Vector<2> down = seen.linear.transpose() * Vector<2>(0, -1);
    return (*attractor)(down, 1e-9 * attractor->radius() * down.norm()).point;
}

} // namespace document
