// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_hierarchy.h"

#include "ifs/copies/copy_distance.h"
#include "ifs/dimension/common_eigendirections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ifs {

namespace {

constexpr double maxThinness = 0.5; // limit to which a map is raised, however small its copies are
constexpr double singular = 0.1;    // larger least singular values are never raised
constexpr double widening = 0.4;    // pixels; widening of the smallest copies on every side
constexpr double maxWidening = 0.6; // limit of the widening, as a share of their size
constexpr double faint = 0.15;      // pixels; mean thickness of copies that are too faint
constexpr double maxFaint = 3;      // pixels; size of copies kept larger to stay visible
constexpr double rough = 1;         // pixels; error from which on a closer look is worthwhile

struct Descent {
    std::vector<int> steps; // steps of each map
    double shrinkage;       // −log of the factor in size of one step
};

// Number of steps that each map descends: the logarithm of its size in units of the largest map's.
Descent descentOf(const std::vector<AffineMap<2>>& maps) {
    constexpr double minShrinkage = 0.03;
    std::vector<double> costs;
    double least = HUGE_VAL;
    for (const auto& map : maps) {
        const auto sigma = singularValues<2>(map.linear);
        // Geometric mean, but at least a share of the length of thin copies.
        const double size = std::sqrt(sigma[0] * std::max(sigma[1], sigma[0] / 10));
        costs.push_back(-std::log(std::max(size, 1e-9)));
        if (costs.back() > 0) least = std::min(least, costs.back());
    }
    Descent descent{{}, std::isfinite(least) ? std::max(least, minShrinkage) : minShrinkage};
    for (const double cost : costs)
        descent.steps.push_back(
            std::clamp(int(std::lround(cost / descent.shrinkage)), 1, CopyHierarchy::maxLevels));
    return descent;
}

bool isFaint(const CopyDeviation& deviation) {
    return deviation.area < faint * deviation.length;
}

} // namespace

std::optional<CopyHierarchy> CopyHierarchy::of(const IteratedFunctionSystem<2>& system,
                                               const AffineMap<2>& display,
                                               std::span<const MovedBranch<2>> moved) {
    ActiveMaps<2> active = activeMaps(system);
    auto frame = CopyFrame::of(active.maps, display);
    if (!frame) return std::nullopt;
    return CopyHierarchy(*std::move(frame), std::move(active), display, moved);
}

CopyHierarchy::CopyHierarchy(CopyFrame frame, ActiveMaps<2> active, const AffineMap<2>& display,
                             std::span<const MovedBranch<2>> moved)
    : m_frame(std::move(frame)),
      m_maps(std::move(active.maps)),
      m_index(std::move(active.index)),
      m_moved(overMaps<2>(moved, m_index)),
      m_display(thickened(display, m_frame.centre,
                          CopyFrame::minThickness / std::max(m_frame.diameter, m_frame.pixel))),
      m_displayShift(maxShift(m_frame, m_display, display)) {
    findProjections();
    Descent descent = descentOf(m_maps);
    m_steps = std::move(descent.steps);
    m_shrinkage = descent.shrinkage;
    findFibre();
    countReferences();
    findFaintLevel();
}

// A map whose copy of the whole picture would be thinner than can be seen is taken for singular.
void CopyHierarchy::findProjections() {
    for (const auto& map : m_maps) {
        const bool isSingular =
            !(thickened(map, m_frame.centre, std::min(m_frame.thinness, singular)) == map);
        m_projections.push_back(isSingular ? std::optional(projectionBy(m_maps, m_frame, map))
                                           : std::nullopt);
    }
}

void CopyHierarchy::findFibre() {
    for (const Vector<2>& direction : commonDirections(m_maps)) {
        constexpr double rounding = 1e-9;
        const Vector<2> across(-direction.y(), direction.x());
        double shrinkage = HUGE_VAL;
        bool isThin = false; // true if some copy is thin, or becomes thin by shear
        bool isThick = false;
        for (std::size_t i = 0; i < m_maps.size(); ++i) {
            const Matrix<2>& linear = m_maps[i].linear;
            const double along = (linear * direction).norm();
            const double area = std::abs(determinant<2>(linear));
            isThin = isThin || along * along < area * (1 - rounding) ||
                     std::abs(direction.dot(linear * across)) > rounding * linear.norm();
            isThick = isThick || m_projections[i] || along * along > area * (1 + rounding);
            shrinkage = std::min(shrinkage, -std::log(along) / m_steps[i]);
        }
        if (isThin && !isThick && shrinkage > m_fibreShrinkage) {
            m_fibre = direction;
            m_fibreShrinkage = shrinkage;
        }
    }
}

void CopyHierarchy::countReferences() {
    for (int level = 0; level <= maxLevels; ++level) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; level > 0 && i < m_maps.size(); ++i)
            sum += m_projections[i] ? 1 : 1 + m_references[std::size_t(below(level, i))];
        m_references.push_back(std::min(sum, maxReferences));
    }
}

// Finds whether copies fade away unless they are larger than a few pixels: the picture is then written out.
void CopyHierarchy::findFaintLevel() {
    if (m_frame.diameter < m_frame.pixel) return;
    const int level = levelFor(1, HUGE_VAL);
    if (deviation(level).largest <= maxFaint || references(level + 1) > comfortableReferences) return;
    auto written = copyWords(m_maps, ifs::pieces<2>(m_moved, m_maps.size()), m_frame, m_projections.size());
    if (!written) return;
    m_words = std::move(written->words);
    m_projections.insert(m_projections.end(), written->projections.begin(), written->projections.end());
    m_faintLevel = level + 1;
}

// The copies that `level` makes are about exp(shrinkage·(depth − level)) times smaller than the picture.
AffineMap<2> CopyHierarchy::map(std::size_t i, int level, int depth) const {
    if (!m_projections[i]) return m_maps[i];
    const double least = m_frame.thinness * std::exp(m_shrinkage * (depth - level));
    return thickened(m_maps[i], m_frame.centre, std::min(least, maxThinness));
}

int CopyHierarchy::below(int level, std::size_t map) const {
    return std::max(0, level - m_steps[map]);
}

Copy CopyHierarchy::copy(std::size_t i, int level, int depth) const {
    Copy copy{map(i, level, depth), below(level, i), {}, i};
    if (m_projections[i] && level > 0) copy.projection = i;
    return copy;
}

std::vector<Copy> CopyHierarchy::copies(int level, int depth) const {
    std::vector<Copy> result;
    for (std::size_t i = 0; i < m_maps.size(); ++i)
        result.push_back(copy(i, level, depth));
    return result;
}

std::vector<MovedBranch<2>> CopyHierarchy::pieces() const {
    auto pieces = ifs::pieces<2>(m_moved, m_maps.size());
    for (MovedBranch<2>& piece : pieces)
        piece.change = thickened(piece.change, m_frame.centre, std::min(m_frame.thinness, singular));
    return pieces;
}

std::vector<Copy> CopyHierarchy::picture(int depth) const {
    std::vector<Copy> result;
    if (depth >= m_faintLevel) {
        for (const CopyWords::Word& word : m_words)
            result.push_back(word.copy);
        return result;
    }
    for (const auto& [word, change] : pieces()) {
        Copy piece{change, depth, {}, {}};
        for (const int symbol : word) {
            const Copy inner = copy(std::size_t(symbol), piece.level, depth);
            piece = {piece.map * inner.map, inner.level, inner.projection, piece.first.value_or(symbol)};
        }
        // Projections show branches that end with their map; the copy of a longer word is flat already, and
        // complete.
        if (!word.empty() || depth == 0) {
            result.push_back(piece);
            continue;
        }
        for (Copy inner : copies(depth, depth)) {
            inner.map = change * inner.map;
            result.push_back(inner);
        }
    }
    return result;
}

Vector<2> CopyHierarchy::fibre(int depth) const {
    constexpr double longest = 1e6; // relative to the picture
    if (depth >= m_faintLevel) return Vector<2>::Zero();
    return m_fibre * std::min(widening * m_frame.pixel * std::exp(m_fibreShrinkage * depth),
                              longest * m_frame.diameter);
}

double CopyHierarchy::margin(int depth) const {
    const double pixel = m_frame.pixel;
    const double diameter = m_frame.diameter;
    if (diameter < pixel) return m_frame.hullError + CopyFrame::minThickness / 2 * pixel; // single dot
    if (depth >= m_faintLevel) return m_frame.hullError + maxWidening * diameter;
    const double smallest = widening * pixel * std::exp(m_shrinkage * depth);
    return m_frame.hullError + std::min(smallest, std::max(maxWidening * diameter, widening * pixel));
}

Polygon CopyHierarchy::outline(int depth) const {
    Polygon wide = pushedOut(m_frame.hull, margin(depth));
    if (m_fibre.isZero()) return wide;
    Polygon ends;
    for (const auto& point : wide)
        for (const double end : {1.0, -1.0})
            ends.push_back(point + end * fibre(depth));
    return convexHull(std::move(ends), 0);
}

std::uint64_t CopyHierarchy::references(int level) const {
    const int depth = std::clamp(level, 0, maxLevels);
    if (depth >= m_faintLevel) return m_words.size();
    if (m_moved.empty()) return m_references[std::size_t(depth)];
    std::uint64_t sum = 0;
    for (const Copy& copy : picture(depth))
        sum += copy.projection ? 1 : 1 + m_references[std::size_t(copy.level)];
    return std::min(sum, maxReferences);
}

int CopyHierarchy::deepest() const {
    if (m_faintLevel <= maxLevels) return maxLevels;
    const auto tooMany = std::find(m_references.begin(), m_references.end(), maxReferences);
    return int(tooMany - m_references.begin()) - 1;
}

CopyStep CopyHierarchy::step(const Copy& copy, const AffineMap<2>& map) const {
    if (!copy.projection) {
        const double shift = maxShift(m_frame, copy.map, map);
        return {copy.map.linear, copy.level, false, shift, shift};
    }
    const CopyProjection& projection = *m_projections[*copy.projection];
    return {copy.map.linear, copy.level, true, maxShift(m_frame, projection, copy.map, map),
            maxMissing(m_frame, projection, copy.map, map)};
}

CopyDeviation CopyHierarchy::deviation(int depth, double excess) const {
    CopyExpansion expansion;
    expansion.diameter = diameter(pushedOut(m_frame.hull, margin(depth)));
    expansion.excess = excess;
    expansion.area = area(outline(depth));
    expansion.fibre = fibre(depth);
    const CopyStep whole{m_display.linear, depth, false, m_displayShift, m_displayShift};
    if (depth >= m_faintLevel) {
        for (const CopyWords::Word& word : m_words)
            expansion.picture.push_back(inside(whole, step(word.copy, word.map)));
        return ifs::deviation(expansion, 2 * maxReferences);
    }
    expansion.copies.resize(std::size_t(depth) + 1);
    for (int level = 1; level <= depth; ++level)
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            expansion.copies[std::size_t(level)].push_back(step(copy(i, level, depth), m_maps[i]));
    for (const auto& [word, change] : pieces()) {
        CopyStep part = whole;
        part.linear = m_display.linear * change.linear;
        for (const int symbol : word) {
            const auto i = std::size_t(symbol);
            part = inside(part, step(copy(i, part.level, depth), m_maps[i]));
        }
        expansion.picture.push_back(part);
    }
    return ifs::deviation(expansion, 2 * maxReferences);
}

double CopyHierarchy::excess(int depth) const {
    constexpr double side = 128; // pixels of the picture on which it is found
    if (m_frame.diameter < m_frame.pixel) return HUGE_VAL;
    const double scale = side / m_frame.diameter;
    const AffineMap<2> display{scale * Matrix<2>::Identity(), Vector<2>::Zero()};
    Polygon level = pushedOut(m_frame.hull, margin(depth));
    for (auto& corner : level)
        corner = display(corner);
    return CopyDistance(m_maps, {display}, m_frame.hull).farthest(level) / scale;
}

double CopyHierarchy::farthest(int depth) const {
    std::vector<AffineMap<2>> shown = pieceMaps<2>(ifs::pieces<2>(m_moved, m_maps.size()), m_maps);
    for (auto& map : shown)
        map = m_display * map;
    const CopyDistance distance(m_maps, shown, m_frame.hull);
    const Polygon leaf = outline(depth);
    std::vector<std::vector<Copy>> levels;
    for (int level = 0; level <= depth && depth < m_faintLevel; ++level)
        levels.push_back(level == 0 ? std::vector<Copy>() : copies(level, depth));
    double result = 0;
    const auto draw = [&](Polygon polygon, const AffineMap<2>& map) {
        for (auto& corner : polygon)
            corner = map(corner);
        result = std::max(result, distance.farthest(polygon));
    };
    std::vector<Copy> open = picture(depth);
    for (auto& copy : open)
        copy.map = m_display * copy.map;
    while (!open.empty()) {
        const Copy copy = open.back();
        open.pop_back();
        if (copy.projection) {
            for (const Polygon& bar : m_projections[*copy.projection]->bars)
                draw(bar, copy.map);
        } else if (copy.level == 0) {
            draw(leaf, copy.map);
        } else {
            for (Copy inner : levels[std::size_t(copy.level)]) {
                inner.map = copy.map * inner.map;
                open.push_back(inner);
            }
        }
    }
    return result;
}

double CopyHierarchy::error(int depth) const {
    const CopyDeviation found = deviation(depth, excess(depth));
    if (!std::isfinite(found.error) || found.error <= rough) return found.error;
    return std::min(found.error, std::max(farthest(depth) + m_displayShift, found.missing));
}

int CopyHierarchy::levelFor(double wanted) const {
    return levelFor(wanted, maxFaint);
}

int CopyHierarchy::levelFor(double wanted, double largest) const {
    int level = 0;
    if (m_frame.diameter < m_frame.pixel) return level;
    while (level < maxLevels && references(level + 1) <= comfortableReferences &&
           deviation(level).largest > wanted) {
        ++level;
        if (level >= m_faintLevel) return level; // lower levels do not show more
    }
    // Larger copies, if thin ones have become faint: they say less exactly where something is, but show that
    // it is there.
    while (level > 0 && isFaint(deviation(level)) && deviation(level - 1).largest <= largest)
        --level;
    return level;
}

} // namespace ifs
