// SPDX-License-Identifier: MIT
#include "ifs/extent/address_search.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace ifs {

namespace {

constexpr std::size_t lookedAtPerNode = 10; // words beyond reach cost less
constexpr std::size_t lookedAtPerMap = 24;
constexpr std::size_t followedPerNode = 256; // of more children within reach, those with x in the middle

struct Node {
    double nearest = 0; // no point of the piece is nearer than this to x
    double aside = 0;   // how far x is from the middle of the ball around the piece, in its radii
    double radius = 0;  // of that ball
    AffineMap<2> map;
    int sought = 0;
    int parent = -1; // −1: its beginning
    int symbol = 0;
    int length = 0;
};

// The nearest first; of those that may be equally near, the longest, so that ties do not widen the search; of
// those the one with x in its middle, so that few lead astray.
struct Later {
    const std::vector<Node>& nodes;
    bool operator()(int a, int b) const {
        const Node &p = nodes[std::size_t(a)], &q = nodes[std::size_t(b)];
        if (p.nearest != q.nearest) return p.nearest > q.nearest;
        if (p.length != q.length) return p.length < q.length;
        return p.aside != q.aside ? p.aside > q.aside : a > b;
    }
};

AddressMatch found(const std::vector<Node>& nodes, std::size_t index, double distance,
                   std::span<const AddressQuery> sought) {
    Word after;
    for (; nodes[index].parent >= 0; index = std::size_t(nodes[index].parent))
        after.push_back(nodes[index].symbol);
    Word address = sought[std::size_t(nodes[index].sought)].beginning;
    address.insert(address.end(), after.rbegin(), after.rend());
    return {std::move(address), distance};
}

// A lower bound of the distance from x to the image of the ball around the attractor: an ellipse, of which
// the circle around it says little once it is long. In the ball's own coordinates x is so far outside, and no
// direction shrinks by more than the least singular value.
double distanceToImage(const AffineMap<2>& map, const SupportFunction<2>& attractor, const Vector<2>& x) {
    const auto back = inverse(map);
    if (!back) return 0;
    const double stretch = spectralNorm<2>(back->linear);
    const double outside = ((*back)(x)-attractor.centre()).norm() - attractor.radius();
    const double condition = spectralNorm<2>(map.linear) * stretch;
    const double rounding =
        0x1p-48 * (x.norm() + map.translation.norm() + condition * (x - map.translation).norm());
    return outside / stretch - rounding;
}

double distanceTo(const Node& node, const SupportFunction<2>& attractor, const AddressQuery& sought) {
    return (node.map(attractor.pointOfAttractor()) - sought.x).norm() / sought.scale;
}

bool isDetail(const Node& node, const AddressQuery& sought, double width) {
    return node.length > 0 && 2 * node.radius <= width * sought.scale;
}

// Where pieces overlap a great deal, all of those that are nearest cannot be looked at; a near one will do.
std::optional<AddressMatch> bestOf(const std::vector<Node>& nodes, const SupportFunction<2>& attractor,
                                   std::span<const AddressQuery> sought, double reach, double width) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const AddressQuery& within = sought[std::size_t(nodes[k].sought)];
        if (!isDetail(nodes[k], within, width)) continue;
        const double distance = distanceTo(nodes[k], attractor, within);
        if (distance > reach) continue;
        reach = distance;
        best = k;
    }
    return best ? std::optional(found(nodes, *best, reach, sought)) : std::nullopt;
}

} // namespace

std::optional<AddressMatch> addressNear(const SupportFunction<2>& attractor,
                                        std::span<const AddressQuery> sought, double reach, double width,
                                        int maxNodes) {
    const std::vector<AffineMap<2>>& maps = attractor.maps();
    std::vector<Node> nodes;
    std::priority_queue<int, std::vector<int>, Later> open(Later{nodes});
    const auto consider = [&](Node node, double outer) {
        const AddressQuery& within = sought[std::size_t(node.sought)];
        node.radius = spectralNorm<2>(node.map.linear) * attractor.radius();
        const double distance = (within.x - node.map(attractor.centre())).norm();
        node.nearest = std::max(outer, (distance - node.radius) / within.scale);
        if (node.nearest > reach) return;
        node.nearest = std::max(node.nearest, distanceToImage(node.map, attractor, within.x) / within.scale);
        if (node.nearest > reach) return;
        node.aside = node.radius > 0 ? distance / node.radius : 0;
        nodes.push_back(node);
    };
    const auto follow = [&](std::size_t first) {
        const auto children = nodes.begin() + std::ptrdiff_t(first);
        if (nodes.size() - first > followedPerNode) {
            const auto end = children + std::ptrdiff_t(followedPerNode);
            std::nth_element(children, end, nodes.end(), [](const Node& a, const Node& b) {
                return a.nearest != b.nearest ? a.nearest < b.nearest : a.aside < b.aside;
            });
            nodes.erase(end, nodes.end());
        }
        for (std::size_t k = first; k < nodes.size(); ++k)
            open.push(int(k));
    };
    for (std::size_t k = 0; k < sought.size(); ++k)
        consider({.map = composed<2>(maps, sought[k].beginning),
                  .sought = int(k),
                  .length = int(sought[k].beginning.size())},
                 0);
    follow(0);
    const std::size_t maxLookedAt =
        lookedAtPerNode * std::size_t(std::max(maxNodes, 1)) + lookedAtPerMap * maps.size();
    for (std::size_t lookedAt = 0; !open.empty(); lookedAt += maps.size()) {
        const auto top = std::size_t(open.top());
        open.pop();
        const Node node = nodes[top];
        const AddressQuery& within = sought[std::size_t(node.sought)];
        if (isDetail(node, within, width))
            return found(nodes, top, distanceTo(node, attractor, within), sought);
        if (nodes.size() > std::size_t(maxNodes) || lookedAt > maxLookedAt)
            return bestOf(nodes, attractor, sought, reach, width);
        const std::size_t first = nodes.size();
        for (std::size_t i = 0; i < maps.size(); ++i)
            consider({.map = node.map * maps[i],
                      .sought = node.sought,
                      .parent = int(top),
                      .symbol = int(i),
                      .length = node.length + 1},
                     node.nearest);
        follow(first);
    }
    return std::nullopt;
}

} // namespace ifs
