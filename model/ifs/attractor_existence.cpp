// SPDX-License-Identifier: MIT
#include "ifs/attractor_existence.h"

#include "ifs/eigenvalues.h"
#include "ifs/invariant_form.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ifs {

namespace {

constexpr double RoundingUnit = 0x1p-53;
constexpr double ContractionLimit = 1 - 0x1p-50; // a rotation whose coefficients were rounded is one still
constexpr double SmallestContractivity = 1e-3;   // keeps γ^(−k) finite where products vanish

template <int Dim> using Matrices = std::vector<Matrix<Dim>, Eigen::aligned_allocator<Matrix<Dim>>>;

// The products A_σ of all words of one length; the digits of an index, base N, spell its word.
template <int Dim> struct WordLevel {
    Matrices<Dim> products;
    std::vector<double> errors = std::vector<double>(products.size()); // of rounding, in the Frobenius norm
    int length = 1;
};

struct Largest {
    double value = -1;
    std::size_t index = 0;
};

template <int Dim> Largest largestNorm(const Matrices<Dim>& products) {
    Largest largest;
    for (std::size_t i = 0; i < products.size(); ++i) {
        if (products[i].norm() <= largest.value) // the Frobenius norm bounds the spectral norm
            continue;
        const double norm = spectralNorm<Dim>(products[i]);
        if (norm > largest.value) largest = {norm, i};
    }
    return largest;
}

// No matrix within `error` of this one has a smaller spectral radius. From trace and determinant, whose
// errors are known: ρ is |t| + √δ when δ = t² − det ≥ 0, t half the trace, and √det when not; never less than
// |t| and √|det|.
double leastSpectralRadius(const Matrix<2>& linear, double error) {
    const double size = linear.cwiseAbs().maxCoeff();
    const Matrix<2> m = linear / size;
    const double e = error / size, all = m.cwiseAbs().sum();
    const double a = m(0, 0), d = m(1, 1), bc = m(0, 1) * m(1, 0), difference = (a - d) / 2;
    const double discriminant = difference * difference + bc;
    const double unsure = 4 * RoundingUnit * (difference * difference + std::abs(bc)) + e * (all + e);
    const double byTrace = std::abs(a + d) / 2 - e + std::sqrt(std::max(discriminant - unsure, 0.0));
    const double determinant = std::abs(a * d - bc);
    const double lost = 4 * RoundingUnit * (std::abs(a * d) + std::abs(bc)) + e * (all + e);
    return size * std::max(byTrace, std::sqrt(std::max(determinant - lost, 0.0)));
}

// In space by the condition of the eigenvalue.
double leastSpectralRadius(const Matrix<3>& linear, double error) {
    const double size = linear.cwiseAbs().maxCoeff();
    const auto [modulus, condition] = largestEigenvalue(linear / size);
    constexpr double Solver = 16 * RoundingUnit; // loses so much, but hardly anything of normal matrices
    return size * (modulus - Solver * (condition - 1)) - condition * error;
}

// The first word that is proved not to shrink everything in the long run, if any.
template <int Dim> Largest firstExpanding(const WordLevel<Dim>& level) {
    for (std::size_t i = 0; i < level.products.size(); ++i) {
        const Matrix<Dim>& product = level.products[i];
        if (product.norm() >= ContractionLimit && spectralRadius<Dim>(product) >= ContractionLimit &&
            leastSpectralRadius(product, level.errors[i]) >= ContractionLimit)
            return {std::max(spectralRadius<Dim>(product), 1.0), i};
    }
    return {};
}

template <int Dim> bool allFinite(const Matrices<Dim>& products) {
    return std::ranges::all_of(products, [](const Matrix<Dim>& m) { return m.allFinite(); });
}

std::vector<int> spell(std::size_t index, int length, std::size_t alphabet) {
    std::vector<int> word(static_cast<std::size_t>(length));
    for (auto symbol = word.rbegin(); symbol != word.rend(); ++symbol, index /= alphabet)
        *symbol = int(index % alphabet);
    return word;
}

template <int Dim> void extend(WordLevel<Dim>& level, const Matrices<Dim>& generators) {
    WordLevel<Dim> longer{{}, {}, level.length + 1};
    longer.products.reserve(level.products.size() * generators.size());
    longer.errors.reserve(level.products.size() * generators.size());
    std::vector<double> norms;
    for (const auto& generator : generators)
        norms.push_back(spectralNorm<Dim>(generator));
    for (std::size_t i = 0; i < level.products.size(); ++i)
        for (std::size_t k = 0; k < generators.size(); ++k) {
            const Matrix<Dim> terms = level.products[i].cwiseAbs() * generators[k].cwiseAbs();
            longer.products.push_back(level.products[i] * generators[k]);
            longer.errors.push_back(level.errors[i] * norms[k] + Dim * Dim * RoundingUnit * terms.maxCoeff());
        }
    level = std::move(longer);
}

// C = max over k < n of γ^(−k)·g_k, with g_0 = 1 and `norms` = g_1 … g_{n−1}.
double normEquivalence(const std::vector<double>& norms, double contractivity) {
    double constant = 1, power = 1;
    for (const double norm : norms) {
        power *= std::max(contractivity, SmallestContractivity);
        constant = std::max(constant, norm / power);
    }
    return constant;
}

constexpr double Emphases[] = {0, 8, 64};

template <int Dim> struct Ellipsoidal {
    ContractingNorm<Dim> norm;
    int slowest = 0; // the map that contracts least
};

// The norm √(xᵀPx) of the invariant form P, when every map contracts in it.
template <int Dim>
std::optional<Ellipsoidal<Dim>> ellipsoidalNorm(std::span<const AffineMap<Dim>> maps, double emphasis) {
    const auto invariant = invariantForm<Dim>(maps, emphasis);
    if (!invariant) return std::nullopt;
    const Matrix<Dim>& form = *invariant;
    const Vector<Dim> eigenvalues =
        Eigen::SelfAdjointEigenSolver<Matrix<Dim>>(form, Eigen::EigenvaluesOnly).eigenvalues();
    const Eigen::LLT<Matrix<Dim>> cholesky(form);
    if (!(eigenvalues[0] > 1e-12 * eigenvalues[Dim - 1]) || cholesky.info() != Eigen::Success)
        return std::nullopt;
    const Matrix<Dim> root = cholesky.matrixU();
    Matrices<Dim> conjugated;
    for (const auto& map : maps)
        conjugated.push_back(root * map.linear * root.inverse());
    const Largest norm = largestNorm<Dim>(conjugated);
    // κ times the rounding unit is what the change of coordinates may have cost.
    const double condition = std::sqrt(eigenvalues[Dim - 1] / eigenvalues[0]);
    if (!(norm.value < 1 - 1e-12 * condition)) return std::nullopt;
    return Ellipsoidal<Dim>{{root, std::max(norm.value, SmallestContractivity), condition * (1 + 1e-12)},
                            int(norm.index)};
}

} // namespace

template <int Dim> Existence classify(std::span<const AffineMap<Dim>> maps, int maxProducts) {
    if (maps.empty()) return {.verdict = Verdict::Empty};
    Existence undecided{.contractivity = std::numeric_limits<double>::infinity()};
    if (!std::ranges::all_of(maps, isFinite<Dim>)) return undecided;

    Matrices<Dim> generators;
    for (const auto& map : maps)
        generators.push_back(map.linear);
    WordLevel<Dim> level{generators};
    std::vector<double> norms;
    const std::size_t allowed = std::size_t(std::max(maxProducts, 0));
    std::size_t products = 0;
    for (;;) {
        const Largest norm = largestNorm<Dim>(level.products);
        const double root = std::pow(norm.value, 1.0 / level.length);
        const auto word = [&](std::size_t index) { return spell(index, level.length, maps.size()); };
        if (norm.value + std::ranges::max(level.errors) < ContractionLimit) {
            const bool immediately = level.length == 1;
            return {.verdict = immediately ? Verdict::Hyperbolic : Verdict::EventuallyContractive,
                    .contractivity = root,
                    .wordLength = level.length,
                    .witness = word(norm.index),
                    .normEquivalence = normEquivalence(norms, root)};
        }
        const Largest expanding = firstExpanding<Dim>(level);
        if (expanding.value >= 1)
            return {.verdict = Verdict::None,
                    .contractivity = std::pow(expanding.value, 1.0 / level.length),
                    .wordLength = level.length,
                    .witness = word(expanding.index)};
        if (root < undecided.contractivity) {
            undecided.contractivity = root;
            undecided.wordLength = level.length;
        }
        norms.push_back(norm.value);
        products += level.products.size() * maps.size();
        if (products > std::size_t(std::max(maxProducts, 0))) break;
        extend(level, generators);
        if (!allFinite<Dim>(level.products)) return undecided;
    }
    if (generators.size() > allowed) return undecided;
    for (const double emphasis : Emphases)
        if (const auto ellipsoidal = ellipsoidalNorm<Dim>(maps, emphasis))
            return {.verdict = Verdict::EventuallyContractive,
                    .contractivity = ellipsoidal->norm.contractivity,
                    .wordLength = 1,
                    .witness = {ellipsoidal->slowest},
                    .normEquivalence = ellipsoidal->norm.equivalence};
    return undecided;
}

template <int Dim>
ContractingNorm<Dim> contractingNorm(std::span<const AffineMap<Dim>> maps, const Existence& existence) {
    constexpr double Tight = 20; // not worth the search for a better one
    const double least = existence.wordLength == 1 ? 0 : SmallestContractivity;
    ContractingNorm<Dim> best{.contractivity = std::max(existence.contractivity, least),
                              .equivalence = existence.normEquivalence};
    const auto cost = [](const auto& norm) { return norm.equivalence / (1 - norm.contractivity); };
    const auto offer = [&](const ContractingNorm<Dim>& norm) {
        if (norm.contractivity < ContractionLimit && cost(norm) < cost(best)) best = norm;
    };
    if (cost(best) <= Tight) return best;
    for (const double emphasis : Emphases)
        if (const auto ellipsoidal = ellipsoidalNorm<Dim>(maps, emphasis)) offer(ellipsoidal->norm);
    if (cost(best) <= Tight) return best;

    constexpr std::size_t MostProducts = 20'000;
    Matrices<Dim> generators;
    for (const auto& map : maps)
        generators.push_back(map.linear);
    WordLevel<Dim> level{generators};
    std::vector<double> norms;
    while (level.products.size() * maps.size() <= MostProducts && maps.size() > 1) {
        norms.push_back(largestNorm<Dim>(level.products).value);
        extend(level, generators);
        const double root = std::max(std::pow(largestNorm<Dim>(level.products).value, 1.0 / level.length),
                                     SmallestContractivity);
        offer({.contractivity = root, .equivalence = normEquivalence(norms, root)});
    }
    return best;
}

template Existence classify<2>(std::span<const AffineMap<2>>, int);
template Existence classify<3>(std::span<const AffineMap<3>>, int);
template ContractingNorm<2> contractingNorm<2>(std::span<const AffineMap<2>>, const Existence&);
template ContractingNorm<3> contractingNorm<3>(std::span<const AffineMap<3>>, const Existence&);

} // namespace ifs
