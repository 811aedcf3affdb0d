// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>

namespace ifs {

// A convex polygon of 16 sides around an attractor, and around its images under affine maps. Certified.
struct EnclosingPolygon {
    static constexpr std::size_t sides = 16;
    using Heights = std::array<double, sides>;
    using Corners = std::array<Vector<2>, sides>;

    static const std::array<Vector<2>, sides>& directions(); // unit vectors, counter-clockwise from (1, 0)

    explicit EnclosingPolygon(const SupportFunction<2>& attractor);

    Heights heights; // ⟨u_k, x⟩ ≤ heights[k] for every point of the attractor
    // Corners of a convex polygon that contains the attractor, counter-clockwise; unused places repeat the
    // last one.
    Corners corners;

    Corners image(const AffineMap<2>& map) const; // image of the corners
};

EnclosingPolygon::Heights heightsOf(const EnclosingPolygon::Corners& corners);
double diameterOf(const EnclosingPolygon::Corners& corners);
// The diameter of the union of both.
double diameterOf(const EnclosingPolygon::Corners& a, const EnclosingPolygon::Corners& b);

} // namespace ifs
