// SPDX-License-Identifier: MIT
#include "ifs/dimension/transfer_operator.h"

#include "ifs/dimension/rank_one.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace ifs {

namespace {

using Values = std::vector<double>; // values of a function at the centres of cells of equal angle

// A direction among the cells: between the middles of `cell` and the next.
struct Position {
    std::uint32_t cell = 0;
    double fraction = 0;
};

Position positionOf(const Vector<2>& v, std::size_t cells) {
    // Directions repeat after half a turn.
    const double turns = std::atan2(v.y(), v.x()) / std::numbers::pi;
    double position = turns * double(cells) - 0.5;
    position -= std::floor(position / double(cells)) * double(cells);
    const double cell = std::min(std::floor(position), double(cells - 1));
    return {std::uint32_t(cell), position - cell};
}

// The cubic through the four nearest values.
double valueAt(const Values& f, const Position& at) {
    const std::size_t n = f.size(), k = at.cell;
    const double s = at.fraction;
    const double before = f[k == 0 ? n - 1 : k - 1], here = f[k], next = f[(k + 1) % n],
                 after = f[(k + 2) % n];
    return here + s * (next - here) -
           s * (1 - s) / 6 * ((2 - s) * (before - 2 * here + next) + (1 + s) * (here - 2 * next + after));
}

// L_t f(x) = Σ_i w_i(x) f(A_iᵀx/|A_iᵀx|) on the directions x of the plane, with w_i = |A_iᵀx|^t for t ≤ 1 and
// |A_iᵀx|^(2−t)·|det A_i|^(t−1) above; its growth rate is that of Σ φ^t(A_σ) over the words σ.
class TransferOperator {
public:
    TransferOperator(std::span<const AffineMap<2>> maps, std::size_t cells) : m_maps(maps), m_cells(cells) {
        for (const auto& map : maps) {
            m_determinants.push_back(isFlat(map.linear) ? 0 : std::abs(determinant<2>(map.linear)));
            for (std::size_t j = 0; j < m_cells; ++j)
                m_images.push_back(image(map, double(j) + 0.5));
        }
    }

    // ln of the growth rate of L_tⁿ1, and the eigenfunction of L_t.
    struct Growth {
        double logarithm = -std::numeric_limits<double>::infinity();
        Values f;
    };
    Growth growth(double t, const std::stop_token& stop) const {
        constexpr int iterations = 1000, undamped = 60;
        const Values weights = weightsFor(t);
        Growth result{0, Values(m_cells, 1)};
        Values& f = result.f;
        Values next(m_cells);
        for (int n = 0; n < iterations && !stop.stop_requested(); ++n) {
            apply(weights, f, next);
            double least = std::numeric_limits<double>::infinity(), most = 0, largest = 0;
            for (std::size_t j = 0; j < m_cells; ++j) {
                largest = std::max(largest, next[j]);
                if (!(f[j] > 0)) continue;
                least = std::min(least, next[j] / f[j]);
                most = std::max(most, next[j] / f[j]);
            }
            if (!(largest > 0)) return {};
            const double factor = (least + most) / 2; // estimate between the bounds of the eigenvalue
            result.logarithm = std::log(factor);
            if (most - least <= 1e-11 * most) break;
            // Half-steps damp other eigenfunctions, whose signs alternate under maps that turn or mirror.
            for (std::size_t j = 0; j < m_cells; ++j)
                f[j] = n < undamped ? next[j] / largest : (f[j] + next[j] / factor) / 2;
        }
        return result;
    }

    // |ln (L_t f)/f| between the cells, too. Since f is positive, it encloses the growth of the operator
    // itself, not of its discretization: that growth lies between the least and the greatest value of (L_t
    // f)/f.
    struct Misfit {
        double largest = 0;
        double mean = 0;
    };
    Misfit misfit(double t, const Values& f) const {
        constexpr int perCell = 4;
        const std::size_t samples = m_cells * perCell;
        Misfit result;
        for (std::size_t j = 0; j < samples; ++j) {
            const double at = (double(j) + 0.5) / perCell;
            const double value = valueAt(f, positionOf(direction(at), m_cells));
            double sum = 0;
            for (std::size_t i = 0; i < m_maps.size(); ++i) {
                const Image there = image(m_maps[i], at);
                sum += weight(there.length, m_determinants[i], t) * valueAt(f, there.position);
            }
            const double off = value > 0 && sum > 0 ? std::abs(std::log(sum / value)) : 1;
            result.largest = std::max(result.largest, off);
            result.mean += off / double(samples);
        }
        return result;
    }

private:
    struct Image {
        double length = 0;
        Position position;
    };

    Vector<2> direction(double cell) const {
        const double angle = cell * std::numbers::pi / double(m_cells);
        return {std::cos(angle), std::sin(angle)};
    }

    Image image(const AffineMap<2>& map, double cell) const {
        const Vector<2> v = map.linear.transpose() * direction(cell);
        const double length = v.norm();
        return length > 0 ? Image{length, positionOf(v, m_cells)} : Image{};
    }

    static double weight(double length, double determinant, double t) {
        return t <= 1 ? std::pow(length, t) : std::pow(length, 2 - t) * std::pow(determinant, t - 1);
    }

    Values weightsFor(double t) const {
        Values weights;
        weights.reserve(m_images.size());
        for (std::size_t k = 0; k < m_images.size(); ++k)
            weights.push_back(weight(m_images[k].length, m_determinants[k / m_cells], t));
        return weights;
    }

    void apply(const Values& weights, const Values& f, Values& next) const {
        std::ranges::fill(next, 0.0);
        for (std::size_t k = 0; k < m_images.size();)
            for (std::size_t j = 0; j < m_cells; ++j, ++k)
                next[j] += weights[k] * valueAt(f, m_images[k].position);
    }

    std::span<const AffineMap<2>> m_maps;
    std::size_t m_cells;
    std::vector<double> m_determinants;
    std::vector<Image> m_images; // images by map and cell
};

// The zero of a decreasing function on [0, 2], looked for first within `reach` of where it may be.
template <class Function> double zeroNear(Function function, double guess, double reach) {
    constexpr double accuracy = 1e-9;
    for (;; reach *= 32) {
        double low = std::max(guess - reach, 0.0), high = std::min(guess + reach, 2.0);
        if ((low > 0 && function(low) <= 0) || (high < 2 && function(high) > 0)) continue;
        while (high - low > accuracy) {
            const double middle = (low + high) / 2;
            (function(middle) > 0 ? low : high) = middle;
        }
        return (low + high) / 2;
    }
}

} // namespace

std::optional<double> transferDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop) {
    constexpr std::size_t minCells = 64, maxCells = 8192, maxImages = 800'000;
    constexpr double accuracy = 1e-6, step = 1e-3;
    double found = 1, before = -1;
    TransferOperator::Misfit misfitBefore;
    for (std::size_t cells = minCells; cells <= maxCells && cells * maps.size() <= maxImages; cells *= 2) {
        const TransferOperator transfer(maps, cells);
        const auto pressure = [&](double t) {
            return stop.stop_requested() ? 0 : transfer.growth(t, stop).logarithm;
        };
        found = zeroNear(pressure, found, cells == minCells ? 1 : 1e-4);
        if (stop.stop_requested()) return std::nullopt;
        const double low = std::max(found - step, 0.0), high = std::min(found + step, 2.0);
        const double steepness = (pressure(low) - pressure(high)) / (high - low);
        const auto misfit = transfer.misfit(found, transfer.growth(found, stop).f);
        if (stop.stop_requested()) return std::nullopt;
        if (misfit.largest <= accuracy * steepness) return found;
        // True at an edge of the function, which narrows with the cells and hardly counts in the mean.
        const bool isEdge =
            misfit.largest <= 0.8 * misfitBefore.largest && misfit.mean <= accuracy * steepness;
        if (isEdge && std::abs(found - before) <= accuracy / 4) return found;
        // Gives up if a finer grid does not reduce the error: another eigenfunction decays too slowly.
        if (cells > 256 && misfit.mean > 0.9 * misfitBefore.mean) return std::nullopt;
        before = found;
        misfitBefore = misfit;
    }
    return std::nullopt;
}

} // namespace ifs
