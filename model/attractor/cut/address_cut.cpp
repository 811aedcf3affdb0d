// SPDX-License-Identifier: MIT
#include "attractor/cut/address_cut.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/arithmetic/double_double.h"
#include "attractor/cut/coinciding.h"
#include "attractor/cut/thinning.h"
#include "attractor/samples/chaos_game.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace attractor {

namespace {

// The displayed node, in cells: its bounding box, and the errors of its maps within it.
struct Shown {
    double xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0; // first-order map from box coordinates
    double halfX = 0, halfY = 0;                         // infinite where nothing is known
    double size = 0;                                     // size of the box as far as known
    double affineMiss = 0;                               // error of the first-order map
    double curvedMiss = 0;                               // error of the second-order map
    Curve curve;                                         // second-order terms, and their visible size
    float curveX = 0, curveY = 0;                        // centre, where the first-order map has x, y
};

// camera·cage·w_σ(centre + δ) = offset + linear·δ, in cells; of a cage that bends, w_σ alone, in coordinates
// of the code.
template <class Real> struct Node {
    Real xx, xy, yx, yy;
    Real x, y;
    double probability = 1;
    PaletteInterval colours{};
    std::uint64_t key = 0;
    std::uint32_t firstMap = 0;
    std::uint32_t lastMap = 0; // innermost map
    int depth = 0;
    Shown shown;
};

template <class Real> struct Branch {
    Real xx, xy, yx, yy;
    Real x, y; // w_i(centre) − centre
    double probability = 0;
};

// Cages that do not bend are part of every node.
template <class Real> class AffineView {
public:
    static constexpr bool bends = false;
    static constexpr std::size_t maxWords = 1U << 15; // limit while refining

    AffineView(const PreparedSystem& system, const Projection& projection, CutMemory&)
        : m_system(system), m_projection(projection) {}

    // Root of the part of the address tree that is displayed by `change`.
    Node<Real> root(const ifs::AffineMap<2>& change) const {
        const ifs::AffineMap<2>& cage = m_projection.cage.affine();
        const ifs::Matrix<2> linear = m_projection.scale * (cage.linear * change.linear);
        const auto changed = [&](int row) { // image of the centre
            return Real(change.linear(row, 0)) * Real(m_system.centre.x()) +
                   Real(change.linear(row, 1)) * Real(m_system.centre.y()) + Real(change.translation[row]);
        };
        const Real x = changed(0);
        const Real y = changed(1);
        Node<Real> node;
        node.xx = linear(0, 0);
        node.xy = linear(0, 1);
        node.yx = linear(1, 0);
        node.yy = linear(1, 1);
        const auto shown = [&](int row) { // image of the centre under the cage, relative to the camera
            return Real(cage.linear(row, 0)) * x + Real(cage.linear(row, 1)) * y +
                   (Real(cage.translation[row]) - Real(m_projection.centre[row]));
        };
        const Real right = shown(0), up = shown(1);
        node.x = m_projection.scaled(0, right, up) + Real(m_projection.grid.width / 2.0);
        node.y = m_projection.scaled(1, right, up) + Real(m_projection.grid.height / 2.0);
        return node;
    }

    Shown shown(const Node<Real>& node) const {
        const ifs::Vector<2>& half = m_system.halfExtent;
        Shown result;
        result.xx = static_cast<double>(node.xx) * half.x();
        result.xy = static_cast<double>(node.xy) * half.y();
        result.yx = static_cast<double>(node.yx) * half.x();
        result.yy = static_cast<double>(node.yy) * half.y();
        result.x = static_cast<double>(node.x);
        result.y = static_cast<double>(node.y);
        result.halfX = std::abs(result.xx) + std::abs(result.xy);
        result.halfY = std::abs(result.yx) + std::abs(result.yy);
        result.size = 2 * std::max(result.halfX, result.halfY);
        return result;
    }

private:
    const PreparedSystem& m_system;
    const Projection& m_projection;
};

// Cages that bend are applied to the nodes, to first order.
class BentView {
public:
    static constexpr bool bends = true;
    static constexpr std::size_t maxWords = 1U << 17;

    BentView(const PreparedSystem& system, const Projection& projection, CutMemory& memory)
        : m_system(system), m_projection(projection), m_table(memory.bends) {
        m_table.follow(*projection.cage.bend(), system.centre, reach(system),
                       maxBendError / 2 * projection.cellsPerPixel / projection.cellsPerUnit(),
                       memory.bent == system.maps);
        memory.bent = system.maps;
    }

    Node<double> root(const ifs::AffineMap<2>& change) const {
        const ifs::Matrix<2>& linear = change.linear;
        const ifs::Vector<2> middle = change(m_system.centre);
        Node<double> node;
        node.xx = linear(0, 0);
        node.xy = linear(0, 1);
        node.yx = linear(1, 0);
        node.yy = linear(1, 1);
        node.x = middle.x();
        node.y = middle.y();
        return node;
    }

    Shown shown(const Node<double>& node) {
        const BendTable::Piece piece = m_table.piece({node.x, node.y}, spread(node));
        const ifs::Vector<2> cell = m_projection.cell(piece.middle());
        const ifs::Matrix<2> linear = m_projection.scale * piece.linear;
        const ifs::Vector<2> half = linear.cwiseAbs().rowwise().sum();
        const ifs::Vector<2> miss = m_projection.boxAround(piece.miss);
        const ifs::Vector<2> middle = m_projection.cell(piece.value);
        const auto cells = [this](const ifs::Vector<2>& v, int row) {
            return static_cast<float>(m_projection.scaled(row, v.x(), v.y()));
        };
        const ifs::Vector<2> affineMiss = m_projection.boxAround(piece.curvature()) + miss;
        return {linear(0, 0),
                linear(0, 1),
                linear(1, 0),
                linear(1, 1),
                cell.x(),
                cell.y(),
                half.x() + affineMiss.x(),
                half.y() + affineMiss.y(),
                2 * half.maxCoeff(),
                affineMiss.maxCoeff(),
                miss.maxCoeff(),
                {cells(piece.aa, 0), cells(piece.ab, 0), cells(piece.bb, 0), cells(piece.aa, 1),
                 cells(piece.ab, 1), cells(piece.bb, 1)},
                static_cast<float>(middle.x()),
                static_cast<float>(middle.y())};
    }

    // Map from box coordinates to coordinates of the code.
    ifs::AffineMap<2> exactMap(const Node<double>& node) const { return {spread(node), {node.x, node.y}}; }

private:
    // Upper bound, rounded to steps, of the distance between the centre and displayed points. The steps keep
    // a dragged branch from restarting the table in every frame.
    static double reach(const PreparedSystem& system) {
        double farthest = system.halfExtent.maxCoeff();
        if (system.moved.empty()) return farthest;
        for (const ifs::AffineMap<2>& piece : shownPieces(system)) {
            const ifs::Vector<2> away = (piece(system.centre) - system.centre).cwiseAbs() +
                                        piece.linear.cwiseAbs() * system.halfExtent;
            while (farthest < away.maxCoeff() && std::isfinite(away.maxCoeff()))
                farthest *= 2;
        }
        return farthest;
    }
    ifs::Matrix<2> spread(const Node<double>& node) const {
        const ifs::Vector<2>& half = m_system.halfExtent;
        return ifs::affineMap(node.xx * half.x(), node.xy * half.y(), node.yx * half.x(), node.yy * half.y(),
                              0, 0)
            .linear;
    }

    const PreparedSystem& m_system;
    const Projection& m_projection;
    BendTable& m_table;
};

template <class Real, class View> class Tree {
public:
    Tree(const PreparedSystem& system, const Projection& projection, const CutSettings& settings,
         CutMemory& memory)
        : m_system(system),
          m_settings(settings),
          m_width(projection.grid.width),
          m_height(projection.grid.height),
          m_maxSize(2.0 * std::max(m_width, m_height)),
          m_maxMiss(maxBendError * projection.cellsPerPixel),
          m_divided(std::clamp<std::size_t>(maxWaiting / system.maps.size(), 64, View::maxWords)),
          m_nodeMemory(&memory.nodes),
          m_view(system, projection, memory) {
        if (m_settings.colours.empty()) m_settings.colours = ColourCoordinates(system.maps.size());
        for (std::size_t i = 0; i < system.maps.size(); ++i)
            m_branches.push_back(branch(system.maps[i], system.centre, system.probabilities[i]));
        // Linked maps have no sample set for the empty word.
        if (system.isLinked()) {
            m_settings.minDepth = std::max(m_settings.minDepth, 1);
            m_settings.maxDepth = std::max(m_settings.maxDepth, 1);
        }
        for (const auto& [word, change] : ifs::pieces<2>(system.moved, system.maps.size())) {
            Node<Real> node = m_view.root(change);
            node.shown = m_view.shown(node);
            for (const int symbol : word)
                node = child(node, static_cast<std::size_t>(symbol));
            if (node.probability > 0) m_roots.push_back(node);
        }
    }

    AddressCut cut(const std::stop_token& stop) {
        // First estimates the measure in view, then cuts. The threshold is a power of two, so that words keep
        // their identity under small changes of the view or a map. With everything in view, rounding cannot
        // decide between two thresholds.
        const Nodes coarse = leaves(m_settings.words / 16.0, Threshold::Relative, stop);
        double visible = 0;
        for (const Node<Real>& node : coarse)
            visible += node.probability;
        double threshold = 1;
        while (threshold > 0 && threshold > visible / m_settings.words * (1 + rounding))
            threshold /= 2;
        m_exact = m_settings.samples > 0 ? minSamples / m_settings.samples * visible : 0;
        m_atBorder = m_settings.samples > 0 ? atBorder / m_settings.samples * visible : 1;
        m_oneColour = std::max(m_exact, m_settings.colours.minShare() * visible);
        m_followsBend = View::bends;
        m_thinnings = 0;
        AddressCut result = words(leaves(threshold, Threshold::Absolute, stop));
        result.isThinned = m_thinnings > 0;
        return stop.stop_requested() ? AddressCut{} : result;
    }

private:
    using Nodes = std::pmr::vector<Node<Real>>;
    enum class Threshold { Absolute, Relative };

    static constexpr std::size_t maxWaiting = 1U << 20; // limit of words of the next level
    // Limit of words wholly in view, unless there are more maps.
    static constexpr std::size_t maxShown = 1U << 16;
    static constexpr std::size_t childrenPerCheck = 8192; // between two checks of the stop token
    static constexpr double rounding = 1e-9;              // relative error bound of a sum of probabilities
    static constexpr double minSize = 0.25;               // cells; smaller words need no division
    static constexpr double atBorder = 512;               // samples of a word that is partly in view
    static constexpr double minSamples = 32;              // samples that justify a first-order map

    static Branch<Real> branch(const ifs::AffineMap<2>& map, const ifs::Vector<2>& centre,
                               double probability) {
        const auto shift = [&](int row) {
            return Real(map.linear(row, 0)) * Real(centre.x()) + Real(map.linear(row, 1)) * Real(centre.y()) +
                   (Real(map.translation[row]) - Real(centre[row]));
        };
        return {map.linear(0, 0), map.linear(0, 1), map.linear(1, 0), map.linear(1, 1),
                shift(0),         shift(1),         probability};
    }

    Node<Real> child(const Node<Real>& node, std::size_t i) {
        const Branch<Real>& b = m_branches[i];
        Node<Real> result;
        result.xx = node.xx * b.xx + node.xy * b.yx;
        result.xy = node.xx * b.xy + node.xy * b.yy;
        result.yx = node.yx * b.xx + node.yy * b.yx;
        result.yy = node.yx * b.xy + node.yy * b.yy;
        result.x = node.x + (node.xx * b.x + node.xy * b.y);
        result.y = node.y + (node.yx * b.x + node.yy * b.y);
        result.probability = node.probability * (m_system.isLinked() ? share(node, i) : b.probability);
        result.lastMap = static_cast<std::uint32_t>(i);
        result.colours = m_settings.colours.child(node.colours, i);
        result.key = mixed(node.key + i + 1);
        result.firstMap = node.depth == 0 ? static_cast<std::uint32_t>(i) : node.firstMap;
        result.depth = node.depth + 1;
        result.shown = m_view.shown(result);
        return result;
    }

    // Share of a linked word's measure that belongs to a child; 0 for inadmissible children.
    double share(const Node<Real>& node, std::size_t i) const {
        const ifs::Transitions& chain = m_system.chain;
        return node.depth == 0 ? chain.stationary[i] : chain.backward[node.lastMap * chain.size + i];
    }

    bool visible(const Node<Real>& node) const { // false if the centre is not finite
        const Shown& s = node.shown;
        return s.x + s.halfX >= 0 && s.x - s.halfX <= m_width && s.y + s.halfY >= 0 &&
               s.y - s.halfY <= m_height;
    }

    bool isInside(const Node<Real>& node) const {
        const Shown& s = node.shown;
        return s.x - s.halfX >= 0 && s.x + s.halfX <= m_width && s.y - s.halfY >= 0 &&
               s.y + s.halfY <= m_height;
    }

    bool isTooBent(const Node<Real>& node) const {
        return m_followsBend && !(node.shown.curvedMiss <= m_maxMiss);
    }

    bool isTooMixed(const Node<Real>& node, double measure) const {
        return measure > m_oneColour && m_settings.colours.isMixed(node.colours) && node.shown.size > minSize;
    }

    // Up to `slack` times the threshold is allowed.
    bool isLeaf(const Node<Real>& node, double threshold, double slack) const {
        if (node.depth >= m_settings.maxDepth) return true;
        const double size = node.shown.size;
        if (node.depth < m_settings.minDepth || !(size <= m_maxSize)) return false;
        const double measure = node.probability / slack;
        return ((measure <= threshold && (measure <= m_atBorder || isInside(node))) || size <= minSize) &&
               (!isTooBent(node) || measure <= m_exact) && !isTooMixed(node, measure);
    }

    // Tolerance of the threshold. With hundreds of children for each node, dividing every node slightly above
    // the threshold would make far too many words. Then only nodes above it by a power of two are divided, so
    // that words of equal measure are treated alike.
    double slackFor(const Nodes& open, std::size_t done, double threshold) const {
        const std::size_t max = std::max(maxShown, 2 * m_branches.size());
        const auto isWithin = [&](double slack) {
            std::size_t divided = 0;
            std::size_t shown = 0; // number of nodes whose children are all in view
            for (const Node<Real>& node : open) {
                if (isLeaf(node, threshold, slack)) continue;
                ++divided;
                shown += isInside(node) ? 1 : 0;
            }
            return divided * m_branches.size() <= maxWaiting &&
                   (shown == 0 || done + shown * m_branches.size() <= max);
        };
        double slack = 1;
        if (done + open.size() * m_branches.size() > max)
            while (slack < 0x1p40 && !isWithin(slack))
                slack *= 2;
        return slack;
    }

    // Divides level by level. For Threshold::Relative, the limit is a number of words, each with at most its
    // share of the measure visible so far.
    Nodes leaves(double limit, Threshold kind, const std::stop_token& stop) {
        Nodes done(m_nodeMemory);
        Nodes open(m_nodeMemory);
        std::ranges::copy_if(m_roots, std::back_inserter(open),
                             [this](const Node<Real>& node) { return visible(node); });
        std::size_t children = 0;
        std::size_t nextCheck = 0;
        double settled = 0;
        Nodes next(m_nodeMemory);
        while (!open.empty() && children < m_settings.maxLooks) {
            double threshold = limit;
            if (kind == Threshold::Relative) {
                double total = settled;
                for (const Node<Real>& node : open)
                    total += node.probability;
                threshold = total / limit;
            }
            const double slack = slackFor(open, done.size(), threshold);
            std::erase_if(open, [&](const Node<Real>& node) {
                if (!isLeaf(node, threshold, slack)) return false;
                done.push_back(node);
                settled += node.probability;
                return true;
            });
            if (open.size() > m_divided) thinOut(open, m_divided);
            next.clear();
            for (const Node<Real>& node : open) {
                if (children >= nextCheck) {
                    if (stop.stop_requested()) return {};
                    nextCheck = children + childrenPerCheck;
                }
                children += m_branches.size();
                for (std::size_t i = 0; i < m_branches.size(); ++i) {
                    if (m_system.isLinked() && !(share(node, i) > 0)) continue;
                    const Node<Real> candidate = child(node, i);
                    if (visible(candidate)) next.push_back(candidate);
                }
                if (next.size() > maxWaiting) thinOut(next, View::maxWords);
            }
            open.swap(next);
            if (m_settings.mergesCoinciding) mergeCoinciding(open);
            if (m_followsBend && open.size() > View::maxWords) settleBent(open, done, threshold);
            thinOverlaps(open);
        }
        done.insert(done.end(), open.begin(), open.end());
        return done;
    }

    // Settles nodes that only wait for their bend.
    void settleBent(Nodes& open, Nodes& done, double threshold) const {
        const auto bentOnly = [&](const Node<Real>& node) {
            return isTooBent(node) && node.depth >= m_settings.minDepth && node.shown.size <= m_maxSize &&
                   node.probability <= threshold;
        };
        std::copy_if(open.begin(), open.end(), std::back_inserter(done), bentOnly);
        std::erase_if(open, bentOnly);
    }

    // Mean number of words that cover a point of the view.
    double coverage(const Nodes& nodes) const {
        double covered = 0;
        for (const Node<Real>& node : nodes) {
            const double share = std::min(1.0, node.shown.size / std::max(m_width, m_height));
            covered += share * share;
        }
        return covered;
    }

    // Thins words out. Words side by side are all needed; of overlapping words only as many as leave no
    // holes.
    void thinOverlaps(Nodes& nodes) {
        constexpr double enough = 16;
        if (nodes.size() <= std::max(View::maxWords, maxShown)) return;
        const double covered = coverage(nodes);
        if (covered > enough)
            thinOut(nodes,
                    std::max(View::maxWords,
                             static_cast<std::size_t>(static_cast<double>(nodes.size()) * enough / covered)));
    }

    void thinOut(Nodes& nodes, std::size_t wanted) {
        attractor::thinOut(nodes, wanted, m_settings.seed + nodes.size() + (m_thinnings++ << 32));
    }

    AddressCut words(const Nodes& nodes) {
        AddressCut result;
        result.words.reserve(nodes.size());
        const auto add = [&](const Node<Real>& node) {
            result.words.push_back(word(node));
            if (m_system.isLinked()) result.sampleSets.push_back(m_system.sampleSetOf[node.lastMap]);
            result.probability += node.probability;
        };
        const auto isAffine = [this](const Node<Real>& node) { return node.shown.affineMiss <= m_maxMiss; };
        for (const Node<Real>& node : nodes)
            if (isAffine(node)) add(node);
        result.firstCurved = result.firstExact = result.words.size();
        if constexpr (View::bends) {
            for (const Node<Real>& node : nodes) {
                if (isAffine(node) || isTooBent(node)) continue;
                add(node);
                result.words.back().x = node.shown.curveX;
                result.words.back().y = node.shown.curveY;
                result.curves.push_back(node.shown.curve);
            }
            result.firstExact = result.words.size();
            for (const Node<Real>& node : nodes) {
                if (isAffine(node) || !isTooBent(node)) continue;
                add(node);
                result.exact.push_back(m_view.exactMap(node));
            }
        }
        return result;
    }

    Word word(const Node<Real>& node) const {
        const Shown& s = node.shown;
        Word result;
        result.xx = static_cast<float>(s.xx);
        result.xy = static_cast<float>(s.xy);
        result.yx = static_cast<float>(s.yx);
        result.yy = static_cast<float>(s.yy);
        result.x = static_cast<float>(s.x);
        result.y = static_cast<float>(s.y);
        result.firstMap = node.firstMap;
        // Multiple of the widest vector.
        result.offset = static_cast<std::uint32_t>(node.key % (SampleSet::size / 16)) * 16;
        result.probability = node.probability;
        result.addressCoordinate = m_settings.colours.middle(node.colours);
        return result;
    }

    const PreparedSystem& m_system;
    CutSettings m_settings;
    double m_width;
    double m_height;
    double m_maxSize;
    double m_maxMiss;
    double m_oneColour = 1; // probability below which a word is drawn in one colour
    double m_atBorder = 1;  // probability above which a word partly in view is divided
    double m_exact = 0;     // probability below which samples are mapped individually
    bool m_followsBend = false;
    std::uint64_t m_thinnings = 0;
    // Number of words divided together; smaller if every word has thousands of children.
    std::size_t m_divided;
    std::pmr::memory_resource* m_nodeMemory;
    View m_view;
    std::vector<Branch<Real>> m_branches;
    std::vector<Node<Real>> m_roots; // roots; every address begins with exactly one of them
};

} // namespace

Projection projection(const Camera& camera, const ifs::Placement& cage, int cellsPerPixel) {
    Projection result;
    result.scale = worldToPixel(camera).linear * cellsPerPixel;
    result.cage = cage;
    result.centre = camera.centre;
    result.grid = {camera.width * cellsPerPixel, camera.height * cellsPerPixel};
    result.cellsPerPixel = cellsPerPixel;
    return result;
}

AddressCut addressCut(const PreparedSystem& system, const Projection& projection, const CutSettings& settings,
                      std::stop_token stop, CutMemory* kept) {
    if (system.maps.empty()) return {};
    CutMemory own;
    CutMemory& memory = kept != nullptr ? *kept : own;
    if (projection.cage.bend() != nullptr)
        return Tree<double, BentView>(system, projection, settings, memory).cut(stop);
    const ifs::AffineMap<2>& cage = projection.cage.affine();
    double reach = 0;
    for (const auto& [word, change] : ifs::pieces<2>(system.moved, system.maps.size())) {
        const ifs::AffineMap<2> shown = cage * change;
        reach = std::max(reach, (shown(system.centre) - projection.centre).cwiseAbs().maxCoeff() +
                                    shown.linear.cwiseAbs().maxCoeff() * system.halfExtent.maxCoeff());
    }
    const bool deep = projection.scale.cwiseAbs().maxCoeff() * reach > 1e9;
    return deep ? Tree<DoubleDouble, AffineView<DoubleDouble>>(system, projection, settings, memory).cut(stop)
                : Tree<double, AffineView<double>>(system, projection, settings, memory).cut(stop);
}

} // namespace attractor
