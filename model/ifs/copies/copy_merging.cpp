// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_merging.h"

#include <limits>
#include <utility>

namespace ifs {

namespace {

using Level = MergedCopies::Level;
using Levels = MergedCopies::Levels;

// Way of writing levels: those that need at most so many corners as one path, the others with copies at least
// `stride` levels below them.
struct Style {
    std::size_t corners = 0;
    int stride = 1;
};

class Merging {
public:
    Merging(const CopyHierarchy& hierarchy, int depth)
        : m_hierarchy(hierarchy), m_depth(depth), m_corners(hierarchy.outline(depth).size()) {}

    // Empty if there would be too much to write.
    Levels levels(const std::vector<Copy>& picture, const Style& style) {
        std::set<int> needed;
        const auto need = [&needed](const std::vector<Copy>& copies) {
            for (const Copy& copy : copies)
                if (!copy.projection) needed.insert(copy.level);
        };
        need(picture);
        Levels levels;
        std::size_t corners = 0, copies = 0;
        while (!needed.empty()) {
            const int number = *needed.rbegin();
            needed.erase(number);
            Level& level = levels[number];
            if (number == 0 || cornersIn(number) <= style.corners) {
                addPieces(level.pieces, number, {});
                corners += cornersIn(number);
            } else {
                level.copies = copiesOf(number, style);
                copies += level.copies.size();
                need(level.copies);
            }
            const bool isTooMuch = (style.corners > 0 && corners > MergedCopies::maxCorners) ||
                                   (style.stride > 1 && copies > MergedCopies::maxWritten);
            if (isTooMuch) return {};
        }
        return levels;
    }

private:
    static constexpr std::size_t many = std::numeric_limits<std::size_t>::max();

    std::size_t cornersOf(std::size_t projection) const {
        std::size_t sum = 0;
        for (const Polygon& bar : m_hierarchy.projection(projection)->bars)
            sum += bar.size();
        return sum;
    }

    // Number of corners in the one path of the level, or `many`.
    std::size_t cornersIn(int level) {
        if (level == 0) return m_corners;
        if (const auto known = m_known.find(level); known != m_known.end()) return known->second;
        std::size_t sum = 0;
        for (const Copy& copy : m_hierarchy.copies(level, m_depth)) {
            const std::size_t inner = copy.projection ? cornersOf(*copy.projection) : cornersIn(copy.level);
            sum = inner == many || sum + inner > MergedCopies::maxCorners ? many : sum + inner;
            if (sum == many) break;
        }
        m_known[level] = sum;
        return sum;
    }

    void addPieces(std::vector<MergedCopies::Piece>& pieces, int level, const AffineMap<2>& outer) const {
        if (level == 0) {
            pieces.push_back({outer, {}});
            return;
        }
        for (const Copy& copy : m_hierarchy.copies(level, m_depth))
            if (copy.projection)
                pieces.push_back({outer * copy.map, copy.projection});
            else
                addPieces(pieces, copy.level, outer * copy.map);
    }

    std::vector<Copy> copiesOf(int level, const Style& style) {
        std::vector<Copy> result;
        std::vector<Copy> open = m_hierarchy.copies(level, m_depth);
        while (!open.empty() && style.stride > 1 && result.size() + open.size() <= MergedCopies::maxWritten) {
            const Copy outer = open.back();
            open.pop_back();
            if (outer.projection || level - outer.level >= style.stride ||
                cornersIn(outer.level) <= style.corners) {
                result.push_back(outer);
                continue;
            }
            for (const Copy& inner : m_hierarchy.copies(outer.level, m_depth))
                open.push_back({outer.map * inner.map, inner.level, inner.projection, outer.first});
        }
        result.insert(result.end(), open.begin(), open.end());
        return result;
    }

    const CopyHierarchy& m_hierarchy;
    int m_depth;
    std::size_t m_corners;
    std::map<int, std::size_t> m_known; // number of corners of each level
};

// Work of a reader for one level.
struct Made {
    double copies = 0;
    double nesting = 0; // sum of the depths of nesting
    double squares = 0; // sum of the squared depths
};

Made madeFor(const std::vector<Copy>& copies, const std::map<int, Made>& levels) {
    Made made;
    for (const Copy& copy : copies) {
        const Made inner = copy.projection ? Made() : levels.at(copy.level);
        made.copies += 1 + inner.copies;
        made.nesting += 1 + inner.copies + inner.nesting;
        made.squares += 1 + inner.copies + 2 * inner.nesting + inner.squares;
    }
    return made;
}

double effortOf(const std::vector<Copy>& picture, const Levels& levels) {
    constexpr double ofCopy = 60; // cost of a copy beside the square of its depth, measured in Chromium
    std::map<int, Made> made;
    for (const auto& [number, level] : levels)
        made[number] = madeFor(level.copies, made);
    const Made all = madeFor(picture, made);
    return ofCopy * all.copies + all.squares;
}

} // namespace

MergedCopies::MergedCopies(const CopyHierarchy& hierarchy, int depth) : m_picture(hierarchy.picture(depth)) {
    Merging merging(hierarchy, depth);
    Style style;
    m_levels = merging.levels(m_picture, style);
    double least = effort();
    // True if further merging gains nothing.
    const auto isEnough = [&](const Style& next) {
        if (least <= comfortable) return true;
        Levels levels = merging.levels(m_picture, next);
        if (levels.empty()) return true;
        if (const double effort = effortOf(m_picture, levels); effort < least) {
            least = effort;
            m_levels = std::move(levels);
            style = next;
        }
        return false;
    };
    const std::size_t outline = hierarchy.outline(depth).size();
    for (const std::size_t outlines : {2, 4, 8, 16, 32, 64, 128, 256, 512})
        if (isEnough({outlines * outline, 1})) break;
    for (const int stride : {2, 3, 4, 6, 8, 12, 16, 24, 32, 48})
        if (isEnough({style.corners, stride})) break;
    const auto addProjections = [this](const std::vector<Copy>& copies) {
        for (const Copy& copy : copies)
            if (copy.projection) m_projections.insert(*copy.projection);
    };
    addProjections(m_picture);
    for (const auto& [number, level] : m_levels)
        addProjections(level.copies);
}

double MergedCopies::effort() const {
    return effortOf(m_picture, m_levels);
}

} // namespace ifs
