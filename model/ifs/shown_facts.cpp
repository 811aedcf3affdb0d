// SPDX-License-Identifier: MIT
#include "ifs/shown_facts.h"

#include "ifs/extent/extent.h"
#include "ifs/extent/polygon.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ifs {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

ConvexHull hullOfImages(const ConvexHull& hull, std::span<const AffineMap<2>> images) {
    Polygon points;
    double size = 0;
    double stretch = 0;
    for (const AffineMap<2>& image : images) {
        stretch = std::max(stretch, spectralNorm<2>(image.linear));
        for (const auto& vertex : hull.vertices) {
            points.push_back(image(vertex));
            size = std::max(size, points.back().norm());
        }
    }
    const double rounding = 16 * epsilon * size;
    ConvexHull result;
    result.vertices = convexHull(std::move(points), rounding);
    result.area = area(result.vertices);
    result.error = stretch * hull.error + 2 * rounding;
    return result;
}

// Share of the measure of a piece: that of its word.
double share(const Word& word, std::span<const double> probabilities) {
    double result = 1;
    for (const int symbol : word)
        result *= probabilities[std::size_t(symbol)];
    return result;
}

// The mean of the means, and of covariances with what the means stray.
template <int Dim>
Moments<Dim> mixed(const Moments<Dim>& moments, std::span<const AffineMap<Dim>> images,
                   std::span<const double> shares) {
    Moments<Dim> result{Vector<Dim>::Zero(), Matrix<Dim>::Zero(), Matrix<Dim>::Zero()};
    double reach = 0;
    double stretch = 0; // factor of the mean square
    for (std::size_t k = 0; k < images.size(); ++k) {
        const double norm = spectralNorm<Dim>(images[k].linear);
        result.mean += shares[k] * images[k](moments.mean);
        result.meanError += shares[k] * norm * moments.meanError;
        stretch += shares[k] * norm * norm;
        reach = std::max(reach, norm * moments.mean.norm() + images[k].translation.norm());
    }
    const double rounding = double(images.size() + 4 * Dim) * epsilon;
    result.meanError += rounding * reach;
    for (std::size_t k = 0; k < images.size(); ++k) {
        const Matrix<Dim>& linear = images[k].linear;
        const Vector<Dim> stray = images[k](moments.mean) - result.mean;
        result.covariance +=
            shares[k] * (linear * moments.covariance * linear.transpose() + stray * stray.transpose());
        // 2‖stray‖·(error of stray), to first order and with the square of it
        const double off = spectralNorm<Dim>(linear) * moments.meanError + result.meanError;
        result.covarianceError += shares[k] * off * (2 * stray.norm() + off);
    }
    result.covarianceError += stretch * Dim * moments.covarianceError + rounding * result.covariance.norm();
    return result;
}

} // namespace

template <int Dim>
Facts<Dim> shown(Facts<Dim> facts, const Facts<Dim>& code, const AffineMap<Dim>& placement,
                 std::span<const MovedBranch<Dim>> pieces) {
    std::vector<AffineMap<Dim>> images = pieceMaps<Dim>(pieces, code.active.maps);
    double stretch = 0;
    for (auto& image : images) {
        image = placement * image;
        stretch = std::max(stretch, spectralNorm<Dim>(image.linear));
    }
    std::vector<double> shares;
    for (const auto& piece : pieces)
        shares.push_back(share(piece.word, code.active.probabilities));
    facts.box.reset();
    facts.simplex.reset();
    facts.hull.reset();
    facts.mean.reset();
    facts.moments.reset();
    facts.extremePoints.clear();
    facts.isHullExact = false;
    if (code.active.isLinked() || images.empty()) return facts;
    if (code.support) {
        const double tolerance = 1e-12 * code.support->radius() * stretch;
        facts.box = boundingBoxOfImages<Dim>(images, *code.support, tolerance);
        facts.simplex = minimalCanonicalSimplexOfImages<Dim>(images, *code.support, tolerance);
    }
    if constexpr (Dim == 2)
        if (code.hull) facts.hull = hullOfImages(*code.hull, images);
    if (code.moments) {
        facts.moments = mixed<Dim>(*code.moments, images, shares);
        facts.mean = Mean<Dim>{facts.moments->mean, facts.moments->meanError};
    }
    return facts;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template Facts<Dim> shown(Facts<Dim>, const Facts<Dim>&, const AffineMap<Dim>&,                          \
                              std::span<const MovedBranch<Dim>>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
