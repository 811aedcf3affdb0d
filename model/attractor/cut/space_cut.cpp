// SPDX-License-Identifier: MIT
#include "attractor/cut/space_cut.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/cut/thinning.h"
#include "attractor/kernels/sample_set.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

struct SpaceNode {
    ifs::AffineMap<3> word; // box → SpaceView::toPixels
    SeenWord seen;
    double probability = 1;
    PaletteInterval colours{};
    std::uint64_t key = 0;
    std::uint32_t firstMap = 0;
    int depth = 0;
};

class SpaceTree {
public:
    SpaceTree(const PreparedSpace& system, const SpaceView& view, const SpaceCutSettings& settings)
        : m_system(system), m_view(view), m_settings(settings) {
        for (const ifs::AffineMap<3>& map : system.maps)
            m_maps.push_back(system.inBox(map));
        if (m_settings.colours.empty()) m_settings.colours = ColourCoordinates(system.maps.size());
    }

    SpaceCut cut(const std::stop_token& stop) {
        // First estimates the measure in view, then cuts. The threshold is a power of two, so that words keep
        // their identity under small changes of the view or a map. With everything in view, rounding cannot
        // decide between two thresholds.
        double visible = 0;
        for (const SpaceNode& node : leaves(16.0 / m_settings.words, stop))
            visible += node.probability;
        double threshold = 1;
        while (threshold > 0 && threshold > visible / m_settings.words * (1 + rounding))
            threshold /= 2;
        m_enough = m_settings.samples > 0 ? minSamples / m_settings.samples * visible : 0;
        m_oneColour = std::max(m_enough, m_settings.colours.minShare() * visible);
        m_followsBend = true;
        m_thinnings = 0;
        SpaceCut result = words(leaves(threshold, stop));
        result.isThinned = m_thinnings > 0;
        return stop.stop_requested() ? SpaceCut{} : result;
    }

private:
    static constexpr std::size_t maxWords = 1U << 16;
    static constexpr std::size_t maxVisits = 1U << 22;
    static constexpr double maxBend = 0.25;  // cells
    static constexpr double minSize = 0.25;  // cells; smaller words need no division
    static constexpr double rounding = 1e-9; // relative error bound of a sum of probabilities
    static constexpr double minSamples = 32;

    // Displayed pieces that meet the view.
    std::vector<SpaceNode> roots() const {
        std::vector<SpaceNode> result;
        SpaceNode root;
        root.word = m_view.toPixels * m_system.fromBox();
        root.seen = seen(root.word, m_view);
        for (const PreparedSpace::Piece& piece : m_system.pieces()) {
            SpaceNode node = root;
            for (const int letter : piece.word)
                node = child(node, static_cast<std::size_t>(letter));
            if (piece.isMoved) {
                node.word = root.word * piece.map;
                node.seen = seen(node.word, m_view);
            }
            if (node.seen.meets(m_view.size)) result.push_back(node);
        }
        return result;
    }

    SpaceNode child(const SpaceNode& node, std::size_t i) const {
        SpaceNode result;
        result.word = node.word * m_maps[i];
        result.seen = seen(result.word, m_view);
        result.probability = node.probability * m_system.probabilities[i];
        result.colours = m_settings.colours.child(node.colours, i);
        result.key = mixed(node.key + i + 1);
        result.firstMap = node.depth == 0 ? static_cast<std::uint32_t>(i) : node.firstMap;
        result.depth = node.depth + 1;
        return result;
    }

    bool isBent(const SpaceNode& node) const {
        return m_followsBend && (node.seen.isCut || !(node.seen.miss <= maxBend && !node.seen.reachesEye));
    }

    bool isExact(const SpaceNode& node) const {
        return m_settings.exactness == Exactness::All || isBent(node);
    }

    bool isLeaf(const SpaceNode& node, double threshold) const {
        if (node.depth < m_settings.minDepth) return false;
        if (!m_system.contracts) return true;
        const double size = 2 * std::max(node.seen.half.x(), node.seen.half.y());
        const double most = 2.0 * std::max(m_view.size.width, m_view.size.height);
        const bool isSmall = node.probability <= threshold && size <= most;
        const bool isMixed = node.probability > m_oneColour && m_settings.colours.isMixed(node.colours);
        return ((isSmall && !isMixed) || size <= minSize) && (!isBent(node) || node.probability <= m_enough);
    }

    // Divides level by level.
    std::vector<SpaceNode> leaves(double threshold, const std::stop_token& stop) {
        std::vector<SpaceNode> done;
        std::vector<SpaceNode> open = roots();
        std::vector<SpaceNode> next;
        std::size_t visits = 0;
        while (!open.empty()) {
            std::erase_if(open, [&](const SpaceNode& node) {
                if (!isLeaf(node, threshold)) return false;
                done.push_back(node);
                return true;
            });
            if (open.size() * m_maps.size() + done.size() > 4 * maxWords)
                thinOut(open, std::max<std::size_t>(64, maxWords / m_maps.size()));
            next.clear();
            for (const SpaceNode& node : open)
                for (std::size_t i = 0; i < m_maps.size(); ++i) {
                    if (++visits % 4096 == 0 && stop.stop_requested()) return {};
                    const SpaceNode candidate = child(node, i);
                    if (candidate.seen.meets(m_view.size)) next.push_back(candidate);
                }
            open.swap(next);
            if (visits > maxVisits) break;
        }
        done.insert(done.end(), open.begin(), open.end());
        return done;
    }

    void thinOut(std::vector<SpaceNode>& nodes, std::size_t wanted) {
        if (nodes.size() <= wanted) return;
        attractor::thinOut(nodes, wanted, m_settings.seed + nodes.size() + (m_thinnings++ << 32));
    }

    SpaceCut words(const std::vector<SpaceNode>& nodes) const {
        SpaceCut result;
        for (const SpaceNode& node : nodes)
            if (!isExact(node)) add(node, result);
        result.firstExact = result.words.size();
        for (const SpaceNode& node : nodes)
            if (isExact(node)) {
                add(node, result);
                result.exact.push_back(straightened(node.word, m_view).word);
            }
        return result;
    }

    void add(const SpaceNode& node, SpaceCut& cut) const {
        const ifs::AffineMap<3>& map = node.seen.onScreen;
        SpaceWord word;
        for (int k = 0; k < 3; ++k) {
            word.shown.column[static_cast<std::size_t>(k)] = static_cast<float>(map.linear(0, k));
            word.shown.row[static_cast<std::size_t>(k)] = static_cast<float>(map.linear(1, k));
        }
        word.shown.x = static_cast<float>(map.translation.x());
        word.shown.y = static_cast<float>(map.translation.y());
        word.halfX = static_cast<float>(node.seen.half.x());
        word.halfY = static_cast<float>(node.seen.half.y());
        word.firstMap = node.firstMap;
        // Multiple of the widest vector.
        word.offset = static_cast<std::uint32_t>(node.key % (SampleSet::size / 16)) * 16;
        word.probability = node.probability;
        word.addressCoordinate = m_settings.colours.middle(node.colours);
        cut.words.push_back(word);
        cut.probability += node.probability;
    }

    const PreparedSpace& m_system;
    const SpaceView& m_view;
    SpaceCutSettings m_settings;
    std::vector<ifs::AffineMap<3>> m_maps; // maps in box coordinates
    bool m_followsBend = false;
    double m_enough = 0;    // probability below which samples are projected one by one
    double m_oneColour = 1; // probability below which a word has one colour, however its points differ
    std::uint64_t m_thinnings = 0;
};

} // namespace

SpaceCut spaceCut(const PreparedSpace& system, const SpaceView& view, const SpaceCutSettings& settings,
                  const std::stop_token& stop) {
    if (system.maps.empty()) return {};
    return SpaceTree(system, view, settings).cut(stop);
}

} // namespace attractor
