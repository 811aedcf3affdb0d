// SPDX-License-Identifier: MIT
#include "ifs/dimension.h"

#include "ifs/attractor_existence.h"
#include "ifs/decomposition.h"
#include "ifs/invariant_form.h"
#include "ifs/iterated_function_system.h"
#include "ifs/rank_one.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ifs {

namespace {

// The zero of a decreasing function on [low, high].
template <class Function> double bisect(Function function, double low, double high, int steps) {
    for (int n = 0; n < steps; ++n) {
        const double middle = (low + high) / 2;
        (function(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

// L_t f(x) = Σ_i w_i(x) f(A_iᵀx/|A_iᵀx|) on the directions x of the plane, with w_i = |A_iᵀx|^t for t ≤ 1 and
// |A_iᵀx|^(2−t)·|det A_i|^(t−1) above; its growth rate is that of Σ φ^t(A_σ) over the words σ.
class TransferOperator {
public:
    TransferOperator(std::span<const AffineMap<2>> maps, std::size_t cells) : m_cells(cells) {
        for (const auto& map : maps) {
            m_determinants.push_back(isFlat(map.linear) ? 0 : std::abs(determinant<2>(map.linear)));
            for (std::size_t j = 0; j < m_cells; ++j) {
                const double angle = (double(j) + 0.5) * std::numbers::pi / double(m_cells);
                m_images.push_back(
                    image(map.linear.transpose() * Vector<2>(std::cos(angle), std::sin(angle))));
            }
        }
    }

    // ln of the growth rate of L_tⁿ1.
    double pressure(double t) const {
        constexpr int Iterations = 200;
        const std::vector<double> weights = weightsFor(t);
        std::vector<double> f(m_cells, 1), next(m_cells);
        double growth = 0;
        int counted = 0;
        for (int n = 0; n < Iterations; ++n) {
            apply(weights, f, next);
            const double largest = std::ranges::max(next);
            if (!(largest > 0)) return -std::numeric_limits<double>::infinity();
            if (2 * n >= Iterations) { // the first half only forgets where it started
                growth += std::log(largest);
                ++counted;
            }
            double least = std::numeric_limits<double>::infinity(), most = 0;
            for (std::size_t j = 0; j < m_cells; ++j) {
                if (f[j] > 0) {
                    least = std::min(least, next[j] / f[j]);
                    most = std::max(most, next[j] / f[j]);
                }
                f[j] = next[j] / largest;
            }
            if (most - least <= 1e-10 * most) // the eigenvalue lies between the two
                return std::log((least + most) / 2);
        }
        return growth / counted;
    }

private:
    struct Image {
        double length;
        std::uint32_t cell; // f there is (1 − fraction)·f[cell] + fraction·f[cell + 1]
        double fraction;
    };

    Image image(const Vector<2>& v) const {
        const double length = v.norm();
        if (length == 0) return {0, 0, 0};
        double position = std::atan2(v.y(), v.x()) / std::numbers::pi * double(m_cells) - 0.5;
        position -= std::floor(position / double(m_cells)) * double(m_cells);
        const double cell = std::min(std::floor(position), double(m_cells - 1));
        return {length, std::uint32_t(cell), position - cell};
    }

    std::vector<double> weightsFor(double t) const {
        std::vector<double> weights;
        weights.reserve(m_images.size());
        for (std::size_t k = 0; k < m_images.size(); ++k) {
            const double det = m_determinants[k / m_cells], length = m_images[k].length;
            weights.push_back(t <= 1 ? std::pow(length, t) : std::pow(length, 2 - t) * std::pow(det, t - 1));
        }
        return weights;
    }

    void apply(const std::vector<double>& weights, const std::vector<double>& f,
               std::vector<double>& next) const {
        std::ranges::fill(next, 0.0);
        for (std::size_t k = 0; k < m_images.size();)
            for (std::size_t j = 0; j < m_cells; ++j, ++k) {
                const Image& at = m_images[k];
                const std::size_t after = at.cell + 1 == m_cells ? 0 : at.cell + 1;
                next[j] += weights[k] * (f[at.cell] + at.fraction * (f[after] - f[at.cell]));
            }
    }

    std::size_t m_cells;
    std::vector<double> m_determinants;
    std::vector<Image> m_images; // map by map, cell by cell
};

// The zero of a decreasing function on [0, 2], looked for first within `reach` of where it may be.
template <class Function> double zeroNear(Function function, double guess, double reach) {
    constexpr double Accuracy = 1e-8;
    for (;; reach *= 32) {
        const double low = std::max(guess - reach, 0.0), high = std::min(guess + reach, 2.0);
        if ((low == 0 || function(low) > 0) && (high == 2 || function(high) <= 0))
            return bisect(function, low, high, int(std::ceil(std::log2((high - low) / Accuracy))));
    }
}

// Where the pressure vanishes, on finer and finer directions. The error of each falls with the square of the
// spacing where the eigenfunction is smooth; so extrapolated, three in a row must agree.
std::optional<double> refinedDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop) {
    constexpr std::size_t FewestCells = 64, MostCells = 8192, MostImages = 800'000;
    constexpr double Agreement = 1e-6;
    double found = 1, extrapolated = -1;
    int agreeing = 0;
    for (std::size_t cells = FewestCells; cells <= MostCells && cells * maps.size() <= MostImages;
         cells *= 2) {
        const TransferOperator transfer(maps, cells);
        const auto pressure = [&](double t) { return stop.stop_requested() ? 0 : transfer.pressure(t); };
        const bool isFirst = cells == FewestCells;
        const double finer = zeroNear(pressure, found, isFirst ? 1 : 1e-4);
        if (stop.stop_requested()) return std::nullopt;
        const double next = finer + (isFirst ? 0 : (finer - found) / 3);
        agreeing = std::abs(next - extrapolated) <= Agreement ? agreeing + 1 : 0;
        if (agreeing == 2) return next;
        found = finer;
        extrapolated = next;
    }
    return std::nullopt;
}

template <int Dim> std::vector<double> similarityRatios(std::span<const AffineMap<Dim>> maps) {
    std::vector<double> ratios;
    for (const auto& map : maps)
        if (const double det = std::abs(determinant<Dim>(map.linear)); det > 0)
            ratios.push_back(std::pow(det, 1.0 / Dim));
    return ratios;
}

// Where Σ φ^t(A_i) = 1: an upper bound of the affinity dimension, in any dimension of space.
template <int Dim> double firstBound(std::span<const AffineMap<Dim>> maps) {
    constexpr double Largest = 64;
    const auto excess = [maps](double t) {
        double sum = -1;
        for (const auto& map : maps)
            sum += singularValueFunction<Dim>(map.linear, t);
        return sum;
    };
    return bisect(excess, 0, Largest, 60);
}

bool hasAttractor(std::span<const AffineMap<2>> maps) {
    const Verdict verdict = classify(maps).verdict;
    return verdict == Verdict::Hyperbolic || verdict == Verdict::EventuallyContractive;
}

template <int Dim> std::optional<double> dimensionOf(std::span<const AffineMap<Dim>> maps) {
    if constexpr (Dim == 2) {
        if (const auto dimension = affinityDimension(maps)) return dimension;
        if (!hasAttractor(maps)) return std::nullopt;
    }
    if (const auto dimension = similarityDimension<Dim>(maps)) return dimension;
    return maps.empty() ? std::nullopt : std::optional(firstBound<Dim>(maps));
}

} // namespace

std::optional<double> moranDimension(std::span<const double> ratios) {
    if (ratios.empty() || !std::ranges::all_of(ratios, [](double s) { return s > 0 && s < 1; }))
        return std::nullopt;
    if (ratios.size() == 1) return 0;
    const auto excess = [ratios](double dimension) {
        double sum = -1;
        for (const double ratio : ratios)
            sum += std::pow(ratio, dimension);
        return sum;
    };
    double high = 64;
    while (excess(high) > 0)
        high *= 2;
    constexpr int Steps = 100;
    return bisect(excess, 0, high, Steps);
}

template <int Dim> std::optional<double> similarityDimension(std::span<const AffineMap<Dim>> maps) {
    if (maps.empty() || !std::ranges::all_of(maps, isFinite<Dim>)) return std::nullopt;
    const auto form = invariantForm<Dim>(maps);
    const std::vector<double> ratios = similarityRatios<Dim>(maps);
    if (!form || ratios.size() != maps.size() || !(singularValues<Dim>(*form)[Dim - 1] > 1e-12))
        return std::nullopt;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Matrix<Dim> image =
            maps[i].linear.transpose() * *form * maps[i].linear / (ratios[i] * ratios[i]);
        if (!((image - *form).cwiseAbs().maxCoeff() <= 1e-9)) return std::nullopt;
    }
    return moranDimension(ratios);
}

template <int Dim> double singularValueFunction(const Matrix<Dim>& linear, double t) {
    if (t >= Dim) return std::pow(std::abs(determinant<Dim>(linear)), t / Dim);
    const Vector<Dim> sigma = singularValues<Dim>(linear);
    double result = 1;
    for (int k = 0; k < Dim && t > 0; ++k, t -= 1)
        result *= t >= 1 ? sigma[k] : std::pow(sigma[k], t);
    return result;
}

std::optional<double> affinityDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop) {
    if (!hasAttractor(maps)) return std::nullopt;
    if (maps.size() == 1) return 0;
    if (const auto dimension = similarityDimension(maps)) return dimension;
    double area = 0;
    for (const auto& map : maps)
        area += std::abs(determinant<2>(map.linear));
    if (area >= 1) // above 2 the pressure is ln Σ |det A_i|^(t/2)
        return moranDimension(similarityRatios<2>(maps));
    if (std::ranges::all_of(maps, [](const auto& map) { return isFlat(map.linear); }))
        return rankOneDimension(maps, stop);
    return refinedDimension(maps, stop);
}

template <int Dim> std::vector<double> dimensionWeights(std::span<const AffineMap<Dim>> maps, double floor) {
    const auto dimension = dimensionOf<Dim>(maps);
    if (!dimension) return determinantWeights(maps, floor);
    std::vector<double> masses;
    for (const auto& map : maps)
        masses.push_back(singularValueFunction<Dim>(map.linear, std::min<double>(*dimension, Dim)));
    return shares(std::move(masses), floor);
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template std::optional<double> similarityDimension<Dim>(std::span<const AffineMap<Dim>>);                \
    template double singularValueFunction<Dim>(const Matrix<Dim>&, double);                                  \
    template std::vector<double> dimensionWeights<Dim>(std::span<const AffineMap<Dim>>, double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
