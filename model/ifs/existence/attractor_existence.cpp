// SPDX-License-Identifier: MIT
#include "ifs/existence/attractor_existence.h"

#include "ifs/existence/common_matrix.h"
#include "ifs/existence/conditioning.h"
#include "ifs/existence/exact_contraction.h"
#include "ifs/existence/exact_similarity.h"
#include "ifs/existence/expansion.h"
#include "ifs/existence/invariant_form.h"
#include "ifs/existence/lyapunov_norm.h"
#include "ifs/existence/polytope_norm.h"
#include "ifs/existence/support_norm.h"
#include "ifs/linear/rounding.h"
#include "ifs/linear/symmetric_matrices.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ifs {

namespace {

constexpr double minContractivity = 1e-3; // keeps γ^(−k) finite when products vanish

// A norm below this is below 1 in spite of its rounding. Jacobi's rotations round more often.
template <int Dim> constexpr double contractionLimit = Dim == 2 ? 1 - 0x1p-50 : 1 - 0x1p-46;

template <int Dim> using Matrices = std::vector<Matrix<Dim>, Eigen::aligned_allocator<Matrix<Dim>>>;

// The products A_σ of all words of one length; the digits of an index, base N, spell its word.
template <int Dim> struct WordLevel {
    Matrices<Dim> products;
    // Rounding errors in the Frobenius norm.
    std::vector<double> errors = std::vector<double>(products.size());
    int length = 1;
};

struct Largest {
    double value = -1;
    std::size_t index = 0;
};

template <int Dim> Matrices<Dim> linearParts(std::span<const AffineMap<Dim>> maps) {
    Matrices<Dim> result;
    for (const auto& map : maps)
        result.push_back(map.linear);
    return result;
}

// Infinite where a product is no finite matrix.
template <int Dim> Largest maxNorm(const Matrices<Dim>& products) {
    constexpr double tiny = 0x1p-400; // limit below which the Frobenius norm may underflow
    Largest largest;
    for (std::size_t i = 0; i < products.size(); ++i) {
        const double frobenius = products[i].norm(); // upper bound of the spectral norm
        if (frobenius > tiny && frobenius <= largest.value) continue;
        if (!products[i].allFinite()) return {std::numeric_limits<double>::infinity(), i};
        const double norm = spectralNorm<Dim>(products[i]);
        if (norm > largest.value) largest = {norm, i};
    }
    return largest;
}

// Infinite where nothing is known.
template <int Dim> double maxError(const WordLevel<Dim>& level) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double result = 0;
    for (const double error : level.errors)
        if (!(error <= result)) result = error < infinity ? error : infinity;
    return result;
}

// A norm with what rounding may have cost the product. Where that is next to nothing, also beside the
// distance from 1, the number is as it was found.
double withError(double norm, double error) {
    constexpr double negligible = 0x1p-40;
    return error <= negligible * std::min(norm, std::abs(1 - norm)) ? norm : norm + error;
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

// Looks for words that are proved not to shrink everything in the long run.
template <int Dim> class ExpansionSearch {
public:
    explicit ExpansionSearch(std::span<const AffineMap<Dim>> maps) : m_maps(maps) {}

    // First of the products with the largest spectral radius.
    Largest first(const WordLevel<Dim>& level) {
        for (std::size_t i = 0; i < level.products.size(); ++i) {
            const Matrix<Dim>& product = level.products[i];
            if (product.norm() + level.errors[i] < 1) continue;
            const Expansion found = expansion<Dim>(product, level.errors[i]);
            if (found == Expansion::No || (found == Expansion::Unknown && !mayAsk(level.length))) continue;
            const double radius = spectralRadius<Dim>(product);
            if (found == Expansion::Yes || expandsExactly(level, i, radius))
                return {std::max(wellRounded(level, i, radius), 1.0), i};
        }
        return {};
    }

private:
    bool expandsExactly(const WordLevel<Dim>& level, std::size_t index, double radius) {
        constexpr double nearOne = 0.999; // lower values are rarely 1 up to rounding
        const std::vector<int> word = spell(index, level.length, m_maps.size());
        if (isPower(word)) return false;
        if (!(radius > nearOne)) {
            // Gives up for a single map, whose large coefficients cancel: ρ is unknown.
            if (level.length > 1 || m_letters == maxLetters) return false;
            ++m_letters;
        } else
            m_symbols += level.length;
        return exactExpansion<Dim>(m_maps, word) == Expansion::Yes;
    }

    // Spectral radius, recomputed if rounding may have spoilt it.
    double wellRounded(const WordLevel<Dim>& level, std::size_t index, double radius) const {
        constexpr double little = 1e-9;
        const double size = level.products[index].norm();
        if (level.errors[index] <= little && roundingUnit * size * size <= little) return radius;
        auto product = exactMatrix<Dim>(Matrix<Dim>::Identity());
        for (const int symbol : spell(index, level.length, m_maps.size()))
            product = product * exactMatrix<Dim>(m_maps[std::size_t(symbol)].linear);
        return radiusOf<Dim>(product);
    }

    bool mayAsk(int length) const {
        constexpr int maxSymbols = 200;
        return m_symbols + length <= maxSymbols;
    }

    // Returns true if the word is a power of a shorter one, which was examined before.
    static bool isPower(const std::vector<int>& word) {
        for (std::size_t period = 1; 2 * period <= word.size(); ++period)
            if (word.size() % period == 0 &&
                std::equal(word.begin() + std::ptrdiff_t(period), word.end(), word.begin()))
                return true;
        return false;
    }

    std::span<const AffineMap<Dim>> m_maps;
    static constexpr int maxLetters = 200;
    int m_symbols = 0; // length of the words examined
    int m_letters = 0; // maps whose ρ seems to be smaller
};

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
            const double before = norms[k] > 0 ? level.errors[i] * norms[k] : 0;
            longer.errors.push_back(before * (1 + 0x1p-48) +
                                    Dim * Dim * roundingUnit * (1 + 0x1p-48) * terms.maxCoeff() + underflow);
        }
    level = std::move(longer);
}

// C = max over k < n of γ^(−k)·g_k, with g_0 = 1 and `norms` = g_1 … g_{n−1}.
double normEquivalence(const std::vector<double>& norms, double contractivity) {
    double constant = 1, power = 1;
    for (const double norm : norms) {
        power *= std::max(contractivity, minContractivity);
        constant = std::max(constant, norm / power);
    }
    return constant;
}

constexpr double emphases[] = {0, 8, 64};

template <int Dim> struct Ellipsoidal {
    ContractingNorm<Dim> norm;
    int slowest = 0; // index of the map that contracts least
};

// The norm √(xᵀPx) of the invariant form P, when every map contracts in it.
template <int Dim>
std::optional<Ellipsoidal<Dim>> ellipsoidalNorm(std::span<const AffineMap<Dim>> maps, double emphasis) {
    const auto invariant = invariantForm<Dim>(maps, emphasis);
    if (!invariant) return std::nullopt;
    const Matrix<Dim>& form = *invariant;
    const Vector<Dim> eigenvalues = symmetricEigenvalues<Dim>(form).values;
    const auto factor = choleskyFactor<Dim>(form);
    if (!(eigenvalues[0] > 1e-12 * eigenvalues[Dim - 1]) || !factor) return std::nullopt;
    const Matrix<Dim>& root = *factor;
    Matrices<Dim> conjugated;
    for (const auto& map : maps)
        conjugated.push_back(root * map.linear * root.inverse());
    const Largest norm = maxNorm<Dim>(conjugated);
    const double condition = std::sqrt(eigenvalues[Dim - 1] / eigenvalues[0]);
    if (!(norm.value < 1 - 1e-12 * condition)) return std::nullopt;
    // Error bound from the change of coordinates; if it is too large, longer numbers decide.
    const double cost =
        64 * roundingUnit * std::pow(condition, 3) * maxNorm<Dim>(linearParts<Dim>(maps)).value;
    if (!(norm.value + cost < contractionLimit<Dim>)) {
        const auto seen = seenFrom<Dim>({root.inverse(), Vector<Dim>::Zero()}, maps);
        if (!seen || !(seen->longest < contractionLimit<Dim>)) return std::nullopt;
    }
    return Ellipsoidal<Dim>{{.root = root,
                             .contractivity = std::max(norm.value, minContractivity),
                             .equivalence = condition * (1 + 1e-12),
                             .norm = NormKind::Ellipsoidal},
                            int(norm.index)};
}

// Lower bound of the contractivity in any norm: the largest ρ(A_σ)^(1/|σ|) among some words, but for
// rounding.
template <int Dim> double leastContractivity(std::span<const AffineMap<Dim>> maps) {
    constexpr std::size_t maxProducts = 1'000;
    const Matrices<Dim> generators = linearParts<Dim>(maps);
    double result = 0;
    for (WordLevel<Dim> level{generators};; extend(level, generators)) {
        for (const auto& product : level.products)
            result = std::max(result, std::pow(spectralRadius<Dim>(product), 1.0 / level.length));
        if (level.products.size() * maps.size() > maxProducts || level.length == 12) return result;
    }
}

// Decisions of exact rules, however slowly the maps contract. `better` are coordinates whose norm may show
// it.
template <int Dim>
std::optional<Existence> contractionWithoutRounding(std::span<const AffineMap<Dim>> maps,
                                                    const std::optional<Conditioned<Dim>>& better,
                                                    int maxProducts) {
    const std::vector<int> longest{int(maxNorm<Dim>(linearParts<Dim>(maps)).index)};
    if (const auto euclidean = exactEuclideanNorm<Dim>(maps))
        return Existence{
            .verdict = Verdict::Hyperbolic, .contractivity = euclidean->contractivity, .witness = longest};
    const auto along = [&longest](const CommonMatrixNorm& norm) {
        return Existence{.verdict = Verdict::EventuallyContractive,
                         .contractivity = norm.contractivity,
                         .witness = longest,
                         .normEquivalence = norm.equivalence,
                         .norm = NormKind::Ellipsoidal};
    };
    std::optional<CommonMatrixNorm> seen;
    if (better) {
        const Matrix<Dim> root = better->image.linear.inverse();
        seen = ellipsoidNorm<Dim>(maps, root.transpose() * root);
    }
    const CommonMatrixNorm unusable{1, std::numeric_limits<double>::infinity()};
    for (const auto& norm : {supportNorm<Dim>(maps), lyapunovNorm<Dim>(maps), seen})
        if (norm && norm->contractivity < 1) return along(*norm);
    const auto contractsInPlane = [maxProducts](std::span<const AffineMap<2>> blocks) {
        return classify<2>(blocks, maxProducts).exists();
    };
    if (seen || contractExactly<Dim>(maps, contractsInPlane)) return along(unusable);
    return std::nullopt;
}

// Contraction in norms that fit the maps, where words have not decided.
template <int Dim>
std::optional<Existence> contractionInSomeNorm(std::span<const AffineMap<Dim>> maps, bool isHurried,
                                               int maxProducts) {
    for (const double emphasis : emphases)
        if (const auto ellipsoidal = ellipsoidalNorm<Dim>(maps, emphasis))
            return Existence{.verdict = Verdict::EventuallyContractive,
                             .contractivity = ellipsoidal->norm.contractivity,
                             .witness = {ellipsoidal->slowest},
                             .normEquivalence = ellipsoidal->norm.equivalence,
                             .norm = NormKind::Ellipsoidal};
    const auto better = conditioned(maps);
    if (better && better->longest < contractionLimit<Dim>)
        return Existence{.verdict = Verdict::EventuallyContractive,
                         .contractivity = std::max(better->longest, minContractivity),
                         .witness = {better->slowest},
                         .normEquivalence = better->condition,
                         .norm = NormKind::Ellipsoidal};
    if (const auto common = commonMatrixNorm<Dim>(maps); common && common->contractivity < 1)
        return Existence{.verdict = Verdict::EventuallyContractive,
                         .contractivity = common->contractivity,
                         .witness = {0},
                         .normEquivalence = common->equivalence,
                         .norm = NormKind::Ellipsoidal};
    const std::span<const AffineMap<Dim>> seen =
        better ? std::span<const AffineMap<Dim>>(better->maps) : maps;
    const double least = leastContractivity<Dim>(maps);
    const double rounding = better ? better->linearRounding : 0;
    for (const double share : {0.5, 0.125, 1. / 64}) { // share of the way from 1 to the least possible value
        if (isHurried && share > 0.1) continue;
        if (const auto polytope =
                polytopeNorm<Dim>(seen, 1 - share * (1 - least), rounding, isHurried ? 300'000 : 4'000'000))
            return Existence{.verdict = Verdict::EventuallyContractive,
                             .contractivity = polytope->contractivity,
                             .witness = {polytope->slowest},
                             .normEquivalence = polytope->equivalence * (better ? better->condition : 1),
                             .norm = NormKind::Polytope};
    }
    return contractionWithoutRounding<Dim>(maps, better, maxProducts);
}

// Longer words than can all be tried: those that are the longest where the maps are short.
template <int Dim> std::optional<Existence> longExpandingWord(std::span<const AffineMap<Dim>> maps) {
    constexpr std::size_t kept = 96;
    constexpr std::size_t maxLength = 32, maxProducts = 100'000;
    constexpr int maxAsked = 16;
    int asked = 0;
    struct Candidate {
        Matrix<Dim> product;
        std::vector<int> word;
        double norm;
    };
    const auto better = conditioned(maps);
    const Matrices<Dim> generators =
        linearParts<Dim>(better ? std::span<const AffineMap<Dim>>(better->maps) : maps);
    std::vector<Candidate> longest{{Matrix<Dim>::Identity(), {}, 1}};
    const std::size_t lengths = std::min(maxLength, maxProducts / (kept * maps.size()));
    for (std::size_t length = 1; length <= lengths; ++length) {
        std::vector<Candidate> longer;
        for (const Candidate& candidate : longest)
            for (std::size_t i = 0; i < generators.size(); ++i) {
                const Matrix<Dim> product = candidate.product * generators[i];
                longer.push_back({product, candidate.word, product.norm()});
                longer.back().word.push_back(int(i));
                const double radius = spectralRadius<Dim>(product);
                if (radius >= 1 && asked++ < maxAsked &&
                    exactExpansion<Dim>(maps, longer.back().word) == Expansion::Yes)
                    return Existence{.verdict = Verdict::None,
                                     .contractivity = std::pow(radius, 1.0 / double(length)),
                                     .wordLength = int(length),
                                     .witness = longer.back().word};
            }
        std::ranges::stable_sort(longer, std::ranges::greater{}, &Candidate::norm);
        if (longer.size() > kept) longer.resize(kept);
        longest = std::move(longer);
    }
    return std::nullopt;
}

} // namespace

template <int Dim> Existence classify(std::span<const AffineMap<Dim>> maps, int maxProducts) {
    if (maps.empty()) return {.verdict = Verdict::Empty};
    Existence undecided{.contractivity = std::numeric_limits<double>::infinity()};
    if (!std::ranges::all_of(maps, isFinite<Dim>)) return undecided;

    const Matrices<Dim> generators = linearParts<Dim>(maps);
    WordLevel<Dim> level{generators};
    ExpansionSearch<Dim> search(maps);
    std::vector<double> norms;
    const std::size_t allowed = std::size_t(std::max(maxProducts, 0));
    std::size_t products = 0;
    for (;;) {
        const Largest norm = maxNorm<Dim>(level.products);
        const double error = maxError(level), most = withError(norm.value, error);
        const double root = std::pow(most, 1.0 / level.length);
        const auto word = [&](std::size_t index) { return spell(index, level.length, maps.size()); };
        if (norm.value + error < contractionLimit<Dim>) {
            const bool immediately = level.length == 1;
            return {.verdict = immediately ? Verdict::Hyperbolic : Verdict::EventuallyContractive,
                    .contractivity = root,
                    .wordLength = level.length,
                    .witness = word(norm.index),
                    .normEquivalence = normEquivalence(norms, root),
                    .norm = immediately ? NormKind::Euclidean : NormKind::Words};
        }
        if (const Largest expanding = search.first(level); expanding.value >= 1)
            return {.verdict = Verdict::None,
                    .contractivity = std::pow(expanding.value, 1.0 / level.length),
                    .wordLength = level.length,
                    .witness = word(expanding.index)};
        if (root < undecided.contractivity) {
            undecided.contractivity = root;
            undecided.wordLength = level.length;
        }
        norms.push_back(most);
        products += level.products.size() * maps.size();
        if (products > allowed) break;
        extend(level, generators);
        if (!allFinite<Dim>(level.products)) break;
    }
    if (generators.size() > allowed) return undecided;
    constexpr int thorough = 20'000; // products; fewer are allowed while somebody waits
    const bool isHurried = maxProducts < thorough;
    if (const auto found = contractionInSomeNorm<Dim>(maps, isHurried, maxProducts)) return *found;
    return isHurried ? undecided : longExpandingWord<Dim>(maps).value_or(undecided);
}

template <int Dim>
ContractingNorm<Dim> contractingNorm(std::span<const AffineMap<Dim>> maps, const Existence& existence) {
    constexpr double tight = 20; // limit of norms that need no better one
    const double least = existence.wordLength == 1 ? 0 : minContractivity;
    ContractingNorm<Dim> best{.contractivity = std::max(existence.contractivity, least),
                              .equivalence = existence.normEquivalence,
                              .norm = existence.norm,
                              .wordLength = existence.wordLength};
    const auto cost = [](const auto& norm) { return norm.equivalence / (1 - norm.contractivity); };
    const auto offer = [&](const ContractingNorm<Dim>& norm) {
        if (norm.contractivity < contractionLimit<Dim> && cost(norm) < cost(best)) best = norm;
    };
    if (cost(best) <= tight) return best;
    for (const double emphasis : emphases)
        if (const auto ellipsoidal = ellipsoidalNorm<Dim>(maps, emphasis)) offer(ellipsoidal->norm);
    if (cost(best) <= tight) return best;

    constexpr std::size_t maxProducts = 20'000;
    const Matrices<Dim> generators = linearParts<Dim>(maps);
    WordLevel<Dim> level{generators};
    std::vector<double> norms;
    double most = maxNorm<Dim>(level.products).value;
    while (level.products.size() * maps.size() <= maxProducts && maps.size() > 1) {
        norms.push_back(most);
        extend(level, generators);
        most = withError(maxNorm<Dim>(level.products).value, maxError(level));
        const double root = std::max(std::pow(most, 1.0 / level.length), minContractivity);
        offer({.contractivity = root,
               .equivalence = normEquivalence(norms, root),
               .norm = NormKind::Words,
               .wordLength = level.length});
    }
    return best;
}

namespace {

// The largest number below ρ(A_σ)^(1/n) that is proved to be no more.
template <int Dim> double provedRadius(const Matrix<Dim>& product, double error, double root, int length) {
    for (const double caution : {1e-14, 1.2e-14, 1e-11, 1e-8, 1e-5}) {
        const double least = root * (1 - caution), power = std::pow(least, length) * (1 + 0x1p-50);
        const Matrix<Dim> shrunk = product / power;
        const double rounding = roundingUnit * shrunk.cwiseAbs().maxCoeff() + underflow;
        if (power > 0 && expansion<Dim>(shrunk, 2 * error / power + rounding) == Expansion::Yes) return least;
    }
    return 0;
}

} // namespace

namespace {

// The largest ratio, for the norm of a product is the product of the ratios.
JointSpectralRadius radiusOfSimilarities(const std::vector<Dyadic>& squares) {
    const Dyadic largest = *std::ranges::max_element(
        squares, [](const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; });
    constexpr double small = 0x1p-900, scale = 0x1p600; // of squares that may be too small for a double
    const bool isSmall = largest.rounded() < small;
    const double root = isSmall ? std::sqrt((Dyadic(scale) * Dyadic(scale) * largest).rounded()) / scale
                                : std::sqrt(largest.rounded());
    if (!std::isfinite(root)) return {0, root};
    if (Dyadic(root) * Dyadic(root) == largest) return {root, root};
    constexpr double few = 0x1p-51;
    const double lost = isSmall ? underflow : 0;
    return {std::max(root * (1 - few) - lost, 0.0), root * (1 + few) + lost};
}

} // namespace

template <int Dim>
JointSpectralRadius jointSpectralRadius(std::span<const AffineMap<Dim>> maps, const Existence& existence) {
    constexpr std::size_t maxProducts = 2'000;
    constexpr int maxLength = 16;
    JointSpectralRadius result{0, std::numeric_limits<double>::infinity()};
    if (maps.empty() || !std::ranges::all_of(maps, isFinite<Dim>)) return result;
    if (const auto squares = squaredRatios<Dim>(maps)) {
        result = radiusOfSimilarities(*squares);
        if (existence.exists()) result.most = std::min(result.most, 1.0);
        return result;
    }
    if (existence.exists()) result.most = std::min(existence.contractivity * (1 + 1e-15), 1.0);
    const Matrices<Dim> generators = linearParts<Dim>(maps);
    for (WordLevel<Dim> level{generators}; allFinite<Dim>(level.products); extend(level, generators)) {
        const double norm = maxNorm<Dim>(level.products).value + maxError(level);
        result.most = std::min(result.most, std::pow(norm, 1.0 / level.length) * (1 + 1e-15));
        for (std::size_t i = 0; i < level.products.size(); ++i) {
            const double root = std::pow(spectralRadius<Dim>(level.products[i]), 1.0 / level.length);
            if (root > result.least * (1 + 1e-12))
                result.least = std::max(
                    result.least, provedRadius<Dim>(level.products[i], level.errors[i], root, level.length));
        }
        if (level.products.size() * maps.size() > maxProducts || level.length == maxLength) break;
    }
    for (const double emphasis : emphases)
        if (const auto ellipsoidal = ellipsoidalNorm<Dim>(maps, emphasis))
            result.most = std::min(result.most, ellipsoidal->norm.contractivity * (1 + 1e-12));
    return result;
}

template Existence classify<2>(std::span<const AffineMap<2>>, int);
template Existence classify<3>(std::span<const AffineMap<3>>, int);
template JointSpectralRadius jointSpectralRadius<2>(std::span<const AffineMap<2>>, const Existence&);
template JointSpectralRadius jointSpectralRadius<3>(std::span<const AffineMap<3>>, const Existence&);
template ContractingNorm<2> contractingNorm<2>(std::span<const AffineMap<2>>, const Existence&);
template ContractingNorm<3> contractingNorm<3>(std::span<const AffineMap<3>>, const Existence&);

} // namespace ifs
