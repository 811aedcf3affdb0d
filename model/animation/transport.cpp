// SPDX-License-Identifier: MIT
#include "animation/transport.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace animation {

namespace {

// A way of the spanning tree, from the source `from` to the sink `to`.
struct Way {
    std::size_t from, to;
    double amount;
};

// The places are numbered: sources first, then sinks. The ways form a spanning tree of them throughout.
class NetworkSimplex {
public:
    NetworkSimplex(std::vector<double> supply, std::vector<double> demand, const Eigen::MatrixXd& cost)
        : m_sources(supply.size()),
          m_places(supply.size() + demand.size()),
          m_cost(cost),
          m_tolerance(1e-12 * (1 + cost.cwiseAbs().maxCoeff())) {
        begin(std::move(supply), std::move(demand));
    }

    std::vector<Way> solved(const std::stop_token& stop) && {
        while (!stop.stop_requested() && improve()) {}
        return std::move(m_ways);
    }

private:
    // North-west corner rule. Each step exhausts one source or sink, so that the result is a tree.
    void begin(std::vector<double> supply, std::vector<double> demand) {
        std::size_t i = 0, k = 0;
        for (;;) {
            const double amount = std::min(supply[i], demand[k]);
            m_ways.push_back({i, k, amount});
            supply[i] -= amount;
            demand[k] -= amount;
            if (i + 1 == supply.size() && k + 1 == demand.size()) return;
            const bool nextSource =
                k + 1 == demand.size() || (i + 1 < supply.size() && supply[i] <= demand[k]);
            nextSource ? ++i : ++k;
        }
    }

    // Potentials with u_i + v_k = c_ik on every way of the tree, and for each place the way to the root.
    void label() {
        std::vector<std::vector<std::size_t>> ways(m_places);
        for (std::size_t w = 0; w < m_ways.size(); ++w) {
            ways[m_ways[w].from].push_back(w);
            ways[m_sources + m_ways[w].to].push_back(w);
        }
        constexpr auto none = std::numeric_limits<std::size_t>::max();
        m_potential.assign(m_places, 0);
        m_parent.assign(m_places, none);
        m_depth.assign(m_places, 0);
        std::vector<std::size_t> open{0};
        while (!open.empty()) {
            const std::size_t place = open.back();
            open.pop_back();
            for (const std::size_t w : ways[place]) {
                if (w == m_parent[place]) continue;
                const std::size_t next = other(w, place);
                m_parent[next] = w;
                m_depth[next] = m_depth[place] + 1;
                m_potential[next] =
                    m_cost(Eigen::Index(m_ways[w].from), Eigen::Index(m_ways[w].to)) - m_potential[place];
                open.push_back(next);
            }
        }
    }

    std::size_t other(std::size_t way, std::size_t place) const {
        return place < m_sources ? m_sources + m_ways[way].to : m_ways[way].from;
    }

    // Adds the way that saves most; false if none saves anything.
    bool improve() {
        label();
        double least = -m_tolerance;
        std::size_t from = 0, to = m_places;
        for (std::size_t i = 0; i < m_sources; ++i)
            for (std::size_t k = 0; k + m_sources < m_places; ++k) {
                const double reduced =
                    m_cost(Eigen::Index(i), Eigen::Index(k)) - m_potential[i] - m_potential[m_sources + k];
                if (reduced < least) {
                    least = reduced;
                    from = i;
                    to = k;
                }
            }
        if (to == m_places) return false;
        enterBasis(from, to);
        return true;
    }

    // Alternately adds and subtracts along the circle that the new way closes in the tree.
    void enterBasis(std::size_t from, std::size_t to) {
        std::vector<std::size_t> less, more; // ways whose amounts decrease, and increase
        std::size_t a = from, b = m_sources + to;
        const auto climb = [&](std::size_t& place) {
            const std::size_t way = m_parent[place];
            // The new way adds to its two ends: the next ways decrease, those after them increase, and so on.
            // A way decreases if it leaves a source towards the root on the side of the source.
            const bool isSource = place < m_sources;
            (isSource == (&place == &a) ? less : more).push_back(way);
            place = other(way, place);
        };
        while (a != b)
            climb(m_depth[a] >= m_depth[b] ? a : b);
        const auto smallest =
            std::ranges::min_element(less, {}, [&](std::size_t way) { return m_ways[way].amount; });
        const double amount = m_ways[*smallest].amount;
        const std::size_t leaving = *smallest;
        for (const std::size_t way : less)
            m_ways[way].amount -= amount;
        for (const std::size_t way : more)
            m_ways[way].amount += amount;
        m_ways[leaving] = {from, to, amount};
    }

    std::size_t m_sources, m_places;
    const Eigen::MatrixXd& m_cost;
    double m_tolerance;
    std::vector<Way> m_ways;
    std::vector<double> m_potential;
    std::vector<std::size_t> m_parent; // way towards the root, the first source
    std::vector<std::size_t> m_depth;
};

// The amounts that a tree alone can have: leaf by leaf.
void settle(std::vector<Way>& ways, std::vector<double> supply, std::vector<double> demand) {
    const std::size_t sources = supply.size();
    std::vector<double> left = std::move(supply);
    left.insert(left.end(), demand.begin(), demand.end());
    std::vector<std::vector<std::size_t>> open(left.size());
    for (std::size_t w = 0; w < ways.size(); ++w) {
        open[ways[w].from].push_back(w);
        open[sources + ways[w].to].push_back(w);
    }
    std::vector<std::size_t> leaves;
    for (std::size_t place = 0; place < open.size(); ++place)
        if (open[place].size() == 1) leaves.push_back(place);
    while (!leaves.empty()) {
        const std::size_t leaf = leaves.back();
        leaves.pop_back();
        if (open[leaf].empty()) continue;
        const std::size_t way = open[leaf].front();
        const std::size_t next = leaf < sources ? sources + ways[way].to : ways[way].from;
        ways[way].amount = left[leaf];
        left[next] -= left[leaf];
        open[leaf].clear();
        std::erase(open[next], way);
        if (open[next].size() == 1) leaves.push_back(next);
    }
}

} // namespace

std::vector<Shipment> transport(const std::vector<double>& supply, const std::vector<double>& demand,
                                const Eigen::MatrixXd& cost, const std::stop_token& stop) {
    if (supply.empty() || demand.empty()) return {};
    // Perturbs the amounts a little, differently for every source, which prevents cycling. The final tree is
    // also optimal for the original amounts, which settle() restores.
    constexpr double nudge = 1e-11;
    std::vector<double> nudged = supply, sink = demand;
    for (std::size_t i = 0; i < nudged.size(); ++i) {
        const double more = nudge * (1 + double(i)) / double(nudged.size());
        nudged[i] += more;
        sink.back() += more;
    }
    std::vector<Way> ways = NetworkSimplex(nudged, sink, cost).solved(stop);
    settle(ways, supply, demand);
    std::vector<Shipment> shipments;
    for (const Way& way : ways)
        if (way.amount > 1e-14) shipments.push_back({way.from, way.to, way.amount});
    std::ranges::sort(shipments, {}, [](const Shipment& s) { return std::pair(s.from, s.to); });
    return shipments;
}

} // namespace animation
