// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/branch.h"
#include "ifs/tops/enclosing_polygon.h"

#include <cstddef>
#include <optional>

// Fractal tops. Of the addresses of a point, the top one comes first in the lexicographic order in which the
// first map of the list comes before the others. docs/mathematics.md, "Fractal tops".
namespace ifs {

struct TopAddress {
    Word word;              // all symbols that doubles determine
    std::size_t period = 0; // > 0: number of last symbols that repeat for ever; 0: the first map repeats
    Vector<2> point;        // image under w_word of the repeating point, on the attractor
};

// The first `count` symbols of the address without end.
Word symbols(const TopAddress& top, std::size_t count);

// φ of the address under other maps, as many as there are; nullopt where no single point repeats.
std::optional<Vector<2>> pointOf(const TopAddress& top, std::span<const AffineMap<2>> maps);

// Finds top addresses in one attractor. A point means all that doubles cannot tell from it: on the boundary
// of two pieces, it has the address of the upper one.
class TopSearch {
public:
    explicit TopSearch(SupportFunction<2> attractor);

    // `isCutShort`: the search was given up, and nothing is known.
    struct Answer {
        std::optional<TopAddress> top; // nullopt: x is farther than reach() from the attractor
        bool isCutShort = false;
    };
    // The address of x, or of the point of the attractor nearest to it.
    Answer at(const Vector<2>& x) const;

    // Distance relative to the size of the attractor, the diagonal of its box.
    double reach() const { return 1e-9 * m_size; }
    double tolerance() const { return m_tolerance; } // distance within which points are regarded as equal
    const SupportFunction<2>& attractor() const { return m_attractor; }

private:
    struct Found {
        Word word;
        bool isFound = false;
        bool isCutShort = false;
    };
    Found firstWithin(const Vector<2>& x) const;
    bool isNear(const AffineMap<2>& map, const Vector<2>& x) const;
    bool isOutside(const AffineMap<2>& map, const Vector<2>& x) const;
    Word settled(const Word& word) const;
    TopAddress completed(const Word& settled, const Vector<2>& x) const;
    std::optional<TopAddress> repeating(const Word& settled, std::size_t carried, const Vector<2>& x) const;

    SupportFunction<2> m_attractor;
    EnclosingPolygon m_polygon;
    double m_size = 0;
    double m_tolerance = 0;
};

} // namespace ifs
