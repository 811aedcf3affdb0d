// SPDX-License-Identifier: MIT
#include "ifs/links/part_points.h"

#include "ifs/linear/rounding.h"
#include "ifs/separation/exact_map.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ifs {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The composition of some maps, with what rounding may have cost it.
struct Composed {
    AffineMap<2> map;
    double linearError = 0, shiftError = 0;

    void compose(const AffineMap<2>& inner) {
        const double size = map.linear.norm(), shift = inner.translation.norm();
        shiftError += linearError * shift + 4 * roundingUnit * (size * shift + map.translation.norm());
        linearError = (linearError + 4 * roundingUnit * size) * inner.linear.norm();
        map = map * inner;
    }
};

// The fixed point with its error. With R near (I − A)⁻¹, it is within 2‖R‖·|residual| if ‖I − R(I − A)‖ ≤ ½.
PartPoint fixedPointOf(const Composed& cycle) {
    const auto found = fixedPoint(cycle.map);
    if (!found) return {Vector<2>::Zero(), infinity};
    const Matrix<2> complement = Matrix<2>::Identity() - cycle.map.linear, inverse = complement.inverse();
    const Vector<2>& x = *found;
    const double size = inverse.norm(), length = complement.norm();
    const double rest = (inverse * complement - Matrix<2>::Identity()).norm() + size * cycle.linearError +
                        8 * roundingUnit * size * length;
    if (!(rest <= 0.5)) return {x, infinity};
    const double residual = (cycle.map.translation - complement * x).norm() + cycle.linearError * x.norm() +
                            cycle.shiftError +
                            8 * roundingUnit * (length * x.norm() + cycle.map.translation.norm());
    return {x, 2 * size * residual};
}

struct Address {
    Word prefix, period;
};

Address addressOf(const std::vector<std::size_t>& before, std::size_t part) {
    std::size_t onCycle = part;
    for (std::size_t step = 0; step < before.size(); ++step)
        onCycle = before[onCycle];
    Address result;
    for (std::size_t i = part; i != onCycle; i = before[i])
        result.prefix.push_back(int(i));
    result.period.push_back(int(onCycle));
    for (std::size_t i = before[onCycle]; i != onCycle; i = before[i])
        result.period.push_back(int(i));
    return result;
}

PartPoint roundedPoint(std::span<const AffineMap<2>> maps, const Address& address) {
    Composed cycle;
    for (const int symbol : address.period)
        cycle.compose(maps[std::size_t(symbol)]);
    PartPoint result = fixedPointOf(cycle);
    for (auto symbol = address.prefix.rbegin(); symbol != address.prefix.rend(); ++symbol) {
        const AffineMap<2>& map = maps[std::size_t(*symbol)];
        const double size = map.linear.norm();
        result.error =
            size * result.error + 4 * roundingUnit * (size * result.point.norm() + map.translation.norm());
        result.point = map(result.point);
    }
    if (!(result.error < infinity) || !result.point.allFinite()) result.error = infinity;
    return result;
}

std::optional<PartPoint> exactPoint(std::span<const AffineMap<2>> maps, const Address& address) {
    const auto fixed = exactFixedPoint(exactWord(maps, address.period));
    if (fixed.denominator.sign() == 0) return std::nullopt;
    const auto point = image(exactWord(maps, address.prefix), fixed);
    PartPoint result;
    for (std::size_t k = 0; k < 2; ++k)
        result.point[Eigen::Index(k)] = roundedQuotient(point.numerator[k], point.denominator);
    result.error = 0x1p-49 * result.point.norm();
    return result.point.allFinite() ? std::optional(result) : std::nullopt;
}

} // namespace

std::vector<PartPoint> pointsOfParts(std::span<const AffineMap<2>> maps,
                                     const std::vector<std::size_t>& before) {
    constexpr double telling = 0x1p-24;
    constexpr std::size_t maxLetters = 64;
    std::size_t left = 2'000; // letters of exact words still allowed
    std::vector<PartPoint> result;
    for (std::size_t part = 0; part < maps.size(); ++part) {
        const Address address = addressOf(before, part);
        result.push_back(roundedPoint(maps, address));
        const std::size_t letters = address.prefix.size() + address.period.size();
        PartPoint& point = result.back();
        if (letters > std::min(maxLetters, left)) continue;
        left -= letters;
        const auto exact = exactPoint(maps, address);
        if (!exact) continue;
        if (point.error <= telling * point.point.norm())
            point.error = exact->error + (point.point - exact->point).norm();
        else
            point = *exact;
    }
    return result;
}

} // namespace ifs
