// SPDX-License-Identifier: MIT
#include "ifs/links/linked_extent.h"

#include "ifs/extent/polygon.h"
#include "ifs/extent/sandwich.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace ifs {

namespace {

constexpr std::size_t maxNodes = 20'000;     // open at once
constexpr std::size_t maxChildren = 400'000; // of the open ones, looked at together
constexpr int maxLevels = 20'000;
constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double grain = 0x1p-46; // of |u|: vectors as close as this are merged

// The composition of the maps along the cycle on which `start` comes back to itself.
AffineMap<2> aroundCycle(const ActiveMaps<2>& active, const std::vector<std::size_t>& before,
                         std::size_t start) {
    AffineMap<2> result = active.maps[start];
    for (std::size_t i = before[start]; i != start; i = before[i])
        result = result * active.maps[i];
    return result;
}

// A point of each part, by going back to some map that comes before, until this repeats.
std::vector<Vector<2>> pointsOfParts(const ActiveMaps<2>& active,
                                     const std::vector<std::vector<std::size_t>>& before) {
    const std::size_t n = active.maps.size();
    std::vector<std::size_t> first(n);
    for (std::size_t j = 0; j < n; ++j)
        first[j] = before[j].front();
    std::vector<Vector<2>> points(n);
    for (std::size_t j = 0; j < n; ++j) {
        std::size_t onCycle = j;
        for (std::size_t step = 0; step < n; ++step)
            onCycle = first[onCycle];
        Vector<2> x = fixedPoint(aroundCycle(active, first, onCycle)).value_or(Vector<2>::Zero());
        std::vector<std::size_t> way; // from j back to the cycle
        for (std::size_t i = j; i != onCycle; i = first[i])
            way.push_back(i);
        while (!way.empty()) {
            x = active.maps[way.back()](x);
            way.pop_back();
        }
        points[j] = x;
    }
    return points;
}

} // namespace

struct LinkedExtent::Node {
    std::size_t last = 0; // the innermost map of the word σ
    AffineMap<2> map;     // w_σ, from the centre
    Vector<2> v;          // A_σᵀu
    double offset = 0;    // ⟨u, w_σ(0)⟩
};

std::optional<LinkedExtent> LinkedExtent::of(const ActiveMaps<2>& active, const Existence& existence) {
    const bool exists =
        existence.verdict == Verdict::Hyperbolic || existence.verdict == Verdict::EventuallyContractive;
    if (!exists || active.maps.empty()) return std::nullopt;
    LinkedExtent result;
    result.m_active = active;
    const std::size_t n = active.maps.size();
    result.m_before.resize(n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            if (!active.isLinked() || active.links[i * n + j] > 0) result.m_before[j].push_back(i);
    result.m_points = pointsOfParts(active, result.m_before);
    const auto seenFrom = [&](const Vector<2>& centre) {
        result.m_centre = centre;
        result.m_seen = result.m_points;
        double farthest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            result.m_seen[i] -= centre;
            Vector<2>& shift = result.m_active.maps[i].translation;
            shift = active.maps[i](centre) - centre;
            farthest = std::max(farthest, shift.norm());
        }
        return farthest * existence.normEquivalence / (1 - existence.contractivity);
    };
    result.m_radius = seenFrom(result.m_points.front());
    if (!std::isfinite(result.m_radius)) return std::nullopt;
    std::array<double, 4> reach{};
    const std::array<Vector<2>, 4> axes{Vector<2>(1, 0), {0, 1}, {-1, 0}, {0, -1}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Height height = result(axes[k], 1e-3 * result.m_radius);
        reach[k] = height.value + height.error;
    }
    const Vector<2> high(reach[0], reach[1]), low(-reach[2], -reach[3]);
    const double radius = seenFrom((low + high) / 2);
    result.m_radius = std::min(radius, (high - low).norm() / 2 * (1 + 8 * unit));
    return result;
}

// All words of one length at a time. Words whose linear parts take u to the same vector, after the same map,
// have the same future: the farther one stands for both. So do words whose vectors differ by as little as
// rounding makes, and the radius times the difference is part of the error.
LinkedExtent::Height LinkedExtent::search(std::vector<Node> open, const Vector<2>& u,
                                          double tolerance) const {
    Height best;
    best.value = -std::numeric_limits<double>::infinity();
    const double rounding = 64 * unit * (m_radius + m_centre.norm()) * u.norm();
    const auto reach = [this](const Node& node) { return node.offset + m_radius * node.v.norm(); };
    double most = best.value, apart = 0;
    for (int level = 0; level < maxLevels; ++level) {
        most = best.value;
        for (const Node& node : open) {
            most = std::max(most, reach(node));
            const Vector<2>& inner = m_seen[m_before[node.last].front()];
            if (const double height = node.offset + node.v.dot(inner); height > best.value) {
                best.value = height;
                best.point = node.map(inner);
            }
        }
        std::erase_if(open, [&](const Node& node) { return !(reach(node) > best.value); });
        const bool isTooMuch = open.size() > maxNodes || open.size() * parts() > maxChildren;
        if (most <= best.value + std::max(rounding, tolerance) || (level > 0 && isTooMuch)) break;
        open = lengthened(open, grain * u.norm(), apart);
    }
    best.error = std::max(0.0, most - best.value) + 2 * rounding + apart * m_radius;
    best.value += u.dot(m_centre);
    best.point += m_centre;
    return best;
}

std::vector<LinkedExtent::Node> LinkedExtent::lengthened(const std::vector<Node>& open, double cell,
                                                         double& apart) const {
    bool differ = false;
    std::map<std::tuple<std::size_t, double, double>, Node> next;
    for (const Node& node : open) {
        for (const std::size_t i : m_before[node.last]) {
            const AffineMap<2>& map = m_active.maps[i];
            const Node child{i, node.map * map, map.linear.transpose() * node.v,
                             node.offset + node.v.dot(map.translation)};
            const auto [at, isNew] =
                next.try_emplace({i, std::round(child.v.x() / cell), std::round(child.v.y() / cell)}, child);
            differ = differ || child.v != at->second.v;
            if (child.offset > at->second.offset) at->second = child;
        }
    }
    if (differ) apart += std::sqrt(2.0) * cell;
    std::vector<Node> result;
    for (const auto& [key, node] : next)
        result.push_back(node);
    return result;
}

LinkedExtent::Node LinkedExtent::first(std::size_t part, const Vector<2>& u) const {
    const AffineMap<2>& map = m_active.maps[part];
    return {part, map, map.linear.transpose() * u, u.dot(map.translation)};
}

LinkedExtent::Height LinkedExtent::ofPart(std::size_t part, const Vector<2>& u, double tolerance) const {
    return search({first(part, u)}, u, tolerance);
}

LinkedExtent::Height LinkedExtent::operator()(const Vector<2>& u, double tolerance) const {
    std::vector<Node> open;
    for (std::size_t j = 0; j < parts(); ++j)
        open.push_back(first(j, u));
    return search(std::move(open), u, tolerance);
}

namespace {

// Of what has such heights in every direction.
template <class Heights> BoundingBox<2> boxOf(const Heights& height) {
    const auto right = height({1, 0}), left = height({-1, 0}), top = height({0, 1}), bottom = height({0, -1});
    BoundingBox<2> box{{0.0 - left.value, 0.0 - bottom.value}, {right.value, top.value}};
    box.error = std::sqrt(2.0) * std::max({right.error, left.error, top.error, bottom.error});
    return box;
}

} // namespace

BoundingBox<2> boundingBox(const LinkedExtent& extent) {
    return boxOf([&](const Vector<2>& u) { return extent(u); });
}

std::vector<std::optional<BoundingBox<2>>>
boxesOfParts(const ActiveMaps<2>& active, const Existence& existence, std::size_t maps, std::size_t copies) {
    constexpr std::size_t maxParts = 64;
    const auto extent = active.isLinked() && active.maps.size() <= maxParts
                            ? LinkedExtent::of(active, existence)
                            : std::nullopt;
    if (!extent) return {};
    std::vector<std::optional<BoundingBox<2>>> boxes(maps);
    for (std::size_t part = 0; part < extent->parts(); ++part) {
        const auto box =
            boxOf([&](const Vector<2>& u) { return extent->ofPart(part, u, 1e-12 * extent->radius()); });
        auto& all = boxes[active.index[part] / copies];
        if (!all) {
            all = box;
            continue;
        }
        all->min = all->min.cwiseMin(box.min);
        all->max = all->max.cwiseMax(box.max);
        all->error = std::max(all->error, box.error);
    }
    return boxes;
}

CanonicalSimplex<2> minimalCanonicalSimplex(const LinkedExtent& extent) {
    std::optional<CanonicalSimplex<2>> best;
    for (const Orientation<2> omega : {Orientation<2>{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
        const double x = omega[0], y = omega[1];
        const auto oblique = extent({x, y}), acrossX = extent({-x, 0}), acrossY = extent({0, -y});
        CanonicalSimplex<2> simplex;
        simplex.orientation = omega;
        simplex.leg = oblique.value + acrossX.value + acrossY.value;
        simplex.error = (std::sqrt(2.0) + 2) * std::max(acrossX.error, acrossY.error) + oblique.error;
        const double reach =
            std::max({std::abs(oblique.value), std::abs(acrossX.value), std::abs(acrossY.value)});
        if (!(simplex.leg > 64 * unit * reach)) simplex.leg = 1;
        const Vector<2> corner(0.0 - x * acrossX.value, 0.0 - y * acrossY.value);
        simplex.vertices = {corner, corner + Vector<2>(x * simplex.leg, 0),
                            corner + Vector<2>(0, y * simplex.leg)};
        if (!best || simplex.leg < best->leg * (1 - 1e-12)) best = simplex;
    }
    return *best;
}

std::optional<ConvexHull> convexHull(const LinkedExtent& extent, double tolerance,
                                     const std::stop_token& stop) {
    constexpr int maxLines = 1'000;
    const double flatness = 1e-14 * (extent.radius() + extent.centre().norm());
    const auto ask = [&](const Vector<2>& u, double wanted, int, const Outline*) {
        const auto height = extent(u, wanted);
        return SupportValue<2>{height.value, height.error, height.point, {}};
    };
    const Sandwich sandwich(ask, extent.centre(), std::max(tolerance, 8e-12 * extent.radius() + 4 * flatness),
                            nullptr, maxLines, stop);
    if (stop.stop_requested()) return std::nullopt;
    ConvexHull hull;
    hull.vertices = convexHull(sandwich.outline().points(), flatness);
    for (Vector<2>& vertex : hull.vertices)
        vertex += extent.centre();
    hull.area = area(hull.vertices);
    hull.error = sandwich.error() + 2 * flatness;
    return hull;
}

} // namespace ifs
