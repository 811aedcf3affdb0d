// SPDX-License-Identifier: MIT
#include "io/svg_levels.h"

#include "ifs/attractor_existence.h"
#include "ifs/support_function.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>

namespace io {

namespace {

constexpr double thinnest = 1.2;       // of a copy, in pixels: what is thinner is hardly seen
constexpr double hullTolerance = 2e-3; // of the radius
constexpr double widening = 0.4;       // of the smallest copies on every side, in pixels
constexpr double mostWidening = 0.6;   // as a share of their size

double diameterOf(const std::vector<ifs::Vector<2>>& points) {
    double longest = 0;
    for (const auto& a : points)
        for (const auto& b : points)
            longest = std::max(longest, (a - b).norm());
    return longest;
}

ifs::Vector<2> middleOf(const std::vector<ifs::Vector<2>>& points) {
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const auto& p : points)
        sum += p;
    return sum / double(points.size());
}

double turn(const ifs::Vector<2>& a, const ifs::Vector<2>& b, const ifs::Vector<2>& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Strictly convex and counter-clockwise: points found to a tolerance need not be (Andrew's monotone chain).
std::vector<ifs::Vector<2>> strictlyConvex(std::vector<ifs::Vector<2>> points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<ifs::Vector<2>> chain;
    const auto add = [&](const ifs::Vector<2>& point, std::size_t fixed) {
        while (chain.size() >= fixed + 2 && turn(chain[chain.size() - 2], chain.back(), point) <= 0)
            chain.pop_back();
        chain.push_back(point);
    };
    for (const auto& point : points)
        add(point, 0);
    const std::size_t lower = chain.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        add(*point, lower);
    chain.pop_back();
    return chain;
}

// The convex polygon pushed out so that it holds every point within `distance` of it (the corners are cut
// only beyond that). A point or a segment becomes a rectangle.
std::vector<ifs::Vector<2>> pushedOut(const std::vector<ifs::Vector<2>>& polygon, double distance) {
    std::vector<ifs::Vector<2>> result;
    const std::size_t n = polygon.size();
    if (n < 3) {
        const ifs::Vector<2>& a = polygon.front();
        const ifs::Vector<2>& b = polygon.back();
        const ifs::Vector<2> along = n == 2 ? ifs::Vector<2>((b - a).normalized()) : ifs::Vector<2>(1, 0);
        const ifs::Vector<2> u = distance * along;
        const ifs::Vector<2> v(-u.y(), u.x());
        return {a - u - v, b + u - v, b + u + v, a - u + v};
    }
    const auto outward =
        [&](std::size_t i) { // of the edge from vertex i, the polygon being counter-clockwise
            const ifs::Vector<2> edge = polygon[(i + 1) % n] - polygon[i % n];
            return ifs::Vector<2>(ifs::Vector<2>(edge.y(), -edge.x()).normalized());
        };
    for (std::size_t i = 0; i < n; ++i) {
        const ifs::Vector<2> before = outward(i + n - 1);
        const ifs::Vector<2> after = outward(i);
        const double cosine = before.dot(after);
        if (cosine > -0.5) {
            result.push_back(polygon[i] + distance * (before + after) / (1 + cosine));
            continue;
        }
        // A sharp corner would stick out far: two vertices, the square around the corner's end.
        const ifs::Vector<2> tip = (before + after).normalized() * distance;
        result.push_back(polygon[i] + distance * before + tip);
        result.push_back(polygon[i] + distance * after + tip);
    }
    return result;
}

struct Descent {
    std::vector<int> steps; // of each map
    double shrinkage;       // − logarithm of the size that one step stands for
};

// How many steps each map descends: the logarithm of its size in units of the largest map's.
Descent descentOf(const std::vector<ifs::AffineMap<2>>& maps) {
    constexpr double smallestShrinkage = 0.03;
    std::vector<double> costs;
    double least = HUGE_VAL;
    for (const auto& map : maps) {
        const auto sigma = ifs::singularValues<2>(map.linear);
        // The geometric mean, but a thin copy is also long.
        const double size = std::sqrt(sigma[0] * std::max(sigma[1], sigma[0] / 10));
        costs.push_back(-std::log(std::max(size, 1e-9)));
        if (costs.back() > 0) least = std::min(least, costs.back());
    }
    Descent descent{{}, std::isfinite(least) ? std::max(least, smallestShrinkage) : smallestShrinkage};
    for (const double cost : costs)
        descent.steps.push_back(
            std::clamp(int(std::lround(cost / descent.shrinkage)), 1, SvgLevels::mostLevels));
    return descent;
}

// What thickening moves points by in the whole picture, when it moves those of one map by `shift`: every
// further thickened map in a word is seen through the ones before it.
double accumulated(double shift, double thickNorm, const ifs::Existence& existence) {
    return shift * existence.normEquivalence / std::max(1 - thickNorm, 1e-3);
}

} // namespace

ifs::AffineMap<2> thickened(const ifs::AffineMap<2>& map, const ifs::Vector<2>& centre, double least) {
    const auto& m = map.linear;
    // A = R(φ)·diag(s, t)·R(ψ), from A z = αz + βz̄.
    const std::complex<double> alpha((m(0, 0) + m(1, 1)) / 2, (m(1, 0) - m(0, 1)) / 2);
    const std::complex<double> beta((m(0, 0) - m(1, 1)) / 2, (m(1, 0) + m(0, 1)) / 2);
    const double s = std::abs(alpha) + std::abs(beta);
    const double t = std::abs(alpha) - std::abs(beta);
    if (std::abs(t) >= least) return map;
    const Eigen::Rotation2D<double> outer((std::arg(alpha) + std::arg(beta)) / 2);
    const Eigen::Rotation2D<double> inner((std::arg(alpha) - std::arg(beta)) / 2);
    const ifs::Vector<2> thickness(std::max(s, least), std::copysign(least, t));
    ifs::AffineMap<2> thick;
    thick.linear = outer.toRotationMatrix() * thickness.asDiagonal() * inner.toRotationMatrix();
    thick.translation = map(centre) - thick.linear * centre;
    return thick;
}

std::optional<SvgLevels> SvgLevels::of(const document::System2& system, const ifs::AffineMap<2>& display) {
    const auto active = ifs::activeMaps(system);
    const auto support = ifs::SupportFunction<2>::of(active.maps);
    if (!support) return std::nullopt;
    SvgLevels levels;
    levels.m_pixel = 1 / std::max(ifs::spectralNorm<2>(display.linear), 1e-300);
    const double tolerance = std::max(hullTolerance * support->radius(), 1e-3 * levels.m_pixel);
    const ifs::ConvexHull hull = ifs::convexHull(*support, tolerance);
    levels.m_hull = strictlyConvex(hull.vertices);
    levels.m_hullError = std::max(hull.error, tolerance);
    levels.m_diameter = diameterOf(levels.m_hull);
    if (!std::isfinite(levels.m_diameter) || levels.m_hull.empty()) return std::nullopt;
    levels.m_index = active.index;
    levels.thickenAll(active.maps, display);
    Descent descent = descentOf(levels.m_maps);
    levels.m_steps = std::move(descent.steps);
    levels.m_shrinkage = descent.shrinkage;
    levels.countReferences();
    return levels;
}

void SvgLevels::thickenAll(const std::vector<ifs::AffineMap<2>>& maps, const ifs::AffineMap<2>& display) {
    const ifs::Vector<2> centre = middleOf(m_hull);
    const double size = std::max(m_diameter, m_pixel);
    m_display = thickened(display, centre, thinnest / size);
    double thickNorm = 0;
    bool anyThick = false;
    for (const auto& map : maps) {
        m_maps.push_back(thickened(map, centre, std::min(thinnest * m_pixel / size, 0.1)));
        if (m_maps.back() == map) continue;
        anyThick = true;
        thickNorm = std::max(thickNorm, ifs::spectralNorm<2>(m_maps.back().linear));
    }
    if (anyThick) m_thickeningError = accumulated(thinnest, thickNorm, ifs::classify<2>(maps));
    if (!(m_display == display)) m_thickeningError += thinnest;
}

void SvgLevels::countReferences() {
    for (int level = 0; level <= mostLevels; ++level) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; level > 0 && i < m_maps.size(); ++i)
            sum += 1 + m_references[std::size_t(below(level, i))];
        m_references.push_back(std::min(sum, mostReferences));
    }
}

double SvgLevels::margin(int depth) const {
    const double smallest = widening * m_pixel * std::exp(m_shrinkage * depth);
    return m_hullError + std::min(smallest, std::max(mostWidening * m_diameter, widening * m_pixel));
}

std::vector<ifs::Vector<2>> SvgLevels::outline(int depth) const {
    return pushedOut(m_hull, margin(depth));
}

int SvgLevels::below(int level, std::size_t map) const {
    return std::max(0, level - m_steps[map]);
}

std::uint64_t SvgLevels::references(int level) const {
    return m_references[std::size_t(std::clamp(level, 0, mostLevels))];
}

int SvgLevels::deepest() const {
    const auto tooMany = std::find(m_references.begin(), m_references.end(), mostReferences);
    return int(tooMany - m_references.begin()) - 1;
}

double SvgLevels::error(int level) const {
    struct Copy {
        ifs::Matrix<2> linear;
        int level;
    };
    double largest = 0;
    const double diameter = diameterOf(outline(level));
    std::vector<Copy> open{{m_display.linear, level}};
    while (!open.empty()) {
        const Copy copy = open.back();
        open.pop_back();
        const double size = ifs::spectralNorm<2>(copy.linear) * diameter;
        if (copy.level == 0) largest = std::max(largest, size);
        for (std::size_t i = 0; copy.level > 0 && i < m_maps.size(); ++i)
            open.push_back({copy.linear * m_maps[i].linear, below(copy.level, i)});
    }
    return largest + m_thickeningError;
}

int SvgLevels::levelFor(double wanted) const {
    int level = 0;
    while (references(level + 1) <= comfortableReferences && error(level) - m_thickeningError > wanted)
        ++level;
    return level;
}

} // namespace io
