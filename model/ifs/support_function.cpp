// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include "ifs/attractor_existence.h"
#include "ifs/direction_fan.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace ifs {

namespace {

constexpr double RoundingUnit = 0x1p-53;
constexpr int TableDepth = 4;
constexpr std::size_t TableWork = 60'000; // bounds evaluated at most while the container is shrunk

template <int Dim> Vector<Dim> solveFixedPoint(const AffineMap<Dim>& contraction) {
    return (Matrix<Dim>::Identity() - contraction.linear).inverse() * contraction.translation;
}

template <int Dim> AffineMap<Dim> meanMap(const std::vector<AffineMap<Dim>>& maps) {
    AffineMap<Dim> mean{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    for (const auto& map : maps) {
        mean.linear += map.linear / double(maps.size());
        mean.translation += map.translation / double(maps.size());
    }
    return mean;
}

} // namespace

// The attractor seen from its centre, in the polytope {x : ⟨g,x⟩ ≤ H_g} over the directions g of a fan.
// The maps are x ↦ A x + offset there; vectors u travel by the transposed matrices.
template <int Dim> struct SupportFunction<Dim>::Container {
    std::vector<Matrix<Dim>> transposed;
    std::vector<Vector<Dim>> offsets;
    Vector<Dim> anchor; // a point of the attractor
    double radius = 0;  // about the centre
    DirectionFan<Dim> fan;
    std::vector<double> heights;
    double mergeLimit = 0; // states this close, relative to |v|, can never be one below the other

    explicit Container(int depth) : fan(depth) {}

    double bound(const Vector<Dim>& v) const { return fan.bound(v, heights); }

    void shrink();
    Vector<Dim> recentre();
};

// H_g ← max_i ⟨g,offset_i⟩ + H(A_iᵀg) as long as it lowers the H: from any container to the smallest polytope
// with these normals that every map takes into itself.
template <int Dim> void SupportFunction<Dim>::Container::shrink() {
    const auto& directions = fan.directions();
    const double rounding = 16 * RoundingUnit * radius;
    const std::size_t sweepWork = directions.size() * offsets.size();
    double progress = radius;
    for (std::size_t work = 0; work < TableWork && progress > 1e-6 * radius; work += sweepWork) {
        progress = 0;
        for (std::size_t g = 0; g < directions.size(); ++g) {
            double height = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < offsets.size(); ++i)
                height =
                    std::max(height, directions[g].dot(offsets[i]) + bound(transposed[i] * directions[g]));
            height += rounding;
            progress = std::max(progress, heights[g] - height);
            heights[g] = std::min(heights[g], height);
        }
    }
}

// Moves the origin to the middle of the box; returns by how much.
template <int Dim> Vector<Dim> SupportFunction<Dim>::Container::recentre() {
    Vector<Dim> middle, half;
    for (int k = 0; k < Dim; ++k) {
        const double high = heights[std::size_t(2 * k)], low = -heights[std::size_t(2 * k + 1)];
        middle[k] = (low + high) / 2;
        half[k] = (high - low) / 2;
    }
    const double rounding = 4 * RoundingUnit * radius;
    for (std::size_t g = 0; g < heights.size(); ++g)
        heights[g] += rounding - fan.directions()[g].dot(middle);
    radius = std::min(radius, half.norm() + rounding);
    return middle;
}

template <int Dim>
std::optional<SupportFunction<Dim>> SupportFunction<Dim>::of(std::span<const AffineMap<Dim>> maps) {
    const Existence existence = classify(maps);
    if (existence.verdict != Verdict::Hyperbolic && existence.verdict != Verdict::EventuallyContractive)
        return std::nullopt;
    SupportFunction result;
    result.m_maps.assign(maps.begin(), maps.end());
    result.m_contractivity = existence.contractivity;
    result.m_normEquivalence = existence.normEquivalence;
    result.m_centre = solveFixedPoint<Dim>(meanMap<Dim>(result.m_maps));
    const Vector<Dim> anchor = solveFixedPoint<Dim>(maps.front());

    int depth = TableDepth;
    while (depth > 0 && (std::size_t(4) << depth) * maps.size() > TableWork)
        --depth;
    auto container = std::make_shared<Container>(depth);
    const auto centreOn = [&](const Vector<Dim>& centre) {
        result.m_centre = centre;
        container->offsets.clear();
        for (const auto& map : maps)
            container->offsets.push_back(map(centre) - centre);
        container->anchor = anchor - centre;
    };
    centreOn(result.m_centre);
    double reach = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        container->transposed.push_back(maps[i].linear.transpose());
        reach = std::max(reach, container->offsets[i].norm());
    }
    const double gap = 1 - existence.contractivity;
    container->radius = reach * existence.normEquivalence / gap * (1 + 1e-12);
    container->mergeLimit = gap / existence.normEquivalence;
    if (!std::isfinite(container->radius) || !anchor.allFinite()) return std::nullopt;
    container->heights.assign(container->fan.directions().size(), container->radius);
    container->shrink();
    centreOn(result.m_centre + container->recentre());
    result.m_radius = container->radius;
    result.m_container = std::move(container);
    return result;
}

template <int Dim> double SupportFunction<Dim>::roundingError(int depth) const {
    const double size = m_centre.norm() + m_radius;
    return std::max(1e-12 * m_radius,
                    RoundingUnit * size * (8 * depth + 4 * m_normEquivalence / (1 - m_contractivity)));
}

namespace {

// The state of an address σ: v = A_σᵀu and o = ⟨u, w_σ(0)⟩, so that h_A(u) = max over all σ of one length of
// o + h_A(v).
template <int Dim> struct State {
    Vector<Dim> v;
    double o = 0;
    int parent = -1;
    int symbol = -1;
    int depth = 0;
};

// v rounded to 43 bits of its largest component. The grid is shifted, for dyadic numbers with an error of one
// ulp would fall to either side of a grid point.
template <int Dim> struct StateKey {
    std::array<std::int64_t, Dim + 1> digits;

    explicit StateKey(const Vector<Dim>& v) {
        int exponent = 0;
        std::frexp(1.1 * v.cwiseAbs().maxCoeff(), &exponent);
        digits[Dim] = exponent;
        for (int k = 0; k < Dim; ++k)
            digits[std::size_t(k)] = std::int64_t(std::floor(std::ldexp(v[k], 43 - exponent) + 0.3));
    }
    bool operator==(const StateKey&) const = default;
};

struct StateKeyHash {
    template <int Dim> std::size_t operator()(const StateKey<Dim>& key) const {
        std::uint64_t hash = 0;
        for (const std::int64_t digit : key.digits) {
            hash = (hash ^ std::uint64_t(digit)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        return std::size_t(hash);
    }
};

// Best first over addresses. Whatever leaves the frontier without being followed is accounted for: in
// `ceiling` when it cannot beat the best value by more than the tolerance, in `slack` when an equal state
// stands for it.
template <int Dim, class Container> class AddressSearch {
public:
    AddressSearch(const Container& container, const Vector<Dim>& u, double tolerance)
        : m_container(container),
          m_tolerance(tolerance),
          m_mergeCost(8 * RoundingUnit * container.radius * u.norm()) {
        consider({.v = u});
    }

    void run(int maxNodes) {
        while (!m_frontier.empty() && m_frontier.top().bound > m_best + m_tolerance &&
               m_considered < maxNodes) {
            const State<Dim> state = m_states[m_frontier.top().state];
            const int parent = int(m_frontier.top().state);
            m_frontier.pop();
            for (std::size_t i = 0; i < m_container.offsets.size(); ++i)
                consider({.v = m_container.transposed[i] * state.v,
                          .o = state.o + state.v.dot(m_container.offsets[i]),
                          .parent = parent,
                          .symbol = int(i),
                          .depth = state.depth + 1});
        }
    }

    double upperBound() const {
        const double open = m_frontier.empty() ? m_ceiling : std::max(m_ceiling, m_frontier.top().bound);
        return std::max(open, m_best) + m_slack;
    }

    std::vector<int> bestAddress() const {
        std::vector<int> address;
        for (int state = int(m_bestState); m_states[std::size_t(state)].parent >= 0;
             state = m_states[std::size_t(state)].parent)
            address.push_back(m_states[std::size_t(state)].symbol);
        std::ranges::reverse(address);
        return address;
    }

    int depth() const { return m_depth; }

private:
    struct Open {
        double bound;
        std::size_t state;
        bool operator<(const Open& other) const { return bound < other.bound; }
    };

    void consider(const State<Dim>& state) {
        ++m_considered;
        m_depth = std::max(m_depth, state.depth);
        const double attained = state.o + state.v.dot(m_container.anchor);
        const double bound = state.o + m_container.bound(state.v);
        const bool isBest = attained > m_best;
        if (!isBest && bound <= m_best + m_tolerance) {
            m_ceiling = std::max(m_ceiling, bound);
            return;
        }
        if (isBest) {
            m_best = attained;
            m_bestState = m_states.size();
        } else if (isMerged(state)) {
            return;
        }
        m_frontier.push({bound, m_states.size()});
        m_states.push_back(state);
    }

    // Whether an earlier state with the same v and no smaller o stands for this one. Whatever h_A the two
    // differ by, radius·|v − v'| bounds it. A state may not stand for its own descendant: in ‖·‖_* a
    // descendant is shorter by the contractivity, so states that are closer than `mergeLimit` are unrelated.
    bool isMerged(const State<Dim>& state) {
        const auto [place, isNew] = m_known.try_emplace(StateKey<Dim>(state.v), m_states.size());
        if (isNew) return false;
        const State<Dim>& earlier = m_states[place->second];
        const double distance = (state.v - earlier.v).norm();
        const double cost = state.o + m_container.radius * distance - earlier.o;
        if (cost > m_mergeCost || distance >= m_container.mergeLimit * earlier.v.norm()) {
            if (state.o > earlier.o) place->second = m_states.size();
            return false;
        }
        m_slack += std::max(cost, 0.0);
        return true;
    }

    const Container& m_container;
    double m_tolerance;
    double m_mergeCost;
    std::vector<State<Dim>> m_states;
    std::priority_queue<Open> m_frontier;
    std::unordered_map<StateKey<Dim>, std::size_t, StateKeyHash> m_known;
    double m_best = -std::numeric_limits<double>::infinity();
    std::size_t m_bestState = 0;
    double m_ceiling = -std::numeric_limits<double>::infinity();
    double m_slack = 0;
    int m_considered = 0;
    int m_depth = 0;
};

} // namespace

template <int Dim>
SupportValue<Dim> SupportFunction<Dim>::operator()(const Vector<Dim>& u, double tolerance,
                                                   int maxNodes) const {
    SupportValue<Dim> result;
    result.point = m_centre + m_container->anchor;
    const double size = u.cwiseAbs().maxCoeff();
    if (!u.allFinite() || size == 0) {
        result.error = size == 0 ? 0 : std::numeric_limits<double>::infinity();
        return result;
    }
    // A power of two, so that scaling rounds nothing.
    int exponent = 0;
    std::frexp(size, &exponent);
    Vector<Dim> scaled;
    for (int k = 0; k < Dim; ++k)
        scaled[k] = std::ldexp(u[k], -exponent);
    const double smallest = 8 * RoundingUnit * m_radius * scaled.norm();
    const double wanted = std::ldexp(tolerance, -exponent);
    AddressSearch<Dim, Container> search(*m_container, scaled, std::max(wanted, smallest));
    search.run(maxNodes);

    result.address = search.bestAddress();
    for (auto symbol = result.address.rbegin(); symbol != result.address.rend(); ++symbol)
        result.point = m_maps[std::size_t(*symbol)](result.point);
    const double value = scaled.dot(result.point);
    const double gap = std::max(0.0, search.upperBound() + scaled.dot(m_centre) - value);
    result.value = std::ldexp(value, exponent);
    result.error = std::ldexp(gap + roundingError(search.depth()) * scaled.norm(), exponent);
    return result;
}

template class SupportFunction<2>;
template class SupportFunction<3>;

} // namespace ifs
