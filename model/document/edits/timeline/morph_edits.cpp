// SPDX-License-Identifier: MIT
#include "document/edits/timeline/morph_edits.h"

#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "ifs/dimension/moments.h"

#include <algorithm>
#include <map>
#include <utility>

namespace document {

namespace {

std::optional<System2> shownSystem(const Fractal& fractal, const Shape<2>&) {
    return effectiveSystem(fractal);
}

std::optional<System3> shownSystem(const Fractal&, const Shape<3>& shape) {
    if (!shape.cage || shape.cage->rest == shape.cage->current) return shape.system;
    if (ifs::bends(*shape.cage)) return std::nullopt;
    return ifs::conjugate(ifs::displayMap(*shape.cage), shape.system);
}

// Pins count all maps, the transport only those that take part.
template <int Dim>
std::vector<animation::Pin> overActive(std::span<const animation::Pin> pins, const ifs::ActiveMaps<Dim>& from,
                                       const ifs::ActiveMaps<Dim>& to) {
    std::vector<animation::Pin> result;
    for (const animation::Pin& pin : pins) {
        for (std::size_t i = 0; i < from.index.size(); ++i)
            for (std::size_t k = 0; k < to.index.size(); ++k)
                if (from.index[i] == pin.from && to.index[k] == pin.to) result.push_back({i, k});
    }
    return result;
}

// Weights of listed maps, from those of their copies.
template <int Dim>
std::vector<animation::Shipment> overListed(const std::vector<animation::Shipment>& pairs,
                                            const ifs::ActiveMaps<Dim>& from,
                                            const ifs::ActiveMaps<Dim>& to) {
    std::map<std::pair<std::size_t, std::size_t>, double> amounts;
    for (const animation::Shipment& pair : pairs)
        amounts[{from.index[pair.from], to.index[pair.to]}] += pair.amount;
    std::vector<animation::Shipment> result;
    for (const auto& [places, amount] : amounts)
        result.push_back({places.first, places.second, amount});
    return result;
}

template <int Dim>
MorphOutcome morphedIn(const Fractal& from, const Fractal& to, int length,
                       std::span<const animation::Pin> pins) {
    const auto first = shownSystem(from, std::get<Shape<Dim>>(from.shape));
    const auto last = shownSystem(to, std::get<Shape<Dim>>(to.shape));
    const auto flawed = [](MorphFlaw flaw, bool isOfFirst) { return MorphOutcome{{}, flaw, {}, !isOfFirst}; };
    if (!first || !last) return flawed(MorphFlaw::BentCage, !first);
    const auto begin = ifs::activeMaps(*first), end = ifs::activeMaps(*last);
    if (begin.isLinked() || end.isLinked()) return flawed(MorphFlaw::Linked, begin.isLinked());
    if (std::max(begin.maps.size(), end.maps.size()) > animation::maxMorphMaps)
        return flawed(MorphFlaw::TooMany, begin.maps.size() > animation::maxMorphMaps);
    const auto pairs = animation::correspondence<Dim>(begin, end, overActive<Dim>(pins, begin, end));
    if (!pairs) return flawed(MorphFlaw::Measure, !ifs::moments<Dim>(begin));
    animation::Morph<Dim> morph = animation::morph<Dim>(begin, end, *pairs, length);
    const animation::Look before = lookOf(from), after = lookOf(to);
    if (!(before == after)) morph.animation.look = {{0, before, {}}, {length, after, {}}};
    Fractal fractal = withLook(Fractal(), before);
    fractal.name = from.name + u'-' + to.name;
    Shape<Dim> shape{std::move(morph.system)};
    shape.animation = std::move(morph.animation);
    fractal.shape = std::move(shape);
    return {std::move(fractal), {}, overListed<Dim>(pairs->pairs, begin, end)};
}

} // namespace

MorphOutcome morphed(const Fractal& from, const Fractal& to, int length,
                     std::span<const animation::Pin> pins) {
    if (plane(from) && plane(to)) return morphedIn<2>(from, to, length, pins);
    if (space(from) && space(to)) return morphedIn<3>(from, to, length, pins);
    return {};
}

} // namespace document
