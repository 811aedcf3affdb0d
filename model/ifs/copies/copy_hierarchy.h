// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/copies/copy.h"
#include "ifs/copies/copy_error.h"
#include "ifs/copies/copy_frame.h"
#include "ifs/copies/copy_projection.h"
#include "ifs/copies/copy_words.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ifs {

// Picture of an attractor put together from copies of itself. Level 0 is an outline around the attractor;
// level k is, for every map, a copy of the level that lies below k by as many steps as the map shrinks, so
// that the copies of level 0 that end up in the picture have about the same size. Where these would be too
// thin to be seen, the picture is made of projections of the attractor instead.
// docs/decisions/0003-thin-copies-in-svg.md.
class CopyHierarchy {
public:
    static constexpr std::uint64_t maxReferences = 400'000;
    static constexpr std::uint64_t comfortableReferences = 150'000;
    static constexpr int maxLevels = 200;

    // `display` takes the code's coordinates to pixels. Words of `moved` are over places in the system.
    // nullopt without an attractor of finite size.
    static std::optional<CopyHierarchy> of(const IteratedFunctionSystem<2>& system,
                                           const AffineMap<2>& display,
                                           std::span<const MovedBranch<2>> moved = {});

    // The active maps' indices in the system, and where the picture goes.
    const std::vector<std::size_t>& index() const { return m_index; }
    const AffineMap<2>& display() const { return m_display; } // regular

    // The copy by a map. A singular map is raised until its copy is visible at its size.
    Copy copy(std::size_t i, int level, int depth) const; // copy by the i-th map for this level
    std::vector<Copy> copies(int level, int depth) const; // copies that a level above 0 consists of
    // Copies that the whole consists of, in coordinates of the code.
    std::vector<Copy> picture(int depth) const;

    // The projection of copies that name one, by map; nullopt for a map that is not singular.
    const std::optional<CopyProjection>& projection(std::size_t i) const { return m_projections[i]; }

    // Level 0 for a picture of this depth: contains the attractor; convex, counter-clockwise. So much wider
    // that copies thinner than a pixel do not fade away, and longer along the fibres of a curve.
    Polygon outline(int depth) const;

    // Copies that a reader of the file makes in all for one of `level`; stays at maxReferences once reached.
    std::uint64_t references(int level) const;
    int deepest() const; // greatest depth with fewer than maxReferences

    // Certified bound, in pixels, of the distance between the attractor and the drawing, both ways.
    double error(int depth) const;
    // The first whose copies leave no larger error, else the deepest that programs draw without a long wait.
    int levelFor(double error) const;

private:
    CopyHierarchy(CopyFrame frame, ActiveMaps<2> active, const AffineMap<2>& display,
                  std::span<const MovedBranch<2>> moved);

    void findProjections();
    void findFibre();
    void countReferences();
    void findFaintLevel();
    int levelFor(double error, double largest) const; // level of a copy, never larger merely to stay visible
    int below(int level, std::size_t map) const;      // level of the copy that `map` makes for `level`
    AffineMap<2> map(std::size_t i, int level, int depth) const; // map of that copy
    std::vector<MovedBranch<2>> pieces() const; // words over the active maps; all changes are regular
    double margin(int depth) const;             // distance between the hull and the outline
    Vector<2> fibre(int depth) const;           // vector by which the outline is longer at both ends
    // `error`, `largest` and `missing` infinite for too many copies to count.
    CopyDeviation deviation(int depth, double excess = HUGE_VAL) const;
    // Bound of the distance of level 0 from the attractor, in units of the code.
    double excess(int depth) const;
    double farthest(int depth) const; // bound of the distance of a copy from the attractor, in pixels
    CopyStep step(const Copy& copy, const AffineMap<2>& map) const; // step of a copy that stands for `map`

    CopyFrame m_frame;
    std::vector<AffineMap<2>> m_maps; // unchanged maps
    std::vector<std::size_t> m_index;
    std::vector<MovedBranch<2>> m_moved;
    AffineMap<2> m_display;
    double m_displayShift = 0;                                // pixels
    std::vector<std::optional<CopyProjection>> m_projections; // projections of the maps, then of words
    std::vector<int> m_steps;
    double m_shrinkage = 0; // −log of the factor by which one level shrinks
    // The direction that all maps keep and shrink the most, as those of a curve over an axis do: copies
    // become thin along it alone, and one may be made longer there without reaching aside.
    Vector<2> m_fibre = Vector<2>::Zero();
    double m_fibreShrinkage = 0; // −log of the greatest factor by which one level shrinks along the fibre
    std::vector<std::uint64_t> m_references;
    // Depth from which on copies would fade away, so that the picture is made of the words below instead.
    int m_faintLevel = maxLevels + 1;
    std::vector<CopyWords::Word> m_words;
};

} // namespace ifs
