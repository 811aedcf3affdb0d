// SPDX-License-Identifier: MIT
#include "document/maps/map_solo.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "ifs/linear/singular_vectors.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace document {

namespace {

// Share of the largest extent below which a picture looks flat, and can be drawn as a solid.
constexpr double thin = 1e-3;

template <int Dim>
std::optional<std::size_t> indexOf(const ifs::IteratedFunctionSystem<Dim>& system, ifs::MapId map) {
    const auto found = std::ranges::find(system.maps, map, &ifs::WeightedMap<Dim>::id);
    if (map == ifs::MapId::None || found == system.maps.end()) return std::nullopt;
    return std::size_t(found - system.maps.begin());
}

// The part of a palette that a map has: colours by address or blend are spread from it to the whole.
attractor::Palette shareOf(const attractor::Palette& palette, double from, double to) {
    attractor::Palette share{palette.name, {}};
    share.stops.push_back({0, attractor::colourAt(palette, from)});
    for (const auto& stop : palette.stops)
        if (stop.position > from && stop.position < to)
            share.stops.push_back({(stop.position - from) / (to - from), stop.colour});
    share.stops.push_back({1, attractor::colourAt(palette, to)});
    return share;
}

// Gives every map below the colour of this one.
template <int Dim>
void keepColours(attractor::Appearance& appearance, const ifs::IteratedFunctionSystem<Dim>& system,
                 std::size_t index, bool isByMap, bool isByAddress, bool isByBlend) {
    if (isByMap) {
        const attractor::Rgba colour = attractor::mapColour(appearance, system.maps[index].id, index);
        attractor::MapColours colours;
        colours.reserve(system.maps.size());
        std::vector<ifs::MapId> ids;
        for (const auto& map : system.maps)
            ids.push_back(map.id);
        std::ranges::sort(ids);
        for (const ifs::MapId id : ids)
            colours[id] = colour;
        appearance.mapColours = std::move(colours);
    }
    if (isByBlend) {
        const attractor::MapBlend blend =
            attractor::mapBlend(appearance, system.maps[index].id, index, system.maps.size());
        const double from = blend.speed * blend.coordinate;
        appearance.palette = shareOf(appearance.palette, from, from + 1 - blend.speed);
    }
    if (!isByAddress) return;
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    const auto place = std::ranges::lower_bound(active.index, index);
    if (place == active.index.end() || *place != index) return;
    const double count = double(active.index.size()), at = double(place - active.index.begin());
    appearance.palette = shareOf(appearance.palette, at / count, (at + 1) / count);
}

// Branches that are moved stay moved, where they are parts of this one; what moves all of it is `whole`.
template <int Dim> struct Within {
    std::vector<MovedBranch<Dim>> moved{};
    ifs::AffineMap<Dim> whole{};
};
template <int Dim> Within<Dim> within(const Shape<Dim>& shape, std::size_t index) {
    const auto& maps = shape.system.maps;
    const ifs::AffineMap<Dim>& map = maps[index].map;
    Within<Dim> result;
    const auto back = ifs::inverse<Dim>(map);
    for (const auto& [word, change] : movedBranches(shape)) {
        if (word.empty() || std::size_t(word.front()) != index) continue;
        if (word.size() == 1) {
            result.whole = result.whole * change;
        } else if (back) {
            result.moved.push_back({{}, *back * change * map});
            for (const int letter : std::span(word).subspan(1))
                result.moved.back().word.push_back(maps[std::size_t(letter)].id);
        }
    }
    return result;
}

// The map, or one that is nearly as flat.
ifs::AffineMap<3> thickened(const ifs::AffineMap<3>& map) {
    const auto [left, values, right] = ifs::singularVectors<3>(map.linear);
    if (values[2] >= thin * values[0]) return map;
    return {left * values.cwiseMax(thin * values[0]).asDiagonal() * right.transpose(), map.translation};
}

// The cage that takes all of the attractor to the image of the map under the present one, which does not
// bend.
ifs::ControlCage<3> cageOnto(const std::optional<ifs::ControlCage<3>>& cage, const ifs::AffineMap<3>& map) {
    ifs::ControlCage<3> onto =
        cage ? *cage : ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const ifs::AffineMap<3> display = cage ? ifs::displayMap(*cage) : ifs::AffineMap<3>{};
    for (std::size_t k = 0; k < onto.rest.size(); ++k)
        onto.current[k] = display(map(onto.rest[k]));
    return onto;
}

} // namespace

QString soloObstacle(const Fractal& fractal, ifs::MapId map) {
    if (const System2* system = system2(fractal)) {
        if (!indexOf(*system, map)) return Text::tr("Select a map first.");
        if (!system->links.empty())
            return Text::tr("The maps are linked. Only maps that may all follow each other can be shown "
                            "alone.");
        return {};
    }
    const Shape<3>* solid = space(fractal);
    const auto index = solid ? indexOf(solid->system, map) : std::nullopt;
    if (!index) return Text::tr("Select a map first.");
    if (solid->cage && ifs::bends(*solid->cage))
        return Text::tr(
            "The cage bends the picture, in which no map can be shown alone. Reset the cage first.");
    if (solid->system.maps[*index].map.linear.isZero())
        return Text::tr("Map %1 takes everything to one point, so there is nothing to show alone.")
            .arg(*index + 1);
    return {};
}

Fractal soloed(Fractal fractal, ifs::MapId map) {
    const bool isByAddress = fractal.appearance.colourBy == attractor::ColourBy::Address;
    const bool isByMap = fractal.appearance.colourBy == attractor::ColourBy::Map;
    const bool isByBlend = fractal.appearance.colourBy == attractor::ColourBy::Blend;
    if (Shape<2>* shape = plane(fractal)) {
        const auto index = indexOf(shape->system, map);
        if (index && soloObstacle(fractal, map).isEmpty()) {
            keepColours(fractal.appearance, shape->system, *index, isByMap, isByAddress, isByBlend);
            Within<2> inside = within(*shape, *index);
            inside.moved.push_back({{}, inside.whole * shape->system.maps[*index].map}); // whole attractor
            shape->moved = std::move(inside.moved);
        }
    } else if (Shape<3>* solid = space(fractal)) {
        const auto index = indexOf(solid->system, map);
        if (!index || !soloObstacle(fractal, map).isEmpty()) return fractal;
        using attractor::SolidColour;
        const auto colour = fractal.inSpace.colourBy;
        keepColours(fractal.appearance, solid->system, *index, isByMap || colour == SolidColour::Map,
                    isByAddress || colour == SolidColour::Address,
                    isByBlend && attractor::showsCloud(fractal.inSpace.look));
        Within<3> inside = within(*solid, *index);
        solid->cage = cageOnto(solid->cage, thickened(inside.whole * solid->system.maps[*index].map));
        solid->moved = std::move(inside.moved);
    }
    return fractal;
}

} // namespace document
