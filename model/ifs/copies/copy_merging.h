// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/copies/copy_hierarchy.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace ifs {

// CopyHierarchy::picture(depth) and what it is made of, to be written down so that browsers show it without a
// long wait. They make every copy of a copy anew, and take time for each and for how deep it is nested. Where
// that would be too much, low levels are written as one path, and levels are made of copies some levels below
// them instead of the next one: a level whose largest map hardly shrinks is otherwise nested a hundred times.
// The shapes stay exactly the same. docs/decisions/0012-svg-in-browsers.md.
class MergedCopies {
public:
    // A reader's time up to which nothing is merged, as effort() gives it: about two seconds in Chromium.
    static constexpr double comfortable = 1'700'000;
    static constexpr std::size_t maxCorners = 60'000; // corners of all paths, unless there are none
    static constexpr std::size_t maxWritten = 4'000;  // copies, unless the unmerged levels have more

    // An image of the outline or of a projection.
    struct Piece {
        AffineMap<2> map;
        std::optional<std::size_t> projection;
    };
    struct Level {
        std::vector<Copy> copies;  // contents of a level that is not merged
        std::vector<Piece> pieces; // contents of the one path of a merged level
    };
    using Levels = std::map<int, Level>;

    MergedCopies(const CopyHierarchy& hierarchy, int depth);

    const std::vector<Copy>& picture() const { return m_picture; }
    const Levels& levels() const { return m_levels; } // required levels, lowest first
    const std::set<std::size_t>& projections() const { return m_projections; }

    // The copies that a reader of the file makes, weighed by the square of how deep each is nested.
    double effort() const;

private:
    std::vector<Copy> m_picture;
    Levels m_levels;
    std::set<std::size_t> m_projections;
};

} // namespace ifs
