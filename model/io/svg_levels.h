// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace io {

// `map` with every singular value that is too small raised to `least`; the image of `centre` stays. Drawing
// programs refuse singular matrices.
ifs::AffineMap<2> thickened(const ifs::AffineMap<2>& map, const ifs::Vector<2>& centre, double least);

// How a picture of an attractor is put together from copies of itself. Level 0 is an outline around the
// attractor; level k is, for every map, a copy of the level that lies below k by as many steps as the map
// shrinks, so that the copies of level 0 that end up in the picture have about the same size. Where these
// would be too thin to be seen, the picture is made of shadows of the attractor instead.
class SvgLevels {
public:
    static constexpr std::uint64_t mostReferences = 400'000;
    static constexpr std::uint64_t comfortableReferences = 150'000;
    static constexpr int mostLevels = 200;

    // `display` takes the code's coordinates to pixels. nullopt without an attractor of finite size.
    static std::optional<SvgLevels> of(const document::System2& system, const ifs::AffineMap<2>& display,
                                       std::span<const ifs::MovedBranch<2>> moved = {});

    // The active maps' places in the system, and where the picture goes.
    const std::vector<std::size_t>& index() const { return m_index; }
    const ifs::AffineMap<2>& display() const { return m_display; } // not singular

    // A copy of a level, or of the shadow of a map. Its map is not singular: a singular one is raised to what
    // can be seen at the size of that copy.
    struct Copy {
        ifs::AffineMap<2> map;
        int level = 0;
        std::optional<std::size_t> shadow;
        std::optional<std::size_t> first; // the outermost map; nullopt: all of the attractor
    };
    Copy copy(std::size_t i, int level, int depth) const; // that the i-th map makes for this level
    std::vector<Copy> copies(int level, int depth) const; // that a level above 0 is made of
    std::vector<Copy> picture(int depth) const; // that the whole is made of, in coordinates of the code

    // A singular map shows the attractor flat on a line, and there is nothing of a level below left to see.
    // Its copies are of these bars: they cover the attractor seen along that line to half a pixel.
    struct Shadow {
        std::vector<std::vector<ifs::Vector<2>>> bars;
        double detail; // in the code's units
    };
    const std::optional<Shadow>& shadowOf(std::size_t i) const { return m_shadows[i]; }

    // Level 0 for a picture of this depth: contains the attractor; convex, counter-clockwise. So much wider
    // that copies thinner than a pixel do not fade away, and longer along the fibres of a curve.
    std::vector<ifs::Vector<2>> outline(int depth) const;

    // Copies that a reader of the file makes in all for one of `level`; stays at mostReferences once reached.
    std::uint64_t references(int level) const;
    int deepest() const; // with fewer than mostReferences

    // Certified bound, in pixels, of the distance between the attractor and what is drawn, both ways.
    double error(int depth) const;
    // The first whose copies leave no larger error, else the deepest that programs draw without a long wait.
    int levelFor(double error) const;

private:
    int levelFor(double error, double largest) const; // no copy is kept larger so as not to fade
    int below(int level, std::size_t map) const;      // the level of which `map` makes a copy for `level`
    ifs::AffineMap<2> map(std::size_t i, int level, int depth) const; // by which it makes that copy
    std::vector<ifs::MovedBranch<2>> pieces() const; // over the active maps; none is singular
    void findFibre();
    void thickenAll(const std::vector<ifs::AffineMap<2>>& maps, const ifs::AffineMap<2>& display);
    Shadow shadowOf(const ifs::AffineMap<2>& map) const;
    Shadow shadowAlong(const ifs::Vector<2>& along, double length) const;
    void findFaintLevel();
    void writeOut();
    void countReferences();
    double shiftBetween(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) const; // of the attractor
    double shadowError(const Shadow& shadow, const ifs::AffineMap<2>& drawn,
                       const ifs::AffineMap<2>& map) const;
    struct Deviation {
        double copy = 0; // largest copy of level 0, in pixels
        double all = 0;  // with shadows and what thickening adds; infinite for too many copies to count
        double area = 0; // of all copies of level 0, in pixels
        double length = 0;
    };
    Deviation deviation(int depth) const;
    static bool isFaint(const Deviation& deviation);
    double margin(int depth) const;        // between the hull and the outline
    ifs::Vector<2> fibre(int depth) const; // by which the outline is longer at both ends

    std::vector<ifs::Vector<2>> m_hull;
    double m_hullError = 0;
    double m_diameter = 0; // of the hull
    double m_pixel = 1;    // in the code's units
    ifs::Vector<2> m_centre = ifs::Vector<2>::Zero();
    std::vector<ifs::AffineMap<2>> m_maps;        // as they are
    std::vector<std::optional<Shadow>> m_shadows; // of the singular maps, by map; then of words
    // From this depth on copies would fade away, and the picture is made of these words instead, as dots and
    // as shadows thick enough to be seen.
    int m_faintLevel = mostLevels + 1;
    struct Word {
        Copy copy;
        ifs::AffineMap<2> map; // the product that the copy stands for
    };
    std::vector<Word> m_words;
    double m_thinness = 0; // that a singular map is raised to, as a copy of the whole picture
    // The direction that all maps keep and shrink the most, as those of a curve over an axis do: copies
    // become thin along it alone, and one may be made longer there without reaching aside.
    ifs::Vector<2> m_fibre = ifs::Vector<2>::Zero();
    double m_fibreShrinkage = 0; // minus the logarithm of what one level shrinks it by, at least
    std::vector<std::size_t> m_index;
    std::vector<ifs::MovedBranch<2>> m_moved;
    std::vector<int> m_steps;
    double m_shrinkage = 0; // minus the logarithm of what one level shrinks by
    ifs::AffineMap<2> m_display;
    double m_displayShift = 0; // in pixels
    std::vector<std::uint64_t> m_references;
};

} // namespace io
