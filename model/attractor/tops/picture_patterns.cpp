// SPDX-License-Identifier: MIT
#include "attractor/tops/picture_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace attractor {

namespace {

struct Colour {
    double red, green, blue; // sRGB, 0 … 1
};

Rgba rgba(const Colour& colour) {
    const auto code = [](double value) { return std::uint8_t(std::clamp(value, 0.0, 1.0) * 255 + 0.5); };
    return {code(colour.red), code(colour.green), code(colour.blue), 255};
}

Colour mixed(const Colour& a, const Colour& b, double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    return {a.red + (b.red - a.red) * s, a.green + (b.green - a.green) * s, a.blue + (b.blue - a.blue) * s};
}

// Hues as three waves that are a third of a turn apart.
Colour hue(double turns) {
    const auto wave = [&](double phase) {
        return 0.55 + 0.45 * std::cos(2 * std::numbers::pi * (turns - phase));
    };
    return {wave(0), wave(1 / 3.0), wave(2 / 3.0)};
}

// x to the right and y upwards, both from 0 to 1.
Colour grid(double x, double y) {
    constexpr double cells = 16, line = 0.08;
    const auto distance = [](double at) { return std::abs(at - std::round(at)); };
    const double coarse = std::min(distance(x * cells / 4), distance(y * cells / 4)) * 4;
    const double fine = std::min(distance(x * cells), distance(y * cells));
    const Colour ground{0.25 + 0.7 * x, 0.25 + 0.7 * y, 0.85 - 0.35 * (x + y) / 2};
    if (coarse < 1.6 * line) return {0.05, 0.06, 0.1};
    return fine < line ? mixed(ground, {1, 1, 1}, 0.75) : ground;
}

Colour wheel(double x, double y) {
    const double dx = x - 0.5, dy = y - 0.5, radius = std::hypot(dx, dy) * 2;
    const Colour pure = hue(std::atan2(dy, dx) / (2 * std::numbers::pi));
    return radius < 1 ? mixed({1, 1, 1}, pure, radius) : mixed(pure, {0, 0, 0}, (radius - 1) * 1.2);
}

Colour rings(double x, double y) {
    const double radius = std::hypot(x - 0.5, y - 0.5) * 20;
    const Colour inner{0.96, 0.76, 0.30}, outer{0.11, 0.27, 0.48};
    const double edge = std::clamp((std::abs(radius - std::round(radius)) - 0.23) * 20, 0.0, 1.0);
    const Colour pale = mixed(inner, outer, radius / 14);
    return int(std::round(radius)) % 2 == 0 ? mixed(pale, {0.98, 0.96, 0.92}, edge)
                                            : mixed({0.98, 0.96, 0.92}, pale, 1 - edge);
}

Colour sunset(double x, double y) {
    Colour sky = y < 0.62 ? mixed({1.0, 0.80, 0.45}, {0.93, 0.42, 0.35}, (y - 0.25) / 0.37)
                          : mixed({0.93, 0.42, 0.35}, {0.20, 0.16, 0.42}, (y - 0.62) / 0.38);
    const double sun = std::hypot(x - 0.62, y - 0.52);
    sky = mixed({1.0, 0.95, 0.75}, sky, sun < 0.1 ? 0 : (sun - 0.1) * 6 + 0.3);
    const std::array<Colour, 3> hills{{{0.45, 0.25, 0.42}, {0.28, 0.17, 0.36}, {0.12, 0.09, 0.20}}};
    for (std::size_t k = 0; k < hills.size(); ++k) {
        const double at = x * (5.0 + 3.0 * double(k)) + 1.7 * double(k);
        const double ridge = 0.36 - 0.11 * double(k) + 0.045 * std::sin(at) + 0.018 * std::sin(3.1 * at + 1);
        if (y < ridge) sky = hills[k];
    }
    return sky;
}

// A number from 0 to 1 that looks random, the same on every machine.
double chance(unsigned x, unsigned y, unsigned which) {
    unsigned bits = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ which * 0xC2B2AE3DU;
    bits = (bits ^ bits >> 15) * 0x2C1B3C6DU;
    bits = (bits ^ bits >> 12) * 0x297A2D39U;
    return double((bits ^ bits >> 15) >> 8) / double(1U << 24);
}

// Cells of coloured glass: every point belongs to the nearest of the centres, one in each cell of a square
// grid.
Colour glass(double x, double y) {
    constexpr double cells = 7, lead = 0.045;
    const int column = int(x * cells), row = int(y * cells);
    double nearest = 9, second = 9, tint = 0, shade = 0;
    for (int i = column - 2; i <= column + 2; ++i)
        for (int j = row - 2; j <= row + 2; ++j) {
            const unsigned u = unsigned(i + 8), v = unsigned(j + 8);
            const double far = std::hypot(x * cells - (i + 0.15 + 0.7 * chance(u, v, 1)),
                                          y * cells - (j + 0.15 + 0.7 * chance(u, v, 2)));
            if (far >= nearest) {
                second = std::min(second, far);
                continue;
            }
            second = std::exchange(nearest, far);
            tint = chance(u, v, 3);
            shade = chance(u, v, 4);
        }
    if (second - nearest < lead) return {0.07, 0.07, 0.09};
    const Colour pane = mixed(hue(tint), {0.10, 0.16, 0.42}, 0.15 + 0.4 * shade);
    return mixed(pane, {1, 1, 1}, 0.28 * std::clamp(1 - nearest, 0.0, 1.0));
}

Colour marble(double x, double y) {
    const double u = x + 0.11 * std::sin(5 * y + 2) + 0.05 * std::sin(13 * y + 4 * x);
    const double v = y + 0.11 * std::sin(6 * x + 1) + 0.05 * std::sin(11 * x - 5 * y);
    const double vein = 1 - std::abs(std::sin(7 * u + 4 * v + 1.3 * std::sin(9 * v)));
    const double fine = 1 - std::abs(std::sin(23 * u - 17 * v + 2 * std::sin(8 * u)));
    const Colour stone = mixed({0.93, 0.55, 0.25}, {0.72, 0.20, 0.16}, v);
    const Colour veined = mixed(stone, {0.99, 0.86, 0.52}, std::pow(vein, 5));
    return mixed(veined, {0.28, 0.10, 0.14}, 0.7 * std::pow(fine, 9));
}

// Colours of the threads in a stripe of the cloth, from 0 to 1 across.
Colour thread(double at) {
    const double part = at * 4 - std::floor(at * 4);
    if (part < 0.06 || (part > 0.44 && part < 0.50)) return {0.95, 0.83, 0.42};
    if (part < 0.22) return {0.60, 0.10, 0.14};
    if (part < 0.44) return {0.08, 0.22, 0.36};
    if (part < 0.72) return {0.10, 0.36, 0.27};
    return part < 0.78 ? Colour{0.94, 0.93, 0.88} : Colour{0.60, 0.10, 0.14};
}

Colour tartan(double x, double y) {
    const int twill = (int(x * 256) + int(y * 256)) & 3;
    return mixed(thread(x), thread(y), twill < 2 ? 0.38 : 0.62);
}

Colour waves(double x, double y) {
    Colour seen = mixed({0.98, 0.91, 0.76}, {0.55, 0.74, 0.83}, (y - 0.75) * 4);
    constexpr int count = 9;
    for (int k = 0; k < count; ++k) { // farthest first
        const double nearness = (k + 1.0) / count, length = 4 + 14 * (1 - nearness);
        const double crest = 0.80 - 0.78 * nearness + 0.035 * std::sin(length * x * 2 + 2.3 * k) +
                             0.05 * nearness * std::abs(std::sin(length * x + 1.7 * k));
        if (y > crest) continue;
        seen = mixed({0.35, 0.66, 0.72}, {0.03, 0.16, 0.34}, nearness);
        seen = mixed({0.97, 0.99, 0.98}, seen, (crest - y) / (0.012 + 0.012 * nearness));
    }
    return seen;
}

Colour colourOf(Pattern pattern, double x, double y) {
    switch (pattern) {
    case Pattern::Grid:
        return grid(x, y);
    case Pattern::Wheel:
        return wheel(x, y);
    case Pattern::Rings:
        return rings(x, y);
    case Pattern::Sunset:
        return sunset(x, y);
    case Pattern::Glass:
        return glass(x, y);
    case Pattern::Marble:
        return marble(x, y);
    case Pattern::Tartan:
        return tartan(x, y);
    case Pattern::Waves:
        break;
    }
    return waves(x, y);
}

} // namespace

MipPicture picture(Pattern pattern, int side) {
    std::vector<Rgba> pixels;
    pixels.reserve(std::size_t(side) * std::size_t(side));
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            pixels.push_back(rgba(colourOf(pattern, (column + .5) / side, 1 - (row + .5) / side)));
    return {side, side, pixels};
}

} // namespace attractor
