// SPDX-License-Identifier: MIT
#include "document/branches/branch_as_map.h"

#include "attractor/request/colour_coordinates.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "ifs/system/recurring_branch.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace document {

namespace {

template <int Dim> using System = ifs::IteratedFunctionSystem<Dim>;

// Appearance of the maps over the cut set of the branch, which come first, and of those that take no part.
// Where addresses colour, their blends give the points the colours of their old addresses.
template <int Dim>
attractor::MapBlends blendsOver(const Fractal& fractal, const ifs::ActiveMaps<Dim>& active,
                                const ifs::Word& branch, const System<Dim>& system) {
    const attractor::Appearance& appearance = fractal.appearance;
    attractor::MapBlends blends;
    const bool isByAddress = appearance.colourBy == attractor::ColourBy::Address;
    if (!isByAddress && appearance.colourBy != attractor::ColourBy::Blend && appearance.mapBlends.empty())
        return blends;
    const System<Dim>& before = std::get<Shape<Dim>>(fractal.shape).system;
    const auto blendAt = [&](std::size_t index) {
        return attractor::mapBlend(appearance, before.maps[index].id, index, before.maps.size());
    };
    const auto blendOf = [&](int letter) {
        return isByAddress ? attractor::addressBlend(std::size_t(letter), active.maps.size())
                           : blendAt(active.index[std::size_t(letter)]);
    };
    std::size_t made = 0;
    for (const ifs::Word& word : ifs::cutSet(branch, active.maps.size())) {
        attractor::MapBlend blend{0, 0};
        for (const int letter : word)
            blend = attractor::composed(blend, blendOf(letter));
        blends[system.maps[made++].id] = blend;
    }
    for (std::size_t index = 0; index < before.maps.size(); ++index)
        if (!std::ranges::binary_search(active.index, index)) blends[system.maps[made++].id] = blendAt(index);
    return blends;
}

// The moved branches of the fractal over the cut set of `letters`, whose maps are those of `system`. A branch
// that changes inside itself goes on doing so if it is one word there, too; else each of its branches is
// moved.
template <int Dim>
std::vector<MovedBranch<Dim>> movedOver(const Shape<Dim>& before, const ifs::ActiveMaps<Dim>& active,
                                        const ifs::Word& letters, const System<Dim>& system) {
    const auto over = [&](const ifs::Word& word) {
        return ifs::overCutSet(word, letters, active.maps.size());
    };
    std::vector<ifs::MovedBranch<Dim>> once, again;
    for (StoredBranch<Dim>& stored : storedBranches(before))
        (stored.recurs ? again : once).push_back(std::move(stored.branch));
    std::vector<MovedBranch<Dim>> moved;
    for (const auto& [word, change] : ifs::overMaps<Dim>(once, active.index))
        for (const ifs::Word& other : over(word))
            moved.push_back({idsOf(system, other), change});
    for (const ifs::MovedBranch<Dim>& branch : ifs::overMaps<Dim>(again, active.index)) {
        if (const auto others = over(branch.word); others.size() == 1) {
            moved.push_back({recurringWord(idsOf(system, others.front())), branch.change});
            continue;
        }
        for (const auto& [word, change] : ifs::recurring<Dim>(branch, active.maps))
            for (const ifs::Word& other : over(word)) {
                const std::vector<ifs::MapId> ids = idsOf(system, other);
                const auto known = std::ranges::find(moved, ids, &MovedBranch<Dim>::word);
                if (known == moved.end())
                    moved.push_back({ids, change});
                else
                    known->change = known->change * change;
            }
    }
    return moved;
}

} // namespace

template <int Dim> Fractal withBranchAsMap(const Fractal& fractal, const ifs::Word& letters) {
    const auto& shape = std::get<Shape<Dim>>(fractal.shape);
    const System<Dim>& before = shape.system;
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(before);
    Fractal result = fractal;
    System<Dim> system = ifs::withBranchChanged<Dim>(before, letters, {});
    attractor::MapColours& colours = result.appearance.mapColours = {};
    colours.reserve(system.maps.size());
    result.mapLabels = {};
    std::size_t made = 0;
    const auto keepColour = [&](std::size_t index) { // colour of the next map
        const ifs::MapId id = system.maps[made++].id, of = before.maps[index].id;
        colours[id] = attractor::mapColour(fractal.appearance, of, index);
        result.mapLabels.set(id, fractal.mapLabels.of(of));
    };
    const auto keepColourOf = [&](int letter) { keepColour(active.index[std::size_t(letter)]); };
    keepColourOf(letters.front());
    for (const auto& [kept, symbol] : ifs::departures(letters, active.maps.size()))
        keepColourOf(kept > 0 ? letters.front() : symbol);
    for (std::size_t index = 0; index < before.maps.size(); ++index) {
        if (std::ranges::binary_search(active.index, index)) continue;
        system.maps.push_back(before.maps[index]);
        system.maps.back().id = ifs::MapId{std::uint32_t(system.maps.size())};
        keepColour(index);
    }
    result.appearance.mapBlends = blendsOver(fractal, active, letters, system);
    if (result.appearance.colourBy == attractor::ColourBy::Address)
        result.appearance.colourBy = attractor::ColourBy::Blend; // addresses have changed
    Shape<Dim> over(system, shape.cage);
    over.moved = movedOver(shape, active, letters, system);
    result.shape = std::move(over);
    return result;
}
template Fractal withBranchAsMap<2>(const Fractal&, const ifs::Word&);
template Fractal withBranchAsMap<3>(const Fractal&, const ifs::Word&);

} // namespace document
