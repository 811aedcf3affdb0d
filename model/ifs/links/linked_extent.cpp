// SPDX-License-Identifier: MIT
#include "ifs/links/linked_extent.h"

#include "ifs/existence/exact_matrix.h"
#include "ifs/extent/polygon.h"
#include "ifs/extent/sandwich.h"
#include "ifs/links/part_points.h"
#include "ifs/separation/exact_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>

namespace ifs {

namespace {

constexpr std::size_t maxNodes = 20'000;     // open nodes
constexpr std::size_t maxChildren = 400'000; // children of open nodes considered together
constexpr int maxLevels = 20'000;
constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr int maxExact = 600;     // letters of words without rounding
constexpr double grain = 0x1p-46; // relative to |u|; distance within which vectors are merged

// The rounding of w(centre) − centre.
double shiftRounding(const AffineMap<2>& map, const Vector<2>& centre) {
    return 2 * unit * (map.linear.norm() * centre.norm() + map.translation.norm() + centre.norm());
}

double reach(const std::vector<Vector<2>>& points) {
    double result = 0;
    for (const Vector<2>& point : points)
        result = std::max(result, point.norm());
    return result;
}

// The maps i with P_ij > 0, for each j.
std::vector<std::vector<std::size_t>> mapsBefore(const ActiveMaps<2>& active) {
    const std::size_t n = active.maps.size();
    std::vector<std::vector<std::size_t>> result(n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            if (!active.isLinked() || active.links[i * n + j] > 0) result[j].push_back(i);
    return result;
}

ExactMap<2> composed(const ExactMap<2>& outer, const AffineMap<2>& inner) {
    const ExactPoint<2> shift{{Dyadic(inner.translation.x()), Dyadic(inner.translation.y())}, Dyadic(1)};
    return {outer.linear * exactMatrix<2>(inner.linear), image(outer, shift).numerator};
}

} // namespace

struct LinkedExtent::Node {
    std::size_t last = 0;                       // innermost map of the word σ
    AffineMap<2> map{};                         // w_σ relative to the centre
    Vector<2> v = Vector<2>::Zero();            // A_σᵀu
    double offset = 0;                          // ⟨u, w_σ(0)⟩
    double loose = 0;                           // rounding error of the heights that follow
    std::shared_ptr<const ExactMap<2>> exact{}; // w_σ, if its maps cancel
};

std::optional<LinkedExtent> LinkedExtent::of(const ActiveMaps<2>& active, const Existence& existence) {
    if (!existence.hasFactor() || active.maps.empty()) return std::nullopt;
    LinkedExtent result;
    result.m_active = active;
    const std::size_t n = active.maps.size();
    result.m_before = mapsBefore(active);
    result.m_maps = active.maps;
    std::vector<std::size_t> before;
    for (const auto& maps : result.m_before)
        before.push_back(maps.front());
    double known = 0;
    for (const auto& [point, error] : pointsOfParts(active.maps, before)) {
        result.m_points.push_back(point);
        known = std::max(known, error);
    }
    // True for maps in a circle, where each part is one point.
    result.m_arePoints =
        std::ranges::all_of(result.m_before, [](const auto& maps) { return maps.size() == 1; });
    double longest = 1;
    for (const auto& map : active.maps)
        longest = std::max(longest, map.linear.norm());
    constexpr double cancelling = 0x1p24;
    result.m_isCancelling = existence.normEquivalence * longest > cancelling;
    const auto seenFrom = [&](const Vector<2>& centre) {
        result.m_centre = centre;
        result.m_seen = result.m_points;
        double farthest = 0, rounding = 0;
        for (std::size_t i = 0; i < n; ++i) {
            result.m_seen[i] -= centre;
            Vector<2>& shift = result.m_active.maps[i].translation;
            shift = active.maps[i](centre) - centre;
            farthest = std::max(farthest, shift.norm());
            rounding = std::max(rounding, shiftRounding(active.maps[i], centre));
        }
        result.m_pointError = known + unit * (centre.norm() + reach(result.m_points));
        constexpr double negligible = 0x1p-36; // compared with the rounding of every height
        if (!(rounding <= negligible * farthest)) farthest += rounding;
        if (result.m_arePoints) return reach(result.m_seen) + result.m_pointError;
        return farthest * existence.normEquivalence / (1 - existence.contractivity);
    };
    result.m_radius = seenFrom(result.m_points.front());
    if (!std::isfinite(result.m_radius) || !std::isfinite(result.m_pointError)) return std::nullopt;
    std::array<double, 4> sides{};
    const std::array<Vector<2>, 4> axes{Vector<2>(1, 0), {0, 1}, {-1, 0}, {0, -1}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Height height = result(axes[k], 1e-3 * result.m_radius);
        sides[k] = height.value + height.error;
    }
    const Vector<2> high(sides[0], sides[1]), low(-sides[2], -sides[3]);
    const double radius = seenFrom((low + high) / 2);
    result.m_radius = std::min(radius, (high - low).norm() / 2 * (1 + 8 * unit));
    if (std::ranges::any_of(axes, [&result](const auto& axis) { return result.isWide(axis); }))
        result.boundParts();
    return result;
}

namespace {

constexpr std::size_t directions = 256;

const std::array<Vector<2>, directions>& circleOfDirections() {
    static const auto made = [] {
        std::array<Vector<2>, directions> result;
        for (std::size_t k = 0; k < directions; ++k) {
            const double angle = 2 * std::numbers::pi * double(k) / double(directions);
            result[k] = {std::cos(angle), std::sin(angle)};
        }
        return result;
    }();
    return made;
}

// A bound of ⟨v,x⟩ from those in the two directions beside v, of which v is a positive combination. What
// rounding may cost is for the caller to add.
double between(const std::vector<double>& bounds, const Vector<2>& v) {
    const auto& u = circleOfDirections();
    const double turn = std::atan2(v.y(), v.x()) / (2 * std::numbers::pi) * double(directions);
    const auto k = std::size_t((std::int64_t(std::floor(turn)) + std::int64_t(directions)) % directions);
    const std::size_t next = (k + 1) % directions;
    const auto cross = [](const Vector<2>& a, const Vector<2>& b) { return a.x() * b.y() - a.y() * b.x(); };
    const double whole = cross(u[k], u[next]);
    return std::max(cross(v, u[next]), 0.0) / whole * bounds[k] +
           std::max(cross(u[k], v), 0.0) / whole * bounds[next];
}

} // namespace

// Returns true if the error of the ball's bound is large in direction u.
bool LinkedExtent::isWide(const Vector<2>& u) const {
    constexpr double wide = 1e-6; // relative to the radius
    return (*this)(u).error > wide * m_radius;
}

// Bounds from the ball on, h_j(u) ≤ max over the maps i before j of h_i(A_jᵀu) + ⟨u,t_j⟩, again and again.
// Every one of these numbers is a bound, wherever the iteration ends.
void LinkedExtent::boundParts() {
    constexpr std::size_t maxWork = 20'000'000;
    constexpr double settled = 1e-7; // relative to the radius
    const std::size_t n = parts();
    std::size_t links = 0;
    for (const auto& before : m_before)
        links += before.size();
    const std::size_t rounds = maxWork / std::max(links * directions, std::size_t(1));
    std::vector<std::vector<double>> bounds(n, std::vector<double>(directions, m_radius));
    for (std::size_t round = 0; round < rounds; ++round) {
        double change = 0;
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < directions; ++k) {
                const Vector<2>& u = circleOfDirections()[k];
                const AffineMap<2>& map = m_active.maps[j];
                const Vector<2> v = map.linear.transpose() * u;
                double most = -m_radius;
                for (const std::size_t i : m_before[j])
                    most = std::max(most, between(bounds[i], v));
                const double slack = 64 * unit * (map.linear.norm() * m_radius + map.translation.norm()) +
                                     shiftRounding(m_maps[j], m_centre);
                const double bound = most + u.dot(map.translation) + slack;
                if (!(bound < bounds[j][k])) continue;
                change = std::max(change, bounds[j][k] - bound);
                bounds[j][k] = bound;
            }
        if (change <= settled * m_radius) break;
    }
    m_bounds = std::move(bounds);
}

double LinkedExtent::boundOfRest(const Node& node) const {
    const double length = node.v.norm(), ball = m_radius * length;
    if (m_bounds.empty() || !(length > 0)) return ball;
    double most = -ball;
    for (const std::size_t i : m_before[node.last])
        most = std::max(most, between(m_bounds[i], node.v));
    return std::min(ball, most + 64 * unit * ball);
}

// Searches all words of one length at a time. Words whose linear parts take u to the same vector, after the
// same map, have the same future: the farther one stands for both. So do words whose vectors differ by as
// little as rounding makes, and the radius times the difference is part of the error.
LinkedExtent::Height LinkedExtent::search(std::vector<Node> open, const Vector<2>& u,
                                          double tolerance) const {
    Height best;
    best.value = -std::numeric_limits<double>::infinity();
    const double rounding = 64 * unit * (m_radius + m_centre.norm()) * u.norm();
    const auto looseness = [this](const Node& node) { return node.loose + node.v.norm() * m_pointError; };
    // Error of each word separately, if errors vary widely.
    const auto allowance = [&](const Node& node) { return m_isCancelling ? looseness(node) : 0; };
    const auto reach = [&](const Node& node) { return node.offset + boundOfRest(node) + allowance(node); };
    double most = best.value, apart = 0, loose = 0;
    int exactLeft = maxExact;
    for (int level = 0; level < maxLevels; ++level) {
        most = best.value;
        for (const Node& node : open) {
            most = std::max(most, reach(node));
            if (!m_isCancelling) loose = std::max(loose, looseness(node));
            const Vector<2>& inner = m_seen[m_before[node.last].front()];
            const double height = node.offset + node.v.dot(inner) - allowance(node);
            if (height > best.value) {
                best.value = height;
                best.point = node.map(inner);
            }
        }
        std::erase_if(open, [&](const Node& node) { return !(reach(node) > best.value); });
        const bool isTooMuch = open.size() > maxNodes || open.size() * parts() > maxChildren;
        if (most <= best.value + std::max(rounding, tolerance) || (level > 0 && isTooMuch)) break;
        open = lengthened(open, u, apart, exactLeft);
    }
    best.error = std::max(0.0, most - best.value) + std::max(2 * rounding, loose) + apart * m_radius;
    best.value += u.dot(m_centre);
    best.point += m_centre;
    return best;
}

std::vector<LinkedExtent::Node> LinkedExtent::lengthened(const std::vector<Node>& open, const Vector<2>& u,
                                                         double& apart, int& exactLeft) const {
    const double cell = grain * u.norm();
    bool differ = false;
    std::map<std::tuple<std::size_t, double, double>, Node> next;
    for (const Node& node : open) {
        for (const std::size_t i : m_before[node.last]) {
            const Node longer = child(node, i, u, exactLeft);
            const auto [at, isNew] = next.try_emplace(
                {i, std::round(longer.v.x() / cell), std::round(longer.v.y() / cell)}, longer);
            differ = differ || longer.v != at->second.v;
            const double loose = std::max(longer.loose, at->second.loose);
            if (longer.offset > at->second.offset) at->second = longer;
            at->second.loose = loose;
        }
    }
    if (differ) apart += std::sqrt(2.0) * cell;
    std::vector<Node> result;
    for (const auto& [key, node] : next)
        result.push_back(node);
    return result;
}

// An error of v counts as often as points of the attractor are far from the centre, whatever follows.
LinkedExtent::Node LinkedExtent::child(const Node& node, std::size_t map, const Vector<2>& u,
                                       int& exactLeft) const {
    const AffineMap<2>& w = m_active.maps[map];
    if (node.exact && --exactLeft >= 0) return exactNode(map, composed(*node.exact, m_maps[map]), u);
    Node result{map, node.map * w, w.linear.transpose() * node.v, node.offset + node.v.dot(w.translation)};
    const double length = node.v.norm(), shift = w.translation.norm();
    result.loose =
        node.loose + length * shiftRounding(m_maps[map], m_centre) +
        unit * (2 * w.linear.norm() * length * m_radius + 2 * length * shift + std::abs(result.offset));
    return result;
}

LinkedExtent::Node LinkedExtent::exactNode(std::size_t last, ExactMap<2> map, const Vector<2>& u) const {
    Node result{last};
    const std::array<Dyadic, 2> centre{Dyadic(m_centre.x()), Dyadic(m_centre.y())};
    const auto end = image(map, ExactPoint<2>{centre, Dyadic(1)}).numerator;
    Dyadic offset;
    for (std::size_t k = 0; k < 2; ++k) {
        const Dyadic way = end[k] - centre[k];
        result.map.translation[Eigen::Index(k)] = way.rounded();
        offset = offset + way * Dyadic(u[Eigen::Index(k)]);
        result.v[Eigen::Index(k)] =
            (map.linear[0][k] * Dyadic(u.x()) + map.linear[1][k] * Dyadic(u.y())).rounded();
    }
    result.map.linear = rounded<2>(map.linear);
    result.offset = offset.rounded();
    result.loose = 8 * unit * (result.v.norm() * m_radius + std::abs(result.offset));
    result.exact = std::make_shared<const ExactMap<2>>(std::move(map));
    return result;
}

LinkedExtent::Node LinkedExtent::first(std::size_t part, const Vector<2>& u) const {
    if (m_isCancelling) return exactNode(part, exactWord<2>(m_maps, {int(part)}), u);
    const AffineMap<2>& map = m_active.maps[part];
    return {part, map, map.linear.transpose() * u, u.dot(map.translation)};
}

LinkedExtent::Height LinkedExtent::ofPoint(std::size_t part, const Vector<2>& u) const {
    const Vector<2>& seen = m_seen[part];
    const double rounding = 8 * unit * u.norm() * (seen.norm() + m_centre.norm());
    return {u.dot(seen) + u.dot(m_centre), u.norm() * m_pointError + rounding, m_points[part]};
}

LinkedExtent::Height LinkedExtent::ofPart(std::size_t part, const Vector<2>& u, double tolerance) const {
    if (m_arePoints) return ofPoint(part, u);
    return search({first(part, u)}, u, tolerance);
}

LinkedExtent::Height LinkedExtent::operator()(const Vector<2>& u, double tolerance) const {
    if (m_arePoints) {
        Height best = ofPoint(0, u);
        double most = best.value + best.error;
        for (std::size_t j = 1; j < parts(); ++j) {
            const Height height = ofPoint(j, u);
            most = std::max(most, height.value + height.error);
            if (height.value > best.value) best = height;
        }
        best.error = most - best.value;
        return best;
    }
    std::vector<Node> open;
    for (std::size_t j = 0; j < parts(); ++j)
        open.push_back(first(j, u));
    return search(std::move(open), u, tolerance);
}

namespace {

// The box of a set with such heights in every direction.
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
