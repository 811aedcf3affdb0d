// SPDX-License-Identifier: MIT
#include "io/picture/vector/svg_shapes.h"

#include "attractor/request/colour_coordinates.h"
#include "attractor/request/shadow.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"

#include <clipper.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace io {

namespace {

constexpr double maxPixel = 1e40; // limit at which products of two numbers do not overflow

// Unions of polygons in whole numbers, in which they are exact. Every level has a grid of its own, in the
// coordinates of the code, as fine as the numbers allow that are multiplied without overflow.
class UnionOfLevels {
public:
    UnionOfLevels(const ifs::CopyHierarchy& levels, int depth, std::stop_token stop)
        : m_levels(levels), m_depth(depth), m_stop(std::move(stop)) {}

    std::vector<Ring> picture() { return united(rings(m_levels.picture(m_depth))); }

private:
    const std::vector<Ring>& of(int level) {
        if (const auto known = m_unions.find(level); known != m_unions.end()) return known->second;
        std::vector<Ring> rings;
        if (level == 0)
            rings = {m_levels.outline(m_depth)};
        else if (!m_stop.stop_requested())
            rings = united(this->rings(m_levels.copies(level, m_depth)));
        return m_unions[level] = std::move(rings);
    }

    std::vector<Ring> rings(const std::vector<ifs::Copy>& copies) {
        std::vector<Ring> rings;
        for (const ifs::Copy& copy : copies) {
            // True if the map reverses rings, holes included.
            const bool turns = ifs::determinant<2>(copy.map.linear) < 0;
            for (Ring ring : copy.projection ? m_levels.projection(*copy.projection)->bars : of(copy.level)) {
                for (auto& point : ring)
                    point = copy.map(point);
                if (turns) std::reverse(ring.begin(), ring.end());
                rings.push_back(std::move(ring));
            }
        }
        return rings;
    }

    static std::vector<Ring> united(const std::vector<Ring>& rings) {
        constexpr double maxCoordinate = 1 << 29; // fast range of the library
        ifs::Vector<2> low = ifs::Vector<2>::Constant(HUGE_VAL);
        ifs::Vector<2> high = -low;
        for (const Ring& ring : rings)
            for (const auto& point : ring) {
                low = low.cwiseMin(point);
                high = high.cwiseMax(point);
            }
        const ifs::Vector<2> middle = (low + high) / 2;
        const double scale = maxCoordinate / std::max((high - low).maxCoeff(), 1e-300);
        ClipperLib::Clipper clipper;
        for (const Ring& ring : rings) {
            ClipperLib::Path path;
            for (const auto& point : ring)
                path.emplace_back(std::llround((point.x() - middle.x()) * scale),
                                  std::llround((point.y() - middle.y()) * scale));
            clipper.AddPath(path, ClipperLib::ptSubject, true);
        }
        ClipperLib::Paths result;
        clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        std::vector<Ring> united;
        for (const auto& path : result) {
            Ring ring;
            for (const auto& point : path)
                ring.push_back(middle + ifs::Vector<2>(double(point.X), double(point.Y)) / scale);
            united.push_back(std::move(ring));
        }
        return united;
    }

    const ifs::CopyHierarchy& m_levels;
    int m_depth;
    std::stop_token m_stop;
    std::map<int, std::vector<Ring>> m_unions;
};

} // namespace

ShapeLevels shapeLevels(const document::Fractal& fractal, const attractor::Camera& camera) {
    const document::System2* system = document::system2(fractal);
    if (!system) return {{}, Text::tr("Only systems in the plane can be written as vector graphics.")};
    ifs::AffineMap<2> display = worldToPixel(camera);
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    if (cage) display = display * ifs::displayMap(*cage);
    const auto isWritable = [](const auto& numbers) { return (numbers.array().abs() < maxPixel).all(); };
    const std::vector<ifs::MovedBranch<2>> moved = document::movedBranches(fractal);
    bool fits = isWritable(display.linear) && isWritable(display.translation);
    for (const auto& [word, change] : moved)
        fits = fits && isWritable((display * change).linear) && isWritable((display * change).translation);
    if (cage)
        for (const auto* polygon : {&cage->rest, &cage->current})
            for (const auto& vertex : *polygon)
                fits = fits && isWritable(toPixel(camera, vertex));
    if (!fits) return {{}, Text::tr("In this view the picture is too large to be written as shapes.")};
    if (ifs::activeMaps(*system).isLinked())
        return {{}, Text::tr("The maps are linked, so the picture is not made of copies of itself.")};
    auto levels = ifs::CopyHierarchy::of(*system, display, moved);
    if (!levels)
        return {{},
                Text::tr("No outline of an attractor could be certified for this system, so there is nothing "
                         "to copy.")};
    return {std::move(levels), {}};
}

attractor::Rgba shapeColour(const attractor::Appearance& appearance) {
    constexpr double bright = 0.75;
    return appearance.colourBy == attractor::ColourBy::Plain
               ? appearance.plain
               : attractor::colourAt(appearance.palette, bright);
}

std::optional<attractor::Rgba> shapeColour(const document::Fractal& fractal, const ifs::CopyHierarchy& levels,
                                           const ifs::Copy& copy) {
    if (!copy.first) return std::nullopt;
    const attractor::Appearance& appearance = fractal.appearance;
    const std::size_t index = levels.index()[*copy.first];
    if (appearance.colourBy == attractor::ColourBy::Map)
        return attractor::mapColour(appearance, document::system2(fractal)->maps[index].id, index);
    if (appearance.colourBy == attractor::ColourBy::Address)
        return attractor::colourAt(appearance.palette,
                                   (double(*copy.first) + 0.5) / double(levels.index().size()));
    if (appearance.colourBy == attractor::ColourBy::Blend) {
        const auto& maps = document::system2(fractal)->maps;
        const attractor::MapBlend blend = attractor::mapBlend(appearance, maps[index].id, index, maps.size());
        const double middle = blend.speed * blend.coordinate + (1 - blend.speed) / 2; // mean of the interval
        return attractor::colourAt(appearance.palette, middle);
    }
    return std::nullopt;
}

std::vector<Ring> leafUnion(const ifs::CopyHierarchy& levels, int depth, const std::stop_token& stop) {
    std::vector<Ring> rings = UnionOfLevels(levels, depth, stop).picture();
    if (stop.stop_requested()) return {};
    for (Ring& ring : rings)
        for (auto& point : ring)
            point = levels.display()(point);
    return rings;
}

std::vector<ColouredPoints> shapePoints(const document::Fractal& fractal, const attractor::Camera& camera,
                                        std::uint64_t points, std::uint64_t seed) {
    constexpr double shades = 64; // number of colours along a palette
    const attractor::Appearance& appearance = fractal.appearance;
    const document::System2& system = *document::system2(fractal);
    const attractor::PreparedSystem drawable = attractor::prepared(system, document::movedBranches(fractal));
    if (drawable.maps.empty()) return {};
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    const ifs::AffineMap<2> display =
        cage ? worldToPixel(camera) * ifs::displayMap(*cage) : worldToPixel(camera);
    std::map<std::size_t, ColouredPoints> groups;
    attractor::Orbit orbit(drawable, seed, attractor::Orbit::skipped,
                           attractor::colourCoordinates<2>(appearance, system, drawable));
    for (std::uint64_t n = 0; n < points; ++n) {
        const auto point = orbit.next();
        const ifs::Vector<2> pixel = display(point.x);
        if (!(pixel.minCoeff() >= 0) || pixel.x() > camera.width || pixel.y() > camera.height) continue;
        std::size_t group = 0;
        attractor::Rgba colour = shapeColour(appearance);
        if (appearance.colourBy == attractor::ColourBy::Map) {
            group = drawable.index[point.lastMap];
            colour = attractor::mapColour(appearance, system.maps[group].id, group);
        } else if (attractor::coloursSamples(appearance.colourBy)) { // palette
            const double shade = std::min(std::floor(point.colourCoordinate * shades), shades - 1);
            group = std::size_t(shade);
            colour = attractor::colourAt(appearance.palette, (shade + 0.5) / shades);
        }
        auto& coloured = groups[group];
        coloured.colour = colour;
        coloured.points.push_back(pixel);
    }
    std::vector<ColouredPoints> result;
    for (auto& [group, coloured] : groups)
        result.push_back(std::move(coloured));
    return result;
}

std::optional<ShapeShadow> shapeShadow(const document::Fractal& fractal, const attractor::Camera& camera) {
    const auto inWorld = document::shadowMap(fractal, camera.yAxis);
    const ifs::AffineMap<2> seen = worldToPixel(camera);
    const auto unseen = ifs::inverse<2>(seen);
    if (!inWorld || !unseen) return std::nullopt;
    ShapeShadow shadow{fractal, seen * *inWorld * *unseen, fractal.appearance.shadow};
    document::Shape<2>& shape = *document::plane(shadow.fractal);
    shape.cage = attractor::movedCage(shape.cage, *inWorld);
    shadow.fractal.appearance = attractor::shadowAppearance(fractal.appearance, shape.system);
    return shadow;
}

} // namespace io
