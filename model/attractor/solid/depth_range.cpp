// SPDX-License-Identifier: MIT
#include "attractor/solid/depth_range.h"

#include <algorithm>
#include <vector>

namespace attractor {

namespace {

struct Open {
    double depth = 0; // priority: larger towards the sought end
    double half = 0;  // half extent of the word's depths; among equals, smaller first
    bool reachesEye = false;
    WalkedWord word;
    friend bool operator<(const Open& a, const Open& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.half > b.half);
    }
};

enum class End { Near, Far };

// Best first: until the word that reaches farthest is so small that it is as good as a point.
class Search {
public:
    Search(const PreparedSpace& system, const SpaceView& view, End end)
        : m_view(view), m_sign(end == End::Near ? -1 : 1) {
        for (const ifs::AffineMap<3>& map : system.maps)
            m_maps.push_back(system.inBox(map));
        const ifs::AffineMap<3> box = view.toPixels * system.fromBox();
        for (const PreparedSpace::Piece& piece : system.pieces())
            add(piece.isMoved ? WalkedWord{box * piece.map}
                              : walkedTo(piece.word, rootWord(box, view), m_maps, view));
    }

    // Returns −HUGE_VAL if nothing is in view.
    double run(bool mayDivide, const std::stop_token& stop) {
        constexpr double small = 4; // pixels
        constexpr std::size_t maxWords = 1U << 17;
        double found = -HUGE_VAL;
        std::size_t words = 0;
        while (!m_open.empty()) {
            const Open best = m_open.front();
            words += m_maps.size();
            const bool isSmall = !best.reachesEye && 2 * best.half <= small;
            if (isSmall || !mayDivide || words > maxWords || stop.stop_requested()) {
                found = best.depth;
                break;
            }
            std::pop_heap(m_open.begin(), m_open.end());
            m_open.pop_back();
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                add(childWord(best.word, i, m_maps[i], m_view));
        }
        return m_sign * found;
    }

private:
    void add(WalkedWord word) {
        const SeenWord it = seen(word, m_view);
        if (!it.meets(m_view.size)) return;
        const double half = it.half.z();
        double depth = m_sign * it.onScreen.translation.z() + half;
        if (m_view.isPerspective() && m_sign < 0)
            depth = std::min(depth, m_view.eyeDistance * (1 - nearestShare));
        m_open.push_back({depth, half, it.reachesEye, std::move(word)});
        std::push_heap(m_open.begin(), m_open.end());
    }

    const SpaceView& m_view;
    double m_sign;
    std::vector<ifs::AffineMap<3>> m_maps; // maps in box coordinates
    std::vector<Open> m_open;
};

} // namespace

DepthRange depthRange(const PreparedSpace& system, const SpaceView& view, const std::stop_token& stop) {
    DepthRange range;
    range.near = Search(system, view, End::Near).run(system.contracts, stop);
    range.far = Search(system, view, End::Far).run(system.contracts, stop);
    if (!(range.near <= range.far)) return {1, 0, false};
    // Room for rounding, which also makes the range positive.
    const double room = 0.5 + 1e-12 * std::max(std::abs(range.near), std::abs(range.far));
    range.near -= room;
    range.far += room;
    if (range.far - range.near > DepthRange::maxLength) {
        range.far = range.near + DepthRange::maxLength;
        range.isClamped = true;
    }
    return range;
}

} // namespace attractor
