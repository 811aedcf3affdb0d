// SPDX-License-Identifier: MIT
#include "ifs/dimension/rank_one.h"
#include "ifs/linear/rounding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ifs {

namespace {

// image·rowᵀ
struct RankOne {
    Vector<2> image, row;
};

RankOne factored(const Matrix<2>& linear) {
    Eigen::Index i = 0, j = 0;
    const double largest = linear.cwiseAbs().maxCoeff(&i, &j);
    if (largest == 0) return {Vector<2>::Zero(), Vector<2>::Zero()};
    return {linear.col(j), linear.row(i).transpose() / linear(i, j)};
}

struct Edge {
    std::size_t to;
    double logarithm; // logarithm of |⟨row_from, image_to⟩|
};
using Graph = std::vector<std::vector<Edge>>;

// The norm of a word is, but for its ends, the product of the weights along it. Maps that follow one another
// to nothing have no edge.
Graph graphOf(std::span<const AffineMap<2>> maps) {
    std::vector<RankOne> factors;
    for (const auto& map : maps)
        factors.push_back(factored(map.linear));
    Graph graph(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        for (std::size_t j = 0; j < maps.size(); ++j) {
            const double weight = std::abs(factors[i].row.dot(factors[j].image));
            if (weight > 8 * roundingUnit * factors[i].row.cwiseAbs().dot(factors[j].image.cwiseAbs()))
                graph[i].push_back({j, std::log(weight)});
        }
    return graph;
}

// The strongly connected parts, each numbered within (Kosaraju's algorithm).
std::vector<Graph> strongParts(const Graph& graph) {
    const std::size_t n = graph.size();
    Graph reversed(n);
    for (std::size_t from = 0; from < n; ++from)
        for (const Edge& edge : graph[from])
            reversed[edge.to].push_back({from, edge.logarithm});
    std::vector<char> isSeen(n, 0);
    const auto visit = [&isSeen](const Graph& along, std::size_t start, std::vector<std::size_t>& finished) {
        struct Step {
            std::size_t node, next;
        };
        std::vector<Step> way{{start, 0}};
        isSeen[start] = 1;
        while (!way.empty()) {
            auto& [node, next] = way.back();
            if (next == along[node].size()) {
                finished.push_back(node);
                way.pop_back();
            } else if (const std::size_t to = along[node][next++].to; !isSeen[to]) {
                isSeen[to] = 1;
                way.push_back({to, 0});
            }
        }
    };
    std::vector<std::size_t> order;
    for (std::size_t node = 0; node < n; ++node)
        if (!isSeen[node]) visit(graph, node, order);
    std::ranges::fill(isSeen, 0);
    std::vector<Graph> parts;
    std::vector<std::size_t> index(n), part(n, n);
    for (auto start = order.rbegin(); start != order.rend(); ++start) {
        if (isSeen[*start]) continue;
        std::vector<std::size_t> nodes;
        visit(reversed, *start, nodes);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            index[nodes[k]] = k;
            part[nodes[k]] = parts.size();
        }
        Graph own(nodes.size());
        for (std::size_t k = 0; k < nodes.size(); ++k)
            for (const Edge& edge : graph[nodes[k]])
                if (part[edge.to] == parts.size()) own[k].push_back({index[edge.to], edge.logarithm});
        parts.push_back(std::move(own));
    }
    return parts;
}

// The spectral radius of the matrix of |weight|^t, between the least and the largest ratio by which it
// stretches a positive vector (Collatz and Wielandt). Adding the identity keeps it from going round and
// round.
std::optional<double> spectralRadius(const Graph& part, double t, const std::stop_token& stop) {
    constexpr int maxRounds = 20'000;
    constexpr double tight = 1e-12;
    if (part.size() == 1 && part[0].empty()) return 0;
    std::vector<std::vector<double>> weights(part.size());
    for (std::size_t k = 0; k < part.size(); ++k)
        for (const Edge& edge : part[k])
            weights[k].push_back(std::exp(t * edge.logarithm));
    std::vector<double> f(part.size(), 1), next(part.size());
    for (int round = 0; round < maxRounds && !stop.stop_requested(); ++round) {
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            next[k] = 0;
            for (std::size_t e = 0; e < part[k].size(); ++e)
                next[k] += weights[k][e] * f[part[k][e].to];
            least = std::min(least, next[k] / f[k]);
            most = std::max(most, next[k] / f[k]);
        }
        const double middle = (least + most) / 2;
        if (most - least <= tight * most) return middle;
        for (std::size_t k = 0; k < part.size(); ++k)
            f[k] = (next[k] / middle + f[k]) / 2;
    }
    return std::nullopt;
}

} // namespace

bool isFlat(const Matrix<2>& linear) {
    const double size = linear.cwiseAbs().maxCoeff();
    if (size == 0) return true;
    const Matrix<2> m = linear / size;
    return std::abs(m.determinant()) <=
           4 * roundingUnit * (std::abs(m(0, 0) * m(1, 1)) + std::abs(m(0, 1) * m(1, 0)));
}

std::optional<double> rankOneDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop) {
    constexpr std::size_t maxMaps = 400;
    if (maps.size() > maxMaps) return std::nullopt;
    const std::vector<Graph> parts = strongParts(graphOf(maps));
    bool isSettled = true;
    const auto growth = [&](double t) {
        double most = 0;
        for (const Graph& part : parts) {
            const auto radius = spectralRadius(part, t, stop);
            isSettled = isSettled && radius;
            most = std::max(most, radius.value_or(0));
        }
        return most;
    };
    double low = 0, high = 1;
    if (growth(0) <= 1 + 1e-10) high = 0;            // no two cycles through any map
    if (high > 0 && growth(1) >= 1 - 1e-12) low = 1; // images are lines without area
    constexpr int steps = 32;
    for (int n = 0; n < steps && low < high && isSettled; ++n) {
        const double middle = (low + high) / 2;
        (growth(middle) > 1 ? low : high) = middle;
    }
    return isSettled ? std::optional((low + high) / 2) : std::nullopt;
}

} // namespace ifs
