// SPDX-License-Identifier: MIT
#include "document/variations/crossing.h"

#include "animation/morph.h"
#include "animation/paths/look_path.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/variations/varied_colours.h"
#include "ifs/dimension/moments.h"
#include "ifs/system/links.h"
#include "ifs/system/map_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace document {

namespace {

constexpr std::size_t maxCopies = 1024; // limit of maps with the partner's symmetry

std::optional<System2> shownSystem(const Fractal& fractal, const Shape<2>&) {
    return effectiveSystem(fractal);
}

std::optional<System3> shownSystem(const Fractal&, const Shape<3>& shape) {
    if (!shape.cage || shape.cage->rest == shape.cage->current || ifs::bends(*shape.cage))
        return std::nullopt;
    return ifs::conjugate(ifs::displayMap(*shape.cage), shape.system);
}

template <int Dim> const Shape<Dim>& shapeOf(const Fractal& fractal) {
    return std::get<Shape<Dim>>(fractal.shape);
}

// The listed maps that take part, without their symmetry and their links.
template <int Dim> ifs::ActiveMaps<Dim> listedMaps(ifs::IteratedFunctionSystem<Dim> system) {
    system.symmetry = {};
    system.links.clear();
    return ifs::activeMaps(system);
}

template <int Dim> double sizeOf(const ifs::Moments<Dim>& moments) {
    return std::sqrt(moments.covariance.trace());
}

} // namespace

// A map of a child.
template <int Dim> struct Crossing<Dim>::Inherited {
    std::optional<std::size_t> mine{}, its{};
    double share = 0; // 0 … 1; share of the partner
};

template <int Dim>
Crossing<Dim>::Crossing(std::shared_ptr<const Fractal> parent, const Fractal& partner)
    : m_parent(std::move(parent)) {
    const Fractal first = frameAt(partner, {}).fractal;
    const Shape<Dim>& shape = shapeOf<Dim>(first);
    m_partner = shownSystem(first, shape).value_or(shape.system);
    m_partnerAppearance = first.appearance;
    const auto& system = shapeOf<Dim>(*m_parent).system;
    m_parentWeights = ifs::probabilities(system);
    m_partnerWeights = ifs::probabilities(m_partner);
    align(ifs::activeMaps(system), ifs::activeMaps(m_partner));
    pairUp();
}

template <int Dim>
void Crossing<Dim>::align(const ifs::ActiveMaps<Dim>& mine, const ifs::ActiveMaps<Dim>& its) {
    const auto here = ifs::moments<Dim>(mine), there = ifs::moments<Dim>(its);
    if (here) m_reference = here->mean;
    if (!here || !there || !(sizeOf<Dim>(*here) > 0) || !(sizeOf<Dim>(*there) > 0)) return;
    ifs::AffineMap<Dim> change;
    change.linear *= sizeOf<Dim>(*here) / sizeOf<Dim>(*there);
    change.translation = here->mean - change.linear * there->mean;
    if (auto moved = ifs::conjugate(change, m_partner)) m_partner = *std::move(moved);
}

// Pairs maps by the transport of weights, each map once, the heaviest pairs first; without a transport, by
// weight.
template <int Dim> void Crossing<Dim>::pairUp() {
    const auto& system = shapeOf<Dim>(*m_parent).system;
    const ifs::ActiveMaps<Dim> mine = listedMaps(system), its = listedMaps(m_partner);
    std::vector<char> isPaired(mine.maps.size()), isTaken(its.maps.size());
    std::vector<animation::Shipment> candidates;
    if (const auto known = animation::correspondence<Dim>(mine, its)) {
        candidates = known->pairs;
    } else {
        const auto byWeight = [](const std::vector<double>& weights) {
            std::vector<std::size_t> order(weights.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::ranges::stable_sort(order, std::ranges::greater{},
                                     [&](std::size_t i) { return weights[i]; });
            return order;
        };
        const auto ofMine = byWeight(mine.probabilities), ofIts = byWeight(its.probabilities);
        for (std::size_t i = 0; i < std::min(ofMine.size(), ofIts.size()); ++i)
            candidates.push_back({ofMine[i], ofIts[i], mine.probabilities[ofMine[i]]});
    }
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &animation::Shipment::amount);
    for (const animation::Shipment& pair : candidates) {
        if (isPaired[pair.from] || isTaken[pair.to]) continue;
        isPaired[pair.from] = isTaken[pair.to] = 1;
        m_pairs.push_back({mine.index[pair.from], its.index[pair.to]});
    }
    for (std::size_t i = 0; i < mine.maps.size(); ++i)
        if (!isPaired[i]) m_onlyMine.push_back(mine.index[i]);
    for (std::size_t k = 0; k < its.maps.size(); ++k)
        if (!isTaken[k]) m_onlyIts.push_back(its.index[k]);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        if (!std::ranges::binary_search(mine.index, i)) m_resting.push_back(i);
}

template <int Dim>
std::vector<typename Crossing<Dim>::Inherited> Crossing<Dim>::draw(Chance& chance, bool mayLose) const {
    const auto& system = shapeOf<Dim>(*m_parent).system;
    const auto isLocked = [&](std::size_t index) {
        return m_parent->mapLabels.of(system.maps[index].id).isLocked;
    };
    std::vector<Inherited> drawn;
    for (const Pair& pair : m_pairs) {
        const double what = chance.between(0, 3), share = chance.between(0.2, 0.8);
        double taken = what < 1 ? 0 : what < 2 ? 1 : share;
        if (ifs::mirrors<Dim>(system.maps[pair.mine].map, m_partner.maps[pair.its].map))
            taken = std::round(taken); // a mean of both would be flat
        drawn.push_back({pair.mine, pair.its, isLocked(pair.mine) ? 0 : taken});
    }
    for (const std::size_t index : m_onlyMine)
        if (!chance.comes(0.5) || !mayLose || isLocked(index)) drawn.push_back({index, std::nullopt, 0});
    for (const std::size_t index : m_onlyIts)
        if (chance.comes(0.5) && mayLose) drawn.push_back({std::nullopt, index, 1});
    for (const std::size_t index : m_resting)
        drawn.push_back({index, std::nullopt, 0});
    std::ranges::sort(drawn, {}, [](const Inherited& map) { // order of the parent, then of the partner
        return std::pair(map.mine.value_or(SIZE_MAX), map.its.value_or(SIZE_MAX));
    });
    return drawn;
}

template <int Dim> bool Crossing<Dim>::canTakeSymmetry(std::size_t maps) const {
    const auto& symmetry = m_partner.symmetry;
    return maps * ifs::groupOrder(symmetry.group, symmetry.order) <= maxCopies;
}

// Adds the map to the child, whose system begins without maps.
template <int Dim>
void Crossing<Dim>::inherit(const Inherited& from, const MayChange& may, Fractal& child) const {
    const auto& parent = shapeOf<Dim>(*m_parent).system;
    auto& system = std::get<Shape<Dim>>(child.shape).system;
    ifs::WeightedMap<Dim> map;
    if (from.mine) {
        map = parent.maps[*from.mine];
    } else {
        map = m_partner.maps[*from.its];
        map.id = ifs::MapId::None; // gets an id after all maps that have one
        if (!may.weights) map.weight = std::nullopt;
    }
    if (from.mine && from.its && may.shape)
        map.map = ifs::interpolated<Dim>(map.map, m_partner.maps[*from.its].map, from.share, m_reference);
    const double mine = from.mine ? m_parentWeights[*from.mine] : 0;
    const double its = from.its ? m_partnerWeights[*from.its] : 0;
    const bool isLocked = from.mine && m_parent->mapLabels.of(map.id).isLocked;
    if (may.weights && !isLocked && mine + its > 0) map.weight = (1 - from.share) * mine + from.share * its;
    system.maps.push_back(std::move(map));
}

// Mixes the blends of the maps; the child has all of them.
template <int Dim> void Crossing<Dim>::mixBlends(const std::vector<Inherited>& drawn, Fractal& child) const {
    const auto blendOf = [](const attractor::Appearance& appearance, const auto& maps, std::size_t index) {
        return attractor::mapBlend(appearance, maps[index].id, index, maps.size());
    };
    const auto& parent = shapeOf<Dim>(*m_parent).system.maps;
    const auto& maps = shapeOf<Dim>(child).system.maps;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Inherited& map = drawn[i];
        const attractor::MapBlend its =
            map.its ? blendOf(m_partnerAppearance, m_partner.maps, *map.its) : attractor::MapBlend{};
        const attractor::MapBlend mine = map.mine ? blendOf(m_parent->appearance, parent, *map.mine) : its;
        const auto mixed = [&](double a, double b) {
            return map.its ? (1 - map.share) * a + map.share * b : a;
        };
        child.appearance.mapBlends[maps[i].id] = {mixed(mine.coordinate, its.coordinate),
                                                  mixed(mine.speed, its.speed)};
    }
}

template <int Dim> Fractal Crossing<Dim>::child(const MayChange& may, Chance& chance) const {
    Fractal child = *m_parent;
    auto& system = std::get<Shape<Dim>>(child.shape).system;
    std::vector<Inherited> drawn = draw(chance, may.shape);
    const auto isNew = [](const Inherited& map) { return map.share > 0; };
    if (may.shape && std::ranges::none_of(drawn, isNew) && !m_onlyIts.empty())
        drawn.push_back({std::nullopt, m_onlyIts[chance.below(m_onlyIts.size())], 1});
    system.maps.clear();
    for (const Inherited& map : drawn)
        inherit(map, may, child);
    const std::vector<ifs::MapId> fresh = ifs::freshIds(shapeOf<Dim>(*m_parent).system, drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (system.maps[i].id == ifs::MapId::None) system.maps[i].id = fresh[i];
    ifs::dropStaleLinks(system);
    const bool takesSymmetry = chance.comes(0.5);
    if (may.shape && takesSymmetry && canTakeSymmetry(drawn.size())) system.symmetry = m_partner.symmetry;
    if (!may.colours) return child;
    const double share = std::array{0.0, 0.5, 1.0}[chance.below(3)];
    child.appearance = animation::withLook(child.appearance,
                                           animation::between(animation::lookOf(m_parent->appearance),
                                                              animation::lookOf(m_partnerAppearance), share));
    child.appearance.colourBy = m_parent->appearance.colourBy;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Inherited& map = drawn[i];
        const auto& listed = shapeOf<Dim>(*m_parent).system.maps;
        const attractor::Rgba mine = attractor::mapColour(
            m_parent->appearance, map.mine ? listed[*map.mine].id : system.maps[i].id, map.mine.value_or(i));
        const attractor::Rgba its =
            map.its ? attractor::mapColour(m_partnerAppearance, m_partner.maps[*map.its].id, *map.its) : mine;
        child.appearance.mapColours[system.maps[i].id] = mixedColour(mine, its, map.share);
    }
    if (child.appearance.colourBy == attractor::ColourBy::Blend) mixBlends(drawn, child);
    return child;
}

template class Crossing<2>;
template class Crossing<3>;

} // namespace document
