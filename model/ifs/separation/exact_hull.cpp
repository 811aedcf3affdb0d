// SPDX-License-Identifier: MIT
#include "ifs/separation/exact_hull.h"

#include "ifs/separation/exact_map.h"

#include <algorithm>
#include <limits>

namespace ifs {

namespace {

constexpr std::size_t maxVertices = 64;
constexpr std::size_t maxLetters = 24; // letters of an address
constexpr std::size_t maxTurns = 50'000;

using Point = ExactPoint<2>;

// Returns true if c lies to the left of the line from a to b or on it.
bool isLeftOrOn(const Point& a, const Point& b, const Point& c) {
    const auto cross = [](const Point& p, const Point& q) {
        return p.numerator[0] * q.numerator[1] - p.numerator[1] * q.numerator[0];
    };
    // Determinant of the rows (x, y, 1), times the denominators.
    const Dyadic determinant =
        cross(b, c) * a.denominator - cross(a, c) * b.denominator + cross(a, b) * c.denominator;
    return determinant.sign() * a.denominator.sign() * b.denominator.sign() * c.denominator.sign() >= 0;
}

// Returns true if c, on the line through a and b, lies between them.
bool isBetween(const Point& a, const Point& b, const Point& c) {
    Dyadic product; // product of c − a and c − b, times the denominators
    for (std::size_t k = 0; k < 2; ++k)
        product = product + (c.numerator[k] * a.denominator - a.numerator[k] * c.denominator) *
                                (c.numerator[k] * b.denominator - b.numerator[k] * c.denominator);
    return product.sign() * a.denominator.sign() * b.denominator.sign() <= 0;
}

bool isWithin(const Point& exact, const Vector<2>& point, double distance) {
    for (std::size_t k = 0; k < 2; ++k) {
        const Dyadic off = exact.numerator[k] - Dyadic(point[Eigen::Index(k)]) * exact.denominator;
        const Dyadic most = Dyadic(distance) * exact.denominator;
        if ((off * off - most * most).sign() > 0) return false;
    }
    return true;
}

} // namespace

std::optional<ExactPoint<2>> exactPointOf(std::span<const AffineMap<2>> maps,
                                          const std::optional<PeriodicPoint>& address) {
    if (!address || address->prefix.size() + address->period.size() > maxLetters) return std::nullopt;
    const Point fixed = exactFixedPoint(exactWord(maps, address->period));
    if (fixed.denominator.sign() == 0) return std::nullopt;
    return image(exactWord(maps, address->prefix), fixed);
}

bool isExactHull(std::span<const AffineMap<2>> maps,
                 const std::vector<std::optional<PeriodicPoint>>& points) {
    const std::size_t count = points.size();
    if (count == 0 || count > maxVertices || count * count * maps.size() > maxTurns) return false;
    std::vector<Point> polygon;
    for (const auto& address : points) {
        const auto point = exactPointOf(maps, address);
        if (!point) return false;
        polygon.push_back(*point);
    }
    const auto holds = [&polygon](const Point& x) {
        for (std::size_t k = 0; k < polygon.size(); ++k)
            if (!isLeftOrOn(polygon[k], polygon[(k + 1) % polygon.size()], x)) return false;
        return polygon.size() > 2 || isBetween(polygon.front(), polygon.back(), x);
    };
    if (!std::ranges::all_of(polygon, holds)) return false; // convex and counter-clockwise
    return std::ranges::all_of(maps, [&](const AffineMap<2>& map) {
        const ExactMap<2> exact = exactWord<2>({&map, 1}, {0});
        return std::ranges::all_of(polygon, [&](const Point& vertex) { return holds(image(exact, vertex)); });
    });
}

double roundingOf(std::span<const AffineMap<2>> maps,
                  const std::vector<std::optional<PeriodicPoint>>& points) {
    double distance = 0; // maximum over both axes
    for (const auto& address : points) {
        const auto exact = exactPointOf(maps, address);
        if (!exact) return std::numeric_limits<double>::infinity();
        while (!isWithin(*exact, address->point, distance))
            distance = std::max(2 * distance, 0x1p-54 * address->point.cwiseAbs().maxCoeff() + 0x1p-1000);
    }
    return 2 * distance; // factor greater than √2
}

} // namespace ifs
