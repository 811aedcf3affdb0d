// SPDX-License-Identifier: MIT
#include "ifs/extent/support_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

namespace ifs {

namespace {

constexpr std::size_t consideredPerNode = 8; // children per node, because dropped children cost less
constexpr std::size_t consideredPerMap = 40;

// The state of an address σ: v = A_σᵀu and o = ⟨u, w_σ(0)⟩, so that h_A(u) = max over all σ of one length of
// o + h_A(v).
template <int Dim> struct State {
    Vector<Dim> v;
    double o = 0;
    int parent = -1;
    int symbol = -1;
    int depth = 0;
};

// A container with a known outline, which alone bounds better once it has more lines than the fan.
struct OutlinedContainer {
    const SupportContainer<2>& container;
    const Outline& outline;

    Outline::Bracket bracket(const Vector<2>& v) const {
        Outline::Bracket result = outline.bracket(v);
        if (outline.lines().size() < container.heights.size())
            result.upper = std::min(result.upper, container.bound(v));
        return result;
    }
    const Vector<2>& point(std::size_t k) const { return outline.points()[k]; }
};

// The indices of states by their v, rounded to `bits` bits of its largest component. The grid is shifted, for
// dyadic numbers with an error of one ulp would fall to either side of a grid point. Two states may share a
// key by chance: who looks one up compares the states themselves.
template <int Dim> class StateTable {
public:
    explicit StateTable(int bits) : m_bits(bits), m_slots(1 << 10) {}

    // Slot of the key: contains its state, or `free`.
    std::int32_t& operator[](const Vector<Dim>& v) {
        if (2 * ++m_used > m_slots.size()) grow();
        return slot(key(v));
    }

    static constexpr std::int32_t free = -1;

private:
    struct Slot {
        std::uint64_t key = 0;
        std::int32_t state = free;
    };

    std::uint64_t key(const Vector<Dim>& v) const {
        int exponent = 0;
        std::frexp(1.1 * v.cwiseAbs().maxCoeff(), &exponent);
        const double scale = std::ldexp(1, m_bits - exponent);
        std::uint64_t hash = std::uint64_t(exponent);
        for (int k = 0; k < Dim; ++k) {
            hash = (hash ^ std::uint64_t(std::int64_t(std::floor(v[k] * scale + 0.3)))) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        return hash;
    }

    std::int32_t& slot(std::uint64_t wanted) {
        std::size_t index = wanted & (m_slots.size() - 1);
        while (m_slots[index].state != free && m_slots[index].key != wanted)
            index = (index + 1) & (m_slots.size() - 1);
        m_slots[index].key = wanted;
        return m_slots[index].state;
    }

    void grow() {
        std::vector<Slot> old(2 * m_slots.size());
        old.swap(m_slots);
        for (const Slot& entry : old)
            if (entry.state != free) slot(entry.key) = entry.state;
    }

    int m_bits;
    std::size_t m_used = 0;
    std::vector<Slot> m_slots;
};

// Best first over addresses. Whatever leaves the frontier without being followed is accounted for: in
// `ceiling` when it cannot beat the best value by more than the tolerance, in `slack` when an equal state
// stands for it.
template <int Dim, class Known> class AddressSearch {
public:
    AddressSearch(const SupportContainer<Dim>& container, const Known& known, const Vector<Dim>& u,
                  double tolerance, int mergeBits)
        : m_container(container),
          m_brackets(known),
          m_tolerance(tolerance),
          m_known(mergeBits),
          m_cell(mergeBits == exactMerging ? 0 : std::ldexp(4, -mergeBits)),
          m_length(u.norm()) {
        consider({.v = u});
    }

    FoundAddress<Dim> run(int maxNodes) {
        const std::size_t maxStates = std::size_t(std::max(maxNodes, 1));
        const std::size_t maxConsidered =
            consideredPerNode * maxStates + consideredPerMap * m_container.offsets.size();
        while (!isFinished() && m_states.size() < maxStates && m_considered < maxConsidered) {
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
        return {.address = bestAddress(),
                .start = m_brackets.point(m_bestPoint),
                .upperBound = upperBound(),
                .depth = m_depth,
                .isFinished = isFinished()};
    }

    // Index of the known point at which the best address begins.
    std::size_t bestPoint() const { return m_bestPoint; }

private:
    struct Open {
        double bound;
        std::size_t state;
        bool operator<(const Open& other) const { return bound < other.bound; }
    };

    double upperBound() const {
        const double open = m_frontier.empty() ? m_ceiling : std::max(m_ceiling, m_frontier.top().bound);
        return std::max(open, m_best) + slack();
    }

    bool isFinished() const { return m_frontier.empty() || m_frontier.top().bound <= m_best + m_tolerance; }

    std::vector<int> bestAddress() const {
        std::vector<int> address;
        for (int state = int(m_bestState); m_states[std::size_t(state)].parent >= 0;
             state = m_states[std::size_t(state)].parent)
            address.push_back(int(m_container.indices[std::size_t(m_states[std::size_t(state)].symbol)]));
        std::ranges::reverse(address);
        return address;
    }

    void consider(const State<Dim>& state) {
        ++m_considered;
        m_depth = std::max(m_depth, state.depth);
        const Outline::Bracket known = m_brackets.bracket(state.v);
        const double attained = state.o + known.lower, bound = state.o + known.upper;
        const bool isBest = attained > m_best;
        if (!isBest && bound <= m_best + m_tolerance) {
            m_ceiling = std::max(m_ceiling, bound);
            return;
        }
        if (isBest) {
            m_best = attained;
            m_bestState = m_states.size();
            m_bestPoint = known.point;
        } else if (isMerged(state)) {
            return;
        }
        m_frontier.push({bound, m_states.size()});
        m_states.push_back(state);
    }

    // Loss from merging: at most all costs together, and at most the costs along one address, where the
    // lengths |v| form a geometric series.
    double slack() const {
        if (m_cell >= m_container.mergeLimit) return m_slack;
        const double alongOneAddress = m_cell * m_length / (m_container.mergeLimit - m_cell);
        return std::min(m_slack, m_container.radius * alongOneAddress + m_merged * rounding());
    }

    // Difference of exact ties caused by rounding.
    double rounding() const { return 8 * roundingUnit * m_container.radius * m_length; }

    // Returns true if an earlier state with nearly the same v and an offset that is hardly smaller represents
    // this one. Their values h_A differ by at most radius·|v − v'|. A state must not represent its own
    // descendant: in ‖·‖_* a descendant is shorter by the contractivity, so that states closer than
    // `mergeLimit` are unrelated.
    bool isMerged(const State<Dim>& state) {
        std::int32_t& index = m_known[state.v];
        if (index == m_known.free) {
            index = std::int32_t(m_states.size());
            return false;
        }
        const State<Dim>& earlier = m_states[std::size_t(index)];
        const double distance = (state.v - earlier.v).norm(), length = earlier.v.norm();
        const double cost = state.o + m_container.radius * distance - earlier.o;
        if (cost > m_cell * m_container.radius * length + rounding() ||
            distance >= m_container.mergeLimit * length) {
            if (state.o > earlier.o) index = std::int32_t(m_states.size());
            return false;
        }
        m_slack += std::max(cost, 0.0);
        ++m_merged;
        return true;
    }

    const SupportContainer<Dim>& m_container;
    const Known& m_brackets;
    double m_tolerance;
    StateTable<Dim> m_known;
    double m_cell; // distance relative to |v| within which states may be merged; 0: exact ties only
    double m_length;
    std::vector<State<Dim>> m_states;
    std::priority_queue<Open> m_frontier;
    double m_best = -std::numeric_limits<double>::infinity();
    std::size_t m_bestState = 0, m_bestPoint = 0;
    double m_ceiling = -std::numeric_limits<double>::infinity();
    double m_slack = 0;
    int m_merged = 0;
    std::size_t m_considered = 0;
    int m_depth = 0;
};

} // namespace

template <int Dim>
FoundAddress<Dim> searchAddresses(const SupportContainer<Dim>& container, const Outline* known,
                                  const Vector<Dim>& u, double tolerance, int mergeBits, int maxNodes) {
    if constexpr (Dim == 2)
        if (known) {
            const OutlinedContainer brackets{container, *known};
            return AddressSearch(container, brackets, u, tolerance, mergeBits).run(maxNodes);
        }
    AddressSearch search(container, container, u, tolerance, mergeBits);
    auto result = search.run(maxNodes);
    result.direction = search.bestPoint();
    return result;
}

template FoundAddress<2> searchAddresses<2>(const SupportContainer<2>&, const Outline*, const Vector<2>&,
                                            double, int, int);
template FoundAddress<3> searchAddresses<3>(const SupportContainer<3>&, const Outline*, const Vector<3>&,
                                            double, int, int);

} // namespace ifs
