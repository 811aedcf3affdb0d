// SPDX-License-Identifier: MIT
#include "ifs/facts.h"

#include "ifs/dimension.h"
#include "ifs/polygon.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ifs {

template <int Dim>
Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance) {
    Facts<Dim> facts;
    facts.probabilities = probabilities(system);
    facts.active = activeMaps(system);
    facts.existence = classify<Dim>(facts.active.maps);
    facts.mean = mean(facts.active);
    facts.moments = moments(facts.active);
    facts.support = SupportFunction<Dim>::of(facts.active.maps);
    if (!facts.support) return facts;
    facts.box = boundingBox(*facts.support);
    facts.simplex = minimalCanonicalSimplex(*facts.support);
    facts.similarityDimension = similarityDimension<Dim>(facts.active.maps);
    const double diagonal = (facts.box->max - facts.box->min).norm();
    facts.hull = convexHull(*facts.support, hullTolerance.value_or(1e-6 * diagonal));
    return facts;
}

namespace {

// Vertices that have an address become the points that it names. Where two of them meet in one point, or one
// no longer stands out, the hull does without: what it loses that way counts as error.
void settleExtremePoints(Facts<2>& facts) {
    ConvexHull& hull = *facts.hull;
    const auto found = periodicExtremePoints(*facts.support, hull);
    Polygon points = hull.vertices;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (found[k]) points[k] = found[k]->point;
    const Polygon before =
        std::exchange(hull.vertices,
                      convexHull(points, 1e-14 * (facts.support->radius() + facts.support->centre().norm())));
    double lost = 0;
    for (const auto& vertex : before)
        lost = std::max(lost, distanceToConvex(hull.vertices, vertex));
    hull.error += lost;
    hull.area = area(hull.vertices);
    for (const auto& vertex : hull.vertices) {
        facts.extremePoints.emplace_back();
        for (std::size_t k = 0; k < points.size(); ++k)
            if (found[k] && points[k] == vertex) facts.extremePoints.back() = found[k];
    }
}

} // namespace

template <int Dim>
Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance) {
    Facts<Dim> facts = geometricFacts(system, hullTolerance);
    std::optional<double> dimension = facts.similarityDimension;
    if constexpr (Dim == 2) {
        dimension = affinityDimension(facts.active.maps);
        if (facts.hull) settleExtremePoints(facts);
    }
    if (dimension) facts.affinityDimension = std::min(*dimension, double(Dim));
    return facts;
}

namespace {

ConvexHull moved(const AffineMap<2>& transformation, const ConvexHull& hull) {
    ConvexHull result;
    double size = 0;
    for (const auto& vertex : hull.vertices) {
        result.vertices.push_back(transformation(vertex));
        size = std::max(size, result.vertices.back().norm());
    }
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
    result.vertices = convexHull(std::move(result.vertices), rounding);
    result.area = area(result.vertices);
    result.error = spectralNorm<2>(transformation.linear) * hull.error + 2 * rounding;
    return result;
}

Moments<2> moved(const AffineMap<2>& transformation, const Moments<2>& moments) {
    const Matrix<2>& linear = transformation.linear;
    return {transformation(moments.mean), linear * moments.covariance * linear.transpose(),
            linear * moments.longRunCovariance * linear.transpose()};
}

} // namespace

Facts<2> moved(const AffineMap<2>& transformation, const Facts<2>& facts) {
    if (transformation == AffineMap<2>{}) return facts;
    Facts<2> result = facts;
    if (facts.mean) result.mean = transformation(*facts.mean);
    if (facts.moments) result.moments = moved(transformation, *facts.moments);
    if (facts.support) {
        const double tolerance = 1e-12 * facts.support->radius() * spectralNorm<2>(transformation.linear);
        result.box = boundingBoxOfImage(transformation, *facts.support, tolerance);
        result.simplex = minimalCanonicalSimplexOfImage(transformation, *facts.support, tolerance);
    }
    if (facts.hull) result.hull = moved(transformation, *facts.hull);
    result.extremePoints.clear();
    const auto sigma = singularValues<2>(transformation.linear);
    if (!(sigma[1] > 1e-6 * sigma[0])) {
        result.active.maps.clear();
        result.similarityDimension.reset();
        result.affinityDimension.reset();
        return result;
    }
    for (auto& map : result.active.maps)
        map = *conjugate(transformation, map);
    // An attractor has an image, whether or not words of the image's maps are seen to contract.
    if (const auto seen = classify<2>(result.active.maps);
        seen.verdict != Verdict::Undecided || facts.existence.verdict == Verdict::Undecided)
        result.existence = seen;
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>&, std::optional<double>);           \
    template Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>&, std::optional<double>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
