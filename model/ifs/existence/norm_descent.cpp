// SPDX-License-Identifier: MIT
#include "ifs/existence/norm_descent.h"

#include "ifs/linear/inverse.h"
#include "ifs/linear/symmetric_matrices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ifs {

namespace {

template <int Dim> using LongMatrix = Eigen::Matrix<long double, Dim, Dim>;

// Half the derivative of log ‖B‖ when the form I becomes I + S: ⟨uuᵀ − vvᵀ, S⟩ for B v = ‖B‖u.
template <int Dim> struct Slope {
    Matrix<Dim> direction;
    double length; // length of the map
};

template <int Dim> class Descent {
public:
    explicit Descent(std::span<const AffineMap<Dim>> maps) : m_maps(maps) {}

    std::vector<Matrix<Dim>> seen(const Matrix<Dim>& root) const {
        const LongMatrix<Dim> there = root.template cast<long double>(), back = inverseOf(there);
        std::vector<Matrix<Dim>> result;
        for (const auto& map : m_maps)
            result.push_back(
                (there * map.linear.template cast<long double>() * back).template cast<double>());
        return result;
    }

    // Infinite unless all lengths are below `limit`.
    double longest(const Matrix<Dim>& root, double limit) const {
        const LongMatrix<Dim> there = root.template cast<long double>(), back = inverseOf(there);
        double result = 0;
        for (const auto& map : m_maps) {
            const LongMatrix<Dim> linear = map.linear.template cast<long double>();
            result = std::max(result, spectralNorm<Dim>((there * linear * back).template cast<double>()));
            if (!(result < limit)) return std::numeric_limits<double>::infinity();
        }
        return result;
    }

    // Slopes of the singular values within a factor of the largest.
    std::vector<Slope<Dim>> slopes(const Matrix<Dim>& root, double factor) const {
        constexpr std::size_t maxSlopes = 16;
        std::vector<Slope<Dim>> result;
        double longest = 0;
        for (const Matrix<Dim>& linear : seen(root)) {
            const auto axes = symmetricEigenvalues<Dim>(linear.transpose() * linear);
            for (int k = Dim; k-- > 0;) {
                const double length = std::sqrt(std::max(axes.values[k], 0.0));
                longest = std::max(longest, length);
                if (!(length > 0 && length >= factor * longest)) break;
                const Vector<Dim> from = axes.vectors.col(k), to = linear * from / length;
                result.push_back({to * to.transpose() - from * from.transpose(), length});
            }
        }
        std::erase_if(result, [&](const auto& slope) { return slope.length < factor * longest; });
        std::ranges::stable_sort(result, std::ranges::greater{}, &Slope<Dim>::length);
        if (result.size() > maxSlopes) result.resize(maxSlopes);
        return result;
    }

private:
    std::span<const AffineMap<Dim>> m_maps;
};

// The shortest of the convex combinations of the slopes, against which all of them fall.
template <int Dim> Matrix<Dim> steepest(const std::vector<Slope<Dim>>& slopes) {
    constexpr int rounds = 200;
    Matrix<Dim> result = slopes.front().direction;
    for (int n = 0; n < rounds; ++n) {
        const auto height = [&](const Slope<Dim>& slope) {
            return slope.direction.cwiseProduct(result).sum();
        };
        const auto& least = *std::ranges::min_element(slopes, {}, height);
        const Matrix<Dim> step = least.direction - result;
        const double gain = -step.cwiseProduct(result).sum(), length = step.squaredNorm();
        if (!(gain > 1e-9 * result.squaredNorm()) || length == 0) break;
        result += std::min(1.0, gain / length) * step;
    }
    return result;
}

// The root of the form a step along −direction leads to, seen from where the form is I.
template <int Dim> Matrix<Dim> stepped(const SymmetricEigenvalues<Dim>& direction, double step) {
    Vector<Dim> stretch;
    for (int k = 0; k < Dim; ++k) {
        const double way = -step * direction.values[k]; // factor close to eʷᵃʸ, without exp()
        stretch[k] = way >= 0 ? 1 + way : 1 / (1 - way);
    }
    return stretch.asDiagonal() * direction.vectors.transpose();
}

} // namespace

template <int Dim> void descend(NormCoordinates<Dim>& best, std::span<const AffineMap<Dim>> maps) {
    constexpr double shortEnough = 0.98, minGain = 1e-7;
    constexpr std::size_t maxNorms = 100'000;
    const std::size_t rounds = std::min<std::size_t>(200, maxNorms / maps.size() / 8);
    const Descent<Dim> descent(maps);
    double width = 0.1, reach = 4;
    for (std::size_t round = 0; round < rounds && best.longest > shortEnough && width > 1e-6; ++round) {
        const auto slopes = descent.slopes(best.root, 1 - width);
        if (slopes.empty()) return;
        Matrix<Dim> direction = steepest<Dim>(slopes);
        if (!(direction.norm() > 1e-3 * width)) {
            width /= 4;
            continue;
        }
        direction /= direction.norm();
        const auto axes = symmetricEigenvalues<Dim>(direction);
        const double before = best.longest;
        for (double step = reach; step > 1e-4 * width; step /= 2) {
            Matrix<Dim> root = stepped<Dim>(axes, step) * best.root;
            root /= spectralNorm<Dim>(root);
            const double longest = descent.longest(root, best.longest);
            if (!(longest < best.longest)) continue;
            best = {root, longest};
            reach = std::min(4 * step, 64.0);
            break;
        }
        if (!(best.longest < before * (1 - minGain))) width /= 4;
    }
}

template void descend(NormCoordinates<2>&, std::span<const AffineMap<2>>);
template void descend(NormCoordinates<3>&, std::span<const AffineMap<3>>);

} // namespace ifs
