// SPDX-License-Identifier: MIT
#include "document/variations/variations.h"

#include "document/text/text.h"
#include "document/variations/crossing.h"
#include "document/variations/varied_colours.h"
#include "document/variations/varied_maps.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace document {

namespace {

constexpr int childTrials = 60;
constexpr int fewTrials = 6;
constexpr int weightTrials = 4;
constexpr std::size_t manyMaps = 1000; // number of maps from which on each trial takes long
constexpr double asWellAs = 0.7;       // share of the parent's filling that a child must reach

std::size_t mapCount(const Fractal& fractal) {
    if (const System2* system = system2(fractal)) return system->maps.size();
    const System3* solid = system3(fractal);
    return solid ? solid->maps.size() : 0;
}

template <int Dim> void dropCageAtRest(Fractal& fractal) {
    auto* shape = std::get_if<Shape<Dim>>(&fractal.shape);
    if (shape && shape->cage && shape->cage->rest == shape->cage->current) shape->cage.reset();
}

// Numbers of their own for maps, weights and colours: what of them may change decides nothing of the others.
Chance ownChance(std::uint64_t seed, std::uint64_t which) {
    return Chance(seed + which * 0x9e3779b97f4a7c15);
}

} // namespace

QString variationObstacle(const Fractal& fractal) {
    if (mapCount(fractal) > 0) return {};
    return Text::tr("This entry has no maps to vary.");
}

class Variations::Crossings {
public:
    Crossings(const std::shared_ptr<const Fractal>& parent, const Fractal& partner) {
        if (plane(*parent) && plane(partner)) m_plane.emplace(parent, partner);
        if (space(*parent) && space(partner)) m_space.emplace(parent, partner);
    }

    std::optional<Fractal> child(const MayChange& may, Chance& chance) const {
        if (m_plane) return m_plane->child(may, chance);
        if (m_space) return m_space->child(may, chance);
        return std::nullopt;
    }

private:
    std::optional<Crossing<2>> m_plane;
    std::optional<Crossing<3>> m_space;
};

Variations::Variations(std::shared_ptr<const Fractal> parent, Mutation mutation)
    : m_parent(std::move(parent)), m_mutation(std::move(mutation)), m_wanted(wellFilled) {
    m_mutation.strength = std::clamp(m_mutation.strength, 0.0, 1.0);
    if (m_mutation.partner) m_crossings = std::make_unique<Crossings>(m_parent, *m_mutation.partner);
    if (!m_mutation.may.shape || !hasCertainAttractor(*m_parent)) return;
    const Filling own = filling(*m_parent);
    m_wanted = {std::min(m_wanted.share, asWellAs * own.share),
                std::min(m_wanted.aspect, asWellAs * own.aspect)};
}

Variations::~Variations() = default;

// The fractal from which the maps are varied.
Fractal Variations::start(std::uint64_t seed, int trial) const {
    Chance chance = ownChance(seed, 3 + std::uint64_t(trial));
    auto crossed = m_crossings ? m_crossings->child(m_mutation.may, chance) : std::nullopt;
    Fractal result = crossed ? *std::move(crossed) : *m_parent;
    result.supports = SupportCache(); // the cache belongs to the parent
    return result;
}

Fractal Variations::of(std::uint64_t seed, const std::stop_token& stop) const {
    Chance weights = ownChance(seed, 1), colours = ownChance(seed, 2);
    Varied varied = m_mutation.may.shape ? shaped(seed, stop) : Varied{start(seed, 0), start(seed, 0), 1};
    Fractal result = varied.fractal;
    double strength = m_mutation.strength;
    for (int trial = 0; m_mutation.may.weights && trial < weightTrials && !stop.stop_requested(); ++trial) {
        result = varied.fractal;
        varyWeights(result, varied.from, trial + 1 < weightTrials ? strength : 0, weights);
        if (!m_mutation.may.shape || fillsAs(filling(result), m_wanted) >= std::min(1.0, varied.fills)) break;
        strength /= 2;
    }
    if (m_mutation.may.colours) varyColours(result, m_mutation.strength, colours);
    return result;
}

// The maps varied until they fill the view, for certain, or else those that fill it best.
Variations::Varied Variations::shaped(std::uint64_t seed, const std::stop_token& stop) const {
    Chance chance = ownChance(seed, 0);
    MapVariation variation{m_mutation.strength, true, false};
    Varied best{*m_parent, *m_parent, -1};
    const int most = mapCount(*m_parent) > manyMaps ? fewTrials : childTrials;
    for (int trial = 0; trial < most && best.fills < 1 && !stop.stop_requested(); ++trial) {
        Fractal from = start(seed, trial);
        dropCageAtRest<2>(from);
        dropCageAtRest<3>(from);
        Fractal child = from;
        variation.tames = 2 * trial >= most;
        varyMaps(child, variation, chance);
        variation.strength *= 0.95; // closer children are likelier to fill as well
        const double fills = hasCertainAttractor(child) ? fillsAs(filling(child), m_wanted) : -1;
        if (fills > best.fills) best = {std::move(child), std::move(from), fills};
    }
    return best;
}

Fractal variation(const Fractal& fractal, const Mutation& mutation, std::uint64_t seed) {
    return Variations(std::make_shared<const Fractal>(fractal), mutation).of(seed);
}

} // namespace document
