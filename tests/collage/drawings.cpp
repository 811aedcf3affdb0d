// SPDX-License-Identifier: MIT
#include "collage/drawings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace drawings {

namespace {

bool isInStar(double x, double y) {
    const double sector = 2 * std::numbers::pi / 5;
    double angle = std::fmod(std::atan2(x, y) + 4 * std::numbers::pi, sector);
    angle = std::min(angle, sector - angle); // from the nearest tip
    // The edge runs from the tip (0.9, 0) to the notch at half a sector.
    const double notch = 0.36, u = std::hypot(x, y) * std::cos(angle), v = std::hypot(x, y) * std::sin(angle);
    const double nx = notch * std::cos(sector / 2), ny = notch * std::sin(sector / 2);
    return v * (nx - 0.9) - (u - 0.9) * ny >= 0;
}

bool isInLeaf(double x, double y) {
    const double t = (y + 0.85) / 1.7;
    if (t < 0) return std::abs(x) < 0.03 && y > -0.95;
    return t <= 1 && std::abs(x) <= 0.9 * t * (1 - t) * (1.4 - 0.8 * t) * 2;
}

bool isInTriangle(double x, double y, double radius) {
    for (int side = 0; side < 3; ++side) {
        const double angle = std::numbers::pi * (0.5 + 2.0 * side / 3 + 1);
        if (x * std::cos(angle) + y * std::sin(angle) > radius / 2) return false;
    }
    return true;
}

// Calls visit(x, y) for every point of the orbit but the first few.
void play(std::span<const ifs::AffineMap<2>> maps, std::span<const double> probabilities, int points,
          const std::function<void(const ifs::Vector<2>&)>& visit) {
    std::mt19937 random(7);
    std::vector<double> sums;
    double sum = 0;
    for (const double p : probabilities)
        sums.push_back(sum += p);
    ifs::Vector<2> x(0, 0);
    for (int k = -100; k < points; ++k) {
        const double u = random() * 0x1p-32 * sum;
        const auto map =
            std::min(maps.size() - 1, std::size_t(std::ranges::upper_bound(sums, u) - sums.begin()));
        x = maps[map](x);
        if (k >= 0) visit(x);
    }
}

} // namespace

collage::Mask drawn(int side, const std::function<bool(double x, double y)>& isInside) {
    collage::Mask mask = collage::emptyMask(side, side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            mask.cells[mask.index(column, row)] =
                isInside((2.0 * column + 1) / side - 1, 1 - (2.0 * row + 1) / side);
    return mask;
}

std::vector<Drawing> all(int side) {
    const auto disc = [](double x, double y, double radius) { return std::hypot(x, y) < radius; };
    return {
        {"disc", drawn(side, [&](double x, double y) { return disc(x, y, 0.85); })},
        {"ring", drawn(side, [&](double x, double y) { return disc(x, y, 0.85) && !disc(x, y, 0.45); })},
        {"star", drawn(side, isInStar)},
        {"L", drawn(side,
                    [](double x, double y) {
                        return std::abs(x) < 0.7 && std::abs(y) < 0.8 && (x < -0.2 || y < -0.3);
                    })},
        {"leaf", drawn(side, isInLeaf)},
        {"hollow triangle",
         drawn(side, [](double x, double y) { return isInTriangle(x, y, 0.8) && !isInTriangle(x, y, 0.5); })},
        {"T", drawn(side,
                    [](double x, double y) {
                        return std::abs(y) < 0.8 && (y > 0.5 ? std::abs(x) < 0.7 : std::abs(x) < 0.17);
                    })},
        {"separate discs", drawn(side,
                                 [&](double x, double y) {
                                     return disc(x + 0.55, y - 0.5, 0.25) || disc(x - 0.45, y - 0.6, 0.2) ||
                                            disc(x - 0.1, y + 0.4, 0.35);
                                 })},
    };
}

std::vector<ifs::AffineMap<2>> fitted(std::span<const ifs::AffineMap<2>> maps,
                                      std::span<const double> probabilities) {
    ifs::Vector<2> least(HUGE_VAL, HUGE_VAL), greatest(-HUGE_VAL, -HUGE_VAL);
    play(maps, probabilities, 20'000, [&](const ifs::Vector<2>& x) {
        least = least.cwiseMin(x);
        greatest = greatest.cwiseMax(x);
    });
    ifs::AffineMap<2> placement;
    const double scale = 0.9 / (greatest - least).maxCoeff();
    placement.linear *= scale;
    placement.translation = -scale * (least + greatest) / 2;
    std::vector<ifs::AffineMap<2>> result;
    for (const ifs::AffineMap<2>& map : maps)
        result.push_back(*ifs::conjugate<2>(placement, map));
    return result;
}

collage::Mask chaosGame(std::span<const ifs::AffineMap<2>> maps, std::span<const double> probabilities,
                        int side, int points) {
    collage::Mask mask = collage::emptyMask(side, side);
    play(maps, probabilities, points, [&](const ifs::Vector<2>& x) {
        const double column = std::floor((x.x() + 0.5) * side), row = std::floor((0.5 - x.y()) * side);
        if (column >= 0 && row >= 0 && column < side && row < side)
            mask.cells[mask.index(int(column), int(row))] = 1;
    });
    return mask;
}

} // namespace drawings
