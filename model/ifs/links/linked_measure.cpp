// SPDX-License-Identifier: MIT
#include "ifs/links/linked_measure.h"

#include "ifs/dimension/dimension.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/inverse.h"
#include "ifs/separation/contact_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

using DynamicMatrix = Eigen::MatrixXd;
using DynamicVector = Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Solved {
    DynamicVector value;
    double error = 0; // error of each component
};

// x = operator·x + constant, with |x − x̃| ≤ ‖R‖·‖residual‖/(1 − ‖I − R(I − operator)‖) for R near the
// inverse.
std::optional<Solved> fixedVector(const DynamicMatrix& map, const DynamicVector& constant) {
    const auto n = double(map.rows());
    const DynamicMatrix complement = DynamicMatrix::Identity(map.rows(), map.cols()) - map;
    const DynamicMatrix inverse = inverseOf(complement);
    if (!inverse.allFinite()) return std::nullopt;
    const auto norm = [](const DynamicMatrix& m) { return m.cwiseAbs().rowwise().sum().maxCoeff(); };
    const double rest = norm(inverse * complement - DynamicMatrix::Identity(map.rows(), map.cols())) +
                        2 * n * epsilon * norm(inverse) * norm(complement);
    if (!(rest < 0.5)) return std::nullopt;
    DynamicVector x = inverse * constant;
    for (int n2 = 0; n2 < 3; ++n2)
        x += inverse * (constant - complement * x);
    const double size = x.cwiseAbs().maxCoeff();
    // The operator and the constant have entries that are sums of products of a few numbers each.
    const double entries = 32 * epsilon * (norm(map) * size + constant.cwiseAbs().maxCoeff());
    const double residual = (constant - complement * x).cwiseAbs().maxCoeff() +
                            2 * n * epsilon * (norm(complement) * size + constant.cwiseAbs().maxCoeff());
    return Solved{x, norm(inverse) * (residual + entries) / (1 - rest)};
}

template <int Dim> class MomentsOf {
public:
    MomentsOf(const ActiveMaps<Dim>& active, const Transitions& chain) : m_active(active), m_chain(chain) {}

    std::optional<Moments<Dim>> found() const {
        const auto first = firstMoments();
        if (!first) return std::nullopt;
        const auto second = secondMoments(*first);
        if (!second) return std::nullopt;
        const std::size_t n = m_chain.size;
        Moments<Dim> result;
        result.mean.setZero();
        Matrix<Dim> square = Matrix<Dim>::Zero();
        for (std::size_t j = 0; j < n; ++j) {
            result.mean += m_chain.stationary[j] * part<Dim>(first->value, j);
            for (int c = 0; c < Dim; ++c)
                square.col(c) +=
                    m_chain.stationary[j] * part<Dim * Dim>(second->value, j).template segment<Dim>(Dim * c);
        }
        result.covariance = square - result.mean * result.mean.transpose();
        result.covariance = (result.covariance + result.covariance.transpose()).eval() / 2;
        result.longRunCovariance.setConstant(std::numeric_limits<double>::quiet_NaN());
        const double size = result.mean.norm(), rounding = 16 * double(n) * epsilon;
        result.meanError = std::sqrt(double(Dim)) * first->error + rounding * size;
        result.covarianceError = second->error + (2 * size + result.meanError) * result.meanError +
                                 rounding * (square.norm() + size * size);
        return result;
    }

private:
    template <int Size> static Eigen::Matrix<double, Size, 1> part(const DynamicVector& all, std::size_t j) {
        return all.template segment<Size>(Eigen::Index(j) * Size);
    }

    double before(std::size_t j, std::size_t i) const { return m_chain.backward[j * m_chain.size + i]; }

    // m_j = Σ_i Q_ji (A_j m_i + t_j)
    std::optional<Solved> firstMoments() const {
        const std::size_t n = m_chain.size;
        DynamicMatrix map = DynamicMatrix::Zero(Eigen::Index(n) * Dim, Eigen::Index(n) * Dim);
        DynamicVector constant(Eigen::Index(n) * Dim);
        for (std::size_t j = 0; j < n; ++j) {
            constant.template segment<Dim>(Eigen::Index(j) * Dim) = m_active.maps[j].translation;
            for (std::size_t i = 0; i < n; ++i)
                map.template block<Dim, Dim>(Eigen::Index(j) * Dim, Eigen::Index(i) * Dim) =
                    before(j, i) * m_active.maps[j].linear;
        }
        return fixedVector(map, constant);
    }

    // S_j = Σ_i Q_ji (A_j S_i A_jᵀ + A_j m_i t_jᵀ + t_j m_iᵀ A_jᵀ + t_j t_jᵀ), column by column
    std::optional<Solved> secondMoments(const Solved& first) const {
        constexpr int size = Dim * Dim;
        const std::size_t n = m_chain.size;
        DynamicMatrix map = DynamicMatrix::Zero(Eigen::Index(n) * size, Eigen::Index(n) * size);
        DynamicVector constant(Eigen::Index(n) * size);
        double spread = 0; // factor from errors of the m_i to the error of the constant
        for (std::size_t j = 0; j < n; ++j) {
            const AffineMap<Dim>& w = m_active.maps[j];
            Vector<Dim> mean = Vector<Dim>::Zero();
            for (std::size_t i = 0; i < n; ++i)
                mean += before(j, i) * part<Dim>(first.value, i);
            const Matrix<Dim> mixed = w.linear * mean * w.translation.transpose();
            const Matrix<Dim> sum = mixed + mixed.transpose() + w.translation * w.translation.transpose();
            constant.template segment<size>(Eigen::Index(j) * size) = sum.reshaped();
            spread = std::max(spread, 2 * Dim * w.linear.norm() * w.translation.norm());
            Eigen::Matrix<double, size, size> kronecker;
            for (int a = 0; a < Dim; ++a)
                for (int b = 0; b < Dim; ++b)
                    kronecker.template block<Dim, Dim>(Dim * a, Dim * b) = w.linear(a, b) * w.linear;
            for (std::size_t i = 0; i < n; ++i)
                map.template block<size, size>(Eigen::Index(j) * size, Eigen::Index(i) * size) =
                    before(j, i) * kronecker;
        }
        auto solved = fixedVector(map, constant);
        if (!solved) return std::nullopt;
        const DynamicMatrix inverse = inverseOf(DynamicMatrix::Identity(map.rows(), map.cols()) - map);
        solved->error += 2 * inverse.cwiseAbs().rowwise().sum().maxCoeff() * spread * first.error;
        return solved;
    }

    const ActiveMaps<Dim>& m_active;
    const Transitions& m_chain;
};

double spectralRadiusAt(double s, const std::vector<double>& ratios, std::span<const double> forward,
                        const std::vector<std::size_t>& part) {
    const auto n = Eigen::Index(part.size());
    DynamicMatrix matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const std::size_t from = part[std::size_t(i)], to = part[std::size_t(j)];
            matrix(i, j) = forward[from * ratios.size() + to] > 0 ? std::pow(ratios[to], s) : 0;
        }
    return largestEigenvalueModulus(matrix);
}

// ln ρ falls with s, and is convex: the secant of a bracket comes close in a few steps.
double rootOf(const std::vector<double>& ratios, std::span<const double> forward,
              const std::vector<std::size_t>& part) {
    const auto height = [&](double s) { return std::log(spectralRadiusAt(s, ratios, forward, part)); };
    double low = 0, atLow = height(0);
    if (!(atLow > 1e-13)) return 0; // cycle: finitely many points
    double high = 1, atHigh = height(1);
    while (atHigh > 0) {
        low = high;
        atLow = atHigh;
        high *= 2;
        atHigh = height(high);
    }
    for (int step = 0; step < 200 && high - low > 4 * epsilon * high; ++step) {
        double s = step % 3 == 2 ? (low + high) / 2 : low + (high - low) * atLow / (atLow - atHigh);
        s = std::clamp(s, low, high);
        const double value = height(s);
        if (value == 0 || s == low || s == high) return s;
        (value > 0 ? low : high) = s;
        (value > 0 ? atLow : atHigh) = value;
    }
    return (low + high) / 2;
}

// The share of a closed part in the entropy of the chain.
double entropyOf(const Transitions& chain, const std::vector<std::size_t>& part) {
    double result = 0;
    for (const std::size_t i : part)
        for (const std::size_t j : part)
            if (const double t = chain.forward[i * chain.size + j]; t > 0)
                result -= chain.stationary[i] * t * std::log(t);
    return result;
}

} // namespace

template <int Dim> std::optional<Moments<Dim>> linkedMoments(const ActiveMaps<Dim>& active) {
    if (active.maps.empty() || active.maps.size() > maxLinkedStates) return std::nullopt;
    return MomentsOf<Dim>(active, transitions(active)).found();
}

double entropyRate(const Transitions& chain) {
    double result = 0;
    for (const auto& part : chain.closed)
        result += entropyOf(chain, part);
    return result;
}

template <int Dim> std::optional<double> linkedLyapunovExponent(const ActiveMaps<Dim>& active) {
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios || active.maps.empty()) return std::nullopt;
    const Transitions chain = transitions(active);
    double result = 0;
    for (std::size_t i = 0; i < chain.size; ++i)
        result += chain.stationary[i] * std::log((*ratios)[i]);
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

template <int Dim> std::optional<double> linkedDimension(const ActiveMaps<Dim>& active) {
    if (active.maps.empty() || active.maps.size() > maxLinkedStates) return std::nullopt;
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios || !std::ranges::all_of(*ratios, [](double r) { return r > 0 && r < 1; }))
        return std::nullopt;
    const Transitions chain = transitions(active);
    double largest = 0;
    for (const auto& part : chain.closed)
        largest = std::max(largest, rootOf(*ratios, chain.forward, part));
    return largest;
}

// The spectral radius at the dimension, enclosed, falls with the exponent by the least −ln s at least.
template <int Dim>
std::optional<double> linkedDimensionError(const ActiveMaps<Dim>& active, double dimension) {
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios || dimension == 0) return ratios ? std::optional(0.0) : std::nullopt;
    const Transitions chain = transitions(active);
    ContactGraph graph(chain.size);
    for (const auto& part : chain.closed)
        for (const std::size_t from : part)
            for (const std::size_t to : part)
                if (chain.forward[from * chain.size + to] > 0)
                    graph.join(from, to, std::pow((*ratios)[to], dimension));
    const auto radius = graph.spectralRadius();
    if (!radius || !(radius->least > 0)) return std::nullopt;
    const double off = std::max(std::abs(std::log(radius->least)), std::abs(std::log(radius->most)));
    const double slope = -std::log(std::ranges::max(*ratios));
    return similarityDimensionError<Dim>(active.maps, dimension) + (off + 8 * epsilon) / slope;
}

template <int Dim> std::optional<double> linkedMeasureDimension(const ActiveMaps<Dim>& active) {
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios || !std::ranges::all_of(*ratios, [](double r) { return r > 0 && r < 1; }))
        return std::nullopt;
    const Transitions chain = transitions(active);
    double largest = 0;
    for (const auto& part : chain.closed) {
        double exponent = 0;
        for (const std::size_t i : part)
            exponent -= chain.stationary[i] * std::log((*ratios)[i]);
        if (exponent > 0) largest = std::max(largest, entropyOf(chain, part) / exponent);
    }
    return largest;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template std::optional<Moments<Dim>> linkedMoments(const ActiveMaps<Dim>&);                              \
    template std::optional<double> linkedLyapunovExponent(const ActiveMaps<Dim>&);                           \
    template std::optional<double> linkedDimension(const ActiveMaps<Dim>&);                                  \
    template std::optional<double> linkedDimensionError(const ActiveMaps<Dim>&, double);                     \
    template std::optional<double> linkedMeasureDimension(const ActiveMaps<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
