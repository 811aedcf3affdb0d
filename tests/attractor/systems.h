// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "attractor/samples/prepared_system.h"
#include "ifs/canonical_systems.h"

#include <array>
#include <initializer_list>

// Systems whose moments and shapes are known exactly; docs/mathematics.md, "Canonical test systems".
namespace systems {

struct Row {
    std::array<double, 6> map;
    double weight = 0; // 0: none given
};

inline ifs::IteratedFunctionSystem<2> system(std::initializer_list<Row> rows) {
    ifs::IteratedFunctionSystem<2> result;
    for (const Row& row : rows) {
        const auto& [a, b, c, d, e, f] = row.map;
        ifs::append<2>(result, ifs::affineMap(a, b, c, d, e, f),
                       row.weight > 0 ? std::optional<double>(row.weight) : std::nullopt);
    }
    return result;
}

inline ifs::IteratedFunctionSystem<2> maple() {
    return canonical::system(canonical::maple());
}
inline ifs::IteratedFunctionSystem<2> flower() {
    return canonical::system(canonical::flower(), {1, 1});
}
inline ifs::IteratedFunctionSystem<2> fern() {
    return canonical::system(canonical::fern(), canonical::fernWeights);
}
inline ifs::IteratedFunctionSystem<2> sierpinski() {
    return canonical::system(canonical::sierpinskiRight());
}
inline ifs::IteratedFunctionSystem<2> dragon() { // of even density
    return canonical::system(canonical::heighway());
}

// The unit square out of equal rectangles.
inline ifs::IteratedFunctionSystem<2> tiling(int columns, int rows) {
    ifs::IteratedFunctionSystem<2> result;
    result.maps.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < result.maps.size(); ++i) {
        const auto column = static_cast<double>(i % static_cast<std::size_t>(columns));
        const auto row = static_cast<double>(i / static_cast<std::size_t>(columns));
        result.maps[i].map = ifs::affineMap(1.0 / columns, 0, 0, 1.0 / rows, column / columns, row / rows);
    }
    return result;
}

inline ifs::IteratedFunctionSystem<2> koch() {
    return canonical::system(canonical::koch());
}
inline ifs::IteratedFunctionSystem<2> cantorDust(double ratio) { // of dimension ln 4 / ln(1 / ratio)
    const double gap = 1 - ratio;
    return system({{{ratio, 0, 0, ratio, 0, 0}},
                   {{ratio, 0, 0, ratio, gap, 0}},
                   {{ratio, 0, 0, ratio, 0, gap}},
                   {{ratio, 0, 0, ratio, gap, gap}}});
}

// All of the attractor in a picture of the given size.
inline attractor::Camera camera(const ifs::IteratedFunctionSystem<2>& system, int width, int height) {
    const attractor::PreparedSystem drawable = attractor::prepared(system);
    attractor::Camera result;
    result.width = width;
    result.height = height;
    return attractor::fitted(result, drawable.centre - drawable.halfExtent,
                             drawable.centre + drawable.halfExtent);
}

inline attractor::RenderRequest request(const ifs::IteratedFunctionSystem<2>& system, std::uint64_t samples,
                                        int width = 320, int height = 200) {
    attractor::RenderRequest result;
    result.system = system;
    result.camera = camera(system, width, height);
    result.samples = samples;
    result.appearance.background = {0, 0, 0, 255};
    result.appearance.colourBy = attractor::ColourBy::Plain;
    result.appearance.plain = {255, 255, 255, 255};
    return result;
}

inline int grey(std::uint32_t pixel) {
    return static_cast<int>(pixel & 255U);
}

inline double meanGrey(const attractor::Frame& frame) {
    double sum = 0;
    for (const std::uint32_t pixel : frame.pixels)
        sum += grey(pixel);
    return frame.pixels.empty() ? 0 : sum / static_cast<double>(frame.pixels.size());
}

// A triangle that is pressed to that height.
inline ifs::ControlCage<2> squeezed(double height) {
    ifs::ControlCage<2> cage;
    cage.rest = {{0, 0}, {1, 0}, {0, 1}};
    cage.current = {{0, 0}, {1, 0}, {0, height}};
    return cage;
}

} // namespace systems
