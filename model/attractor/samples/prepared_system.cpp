// SPDX-License-Identifier: MIT
#include "attractor/samples/prepared_system.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/samples/finite_maps.h"
#include "attractor/samples/rounded_map.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/support_function.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <unordered_set>
#include <utility>

namespace attractor {

namespace {

using ifs::Vector;

// Support values of a convex set in 64 directions that run around the square [−1, 1]². In between, the linear
// interpolation along a side of the square is an upper bound, because support functions are convex.
class Enclosure {
public:
    static constexpr int steps = 16; // number of steps per side of the square
    static constexpr int count = 4 * steps;
    using Values = std::array<double, count>;

    static Vector<2> direction(int j) {
        const double along = 2.0 * (j % steps) / steps - 1;
        switch (j / steps) {
        case 0:
            return {1, along};
        case 1:
            return {-along, 1};
        case 2:
            return {-1, -along};
        default:
            return {along, -1};
        }
    }

    // Weights of two neighbouring directions whose combination is u.
    struct Interpolation {
        int low = 0;
        int high = 0;
        double weightLow = 0;
        double weightHigh = 0;
    };
    static Interpolation interpolation(const Vector<2>& u) {
        const double size = std::max(std::abs(u.x()), std::abs(u.y()));
        if (!(size > 0)) return {};
        const bool upright = std::abs(u.y()) > std::abs(u.x());
        const int side = upright ? (u.y() > 0 ? 1 : 3) : (u.x() > 0 ? 0 : 2);
        const std::array<double, 4> along{u.y(), -u.x(), -u.y(), u.x()};
        const double position = (along[static_cast<std::size_t>(side)] / size + 1) / 2 * steps;
        const int step = std::clamp(static_cast<int>(position), 0, steps - 1);
        const double f = position - step;
        const int low = side * steps + step;
        return {low, (low + 1) % count, size * (1 - f), size * f};
    }
};

struct SupportStep { // one term ⟨u_j, d_i⟩ + h(A_iᵀ u_j)
    double offset = 0;
    Enclosure::Interpolation inner;
};

std::vector<SupportStep> supportSteps(const std::vector<ifs::AffineMap<2>>& centred) {
    std::vector<SupportStep> steps;
    steps.reserve(centred.size() * Enclosure::count);
    for (int j = 0; j < Enclosure::count; ++j) {
        const Vector<2> u = Enclosure::direction(j);
        for (const ifs::AffineMap<2>& map : centred)
            steps.push_back({u.dot(map.translation), Enclosure::interpolation(map.linear.transpose() * u)});
    }
    return steps;
}

// h ← max(h, W h) until it settles; returns the last relative growth.
double grow(Enclosure::Values& h, const std::vector<SupportStep>& steps, int rounds) {
    const std::size_t maps = steps.size() / Enclosure::count;
    double growth = 0;
    for (int round = 0; round < rounds; ++round) {
        growth = 0;
        double size = 0;
        for (std::size_t j = 0; j < h.size(); ++j) {
            double best = h[j];
            for (std::size_t i = 0; i < maps; ++i) {
                const SupportStep& s = steps[j * maps + i];
                best =
                    std::max(best, s.offset + s.inner.weightLow * h[static_cast<std::size_t>(s.inner.low)] +
                                       s.inner.weightHigh * h[static_cast<std::size_t>(s.inner.high)]);
            }
            growth = std::max(growth, best - h[j]);
            h[j] = best;
            size = std::max(size, best);
        }
        if (!(growth > 1e-4 * size)) return 0;
        growth /= size;
    }
    return growth;
}

// The mean of the invariant measure where it exists, else the middle of the translations.
Vector<2> startingPoint(const PreparedSystem& system) {
    ifs::AffineMap<2> mean{ifs::Matrix<2>::Zero(), Vector<2>::Zero()};
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        mean.linear += system.probabilities[i] * system.maps[i].linear;
        mean.translation += system.probabilities[i] * system.maps[i].translation;
    }
    const auto fixed = ifs::fixedPoint(mean);
    return fixed && fixed->allFinite() ? *fixed : mean.translation;
}

std::vector<ifs::AffineMap<2>> centredMaps(const PreparedSystem& system, const Vector<2>& centre) {
    std::vector<ifs::AffineMap<2>> maps = system.maps;
    for (ifs::AffineMap<2>& map : maps)
        map.translation = map(centre) - centre;
    return maps;
}

// A short orbit with a guard against escape, as support values about the centre.
Enclosure::Values pilotExtent(const std::vector<ifs::AffineMap<2>>& centred,
                              const std::vector<double>& probabilities) {
    double reach = 0;
    for (const ifs::AffineMap<2>& map : centred)
        reach = std::max(reach, map.translation.cwiseAbs().maxCoeff());
    const double farAway = 1e3 * reach;
    std::array<Vector<2>, Enclosure::count> directions;
    for (std::size_t j = 0; j < directions.size(); ++j)
        directions[j] = Enclosure::direction(static_cast<int>(j));
    std::vector<double> cumulative;
    cumulative.reserve(probabilities.size());
    std::partial_sum(probabilities.begin(), probabilities.end(), std::back_inserter(cumulative));
    Enclosure::Values h{};
    Vector<2> x = Vector<2>::Zero();
    std::uint64_t state = 1;
    for (int n = 0; n < 1500; ++n) {
        const double u = static_cast<double>(mixed(++state) >> 11) * 0x1p-53;
        const auto i =
            std::ranges::upper_bound(cumulative.begin(), cumulative.end() - 1, u) - cumulative.begin();
        x = centred[static_cast<std::size_t>(i)](x);
        if (!(x.cwiseAbs().maxCoeff() <= farAway)) x = Vector<2>::Zero();
        if (n < 100) continue;
        for (std::size_t j = 0; j < h.size(); ++j)
            h[j] = std::max(h[j], directions[j].dot(x));
    }
    return h;
}

// Maps that can lead to the border of the attractor: of many thousands, a few.
std::vector<ifs::AffineMap<2>> outerMaps(const PreparedSystem& system,
                                         const std::vector<ifs::AffineMap<2>>& centred) {
    constexpr std::size_t few = 256;
    if (system.maps.size() <= few) return centred;
    const auto support = ifs::SupportFunction<2>::of(system.maps);
    if (!support) return centred;
    std::vector<ifs::AffineMap<2>> outer;
    for (const std::size_t index : support->mapsToTheHull())
        outer.push_back(centred[index]);
    return outer;
}

// A box for maps that stretch before they contract: an orbit may leave the far ends of a thin attractor out,
// and interpolated values need not settle.
std::optional<ifs::BoundingBox<2>> certifiedBox(const PreparedSystem& system) {
    const auto stretches = [](const auto& map) { return ifs::spectralNorm<2>(map.linear) >= 1; };
    if (system.note != RenderNote::None || std::ranges::none_of(system.maps, stretches)) return std::nullopt;
    const auto support = ifs::SupportFunction<2>::of(system.maps);
    return support ? std::optional(ifs::boundingBox(*support, 1e-4 * support->radius())) : std::nullopt;
}

void placeBox(PreparedSystem& system) {
    const Vector<2> start = startingPoint(system);
    const auto centred = centredMaps(system, start);
    Enclosure::Values h = pilotExtent(centred, system.probabilities);
    const Enclosure::Values pilot = h;
    double slack = 1e-2;
    const auto certified = certifiedBox(system);
    if (!certified &&
        (system.note != RenderNote::None || grow(h, supportSteps(outerMaps(system, centred)), 400) > 1e-3)) {
        h = pilot;
        slack = 1;
    }
    constexpr int middle = Enclosure::steps / 2;
    const auto at = [&](int side) { return h[static_cast<std::size_t>(side) * Enclosure::steps + middle]; };
    Vector<2> high(at(0), at(1)), low(-at(2), -at(3));
    if (certified) {
        const Vector<2> error = Vector<2>::Constant(certified->error);
        high = certified->max + error - start;
        low = certified->min - error - start;
    }
    system.centre = start + (low + high) / 2;
    system.halfExtent = (high - low) / 2;
    const double size = system.halfExtent.maxCoeff();
    if (!(size > 0) || !std::isfinite(size)) {
        system.halfExtent =
            Vector<2>::Constant(std::isfinite(size) ? 1e-9 + 1e-12 * start.cwiseAbs().maxCoeff() : 1);
        return;
    }
    system.halfExtent += Vector<2>::Constant(slack * size);
}

// Maps that are applied to the same points, as far as their columns of the matrix tell.
std::vector<std::uint32_t> setsByColumn(const ifs::Transitions& chain) {
    constexpr double alike = 1e-12;
    const std::size_t n = chain.size;
    std::vector<std::uint32_t> sets(n);
    std::vector<std::size_t> first; // map of each set
    for (std::size_t j = 0; j < n; ++j) {
        const auto hasItsColumn = [&](std::size_t k) {
            for (std::size_t i = 0; i < n; ++i)
                if (!(std::abs(chain.backward[k * n + i] - chain.backward[j * n + i]) <= alike)) return false;
            return true;
        };
        const auto known = std::ranges::find_if(first, hasItsColumn);
        sets[j] = static_cast<std::uint32_t>(known - first.begin());
        if (known == first.end()) first.push_back(j);
    }
    return sets;
}

double linkedLogarithm(const PreparedSystem& system) {
    double sum = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        sum += system.chain.stationary[i] * naturalLogarithm(ifs::spectralNorm<2>(system.maps[i].linear));
    return sum;
}

// Below 0, also where no double below 1 is a factor by which the maps contract.
double slowestLogarithm(const ifs::Existence& existence) {
    return naturalLogarithm(std::min(existence.contractivity, 1 - 0x1p-53));
}

void setBox(PreparedSystem& system, const ifs::Vector<2>& low, const ifs::Vector<2>& high, double slack) {
    system.centre = (low + high) / 2;
    system.halfExtent = (high - low) / 2;
    const double size = system.halfExtent.maxCoeff();
    if (size > 0 && std::isfinite(size))
        system.halfExtent += ifs::Vector<2>::Constant(slack * size);
    else
        system.halfExtent = ifs::Vector<2>::Constant(
            std::isfinite(size) ? 1e-9 + 1e-12 * system.centre.cwiseAbs().maxCoeff() : 1);
    if (!system.centre.allFinite()) system.centre = ifs::Vector<2>::Zero();
}

void placeLinkedBox(PreparedSystem& system, const ifs::LinkedExtent& extent) {
    const double tolerance = 1e-3 * extent.radius();
    const auto reach = [&](double x, double y) {
        const auto height = extent({x, y}, tolerance);
        return height.value + height.error;
    };
    setBox(system, {-reach(-1, 0), -reach(0, -1)}, {reach(1, 0), reach(0, 1)}, 1e-2);
}

// A box without a certificate: that of a short orbit.
void placeBoxByOrbit(PreparedSystem& system) {
    ifs::Vector<2> low = ifs::Vector<2>::Zero(), high = low, x = low;
    double reach = 0;
    for (const ifs::AffineMap<2>& map : system.maps)
        reach = std::max(reach, map.translation.cwiseAbs().maxCoeff());
    const auto drawn = [](std::span<const double> shares, double u) {
        std::size_t i = 0;
        while (i + 1 < shares.size() && u >= shares[i])
            u -= shares[i++];
        return i;
    };
    const std::size_t maps = system.maps.size();
    const std::span<const double> forward(system.chain.forward);
    std::size_t last = 0;
    for (std::uint64_t n = 0; n < 1500; ++n) {
        const double u = static_cast<double>(mixed(n + 1) >> 11) * 0x1p-53;
        last = drawn(n % 500 == 0 ? std::span<const double>(system.chain.stationary)
                                  : forward.subspan(last * maps, maps),
                     u);
        x = system.maps[last](x);
        if (!(x.cwiseAbs().maxCoeff() <= 1e3 * reach)) x.setZero();
        if (n < 100) continue;
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    setBox(system, low, high, 1);
}

} // namespace

RenderNote existenceNote(ifs::Verdict verdict) {
    switch (verdict) {
    case ifs::Verdict::None:
        return RenderNote::NoAttractor;
    case ifs::Verdict::Undecided:
        return RenderNote::Undecided;
    case ifs::Verdict::Empty:
        return RenderNote::NoMaps;
    default:
        return RenderNote::None;
    }
}

namespace {

void prepareLinked(PreparedSystem& system) {
    system.chain = ifs::transitions(system);
    system.sampleSetOf = setsByColumn(system.chain);
    system.meanLogarithm = linkedLogarithm(system);
    const ifs::Existence existence = ifs::classifyLinked<2>(system, 2000);
    system.note = existenceNote(existence.verdict);
    if (!(system.meanLogarithm < 0) && existence.verdict == ifs::Verdict::EventuallyContractive)
        system.meanLogarithm = slowestLogarithm(existence);
    if (const auto extent = ifs::LinkedExtent::of(system, existence))
        placeLinkedBox(system, *extent);
    else
        placeBoxByOrbit(system);
}

// Among the words of one map, and of two and three maps where these are not too many: exact overlaps show in
// such words, or nearly never. Up to rounding. Thousands of maps would cost more than their noise is worth.
bool shortWordsCoincide(const PreparedSystem& system) {
    constexpr std::size_t maxMaps = 4096, maxWords = 256;
    if (system.maps.size() > maxMaps) return false;
    constexpr double perUnit = 0x1p40; // steps per unit of the box
    const double size = system.halfExtent.maxCoeff();
    const auto key = [&](const ifs::AffineMap<2>& map) {
        const Vector<2> shift = (map(system.centre) - system.centre) / size;
        const ifs::Matrix<2>& m = map.linear;
        return RoundedMap({m(0, 0), m(0, 1), m(1, 0), m(1, 1), shift.x(), shift.y()}, perUnit);
    };
    std::vector<ifs::AffineMap<2>> words = system.maps;
    for (int length = 1; length <= 3; ++length) {
        std::unordered_set<RoundedMap, RoundedMapHash> known;
        known.reserve(words.size());
        for (const ifs::AffineMap<2>& word : words)
            if (!known.insert(key(word)).second) return true;
        if (words.size() * system.maps.size() > maxWords) break;
        std::vector<ifs::AffineMap<2>> longer;
        longer.reserve(words.size() * system.maps.size());
        for (const ifs::AffineMap<2>& word : words)
            for (const ifs::AffineMap<2>& map : system.maps)
                longer.push_back(word * map);
        words = std::move(longer);
    }
    return false;
}

} // namespace

PreparedSystem prepared(const ifs::IteratedFunctionSystem<2>& system,
                        std::span<const ifs::MovedBranch<2>> moved) {
    PreparedSystem result{finiteMaps(system)};
    if (result.maps.empty()) {
        result.note = RenderNote::NoMaps;
        return result;
    }
    result.moved = ifs::overMaps<2>(moved, result.index);
    if (result.isLinked()) {
        prepareLinked(result);
        return result;
    }
    for (std::size_t i = 0; i < result.maps.size(); ++i)
        result.meanLogarithm +=
            result.probabilities[i] * naturalLogarithm(ifs::spectralNorm<2>(result.maps[i].linear));
    const ifs::Existence existence = ifs::classify<2>(result.maps, 2000);
    result.note = existenceNote(existence.verdict);
    // Words may contract although single maps stretch, under a cage that shears.
    if (!(result.meanLogarithm < 0) && existence.verdict == ifs::Verdict::EventuallyContractive)
        result.meanLogarithm = slowestLogarithm(existence);
    placeBox(result);
    result.coincides = shortWordsCoincide(result);
    return result;
}

std::vector<ifs::AffineMap<2>> shownPieces(const PreparedSystem& system) {
    return ifs::pieceMaps<2>(ifs::pieces<2>(system.moved, system.maps.size()), system.maps);
}

} // namespace attractor
