// SPDX-License-Identifier: MIT
#include "ifs/tiles/tile.h"

#include "ifs/existence/exact_matrix.h"
#include "ifs/linear/rounding.h"
#include "ifs/separation/stored_rounding.h"
#include "ifs/tiles/tile_area.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

constexpr std::size_t maxMaps = 64;

struct Figure {
    double value = 0, error = 0;
};

// N similarities of one ratio s with Ns² = 1, whose neighbours are finitely many and none of them the tile
// itself: the open set condition holds, and the attractor has inner points (Bandt; Schief).
std::optional<Figure> boundaryDimension(std::span<const AffineMap<2>> maps,
                                        const NeighbourGraph& neighbours) {
    const double share = 1 / double(maps.size());
    for (const auto& map : maps)
        if (std::abs(std::abs(determinant<2>(map.linear)) - share) >
            offDeterminant<2>(map.linear) + roundingUnit * share)
            return std::nullopt;
    if (neighbours.overlap()) return std::nullopt;
    const auto radius = neighbours.contacts().spectralRadius();
    if (!radius || radius->least < 1) return std::nullopt;
    const double rate = std::log(double(maps.size())) / 2, middle = (radius->least + radius->most) / 2;
    Figure result{std::log(middle) / rate};
    result.error = (radius->most - radius->least) / (2 * radius->least * rate) +
                   4 * roundingUnit * (result.value + 1 / rate);
    return result;
}

} // namespace

std::optional<Tile> tile(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                         const NeighbourGraph* neighbours) {
    if (maps.size() < 2 || maps.size() > maxMaps || !box.min.allFinite() || !box.max.allFinite())
        return std::nullopt;
    Dyadic excess(-1); // Σ|det A_i| − 1, without rounding
    double rounding = 0;
    for (const auto& map : maps) {
        if (!isFinite(map) || determinant<2>(map.linear) == 0) return std::nullopt;
        const auto m = exactMatrix<2>(map.linear);
        const Dyadic determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        excess = determinant.sign() < 0 ? excess - determinant : excess + determinant;
        rounding += offDeterminant<2>(map.linear);
    }
    if (!(std::abs(excess.rounded()) <= rounding)) return std::nullopt;
    bool isAreaExact = true, isDimensionExact = true;
    Tile result;
    if (const auto area = tileArea(maps, box, neighbours)) {
        result.area = area->value;
        isAreaExact = area->certainty == Certainty::Exact;
    }
    if (const auto dimension = neighbours ? boundaryDimension(maps, *neighbours) : std::nullopt) {
        result.boundaryDimension = dimension->value;
        result.boundaryDimensionError = dimension->error;
        isDimensionExact = neighbours->certainty() == Certainty::Exact;
    }
    if (!result.area && !result.boundaryDimension) return std::nullopt;
    result.isExact = isAreaExact && isDimensionExact;
    return result;
}

} // namespace ifs
