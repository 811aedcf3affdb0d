// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/outline.h"
#include "ifs/extent/polygon.h"
#include "ifs/extent/support_value.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace ifs {

// The attractor from inside and outside at once, refined where the two are farthest apart: between two lines
// its hull lies between the corner where they meet and the segment of their points. Seen from the centre of
// the attractor. docs/mathematics.md, "Convex hull".
class Sandwich {
public:
    // Answers h_A(u) as SupportFunction<2> does: of u, a tolerance, a limit of words, and a known outline.
    using Ask = std::function<SupportValue<2>(const Vector<2>&, double, int, const Outline*)>;

    // Refines until lines and points are nowhere farther apart than `tolerance`, or `maxLines` lines were
    // asked for. A coarser outline known before shortens the search. When stopped, the outline is coarser but
    // valid.
    Sandwich(Ask support, const Vector<2>& centre, double tolerance, const Outline* known, int maxLines,
             std::stop_token stop = {});

    const Outline& outline() const { return m_outline; }

    // Upper bound of the distance of a point of the attractor from the hull of the points.
    double error() const;

    // Finds each corner exactly, by a search in the middle of its normals, where it is the only farthest
    // point; a search along an edge may stop anywhere beside it.
    void settleCorners(const Polygon& polygon);

private:
    SupportValue<2> ask(const Vector<2>& normal, double tolerance) const;
    void add(const Vector<2>& normal, const SupportValue<2>& h);
    const Vector<2>& pointAt(std::size_t line) const;
    bool refine();
    std::optional<Vector<2>> directionInto(std::size_t line) const;

    Ask m_support;
    Vector<2> m_centre;
    double m_tolerance;
    const Outline* m_known;
    std::stop_token m_stop;
    Outline m_outline;
};

} // namespace ifs
