// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/drawable_system.h"
#include "attractor/renderer.h"
#include "ifs/iterated_function_system.h"

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
    return system({{{-0.04, 0, -0.23, -0.65, -0.08, 0.26}},
                   {{0.61, 0, 0, 0.31, 0.07, 3.5}},
                   {{0.65, 0.29, -0.3, 0.48, 0.74, 0.39}},
                   {{0.64, -0.3, 0.16, 0.56, -0.56, 0.60}}});
}
inline ifs::IteratedFunctionSystem<2> flower() {
    return system({{{0.47, 0.30, -0.30, 0.47, 0.37, 1.74}, 1}, {{0.48, -0.29, 0.29, 0.48, -0.34, 1.75}, 1}});
}
inline ifs::IteratedFunctionSystem<2> fern() {
    return system({{{0, 0, 0, 0.16, 0, 0}, 0.01},
                   {{0.85, 0.04, -0.04, 0.85, 0, 1.6}, 0.85},
                   {{0.2, -0.26, 0.23, 0.22, 0, 1.6}, 0.07},
                   {{-0.15, 0.28, 0.26, 0.24, 0, 0.44}, 0.07}});
}
inline ifs::IteratedFunctionSystem<2> sierpinski() { // right-angled
    return system({{{0.5, 0, 0, 0.5, 0, 0}}, {{0.5, 0, 0, 0.5, 0.5, 0}}, {{0.5, 0, 0, 0.5, 0, 0.5}}});
}
inline ifs::IteratedFunctionSystem<2> dragon() { // of even density
    return system({{{0.5, -0.5, 0.5, 0.5, 0, 0}}, {{-0.5, -0.5, 0.5, -0.5, 1, 0}}});
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
    const double h = 0.28867513459481287; // √3/6
    return system({{{1.0 / 3, 0, 0, 1.0 / 3, 0, 0}},
                   {{1.0 / 6, -h, h, 1.0 / 6, 1.0 / 3, 0}},
                   {{1.0 / 6, h, -h, 1.0 / 6, 0.5, h}},
                   {{1.0 / 3, 0, 0, 1.0 / 3, 2.0 / 3, 0}}});
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
    const attractor::DrawableSystem drawable = attractor::drawable(system);
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

} // namespace systems
