// SPDX-License-Identifier: MIT
#include "ifs/extent/address_search.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace ifs {

namespace {

constexpr std::size_t lookedAtPerNode = 10; // words out of reach per node, because they cost less
constexpr std::size_t lookedAtPerMap = 24;
// Children per node; of more, those with x nearest to the middle are followed.
constexpr std::size_t followedPerNode = 256;

template <int Dim> struct Node {
    double nearest = 0; // lower bound of the distance from x to the piece
    double aside = 0;   // distance of x from the centre of the ball around the piece, in its radii
    double radius = 0;  // radius of that ball
    AffineMap<Dim> map;
    int sought = 0;
    int parent = -1; // index of its beginning without the last symbol; −1: none
    int symbol = 0;
    int length = 0;
};

// The nearest first; of those that may be equally near, the longest, so that ties do not widen the search; of
// those the one with x in its middle, so that few lead astray.
template <int Dim> struct Later {
    const std::vector<Node<Dim>>& nodes;
    bool operator()(int a, int b) const {
        const Node<Dim>&p = nodes[std::size_t(a)], &q = nodes[std::size_t(b)];
        if (p.nearest != q.nearest) return p.nearest > q.nearest;
        if (p.length != q.length) return p.length < q.length;
        return p.aside != q.aside ? p.aside > q.aside : a > b;
    }
};

template <int Dim>
AddressMatch found(const std::vector<Node<Dim>>& nodes, std::size_t index, double distance,
                   std::span<const AddressQueryIn<Dim>> sought) {
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
template <int Dim>
double distanceToImage(const AffineMap<Dim>& map, const SupportFunction<Dim>& attractor,
                       const Vector<Dim>& x) {
    const auto back = inverse(map);
    if (!back) return 0;
    const double stretch = spectralNorm<Dim>(back->linear);
    const double outside = ((*back)(x)-attractor.centre()).norm() - attractor.radius();
    const double condition = spectralNorm<Dim>(map.linear) * stretch;
    const double rounding =
        0x1p-48 * (x.norm() + map.translation.norm() + condition * (x - map.translation).norm());
    return outside / stretch - rounding;
}

template <int Dim>
double distanceTo(const Node<Dim>& node, const SupportFunction<Dim>& attractor,
                  const AddressQueryIn<Dim>& sought) {
    return (node.map(attractor.pointOfAttractor()) - sought.x).norm() / sought.scale;
}

template <int Dim> bool isDetail(const Node<Dim>& node, const AddressQueryIn<Dim>& sought, double width) {
    return node.length > 0 && 2 * node.radius <= width * sought.scale;
}

// The best match among the nodes. Where pieces overlap a great deal, not all of the nearest can be examined;
// a near one will do.
template <int Dim>
std::optional<AddressMatch> bestOf(const std::vector<Node<Dim>>& nodes, const SupportFunction<Dim>& attractor,
                                   std::span<const AddressQueryIn<Dim>> sought, double reach, double width) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const AddressQueryIn<Dim>& within = sought[std::size_t(nodes[k].sought)];
        if (!isDetail<Dim>(nodes[k], within, width)) continue;
        const double distance = distanceTo<Dim>(nodes[k], attractor, within);
        if (distance > reach) continue;
        reach = distance;
        best = k;
    }
    return best ? std::optional(found<Dim>(nodes, *best, reach, sought)) : std::nullopt;
}

} // namespace

template <int Dim>
std::optional<AddressMatch> addressNear(const SupportFunction<Dim>& attractor,
                                        std::type_identity_t<std::span<const AddressQueryIn<Dim>>> sought,
                                        double reach, double width, int maxNodes) {
    const std::vector<AffineMap<Dim>>& maps = attractor.maps();
    std::vector<Node<Dim>> nodes;
    std::priority_queue<int, std::vector<int>, Later<Dim>> open(Later<Dim>{nodes});
    const auto consider = [&](Node<Dim> node, double outer) {
        const AddressQueryIn<Dim>& within = sought[std::size_t(node.sought)];
        node.radius = spectralNorm<Dim>(node.map.linear) * attractor.radius();
        const double distance = (within.x - node.map(attractor.centre())).norm();
        node.nearest = std::max(outer, (distance - node.radius) / within.scale);
        if (node.nearest > reach) return;
        node.nearest =
            std::max(node.nearest, distanceToImage<Dim>(node.map, attractor, within.x) / within.scale);
        if (node.nearest > reach) return;
        node.aside = node.radius > 0 ? distance / node.radius : 0;
        nodes.push_back(node);
    };
    const auto follow = [&](std::size_t first) {
        const auto children = nodes.begin() + std::ptrdiff_t(first);
        if (nodes.size() - first > followedPerNode) {
            const auto end = children + std::ptrdiff_t(followedPerNode);
            std::nth_element(children, end, nodes.end(), [](const Node<Dim>& a, const Node<Dim>& b) {
                return a.nearest != b.nearest ? a.nearest < b.nearest : a.aside < b.aside;
            });
            nodes.erase(end, nodes.end());
        }
        for (std::size_t k = first; k < nodes.size(); ++k)
            open.push(int(k));
    };
    for (std::size_t k = 0; k < sought.size(); ++k)
        consider({.map = composed<Dim>(maps, sought[k].beginning),
                  .sought = int(k),
                  .length = int(sought[k].beginning.size())},
                 0);
    follow(0);
    const std::size_t maxLookedAt =
        lookedAtPerNode * std::size_t(std::max(maxNodes, 1)) + lookedAtPerMap * maps.size();
    for (std::size_t lookedAt = 0; !open.empty(); lookedAt += maps.size()) {
        const auto top = std::size_t(open.top());
        open.pop();
        const Node<Dim> node = nodes[top];
        const AddressQueryIn<Dim>& within = sought[std::size_t(node.sought)];
        if (isDetail<Dim>(node, within, width))
            return found<Dim>(nodes, top, distanceTo<Dim>(node, attractor, within), sought);
        if (nodes.size() > std::size_t(maxNodes) || lookedAt > maxLookedAt)
            return bestOf<Dim>(nodes, attractor, sought, reach, width);
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

template std::optional<AddressMatch> addressNear<2>(const SupportFunction<2>&,
                                                    std::span<const AddressQueryIn<2>>, double, double, int);
template std::optional<AddressMatch> addressNear<3>(const SupportFunction<3>&,
                                                    std::span<const AddressQueryIn<3>>, double, double, int);

} // namespace ifs
