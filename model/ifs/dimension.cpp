// SPDX-License-Identifier: MIT
#include "ifs/dimension.h"

#include "ifs/attractor_existence.h"
#include "ifs/decomposition.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ifs {

namespace {

constexpr double largestDimension = 64;

// The zero of a decreasing function on [low, high], which has a sign change there.
template <class Function> double zeroOf(Function decreasing, double low, double high) {
    for (int step = 0; step < 80 && high - low > 1e-15 * high; ++step) {
        const double middle = (low + high) / 2;
        (decreasing(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

// The ratio of a map that is a similarity in some coordinates: all eigenvalues of one modulus, and none defective.
template <int Dim> std::optional<double> similarityRatio(const Matrix<Dim>& linear) {
    const double norm = spectralNorm<Dim>(linear);
    const MapKind which = kind<Dim>(linear);
    if (which == MapKind::Similarity || which == MapKind::ReflectedSimilarity) return norm;
    return std::nullopt;
}

// In coordinates in which the first map with complex eigenvalues is a rotation and scaling. If the maps are
// similarities in any common coordinates, they are in these.
std::optional<Matrix<2>> roundingCoordinates(std::span<const AffineMap<2>> maps) {
    for (const AffineMap<2>& map : maps) {
        const double half = map.linear.trace() / 2;
        const double discriminant = half * half - map.linear.determinant();
        if (!(discriminant < -1e-12 * map.linear.squaredNorm())) continue;
        const double beta = std::sqrt(-discriminant);
        // A = half·I + beta·J with J² = −I; J becomes the quarter turn in the basis (v, −Jv).
        const Matrix<2> turn = (map.linear - half * Matrix<2>::Identity()) / beta;
        Matrix<2> basis;
        basis.col(0) = Vector<2>::UnitX();
        basis.col(1) = turn * Vector<2>::UnitX();
        return basis;
    }
    return std::nullopt;
}

template <int Dim> std::optional<std::vector<double>> ratios(std::span<const AffineMap<Dim>> maps) {
    std::vector<double> result;
    for (const AffineMap<Dim>& map : maps) {
        const auto ratio = similarityRatio<Dim>(map.linear);
        if (!ratio) return std::nullopt;
        result.push_back(*ratio);
    }
    return result;
}

// Growth rate e^{P(t)} of Falconer's pressure: the transfer operator on functions of the direction, on `cells` cells
// of the half circle with linear interpolation.
class DirectionOperator {
public:
    explicit DirectionOperator(std::span<const AffineMap<2>> maps) {
        for (const AffineMap<2>& map : maps)
            addMap(map.linear);
    }

    double growth(double t) const {
        std::vector<double> density(cells, 1.0), next(cells);
        double logarithm = 0;
        std::vector<double> weights(m_arms.size());
        std::transform(m_arms.begin(), m_arms.end(), weights.begin(),
                       [t](const Arm& arm) { return arm.weight(t); });
        for (int step = 0; step < steps; ++step) {
            std::fill(next.begin(), next.end(), 0.0);
            for (std::size_t k = 0; k < m_arms.size(); ++k) {
                const Arm& arm = m_arms[k];
                next[arm.from] += weights[k] * ((1 - arm.share) * density[arm.to] +
                                                arm.share * density[(arm.to + 1) % cells]);
            }
            const double largest = *std::max_element(next.begin(), next.end());
            if (!(largest > 0)) return 0;
            for (double& value : next)
                value /= largest;
            if (step >= steps / 2) logarithm += std::log(largest);
            density.swap(next);
        }
        return std::exp(logarithm / (steps - steps / 2));
    }

private:
    static constexpr std::size_t cells = 500;
    static constexpr int steps = 200;

    struct Arm {
        std::size_t from = 0, to = 0;
        double share = 0;  // of cell to + 1
        double length = 0; // |Aᵀx|
        double determinant = 0;
        double weight(double t) const {
            if (t <= 1) return std::pow(length, t);
            if (t <= 2) return std::pow(length, 2 - t) * std::pow(determinant, t - 1);
            return std::pow(determinant, t / 2);
        }
    };

    void addMap(const Matrix<2>& linear) {
        const double spacing = std::numbers::pi / cells;
        for (std::size_t j = 0; j < cells; ++j) {
            const double angle = (static_cast<double>(j) + 0.5) * spacing;
            const Vector<2> image = linear.transpose() * Vector<2>(std::cos(angle), std::sin(angle));
            Arm arm;
            arm.from = j;
            arm.length = image.norm();
            arm.determinant = std::abs(linear.determinant());
            if (!(arm.length > 0)) continue;
            double place = std::atan2(image.y(), image.x()) / spacing - 0.5;
            place -= std::floor(place / cells) * cells;
            const double cell = std::floor(place);
            arm.to = static_cast<std::size_t>(cell) % cells;
            arm.share = place - cell;
            m_arms.push_back(arm);
        }
    }

    std::vector<Arm> m_arms;
};

bool hasAttractor(std::span<const AffineMap<2>> maps) {
    const Verdict verdict = classify<2>(maps).verdict;
    return verdict == Verdict::Hyperbolic || verdict == Verdict::EventuallyContractive;
}

} // namespace

std::optional<double> moranDimension(std::span<const double> ratios) {
    if (ratios.empty()) return std::nullopt;
    for (double ratio : ratios)
        if (!(ratio > 0 && ratio < 1)) return std::nullopt;
    if (ratios.size() == 1) return 0;
    const auto excess = [&](double dimension) {
        double sum = -1;
        for (double ratio : ratios)
            sum += std::pow(ratio, dimension);
        return sum;
    };
    double high = 1;
    while (high < largestDimension && excess(high) > 0)
        high *= 2;
    return zeroOf(excess, 0, high);
}

template <int Dim> std::optional<double> similarityDimension(std::span<const AffineMap<Dim>> maps) {
    if (const auto direct = ratios<Dim>(maps)) return moranDimension(*direct);
    if constexpr (Dim == 2) {
        const auto coordinates = roundingCoordinates(maps);
        if (!coordinates) return std::nullopt;
        std::vector<AffineMap<2>> round;
        for (const AffineMap<2>& map : maps) {
            const auto seen = inverse(AffineMap<2>{*coordinates, Vector<2>::Zero()});
            if (!seen) return std::nullopt;
            round.push_back({seen->linear * map.linear * *coordinates, map.translation});
            // The change of coordinates costs digits: a similarity up to 1e-9 is one.
            const Vector<2> sigma = singularValues<2>(round.back().linear);
            if (sigma[0] - sigma[1] > 1e-9 * sigma[0]) return std::nullopt;
        }
        std::vector<double> result;
        for (const AffineMap<2>& map : maps)
            result.push_back(std::sqrt(std::abs(map.linear.determinant())));
        return moranDimension(result);
    }
    return std::nullopt;
}

template <int Dim> double singularValueFunction(const Matrix<Dim>& linear, double t) {
    if (t <= 0) return 1;
    const Vector<Dim> sigma = singularValues<Dim>(linear);
    if (t >= Dim) return std::pow(std::abs(linear.determinant()), t / Dim);
    const int whole = static_cast<int>(std::ceil(t)) - 1;
    double product = 1;
    for (int k = 0; k < whole; ++k)
        product *= sigma[k];
    return product * std::pow(sigma[whole], t - whole);
}

std::optional<double> affinityDimension(std::span<const AffineMap<2>> maps) {
    if (maps.empty() || !hasAttractor(maps)) return std::nullopt;
    if (maps.size() == 1) return 0;
    const DirectionOperator transfer(maps);
    const auto excess = [&](double t) { return transfer.growth(t) - 1; };
    double high = 2;
    double area = 0;
    for (const AffineMap<2>& map : maps)
        area += std::abs(map.linear.determinant());
    if (area >= 1) { // Σ |det|^{t/2} = 1 lies beyond 2, where the singular value function knows only the determinant
        const auto beyond = [&](double t) {
            double sum = -1;
            for (const AffineMap<2>& map : maps)
                sum += std::pow(std::abs(map.linear.determinant()), t / 2);
            return sum;
        };
        while (high < largestDimension && beyond(high) > 0)
            high *= 2;
        return zeroOf(beyond, 2, high);
    }
    double low = 0, top = high;
    for (int step = 0; step < 30; ++step) {
        const double middle = (low + top) / 2;
        (excess(middle) > 0 ? low : top) = middle;
    }
    return (low + top) / 2;
}

template std::optional<double> similarityDimension<2>(std::span<const AffineMap<2>>);
template std::optional<double> similarityDimension<3>(std::span<const AffineMap<3>>);
template double singularValueFunction<2>(const Matrix<2>&, double);
template double singularValueFunction<3>(const Matrix<3>&, double);

} // namespace ifs
