// SPDX-License-Identifier: MIT
#include "ifs/address_search.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace ifs {

namespace {

struct Node {
    double nearest = 0; // no point of the piece is nearer than this to x
    double radius = 0;  // of the ball around the piece
    AffineMap<2> map;
    int parent = -1;
    int symbol = 0;
    int length = 0;
};

// The nearest first; of those that may be equally near, the longest, so that ties do not widen the search.
struct Later {
    const std::vector<Node>& nodes;
    bool operator()(int a, int b) const {
        const Node &p = nodes[std::size_t(a)], &q = nodes[std::size_t(b)];
        if (p.nearest != q.nearest) return p.nearest > q.nearest;
        return p.length != q.length ? p.length < q.length : a > b;
    }
};

Word spelled(const std::vector<Node>& nodes, int node) {
    Word word;
    for (; nodes[std::size_t(node)].parent >= 0; node = nodes[std::size_t(node)].parent)
        word.push_back(nodes[std::size_t(node)].symbol);
    std::ranges::reverse(word);
    return word;
}

// Where pieces overlap a great deal, all of those that are nearest cannot be looked at; a near one will do.
std::optional<Addressed> bestOf(const std::vector<Node>& nodes, const SupportFunction<2>& attractor,
                                const Vector<2>& x, double reach, double width) {
    int best = -1;
    double least = reach;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (2 * nodes[k].radius > width) continue;
        const double distance = (nodes[k].map(attractor.pointOfAttractor()) - x).norm();
        if (distance <= least) {
            least = distance;
            best = int(k);
        }
    }
    if (best < 0) return std::nullopt;
    return Addressed{spelled(nodes, best), least};
}

} // namespace

std::optional<Addressed> addressNear(const SupportFunction<2>& attractor, const Vector<2>& x, double reach,
                                     double width, const Word& beginning, int maxNodes) {
    const std::vector<AffineMap<2>>& maps = attractor.maps();
    std::vector<Node> nodes{{.radius = attractor.radius(), .map = {}}};
    const auto add = [&](int parent, int symbol) {
        const Node& outer = nodes[std::size_t(parent)];
        const AffineMap<2> map = outer.map * maps[std::size_t(symbol)];
        const double radius = spectralNorm<2>(map.linear) * attractor.radius();
        const double nearest = std::max(outer.nearest, (x - map(attractor.centre())).norm() - radius);
        nodes.push_back({nearest, radius, map, parent, symbol, outer.length + 1});
        return int(nodes.size()) - 1;
    };
    int first = 0;
    for (const int symbol : beginning)
        first = add(first, symbol);
    std::priority_queue<int, std::vector<int>, Later> open(Later{nodes});
    open.push(first);
    while (!open.empty()) {
        const int top = open.top();
        open.pop();
        const Node node = nodes[std::size_t(top)];
        if (node.nearest > reach) return std::nullopt;
        if (node.length > 0 && 2 * node.radius <= width) {
            const double distance = (node.map(attractor.pointOfAttractor()) - x).norm();
            return Addressed{spelled(nodes, top), distance};
        }
        if (nodes.size() + maps.size() > std::size_t(maxNodes))
            return bestOf(nodes, attractor, x, reach, width);
        for (std::size_t i = 0; i < maps.size(); ++i)
            open.push(add(top, int(i)));
    }
    return std::nullopt;
}

} // namespace ifs
