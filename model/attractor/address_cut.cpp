// SPDX-License-Identifier: MIT
#include "attractor/address_cut.h"

#include "attractor/arithmetic.h"
#include "attractor/chaos_game.h"
#include "attractor/double_double.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

// camera·cage·w_σ(centre + δ) = offset + linear·δ, in cells.
template <class Real> struct Node {
    Real xx, xy, yx, yy;
    Real x, y;
    double probability = 1;
    double place = 0; // Σ σ_k N^−k
    double step = 1;  // N^−|σ|
    std::uint64_t key = 0;
    std::uint32_t firstMap = 0;
    int depth = 0;
};

template <class Real> struct Branch {
    Real xx, xy, yx, yy;
    Real x, y; // w_i(centre) − centre
    double probability = 0;
};

template <class Real> class Tree {
public:
    Tree(const DrawableSystem& system, const Projection& projection, const CutSettings& settings)
        : m_settings(settings),
          m_halfX(system.halfExtent.x()),
          m_halfY(system.halfExtent.y()),
          m_width(projection.grid.width),
          m_height(projection.grid.height),
          m_kept(std::clamp<std::size_t>((std::size_t{1} << 23) / system.maps.size(), 256, most)),
          m_root(root(system, projection)) {
        m_largest = 2.0 * std::max(m_width, m_height);
        for (std::size_t i = 0; i < system.maps.size(); ++i)
            m_branches.push_back(branch(system.maps[i], system.centre, system.probabilities[i]));
    }

    AddressCut cut(const std::stop_token& stop) {
        // First the measure in view, coarsely; then the cut, whose threshold is a power of two so that words
        // keep their identity while the view moves a little.
        const std::vector<Node<Real>> coarse = leaves(m_settings.words / 16.0, Threshold::Relative, stop);
        double visible = 0;
        for (const Node<Real>& node : coarse)
            visible += node.probability;
        double threshold = 1;
        while (threshold > 0 && threshold > visible / m_settings.words)
            threshold /= 2;
        AddressCut result;
        for (const Node<Real>& node : leaves(threshold, Threshold::Absolute, stop)) {
            result.words.push_back(word(node));
            result.probability += node.probability;
        }
        return stop.stop_requested() ? AddressCut{} : result;
    }

private:
    enum class Threshold { Absolute, Relative };

    static constexpr std::size_t most = 1U << 15;         // words kept while refining
    static constexpr std::size_t mostWaiting = 32 * most; // words of the next level before refining it
    static constexpr std::size_t mostVisits = 3'000'000;
    static constexpr double smallest = 0.25; // cells; below, splitting shows nothing new

    static Node<Real> root(const DrawableSystem& system, const Projection& projection) {
        const ifs::Matrix<2> linear = projection.scale * projection.cage.linear;
        Node<Real> node;
        node.xx = linear(0, 0);
        node.xy = linear(0, 1);
        node.yx = linear(1, 0);
        node.yy = linear(1, 1);
        const auto shown = [&](int row) { // of the cage applied to the centre, relative to the camera
            return Real(projection.cage.linear(row, 0)) * Real(system.centre.x()) +
                   Real(projection.cage.linear(row, 1)) * Real(system.centre.y()) +
                   (Real(projection.cage.translation[row]) - Real(projection.centre[row]));
        };
        node.x = Real(projection.scale(0, 0)) * shown(0) + Real(projection.grid.width / 2.0);
        node.y = Real(projection.scale(1, 1)) * shown(1) + Real(projection.grid.height / 2.0);
        return node;
    }

    static Branch<Real> branch(const ifs::AffineMap<2>& map, const ifs::Vector<2>& centre,
                               double probability) {
        const auto shift = [&](int row) {
            return Real(map.linear(row, 0)) * Real(centre.x()) + Real(map.linear(row, 1)) * Real(centre.y()) +
                   (Real(map.translation[row]) - Real(centre[row]));
        };
        return {map.linear(0, 0), map.linear(0, 1), map.linear(1, 0), map.linear(1, 1),
                shift(0),         shift(1),         probability};
    }

    Node<Real> child(const Node<Real>& node, std::size_t i) const {
        const Branch<Real>& b = m_branches[i];
        Node<Real> result;
        result.xx = node.xx * b.xx + node.xy * b.yx;
        result.xy = node.xx * b.xy + node.xy * b.yy;
        result.yx = node.yx * b.xx + node.yy * b.yx;
        result.yy = node.yx * b.xy + node.yy * b.yy;
        result.x = node.x + (node.xx * b.x + node.xy * b.y);
        result.y = node.y + (node.yx * b.x + node.yy * b.y);
        result.probability = node.probability * b.probability;
        result.step = node.step / static_cast<double>(m_branches.size());
        result.place = node.place + static_cast<double>(i) * result.step;
        result.key = mixed(node.key + i + 1);
        result.firstMap = node.depth == 0 ? static_cast<std::uint32_t>(i) : node.firstMap;
        result.depth = node.depth + 1;
        return result;
    }

    struct Extent {
        double x = 0;
        double y = 0;
    };
    Extent extent(const Node<Real>& node) const {
        const auto size = [](const Real& value) { return std::abs(static_cast<double>(value)); };
        return {size(node.xx) * m_halfX + size(node.xy) * m_halfY,
                size(node.yx) * m_halfX + size(node.yy) * m_halfY};
    }

    bool visible(const Node<Real>& node, const Extent& half) const { // false for anything not finite
        const auto x = static_cast<double>(node.x);
        const auto y = static_cast<double>(node.y);
        return x + half.x >= 0 && x - half.x <= m_width && y + half.y >= 0 && y - half.y <= m_height;
    }

    bool isLeaf(const Node<Real>& node, const Extent& half, double threshold) const {
        const double size = 2 * std::max(half.x, half.y);
        return node.depth >= m_settings.maxDepth || (node.depth >= m_settings.minDepth && size <= m_largest &&
                                                     (node.probability <= threshold || size <= smallest));
    }

    // Level by level. With Threshold::Relative the limit is a number of words, each at most its share of what
    // is visible so far.
    std::vector<Node<Real>> leaves(double limit, Threshold kind, const std::stop_token& stop) const {
        std::vector<Node<Real>> done;
        std::vector<Node<Real>> open;
        if (visible(m_root, extent(m_root))) open.push_back(m_root);
        std::size_t visits = 0;
        double settled = 0;
        std::vector<Node<Real>> next;
        while (!open.empty() && visits < mostVisits && !stop.stop_requested()) {
            double threshold = limit;
            if (kind == Threshold::Relative) {
                double total = settled;
                for (const Node<Real>& node : open)
                    total += node.probability;
                threshold = total / limit;
            }
            visits += open.size();
            next.clear();
            for (const Node<Real>& node : open) {
                if (isLeaf(node, extent(node), threshold)) {
                    done.push_back(node);
                    settled += node.probability;
                    continue;
                }
                for (std::size_t i = 0; i < m_branches.size(); ++i) {
                    const Node<Real> candidate = child(node, i);
                    if (visible(candidate, extent(candidate))) next.push_back(candidate);
                }
                if (next.size() > mostWaiting) thinOut(next, most);
            }
            open.swap(next);
            if (open.size() > m_kept) thinOut(open, m_kept);
        }
        done.insert(done.end(), open.begin(), open.end());
        return done;
    }

    // Overlapping systems have exponentially many words in a small view. A systematic sample of them, each
    // standing for its share, keeps every estimate unbiased.
    void thinOut(std::vector<Node<Real>>& nodes, std::size_t wanted) const {
        double total = 0;
        for (const Node<Real>& node : nodes)
            total += node.probability;
        const double share = 2 * total / static_cast<double>(wanted);
        double sum =
            static_cast<double>(mixed(m_settings.seed + static_cast<std::uint64_t>(nodes.size())) >> 11) *
            0x1p-53 * share;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            Node<Real> node = nodes[k];
            if (node.probability < share) {
                sum += node.probability;
                if (sum < share) continue;
                sum -= share;
                node.probability = share;
            }
            nodes[kept++] = node;
        }
        nodes.resize(kept);
    }

    Word word(const Node<Real>& node) const {
        const auto entry = [](const Real& value, double half) {
            return static_cast<float>(static_cast<double>(value) * half);
        };
        Word result;
        result.xx = entry(node.xx, m_halfX);
        result.xy = entry(node.xy, m_halfY);
        result.yx = entry(node.yx, m_halfX);
        result.yy = entry(node.yy, m_halfY);
        result.x = entry(node.x, 1);
        result.y = entry(node.y, 1);
        result.firstMap = node.firstMap;
        // Runs begin at multiples of the widest vector.
        result.offset = static_cast<std::uint32_t>(node.key % (SampleSet::size / 16)) * 16;
        result.probability = node.probability;
        result.addressCoordinate = node.place + node.step / 2;
        return result;
    }

    CutSettings m_settings;
    double m_halfX;
    double m_halfY;
    double m_width;
    double m_height;
    double m_largest = 0;
    std::size_t m_kept; // fewer where every word has thousands of children
    Node<Real> m_root;
    std::vector<Branch<Real>> m_branches;
};

} // namespace

Projection projection(const Camera& camera, const ifs::AffineMap<2>& cage, int cellsPerPixel) {
    Projection result;
    result.scale = worldToPixel(camera).linear * cellsPerPixel;
    result.cage = cage;
    result.centre = camera.centre;
    result.grid = {camera.width * cellsPerPixel, camera.height * cellsPerPixel};
    return result;
}

AddressCut addressCut(const DrawableSystem& system, const Projection& projection, const CutSettings& settings,
                      std::stop_token stop) {
    if (system.maps.empty()) return {};
    const double reach = (projection.cage(system.centre) - projection.centre).cwiseAbs().maxCoeff() +
                         projection.cage.linear.cwiseAbs().maxCoeff() * system.halfExtent.maxCoeff();
    const bool deep = projection.scale.cwiseAbs().maxCoeff() * reach > 1e9;
    return deep ? Tree<DoubleDouble>(system, projection, settings).cut(stop)
                : Tree<double>(system, projection, settings).cut(stop);
}

} // namespace attractor
