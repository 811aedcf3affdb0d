// SPDX-License-Identifier: MIT
#include "web/engine.h"

#include "web/engine_rows.h"
#include "web/engine_state.h"

#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "ifs/system/links.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace web {

namespace {

attractor::Rgba colourAt(const double* numbers) {
    const auto channel = [&](int i) { return std::uint8_t(std::clamp(numbers[i], 0.0, 255.0)); };
    return {channel(0), channel(1), channel(2), channel(3)};
}

template <int Dim> void settle(Loaded<Dim>& loaded) {
    loaded.box.reset();
    loaded.simplex.reset();
    const auto active = ifs::activeMaps(loaded.system);
    if (const auto support = ifs::SupportFunction<Dim>::of(active.maps)) {
        loaded.box = ifs::boundingBox(*support);
        loaded.simplex = ifs::minimalCanonicalSimplex(*support);
    }
    if constexpr (Dim == 2) {
        if (!active.isLinked()) return;
        loaded.box.reset();
        loaded.simplex.reset();
        if (const auto linked = ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active))) {
            loaded.box = ifs::boundingBox(*linked);
            loaded.simplex = ifs::minimalCanonicalSimplex(*linked);
        }
    }
}

template <int Dim> int writeExtent(const Loaded<Dim>& loaded, double* box, double* simplex) {
    if (!loaded.box || !loaded.simplex) return 0;
    box = std::copy_n(loaded.box->min.data(), Dim, box);
    box = std::copy_n(loaded.box->max.data(), Dim, box);
    *box = loaded.box->error;
    for (const auto& vertex : loaded.simplex->vertices)
        simplex = std::copy_n(vertex.data(), Dim, simplex);
    return 1;
}

template <int Dim>
std::optional<ifs::ControlCage<Dim>> cageOf(const double* rest, const double* current, int count,
                                            bool bends) {
    ifs::ControlCage<Dim> cage;
    for (int i = 0; i < count; ++i, rest += Dim, current += Dim) {
        cage.rest.push_back(vectorAt<Dim>(rest));
        cage.current.push_back(vectorAt<Dim>(current));
    }
    cage.deformation = bends ? ifs::Deformation::Bend : ifs::Deformation::AffineFit;
    return ifs::isValid(cage) ? std::optional(std::move(cage)) : std::nullopt;
}

template <int Dim>
bool setSymmetry(Loaded<Dim>& loaded, int group, int order, double angle, const double* place) {
    ifs::Symmetry<Dim> symmetry;
    symmetry.group = ifs::SymmetryGroup(group);
    symmetry.order = order;
    symmetry.angle = angle;
    symmetry.centre = vectorAt<Dim>(place);
    symmetry.frame = mapAt<Dim>(place + Dim).linear;
    if (!ifs::isValid(symmetry)) return false;
    loaded.system.symmetry = symmetry;
    return true;
}

template <int Dim> void readRows(Loaded<Dim>& loaded, const double* rows, int maps) {
    for (int i = 0; i < maps; ++i, rows += rowLength<Dim>) {
        const double weight = rows[rowLength<Dim> - 1];
        ifs::append(loaded.system, mapAt<Dim>(rows),
                    std::isnan(weight) ? std::nullopt : std::optional(weight));
    }
}

} // namespace

} // namespace web

web::Engine* barycage_new() {
    return new web::Engine;
}

void barycage_free(web::Engine* engine) {
    delete engine;
}

int barycage_load(web::Engine* engine, int dimension, const double* rows, int maps) {
    if ((dimension != 2 && !(web::knowsSpace && dimension == 3)) || maps < 0) return 0;
    engine->dimension = dimension;
    engine->plane = {};
    engine->space = {};
    engine->inSpace.clip.reset();
    engine->moment.reset();
    engine->exposure.reset();
    engine->with([&](auto& loaded) { web::readRows(loaded, rows, maps); });
    return 1;
}

void barycage_links(web::Engine* engine, const double* matrix) {
    engine->with([&](auto& loaded) {
        const std::size_t maps = loaded.system.maps.size();
        ifs::setLinks(loaded.system, std::span(matrix, maps * maps));
    });
}

int barycage_symmetry(web::Engine* engine, int group, int order, double angle, const double* place) {
    return engine->with([&](auto& loaded) { return web::setSymmetry(loaded, group, order, angle, place); })
               ? 1
               : 0;
}

void barycage_branch(web::Engine* engine, const int* word, int length, const double* change) {
    ifs::Word symbols(word, word + length);
    if (engine->isSpace())
        engine->space.moved.push_back({std::move(symbols), web::mapAt<3>(change)});
    else
        engine->plane.moved.push_back({std::move(symbols), web::mapAt<2>(change)});
}

int barycage_settle(web::Engine* engine) {
    return engine->with([](auto& loaded) {
        web::settle(loaded);
        return loaded.box ? 1 : 0;
    });
}

int barycage_extent(web::Engine* engine, double* box, double* simplex) {
    return engine->with([&](const auto& loaded) { return web::writeExtent(loaded, box, simplex); });
}

int barycage_cage(web::Engine* engine, const double* rest, const double* current, int count, int bends) {
    if (engine->isSpace()) {
        engine->space.cage = web::cageOf<3>(rest, current, count, bends != 0);
        return engine->space.cage ? 1 : 0;
    }
    engine->plane.cage = web::cageOf<2>(rest, current, count, bends != 0);
    return engine->plane.cage ? 1 : 0;
}

void barycage_camera(web::Engine* engine, int width, int height, const double* view) {
    if (!engine->isSpace()) {
        engine->camera = {{view[0], view[1]}, view[2], width, height};
        return;
    }
    attractor::OrbitCamera& camera = engine->orbit;
    camera.target = web::vectorAt<3>(view);
    camera.orientation = attractor::orbit(view[3], view[4]);
    camera.height = view[5];
    camera.projection = view[6] > 0 ? attractor::OrbitCamera::Projection::Perspective
                                    : attractor::OrbitCamera::Projection::Orthographic;
    if (view[6] > 0) camera.fieldOfView = view[6];
    camera.size = {width, height};
}

void barycage_appearance(web::Engine* engine, const double* n) {
    attractor::Appearance& appearance = engine->appearance;
    appearance = {};
    appearance.colourBy = attractor::ColourBy(std::clamp(int(n[0]), 0, int(attractor::ColourBy::Blend)));
    appearance.brightness = n[1];
    appearance.gamma = n[2];
    appearance.contrast = n[3];
    appearance.vibrancy = n[4];
    appearance.supersample = int(n[5]);
    appearance.plain = web::colourAt(n + 6);
    appearance.background = web::colourAt(n + 10);
}

void barycage_stops(web::Engine* engine, const double* stops, int count) {
    attractor::Palette palette;
    for (int i = 0; i < count; ++i, stops += 5)
        palette.stops.push_back({stops[0], web::colourAt(stops + 1)});
    if (count >= 2) engine->appearance.palette = std::move(palette);
}

void barycage_map_colour(web::Engine* engine, int map, const double* colour) {
    engine->appearance.mapColours[ifs::MapId(std::uint32_t(map) + 1)] = web::colourAt(colour);
}

void barycage_map_blend(web::Engine* engine, int map, double coordinate, double speed) {
    engine->appearance.mapBlends[ifs::MapId(std::uint32_t(map) + 1)] = {coordinate, speed};
}

void barycage_light(web::Engine* engine, int look, int colour, const double* n) {
    attractor::SpaceAppearance& inSpace = engine->inSpace;
    inSpace.look = attractor::LookInSpace(std::clamp(look, 0, int(attractor::LookInSpace::Normals)));
    inSpace.colourBy = attractor::SolidColour(std::clamp(colour, 0, int(attractor::SolidColour::Depth)));
    inSpace.lightAzimuth = n[0];
    inSpace.lightElevation = n[1];
    inSpace.fog = std::clamp(n[2], 0.0, attractor::SpaceAppearance::maxFog);
}

void barycage_clip(web::Engine* engine, const double* clip) {
    const attractor::SpaceClip given{web::vectorAt<3>(clip), clip[3], clip[4]};
    engine->inSpace.clip = attractor::isUsable(given) ? std::optional(given) : std::nullopt;
}

double barycage_draw(web::Engine* engine, double samples, int begin, int keepExposure) {
    if (keepExposure == 0 && begin != 0) engine->exposure.reset();
    return engine->isSpace() ? engine->drawSpace(samples, begin != 0)
                             : engine->drawPlane(samples, begin != 0);
}

const std::uint8_t* barycage_pixels(web::Engine* engine) {
    const auto picture = engine->picture();
    engine->straight.resize(4 * picture.size());
    std::uint8_t* out = engine->straight.data();
    for (const std::uint32_t pixel : picture) {
        const std::uint32_t alpha = pixel >> 24;
        for (int shift = 16; shift >= 0; shift -= 8) {
            const std::uint32_t channel = (pixel >> shift) & 255;
            *out++ = std::uint8_t(
                alpha == 255 || alpha == 0 ? channel : std::min((channel * 255 + alpha / 2) / alpha, 255U));
        }
        *out++ = std::uint8_t(alpha);
    }
    return engine->straight.data();
}

std::uint32_t barycage_hash(web::Engine* engine, int high) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const std::uint32_t pixel : engine->picture())
        for (int shift = 0; shift < 32; shift += 8)
            hash = (hash ^ ((pixel >> shift) & 255)) * 1099511628211ULL;
    return std::uint32_t(high != 0 ? hash >> 32 : hash);
}

int barycage_palettes() {
    return int(attractor::builtInPalettes().size());
}

const char* barycage_palette_name(int palette) {
    return attractor::builtInPalettes()[std::size_t(palette)].name.c_str();
}

int barycage_palette_stops(int palette, double* stops) {
    const auto& all = attractor::builtInPalettes()[std::size_t(palette)].stops;
    const std::size_t count = std::min<std::size_t>(all.size(), 64);
    for (std::size_t i = 0; i < count; ++i) {
        const attractor::Rgba& colour = all[i].colour;
        for (const double number : {all[i].position, double(colour.red), double(colour.green),
                                    double(colour.blue), double(colour.alpha)})
            *stops++ = number;
    }
    return int(count);
}
