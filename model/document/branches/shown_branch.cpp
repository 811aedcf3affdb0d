// SPDX-License-Identifier: MIT
#include "document/branches/shown_branch.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"

#include <algorithm>
#include <span>
#include <utility>

namespace document {

namespace {

template <int Dim>
const MovedBranch<Dim>* find(const Shape<Dim>& shape, const std::vector<ifs::MapId>& word) {
    const auto moved = std::ranges::find(shape.moved, word, &MovedBranch<Dim>::word);
    return moved == shape.moved.end() ? nullptr : &*moved;
}

// The change that moves exactly this branch; branches inside it may be moved further.
template <int Dim>
ifs::AffineMap<Dim> shownChange(std::span<const ifs::MovedBranch<Dim>> moved, const ifs::Word& branch) {
    ifs::AffineMap<Dim> change;
    for (const ifs::MovedBranch<Dim>& one : moved)
        if (one.word == branch) change = change * one.change;
    return change;
}

// The change of the branches around this one, as they are shown.
template <int Dim>
ifs::AffineMap<Dim> changeAround(std::span<const ifs::MovedBranch<Dim>> moved, const ifs::Word& branch) {
    ifs::AffineMap<Dim> change;
    for (std::size_t length = 0; length < branch.size(); ++length)
        change = change * shownChange<Dim>(moved, {branch.begin(), branch.begin() + std::ptrdiff_t(length)});
    return change;
}

} // namespace

template <int Dim> ifs::AffineMap<Dim> movedBy(const Shape<Dim>& shape, const ifs::Word& branch) {
    if (shape.moved.empty()) return {};
    const std::vector<ifs::MovedBranch<Dim>> moved = movedBranches(shape);
    return changeAround<Dim>(moved, branch) * shownChange<Dim>(moved, branch);
}

template <int Dim>
ShownBranch<Dim> shownBranch(const Shape<Dim>& shape, const ifs::Word& branch, bool recurs) {
    ifs::AffineMap<Dim> map;
    for (const int index : branch)
        map = map * shape.system.maps[std::size_t(index)].map;
    const std::vector<ifs::MovedBranch<Dim>> moved = movedBranches(shape);
    ShownBranch<Dim> result{idsOf(shape.system, branch), changeAround<Dim>(moved, branch), {}};
    ifs::AffineMap<Dim> change = shownChange<Dim>(moved, branch);
    if (const MovedBranch<Dim>* once = recurs ? find(shape, result.word) : nullptr) {
        const auto back = ifs::inverse(once->change);
        if (back) change = *back * change;
        result.within = result.within * once->change;
    }
    if (recurs) result.word = recurringWord(std::move(result.word));
    result.map = change * map;
    return result;
}

template <int Dim>
void moveShown(Shape<Dim>& shape, const std::vector<ifs::MapId>& word, const ifs::AffineMap<Dim>& change) {
    const auto moved = std::ranges::find(shape.moved, word, &MovedBranch<Dim>::word);
    if (moved == shape.moved.end())
        shape.moved.push_back({word, change});
    else
        moved->change = change * moved->change;
}

template <int Dim> bool isMoved(const Shape<Dim>& shape, const ifs::Word& branch) {
    const auto isMap = [&](int index) { return std::size_t(index) < shape.system.maps.size(); };
    if (shape.moved.empty() || !std::ranges::all_of(branch, isMap)) return false;
    const std::vector<ifs::MapId> word = idsOf(shape.system, branch);
    return find(shape, word) || find(shape, recurringWord(word));
}

template <int Dim> void putBack(Shape<Dim>& shape, const ifs::Word& branch) {
    if (!isMoved(shape, branch)) return;
    const std::vector<ifs::MapId> word = idsOf(shape.system, branch), recurring = recurringWord(word);
    std::erase_if(shape.moved, [&](const MovedBranch<Dim>& moved) {
        return moved.word == word || moved.word == recurring;
    });
}

template <int Dim> ifs::AffineMap<Dim> recurringMap(const Shape<Dim>& shape, const ifs::Word& branch) {
    const MovedBranch<Dim>* moved = find(shape, recurringWord(idsOf(shape.system, branch)));
    return (moved ? moved->change : ifs::AffineMap<Dim>{}) *
           ifs::composed<Dim>(ifs::mapsOf(shape.system), branch);
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template ifs::AffineMap<Dim> movedBy(const Shape<Dim>&, const ifs::Word&);                               \
    template ShownBranch<Dim> shownBranch(const Shape<Dim>&, const ifs::Word&, bool);                        \
    template void moveShown(Shape<Dim>&, const std::vector<ifs::MapId>&, const ifs::AffineMap<Dim>&);        \
    template bool isMoved(const Shape<Dim>&, const ifs::Word&);                                              \
    template void putBack(Shape<Dim>&, const ifs::Word&);                                                    \
    template ifs::AffineMap<Dim> recurringMap(const Shape<Dim>&, const ifs::Word&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace document
