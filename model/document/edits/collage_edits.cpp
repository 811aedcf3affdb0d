// SPDX-License-Identifier: MIT
#include "document/edits/collage_edits.h"

#include "collage/fit/attractor_fit.h"
#include "collage/fit/cage_fit.h"
#include "collage/fit/collage_fit.h"
#include "collage/fit/weight_fit.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"

#include <algorithm>

namespace document {

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;

constexpr double margin = 0.25;     // margin around the target, as a share of its longer side
constexpr double maxNorm = 0.9;     // norm of a map moved by a fit
constexpr double weightBlur = 2;    // pixels
constexpr double newScale = 0.3;    // scale of an added map
constexpr int addedSide = 128;      // cells along the longer side of the target for adding a map
constexpr double cageMargin = 0.02; // margin of the cage, as a share of the size of the attractor

struct Level {
    int side; // cells along the longer side of the target
    int iterations;
};
constexpr Level levels[] = {{64, 25}, {128, 15}, {256, 10}, {512, 8}};

collage::Target level(const TracedPicture& traced, int side) {
    return placed(collage::target(traced.mask, collage::factorFor(traced.mask, side), margin), traced.place);
}

// A map of the picture that is 1 unit high, with its middle at the origin, as that of the placed one.
ifs::AffineMap<2> movedTo(const PicturePlace& place, const ifs::AffineMap<2>& map) {
    return {map.linear, place.height * map.translation + place.middle - map.linear * place.middle};
}

// And back.
Maps inUnits(const PicturePlace& place, const Maps& maps) {
    Maps result;
    for (const auto& map : maps)
        result.push_back(
            {map.linear, (map.translation - place.middle + map.linear * place.middle) / place.height});
    return result;
}

std::vector<std::uint8_t> lockedIn(const Fractal& fractal, const CollageMaps& maps,
                                   const std::vector<ifs::MapId>& locked) {
    std::vector<std::uint8_t> flags;
    for (const std::size_t index : maps.index)
        flags.push_back(std::ranges::count(locked, system2(fractal)->maps[index].id) > 0);
    return flags;
}

// The code with those of the displayed maps that have changed.
std::optional<Fractal> withMaps(Fractal fractal, const CollageMaps& before, const Maps& after) {
    const auto back = ifs::inverse<2>(placement(fractal).affine());
    if (!back) return std::nullopt;
    bool isChanged = false;
    for (std::size_t k = 0; k < after.size(); ++k) {
        if (after[k] == before.maps[k]) continue;
        const auto map = ifs::conjugate<2>(*back, after[k]);
        if (!map || !ifs::isFinite(*map)) return std::nullopt;
        system2(fractal)->maps[before.index[k]].map = *map;
        isChanged = true;
    }
    return isChanged ? std::optional(std::move(fractal)) : std::nullopt;
}

double visible(const TracedPicture& traced, const Maps& maps) {
    return collage::visibleError(traced.target, collage::attractorAgreement(traced.target, maps));
}

// ICP at one level; the maps that are locked keep their bits.
Maps improved(const collage::Target& target, const Maps& maps, const collage::FitSchedule& schedule,
              std::span<const std::uint8_t> locked, const std::stop_token& stop) {
    Maps inside;
    for (const auto& map : maps)
        inside.push_back(collage::inGrid(target.grid, map));
    collage::CollageFit(target).improve(inside, schedule, locked, stop);
    Maps result = maps;
    for (std::size_t k = 0; k < maps.size(); ++k)
        if (locked.empty() || locked[k] == 0) result[k] = collage::fromGrid(target.grid, inside[k]);
    return result;
}

double collageError(const TracedPicture& traced, const Maps& maps) {
    return collage::collageMeasure(traced.target, maps).images.mean;
}

// Density of the target: its darkness, or its opacity.
collage::Density densityOf(const TracedPicture& traced) {
    collage::Density density{traced.mask.width, traced.mask.height, {}};
    const bool byOpacity = collage::isShapedByOpacity(traced.picture);
    const std::vector<std::uint8_t>& shade = byOpacity ? traced.picture.opacity : traced.picture.grey;
    for (std::size_t k = 0; k < traced.mask.cells.size(); ++k) {
        const double mass = byOpacity ? shade[k] : 255 - shade[k];
        density.mass.push_back(traced.mask.cells[k] != 0 ? mass : 0.0);
    }
    return density;
}

} // namespace

QString collageObstacle(const Fractal& fractal) {
    if (QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (ifs::countActive(*system2(fractal)) == 0) return Text::tr("All maps are off.");
    if (!system2(fractal)->links.empty())
        return Text::tr(
            "The maps are linked. Only maps that may all follow each other can be compared with a "
            "picture.");
    if (isSymmetric(fractal))
        return Text::tr("A symmetry repeats the maps. Expand it to compare them with a picture.");
    if (!effectiveSystem(fractal))
        return Text::tr("The cage bends the picture, or is flat. Reset the cage to compare the maps.");
    return {};
}

std::optional<CollageMaps> collageMaps(const Fractal& fractal) {
    if (!collageObstacle(fractal).isEmpty()) return std::nullopt;
    // Maps of the code itself, bit for bit, if the cage is at rest.
    const System2 shown = isAtRest(fractal) ? *system2(fractal) : *effectiveSystem(fractal);
    const std::vector<double> probabilities = ifs::probabilities(shown);
    CollageMaps maps;
    for (std::size_t i = 0; i < shown.maps.size(); ++i) {
        if (probabilities[i] <= 0) continue;
        if (!ifs::isFinite(shown.maps[i].map)) return std::nullopt;
        maps.maps.push_back(shown.maps[i].map);
        maps.index.push_back(i);
    }
    return maps;
}

Fractal withSuggestion(Fractal fractal, const collage::Suggestion& suggestion, const PicturePlace& place) {
    Shape<2> shape;
    for (std::size_t i = 0; i < suggestion.maps.size(); ++i)
        ifs::append<2>(shape.system, movedTo(place, suggestion.maps[i]), suggestion.weights[i]);
    fractal.shape = std::move(shape);
    fractal.mapLabels = {}; // labels belong to other maps
    return fractal;
}

std::optional<Fractal> withMapsRefined(const Fractal& fractal, const TracedPicture& traced,
                                       const CollageFitOptions& options, const std::stop_token& stop) {
    const auto before = collageMaps(fractal);
    if (!before) return std::nullopt;
    const auto locked = lockedIn(fractal, *before, options.locked);
    const auto reach = std::max(traced.mask.width, traced.mask.height);
    Maps maps = before->maps;
    Maps best = maps;
    double bestError = collageError(traced, maps);
    for (const Level& at : levels) {
        if (stop.stop_requested()) return std::nullopt;
        maps = improved(level(traced, at.side), maps,
                        {options.constraints, at.iterations, 0, maxNorm, maxNorm}, locked, stop);
        const double error = collageError(traced, maps);
        if (error < bestError) {
            best = maps;
            bestError = error;
        }
        if (at.side >= reach) break; // finer levels would be the same
    }
    return stop.stop_requested() ? std::nullopt : withMaps(fractal, *before, best);
}

std::optional<Fractal> withAttractorRefined(const Fractal& fractal, const TracedPicture& traced,
                                            const CollageFitOptions& options, const std::stop_token& stop) {
    const auto before = collageMaps(fractal);
    if (!before || collage::contraction(before->maps) >= 1) return std::nullopt;
    const auto locked = lockedIn(fractal, *before, options.locked);
    Maps maps = before->maps;
    for (const Level& at : {Level{128, 8}, Level{256, 4}}) {
        if (stop.stop_requested()) return std::nullopt;
        maps = collage::fittedAttractor(level(traced, at.side), std::move(maps),
                                        {options.constraints, at.iterations, 0.95}, locked, stop);
    }
    if (stop.stop_requested() || !(visible(traced, maps) < visible(traced, before->maps)))
        return std::nullopt;
    return withMaps(fractal, *before, maps);
}

std::optional<Fractal> withWeightsFitted(const Fractal& fractal, const TracedPicture& traced,
                                         const std::stop_token& stop) {
    const auto maps = collageMaps(fractal);
    if (!maps) return std::nullopt;
    const std::vector<double> weights = ifs::shares(
        collage::fittedWeights(densityOf(traced), inUnits(traced.place, maps->maps), weightBlur, stop), 1e-4);
    if (stop.stop_requested()) return std::nullopt;
    Fractal result = fractal;
    for (std::size_t k = 0; k < weights.size(); ++k)
        system2(result)->maps[maps->index[k]].weight = weights[k];
    return result == fractal ? std::nullopt : std::optional(std::move(result));
}

std::optional<double> shadesBound(const Fractal& fractal, const TracedPicture& traced,
                                  const std::stop_token& stop) {
    const auto maps = collageMaps(fractal);
    if (!maps) return std::nullopt;
    const std::vector<double> all = ifs::probabilities(*system2(fractal));
    std::vector<double> weights;
    for (const std::size_t index : maps->index)
        weights.push_back(all[index]);
    return collage::measureBound(densityOf(traced), inUnits(traced.place, maps->maps), weights, stop);
}

std::optional<Fractal> withCageFittedTo(const Fractal& fractal, const TracedPicture& traced, int corners,
                                        const std::stop_token& stop) {
    if (!planeObstacle(fractal).isEmpty() || !system2(fractal)->links.empty()) return std::nullopt;
    Fractal result = fractal;
    plane(result)->cage.reset();
    auto held = withCageAround(withCageAtRest(std::move(result)), PolygonChoice::Regular, corners);
    const ifs::ControlCage<2>* cage = held ? cage2(*held) : nullptr;
    if (!cage) return std::nullopt;
    std::vector<ifs::Vector<2>> rest = cage->rest;
    ifs::Vector<2> middle = ifs::Vector<2>::Zero();
    for (const auto& vertex : rest)
        middle += vertex / double(rest.size());
    for (auto& vertex : rest)
        vertex += cageMargin * (vertex - middle);
    Maps maps;
    for (const auto& map : ifs::activeMaps(*system2(*held)).maps)
        maps.push_back(map);
    const auto fit = collage::fittedCage(traced.target, maps, rest, ifs::Coordinates::Wachspress, stop);
    if (!fit) return std::nullopt;
    plane(*held)->cage = ifs::ControlCage<2>{std::move(rest), fit->vertices, ifs::Deformation::Bend};
    return *held == fractal ? std::nullopt : held;
}

std::optional<Fractal> withMapAdded(const Fractal& fractal, const TracedPicture& traced,
                                    const ifs::Vector<2>& point, const collage::Constraints& constraints,
                                    const std::stop_token& stop) {
    auto before = collageMaps(fractal);
    if (!before) return std::nullopt;
    Fractal result = fractal;
    System2& system = *system2(result);
    collage::Constraints ofNew = constraints;
    if (!system.maps.empty()) ofNew.first = collage::FirstMap::Free;
    const collage::Target coarse = level(traced, addedSide);
    const ifs::Vector<2> mean = coarse.grid.fromGrid()(coarse.mean);
    ifs::AffineMap<2> added = ifs::affineMap(newScale, 0, 0, newScale, 0, 0);
    added.translation = point - newScale * mean;
    Maps maps = before->maps;
    maps.push_back(added);
    std::vector<std::uint8_t> locked(maps.size(), 1);
    locked.back() = 0;
    const ifs::AffineMap<2> fitted =
        improved(coarse, maps, {ofNew, 25, 10, 0.5, maxNorm}, locked, stop).back();
    if (stop.stop_requested()) return std::nullopt;
    const auto back = ifs::inverse<2>(placement(fractal).affine());
    const auto map = back ? ifs::conjugate<2>(*back, fitted) : std::nullopt;
    if (!map || !ifs::isFinite(*map)) return std::nullopt;
    const bool isRuled =
        std::ranges::none_of(system.maps, [](const auto& one) { return one.weight.has_value(); });
    std::optional<double> weight;
    if (!isRuled) {
        const std::vector<double> probabilities = ifs::probabilities(system);
        const auto active = double(before->maps.size());
        for (std::size_t i = 0; i < system.maps.size(); ++i)
            if (system.maps[i].enabled) system.maps[i].weight = probabilities[i];
        weight = 1 / active;
    }
    ifs::append<2>(system, *map, weight);
    return result;
}

} // namespace document
