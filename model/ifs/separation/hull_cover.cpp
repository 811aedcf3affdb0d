// SPDX-License-Identifier: MIT
#include "ifs/separation/hull_cover.h"

#include "ifs/separation/exact_hull.h"
#include "ifs/separation/exact_map.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace ifs {

namespace {

// A point (x, y, d) for (x/d, y/d) with d > 0, or a line with the points of its left side where the product
// is positive.
using Triple = std::array<Dyadic, 3>;

Triple crossed(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple opposite(const Triple& line) {
    return {-line[0], -line[1], -line[2]};
}

int sideOf(const Triple& line, const Triple& point) {
    return (line[0] * point[0] + line[1] * point[1] + line[2] * point[2]).sign();
}

Triple tripleOf(const ExactPoint<2>& point) {
    const Triple triple{point.numerator[0], point.numerator[1], point.denominator};
    return point.denominator.sign() < 0 ? opposite(triple) : triple;
}

// A convex polygon as the lines of its sides, counter-clockwise, so that the numbers do not grow as it is
// cut.
using Sides = std::vector<Triple>;

Sides sidesOf(const std::vector<Triple>& corners) {
    Sides result;
    for (std::size_t k = 0; k < corners.size(); ++k)
        result.push_back(crossed(corners[k], corners[(k + 1) % corners.size()]));
    return result;
}

// The part to the left of a line; empty where that has no area.
Sides leftOf(const Triple& line, const Sides& polygon) {
    const std::size_t count = polygon.size();
    std::vector<int> sides; // indices of the corners at which the sides begin
    for (std::size_t k = 0; k < count; ++k)
        sides.push_back(sideOf(line, crossed(polygon[(k + count - 1) % count], polygon[k])));
    if (std::ranges::none_of(sides, [](int side) { return side > 0; })) return {};
    if (std::ranges::none_of(sides, [](int side) { return side < 0; })) return polygon;
    const auto isKept = [&](std::size_t k) { return sides[k] > 0 || sides[(k + 1) % count] > 0; };
    Sides result;
    for (std::size_t k = 0; k < count; ++k) {
        if (!isKept(k)) continue;
        result.push_back(polygon[k]);
        if (!isKept((k + 1) % count)) result.push_back(line);
    }
    // Keeps two sides with ends on the line, if all sides are kept.
    if (std::ranges::find(result, line) == result.end())
        for (std::size_t k = 0; k < count; ++k)
            if (sides[(k + 1) % count] < 0) {
                result.insert(result.begin() + std::ptrdiff_t(k) + 1, line);
                break;
            }
    return result;
}

class Cover {
public:
    explicit Cover(std::vector<Sides> images) : m_images(std::move(images)) {}

    // Returns true if the images from `first` on cover the polygon.
    bool holds(Sides polygon, std::size_t first = 0) {
        if (first == m_images.size()) return false;
        for (const Triple& side : m_images[first]) {
            if (--m_cutsLeft < 0) return false;
            const Sides outside = leftOf(opposite(side), polygon);
            if (!outside.empty() && !holds(outside, first + 1)) return false;
            polygon = leftOf(side, polygon);
            if (polygon.empty()) return true;
        }
        return true;
    }

private:
    std::vector<Sides> m_images;
    int m_cutsLeft = 5'000;
};

// Returns true if p comes before q along a coordinate.
bool isBefore(const Triple& p, const Triple& q, std::size_t axis) {
    return (p[axis] * q[2] - q[axis] * p[2]).sign() < 0;
}

bool coverSegment(std::vector<std::pair<Triple, Triple>> images, Triple low, Triple high) {
    const std::size_t axis = isBefore(low, high, 0) || isBefore(high, low, 0) ? 0 : 1;
    if (isBefore(high, low, axis)) std::swap(low, high);
    for (auto& [from, to] : images)
        if (isBefore(to, from, axis)) std::swap(from, to);
    while (isBefore(low, high, axis)) {
        Triple farthest = low;
        for (const auto& [from, to] : images)
            if (!isBefore(low, from, axis) && isBefore(farthest, to, axis)) farthest = to;
        if (!isBefore(low, farthest, axis)) return false;
        low = farthest;
    }
    return true;
}

// The convex hull of points and its images.
struct HullImages {
    std::vector<Triple> corners;
    std::vector<Sides> images;                       // of a polygon, those that are not flat
    std::vector<std::pair<Triple, Triple>> segments; // of a segment
};

std::optional<HullImages> hullImages(std::span<const AffineMap<2>> maps,
                                     const std::vector<std::optional<PeriodicPoint>>& points) {
    constexpr std::size_t maxCorners = 16, maxImages = 64;
    if (points.empty() || points.size() > maxCorners || maps.size() > maxImages) return std::nullopt;
    std::vector<ExactPoint<2>> exact;
    HullImages result;
    std::vector<Triple>& corners = result.corners;
    for (const auto& address : points) {
        const auto point = exactPointOf(maps, address);
        if (!point) return std::nullopt;
        exact.push_back(*point);
        corners.push_back(tripleOf(*point));
    }
    for (std::size_t k = 0; corners.size() > 2 && k < corners.size();) {
        const std::size_t count = corners.size(), before = (k + count - 1) % count, after = (k + 1) % count;
        if (sideOf(crossed(corners[before], corners[k]), corners[after]) != 0) {
            ++k;
            continue;
        }
        corners.erase(corners.begin() + std::ptrdiff_t(k)); // collinear with its neighbours
        exact.erase(exact.begin() + std::ptrdiff_t(k));
    }
    for (int i = 0; i < int(maps.size()); ++i) {
        const auto map = exactWord<2>(maps, {i});
        std::vector<Triple> seen;
        for (const auto& point : exact)
            seen.push_back(tripleOf(image(map, point)));
        const int turn = (map.linear[0][0] * map.linear[1][1] - map.linear[0][1] * map.linear[1][0]).sign();
        if (turn < 0) std::ranges::reverse(seen);
        if (corners.size() == 2)
            result.segments.emplace_back(seen[0], seen[1]);
        else if (turn != 0)
            result.images.push_back(sidesOf(seen));
    }
    return result;
}

bool haveCommonArea(Sides polygon, const Sides& other) {
    for (const Triple& side : other)
        if (polygon = leftOf(side, polygon); polygon.empty()) return false;
    return true;
}

} // namespace

bool imagesCoverHull(std::span<const AffineMap<2>> maps,
                     const std::vector<std::optional<PeriodicPoint>>& points) {
    auto hull = hullImages(maps, points);
    if (!hull) return false;
    const auto& corners = hull->corners;
    if (corners.size() == 1) return true;
    if (corners.size() == 2) return coverSegment(std::move(hull->segments), corners[0], corners[1]);
    return Cover(std::move(hull->images)).holds(sidesOf(corners));
}

bool haveImagesDisjointInsides(std::span<const AffineMap<2>> maps,
                               const std::vector<std::optional<PeriodicPoint>>& points) {
    const auto hull = hullImages(maps, points);
    if (!hull || hull->corners.size() < 3 || hull->images.size() != maps.size()) return false;
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (std::size_t j = i + 1; j < maps.size(); ++j)
            if (haveCommonArea(hull->images[i], hull->images[j])) return false;
    return true;
}

} // namespace ifs
