// SPDX-License-Identifier: MIT
#include "ifs/extent/support_builder.h"

#include "ifs/existence/polytope_norm.h"
#include "ifs/extent/polygon.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ifs {

namespace {

constexpr int maxDepth = 4;          // depth of the fan
constexpr std::size_t fewMaps = 256; // number of maps below which all are kept

template <int Dim> AffineMap<Dim> meanMap(std::span<const AffineMap<Dim>> maps) {
    AffineMap<Dim> mean{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    for (const auto& map : maps) {
        mean.linear += map.linear / double(maps.size());
        mean.translation += map.translation / double(maps.size());
    }
    return mean;
}

// An ellipsoid about the attractor: a ball of the norm, of radius max_i ‖w_i(c) − c‖ / (1 − s_i) about any c.
// A slow map does not widen it when c is its fixed point.
template <int Dim>
Ellipsoid<Dim> enclosingEllipsoid(std::span<const AffineMap<Dim>> maps, const ContractingNorm<Dim>& norm) {
    const Matrix<Dim> unroot = norm.root.inverse();
    std::vector<double> reach;
    for (const auto& map : maps)
        reach.push_back(1 / (1 - spectralNorm<Dim>(norm.root * map.linear * unroot)));
    // Only longer words contract.
    if (std::ranges::any_of(reach, [](double r) { return !(r > 0 && std::isfinite(r)); }))
        std::ranges::fill(reach, norm.equivalence / (1 - norm.contractivity));
    const auto radius = [&](const Vector<Dim>& centre) {
        double result = 0;
        for (std::size_t i = 0; i < maps.size(); ++i)
            result = std::max(result, (norm.root * (maps[i](centre) - centre)).norm() * reach[i]);
        return result * (1 + 1e-12 * norm.equivalence);
    };
    const Vector<Dim> middle = solveFixedPoint<Dim>(meanMap<Dim>(maps));
    const auto slowest = std::size_t(std::ranges::max_element(reach) - reach.begin());
    const Vector<Dim> aside = solveFixedPoint<Dim>(maps[slowest]);
    const Vector<Dim>& centre = radius(aside) < radius(middle) ? aside : middle;
    return {centre, radius(centre) * unroot};
}

// Points of the attractor far out in some directions, of those that the maps leave where they are.
std::vector<Vector<2>> outerFixedPoints(std::span<const AffineMap<2>> maps) {
    constexpr int directions = 32;
    std::vector<Vector<2>> fixed;
    for (const auto& map : maps)
        if (const Vector<2> point = solveFixedPoint<2>(map); point.allFinite()) fixed.push_back(point);
    std::vector<Vector<2>> outer;
    for (int k = 0; k < directions && !fixed.empty(); ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        const Vector<2> u(std::cos(angle), std::sin(angle));
        outer.push_back(*std::ranges::max_element(fixed, {}, [&u](const auto& x) { return u.dot(x); }));
    }
    return outer;
}

// The maps at `indices` that can lead to the hull of the attractor. One that takes all of a container into
// the hull of some `points` of the attractor does not: without it the hull solves the same equation h(u) =
// max_i ⟨u, t_i⟩ + h(A_iᵀu), which has one solution. `bound` is that of the container seen from `centre`.
template <class Bound>
std::vector<std::size_t> outerMaps(std::span<const AffineMap<2>> maps, std::vector<std::size_t> indices,
                                   const Vector<2>& centre, double radius, Bound bound,
                                   const std::vector<Vector<2>>& points) {
    const Polygon hull = convexHull(points, 0);
    if (hull.size() < 3) return indices;
    const double margin = 1e-9 * (radius + centre.norm());
    std::vector<Vector<2>> outwards;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Vector<2> edge = hull[(k + 1) % hull.size()] - hull[k];
        outwards.push_back(Vector<2>(edge.y(), -edge.x()).normalized());
    }
    std::erase_if(indices, [&](std::size_t i) {
        const Vector<2> image = maps[i](centre);
        for (std::size_t k = 0; k < hull.size(); ++k)
            if (outwards[k].dot(image - hull[k]) + bound(maps[i].linear.transpose() * outwards[k]) > -margin)
                return false;
        return true;
    });
    return indices;
}

template <int Dim> class Builder {
public:
    using Container = SupportContainer<Dim>;

    Builder(std::span<const AffineMap<Dim>> maps, const ContractingNorm<Dim>& norm)
        : m_maps(maps),
          m_ellipsoid(enclosingEllipsoid(maps, norm)),
          m_radius(spectralNorm<Dim>(m_ellipsoid.shape)),
          m_anchor(solveFixedPoint<Dim>(maps.front())),
          m_contractivity(norm.contractivity),
          m_mergeLimit((1 - norm.contractivity) / norm.equivalence) {
        for (const auto& map : maps)
            m_longest = std::max(m_longest, spectralNorm<Dim>(map.linear));
    }

    std::shared_ptr<const Container> container() const {
        if (!std::isfinite(m_radius) || !m_ellipsoid.centre.allFinite() || !m_anchor.allFinite())
            return nullptr;
        std::vector<std::size_t> all(m_maps.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        if constexpr (Dim == 2)
            if (all.size() > fewMaps) return ofOuterMaps(std::move(all));
        return first(std::move(all));
    }

    std::shared_ptr<const Container> finer(const Container& known) const {
        constexpr int finest = Dim == 2 ? 8 : 10;
        constexpr std::size_t maxWork = 4'000'000, maxSweepWork = 40'000;
        int depth = finest;
        while ((std::size_t(4) << depth) * known.indices.size() > maxSweepWork)
            --depth;
        if (depth <= maxDepth) return nullptr;
        const auto result = std::make_shared<Container>(DirectionFan<Dim>(depth));
        describe(*result, known.indices);
        startInside(*result, known);
        centreOn(*result, known.centre);
        result->shrink(maxWork);
        result->findPoints();
        return result;
    }

private:
    // Container built from the few of many maps that can lead to the hull. If it keeps as many maps, more
    // directions may help.
    std::shared_ptr<const Container> ofOuterMaps(std::vector<std::size_t> all) const {
        std::vector<Vector<2>> points = outerFixedPoints(m_maps);
        const auto ofEllipsoid = [&](const Vector<2>& v) {
            return (m_ellipsoid.shape.transpose() * v).norm();
        };
        auto result =
            first(outerMaps(m_maps, std::move(all), m_ellipsoid.centre, m_radius, ofEllipsoid, points));
        for (int finer = 0; result->indices.size() > fewMaps;) {
            for (const Vector<2>& point : result->points)
                points.push_back(result->centre + point);
            auto fewer = outerMaps(
                m_maps, result->indices, result->centre, result->radius,
                [&](const Vector<2>& v) { return result->bound(v); }, points);
            if (finer == maxDepth && 10 * fewer.size() > 9 * result->indices.size()) break;
            if (2 * fewer.size() > result->indices.size()) finer = std::min(finer + 2, maxDepth);
            result = inside(*result, std::move(fewer), finer);
        }
        return result;
    }

    std::shared_ptr<const Container> first(std::vector<std::size_t> indices) const {
        const auto result = empty(std::move(indices), 0);
        result->ellipsoid = {Vector<Dim>::Zero(), m_ellipsoid.shape};
        result->radius = m_radius;
        for (const auto& direction : result->fan.directions())
            result->heights.push_back(result->ellipsoid.bound(direction) * (1 + 1e-15));
        finish(*result, m_ellipsoid.centre);
        return result;
    }

    // Container inside a known one, in finer directions than the budget for so many maps allows.
    std::shared_ptr<const Container> inside(const Container& known, std::vector<std::size_t> indices,
                                            int finer) const {
        const auto result = empty(std::move(indices), finer);
        startInside(*result, known);
        finish(*result, known.centre);
        return result;
    }

    static void startInside(Container& container, const Container& known) {
        container.ellipsoid = known.ellipsoid;
        container.radius = known.radius;
        for (const auto& direction : container.fan.directions())
            container.heights.push_back(known.bound(direction) + known.rounding());
    }

    std::shared_ptr<Container> empty(std::vector<std::size_t> indices, int finer) const {
        int depth = maxDepth;
        while (depth > 0 && (std::size_t(4) << depth) * indices.size() > maxTableWork)
            --depth;
        auto result = std::make_shared<Container>(DirectionFan<Dim>(std::min(depth + finer, maxDepth)));
        describe(*result, std::move(indices));
        return result;
    }

    void describe(Container& container, std::vector<std::size_t> indices) const {
        for (const std::size_t i : indices)
            container.transposed.push_back(m_maps[i].linear.transpose());
        container.indices = std::move(indices);
        container.longest = m_longest;
        container.mergeLimit = m_mergeLimit;
    }

    void finish(Container& container, const Vector<Dim>& centre) const {
        centreOn(container, centre);
        if (!container.solve()) container.shrink();
        centreOn(container, centre + container.recentre());
        container.findPoints();
        if (Dim == 2 && container.isLoose()) fitDirections(container);
    }

    // Chooses directions in which a norm of the transposed maps is largest and the shares of A_iᵀg sum to
    // less than 1: then bounds do not grow, however slowly the maps contract. Directions that a cycle of maps
    // keeps lose nothing at all; solving the container finds them.
    void fitDirections(Container& container) const {
        constexpr int rounds = 12;
        constexpr std::size_t maxDirections = 400;
        std::vector<Vector<Dim>> directions = dualVertices(container.indices);
        if (directions.empty()) return;
        const DirectionFan<Dim> usual(maxDepth);
        directions.insert(directions.end(), usual.directions().begin(), usual.directions().end());
        std::size_t known = 0;
        for (int round = 0; round < rounds; ++round) {
            Container fitted{DirectionFan<Dim>(directions)};
            const std::size_t count = fitted.fan.directions().size();
            if (count == known || count > maxDirections) break;
            known = count;
            describe(fitted, container.indices);
            startInside(fitted, container);
            centreOn(fitted, container.centre);
            if (!fitted.solve()) break;
            centreOn(fitted, fitted.centre + fitted.recentre());
            fitted.findPoints();
            container = std::move(fitted);
            const std::vector<Vector<Dim>> found = container.cycleDirections();
            directions.insert(directions.end(), found.begin(), found.end());
        }
    }

    std::vector<Vector<Dim>> dualVertices(const std::vector<std::size_t>& indices) const {
        std::vector<AffineMap<Dim>> transposed;
        for (const std::size_t i : indices)
            transposed.push_back({m_maps[i].linear.transpose(), Vector<Dim>::Zero()});
        std::vector<Vector<Dim>> result;
        for (const double contractivity : {m_contractivity, (1 + m_contractivity) / 2}) {
            const auto norm = polytopeNorm<Dim>(transposed, contractivity);
            if (!norm) continue;
            for (const Vector<Dim>& vertex : norm->vertices)
                result.insert(result.end(), {vertex, -vertex});
            break;
        }
        return result;
    }

    void centreOn(Container& container, const Vector<Dim>& centre) const {
        container.centre = centre;
        container.offsets.clear();
        for (const std::size_t i : container.indices)
            container.offsets.push_back(m_maps[i](centre) - centre);
        container.anchor = m_anchor - centre;
    }

    std::span<const AffineMap<Dim>> m_maps;
    Ellipsoid<Dim> m_ellipsoid; // ellipsoid around the attractor
    double m_radius;            // radius of a ball around the ellipsoid
    Vector<Dim> m_anchor;
    double m_contractivity;
    double m_mergeLimit;
    double m_longest = 1;
};

} // namespace

template <int Dim>
std::shared_ptr<const SupportContainer<Dim>> supportContainer(std::span<const AffineMap<Dim>> maps,
                                                              const ContractingNorm<Dim>& norm) {
    return Builder<Dim>(maps, norm).container();
}

template <int Dim>
std::shared_ptr<const SupportContainer<Dim>> finerContainer(std::span<const AffineMap<Dim>> maps,
                                                            const ContractingNorm<Dim>& norm,
                                                            const SupportContainer<Dim>& known) {
    return Builder<Dim>(maps, norm).finer(known);
}

template std::shared_ptr<const SupportContainer<2>>
finerContainer<2>(std::span<const AffineMap<2>>, const ContractingNorm<2>&, const SupportContainer<2>&);
template std::shared_ptr<const SupportContainer<3>>
finerContainer<3>(std::span<const AffineMap<3>>, const ContractingNorm<3>&, const SupportContainer<3>&);
template std::shared_ptr<const SupportContainer<2>> supportContainer<2>(std::span<const AffineMap<2>>,
                                                                        const ContractingNorm<2>&);
template std::shared_ptr<const SupportContainer<3>> supportContainer<3>(std::span<const AffineMap<3>>,
                                                                        const ContractingNorm<3>&);

} // namespace ifs
