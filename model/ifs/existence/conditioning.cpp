// SPDX-License-Identifier: MIT
#include "ifs/existence/conditioning.h"

#include "ifs/existence/invariant_form.h"
#include "ifs/existence/norm_descent.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/inverse.h"
#include "ifs/linear/symmetric_matrices.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ifs {

namespace {

constexpr double contracts = 1 - 1e-9; // leaves room for rounding
constexpr double maxCondition = 1e6;

template <int Dim> double condition(const Matrix<Dim>& root) {
    return root.norm() * root.inverse().norm();
}

// About by how much a figure is wider for being found in these coordinates.
double widening(double condition, double longest) {
    return longest < contracts ? condition / (1 - longest) : std::numeric_limits<double>::infinity();
}

template <int Dim> double widening(const NormCoordinates<Dim>& coordinates) {
    return widening(condition<Dim>(coordinates.root), coordinates.longest);
}

// Maps that contract as it is are made shorter only by coordinates that do not stretch much: triangular maps
// come as near to their diagonals as one likes, and all that is known there is stretched back.
template <int Dim> bool isShorter(const NormCoordinates<Dim>& next, const NormCoordinates<Dim>& best) {
    constexpr double slow = 0.99;
    return next.longest < best.longest && (best.longest >= slow || condition<Dim>(next.root) <= maxCondition);
}

template <int Dim> std::vector<double> norms(std::span<const AffineMap<Dim>> maps) {
    std::vector<double> result;
    for (const auto& map : maps)
        result.push_back(spectralNorm<Dim>(map.linear));
    return result;
}

template <int Dim>
std::vector<AffineMap<Dim>> seenThrough(const Matrix<Dim>& root, std::span<const AffineMap<Dim>> maps) {
    const Matrix<Dim> unroot = root.inverse();
    std::vector<AffineMap<Dim>> result;
    for (const auto& map : maps)
        result.push_back({root * map.linear * unroot, map.translation});
    return result;
}

template <int Dim> std::optional<Matrix<Dim>> choleskyRoot(const Matrix<Dim>& form) {
    constexpr double minEigenvalue = 1e-9; // keeps a nearly flat form definite
    return choleskyFactor<Dim>(form + minEigenvalue * form.trace() * Matrix<Dim>::Identity());
}

// The root of the weighted form of these maps. Where they stretch too much for that to be found, one step
// of the power iteration towards it is positive definite all the same, and the maps are shorter there.
template <int Dim>
std::optional<Matrix<Dim>> rootOfForm(std::span<const AffineMap<Dim>> maps,
                                      const std::vector<double>& weights) {
    if (const auto form = invariantForm<Dim>(maps, weights))
        if (const auto root = choleskyRoot<Dim>(*form)) return root;
    Matrix<Dim> step = Matrix<Dim>::Zero();
    for (std::size_t i = 0; i < maps.size(); ++i)
        step += weights[i] * maps[i].linear.transpose() * maps[i].linear;
    return choleskyRoot<Dim>(step);
}

constexpr std::size_t maxWork = 100'000; // norms to compute, unless there are too many maps

// Forms in which the maps that were the longest before weigh more and more.
template <int Dim> void weigh(NormCoordinates<Dim>& best, std::span<const AffineMap<Dim>> maps) {
    constexpr double shortEnough = 0.5;
    const std::size_t rounds = std::clamp<std::size_t>(maxWork / maps.size(), 2, 20);
    Matrix<Dim> root = best.root;
    std::vector<AffineMap<Dim>> seen(maps.begin(), maps.end());
    std::vector<double> weights(maps.size(), 1);
    for (std::size_t round = 0; round < rounds && best.longest > shortEnough; ++round) {
        const auto step = rootOfForm<Dim>(seen, weights);
        if (!step) return;
        root = *step * root;
        root /= spectralNorm<Dim>(root);
        seen = seenThrough<Dim>(root, maps);
        const std::vector<double> lengths = norms<Dim>(seen);
        const double longest = std::ranges::max(lengths);
        if (!std::isfinite(longest)) return;
        const NormCoordinates<Dim> next{root, longest};
        if (isShorter(next, best)) best = next;
        for (std::size_t i = 0; i < weights.size(); ++i)
            weights[i] *= std::pow(std::max(lengths[i] / longest, 1e-3), 2);
    }
}

// Smaller and smaller steps along the entries of the root as long as they shorten the longest map: the best
// norm need not be that of a weighted form.
template <int Dim> void refine(NormCoordinates<Dim>& best, std::span<const AffineMap<Dim>> maps) {
    constexpr double shortEnough = 0.9, minStep = 1e-3;
    constexpr int tries = 4;
    const auto shortens = [&](const Matrix<Dim>& root) {
        const Matrix<Dim> unroot = root.inverse();
        double longest = 0;
        for (const auto& map : maps) {
            longest = std::max(longest, spectralNorm<Dim>(root * map.linear * unroot));
            if (!(longest < best.longest)) return false;
        }
        const NormCoordinates<Dim> next{root, longest};
        if (!isShorter(next, best)) return false;
        best = next;
        return true;
    };
    std::size_t work = 0;
    double step = 0.3;
    const auto isAnyShorter = [&] {
        bool result = false;
        for (int row = 0; row < Dim; ++row)
            for (int column = row; column < Dim; ++column)
                for (const double change : {step, -step}) {
                    Matrix<Dim> stretch = Matrix<Dim>::Identity();
                    stretch(row, column) += change;
                    result = shortens(stretch * best.root) || result;
                    work += maps.size();
                }
        return result;
    };
    for (; step > minStep && best.longest > shortEnough && work < maxWork; step /= 2)
        for (int n = 0; n < tries && isAnyShorter(); ++n) {}
}

// Maps that keep a flag of directions are triangular along it, and as short as the diagonals are, once the
// directions are stretched enough against each other: no further than is worth what stretching costs.
template <int Dim>
void stretch(NormCoordinates<Dim>& best, const Matrix<Dim>& flag, std::span<const AffineMap<Dim>> maps) {
    constexpr double leastShare = 1e-9, minGain = 1e-6;
    for (double share = 1; share > leastShare; share /= 4) {
        Vector<Dim> lengths;
        for (int k = 0; k < Dim; ++k)
            lengths[k] = std::pow(share, Dim - 1 - k);
        Matrix<Dim> root = lengths.asDiagonal() * flag;
        root /= spectralNorm<Dim>(root);
        const NormCoordinates<Dim> next{root, std::ranges::max(norms<Dim>(seenThrough<Dim>(root, maps)))};
        const bool isBetter = next.longest < contracts ? widening<Dim>(next) < widening<Dim>(best)
                                                       : next.longest < best.longest * (1 - minGain);
        if (isBetter) best = next;
    }
}

// The directions of a sum of the maps are tried as such a flag in every order, as they are and at right
// angles.
template <int Dim> void alongFlag(NormCoordinates<Dim>& best, std::span<const AffineMap<Dim>> maps) {
    if (maps.size() > maxWork / 50) return;
    Matrix<Dim> sum = Matrix<Dim>::Zero(); // weighted sum; the weights prevent maps from cancelling
    for (std::size_t i = 0; i < maps.size(); ++i)
        sum += maps[i].linear / double(i + 1);
    const auto directions = eigendirections<Dim>(sum);
    if (!directions) return;
    std::array<int, Dim> order{};
    std::iota(order.begin(), order.end(), 0);
    do {
        Matrix<Dim> flag;
        for (int k = 0; k < Dim; ++k)
            flag.col(k) = directions->col(order[std::size_t(k)]);
        if (const Matrix<Dim> back = flag.inverse(); back.allFinite()) stretch<Dim>(best, back, maps);
        const Matrix<Dim> turned = orthogonalFactor(flag);
        stretch<Dim>(best, turned.transpose(), maps);
    } while (std::next_permutation(order.begin(), order.end()));
}

} // namespace

// The maps in the coordinates of the image, each rounded once where a long double is longer. With W near U⁻¹
// and W U = I + E, the exact maps are (I + E)⁻¹ times those that W gives.
template <int Dim>
std::optional<Conditioned<Dim>> seenFrom(const AffineMap<Dim>& image, std::span<const AffineMap<Dim>> maps) {
    using Real = long double;
    using RealMatrix = Eigen::Matrix<Real, Dim, Dim>;
    using RealVector = Eigen::Matrix<Real, Dim, 1>;
    // Error of a product of three matrices.
    constexpr Real products = 4 * Dim * std::numeric_limits<Real>::epsilon();
    const RealMatrix there = image.linear.template cast<Real>(), back = inverseOf(there);
    const RealMatrix size = there.cwiseAbs(), backSize = back.cwiseAbs();
    const RealVector centre = image.translation.template cast<Real>();
    const Real inverse = (back * there - RealMatrix::Identity()).norm() + products * (backSize * size).norm();
    if (!(inverse < 0.01L)) return std::nullopt;
    Conditioned<Dim> result{.image = image, .condition = double(there.norm() * back.norm())};
    for (const auto& map : maps) {
        const RealMatrix linear = map.linear.template cast<Real>(), seen = back * linear * there;
        const RealVector shift = map.translation.template cast<Real>(),
                         seenShift = back * (linear * centre + shift - centre);
        result.maps.push_back({seen.template cast<double>(), seenShift.template cast<double>()});
        const AffineMap<Dim>& rounded = result.maps.back();
        const Real linearError = (seen - rounded.linear.template cast<Real>()).norm() +
                                 inverse * seen.norm() +
                                 products * (backSize * linear.cwiseAbs() * size).norm();
        const RealVector terms = linear.cwiseAbs() * centre.cwiseAbs() + shift.cwiseAbs() + centre.cwiseAbs();
        const Real shiftError = (seenShift - rounded.translation.template cast<Real>()).norm() +
                                inverse * seenShift.norm() + products * (backSize * terms).norm();
        if (!isFinite(rounded) || !std::isfinite(double(linearError)) || !std::isfinite(double(shiftError)))
            return std::nullopt;
        result.linearRounding = std::max(result.linearRounding, 2 * double(linearError));
        result.translationRounding = std::max(result.translationRounding, 2 * double(shiftError));
    }
    const std::vector<double> lengths = norms<Dim>(result.maps);
    const auto slowest = std::ranges::max_element(lengths);
    result.longest = *slowest * (1 + 1e-15) + result.linearRounding;
    result.slowest = int(slowest - lengths.begin());
    return result;
}

namespace {

// The power of two that lengths are measured in, so that no product of lengths underflows.
template <int Dim> double unitOfLength(std::span<const AffineMap<Dim>> maps) {
    constexpr double tiny = 0x1p-200;
    double size = 0;
    for (const auto& map : maps)
        size = std::max(size, map.translation.cwiseAbs().maxCoeff());
    return size > 0 && size < tiny ? std::ldexp(1, std::ilogb(size)) : 1;
}

template <int Dim>
std::optional<Conditioned<Dim>> seenIn(const Matrix<Dim>& root, std::span<const AffineMap<Dim>> maps) {
    // Power of two that keeps the size of the attractor about the same; its orientation stays, too.
    int exponent = 0;
    std::frexp(spectralNorm<Dim>(root.inverse()), &exponent);
    Matrix<Dim> upright = std::ldexp(1, exponent) * root;
    if (upright.determinant() < 0) upright.row(0) = -upright.row(0).eval();
    AffineMap<Dim> mean{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    for (const auto& map : maps) {
        mean.linear += map.linear / double(maps.size());
        mean.translation += map.translation / double(maps.size());
    }
    return seenFrom<Dim>(
        {unitOfLength(maps) * upright.inverse(), fixedPoint(mean).value_or(Vector<Dim>::Zero())}, maps);
}

} // namespace

template <int Dim> std::optional<Conditioned<Dim>> conditioned(std::span<const AffineMap<Dim>> maps) {
    const double before = std::ranges::max(norms<Dim>(maps));
    if (!(before >= 1))
        return unitOfLength(maps) < 1 ? seenIn<Dim>(Matrix<Dim>::Identity(), maps) : std::nullopt;
    NormCoordinates<Dim> best{Matrix<Dim>::Identity(), before};
    weigh(best, maps);
    refine(best, maps);
    if (!(best.longest < contracts)) descend(best, maps);
    auto result = best.longest < before ? seenIn<Dim>(best.root, maps) : std::nullopt;
    constexpr double littleStretch = 100;
    if (result && result->longest < contracts && result->condition <= littleStretch) return result;
    // Fallback if rounding cancels the gain of the best norm.
    NormCoordinates<Dim> flag{Matrix<Dim>::Identity(), before};
    alongFlag(flag, maps);
    auto other = flag.longest < before ? seenIn<Dim>(flag.root, maps) : std::nullopt;
    if (!result || !other) return result ? result : other;
    const double width = widening(result->condition, result->longest),
                 otherWidth = widening(other->condition, other->longest);
    const bool isOther = width == otherWidth ? other->longest < result->longest : otherWidth < width;
    return isOther ? other : result;
}

template std::optional<Conditioned<2>> seenFrom(const AffineMap<2>&, std::span<const AffineMap<2>>);
template std::optional<Conditioned<3>> seenFrom(const AffineMap<3>&, std::span<const AffineMap<3>>);
template std::optional<Conditioned<2>> conditioned(std::span<const AffineMap<2>>);
template std::optional<Conditioned<3>> conditioned(std::span<const AffineMap<3>>);

} // namespace ifs
