// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/affine_map.h"

#include <span>
#include <type_traits>
#include <vector>

// Shapes to which a cage can be fitted: polygons and polyhedra around an attractor, certified to hold it.
// Menus and --rest-cage follow from these tables.
namespace document {

// The bounding box, the smallest rectangle of any direction, the convex hull simplified from outside to so
// many corners, and the smallest regular polygon with so many.
enum class PolygonChoice { Box, Rectangle, Hull, Regular };

// The minimal canonical simplex, which is in no table; eight corners of the box, six of an octahedron, or at
// most so many of a hull.
enum class SpacePolyhedron { Simplex, Box, Octahedron, Hull };

// Numbers of corners that a fit can have.
struct CornerCounts {
    int usual, least, most;
    std::span<const int> offered{}; // numbers in the menu; empty: no choice
};

template <int Dim> struct CageFit {
    std::conditional_t<Dim == 2, PolygonChoice, SpacePolyhedron> choice;
    const char* id;    // name on the command line; empty: none
    const char* title; // title in the menu, for Text::tr()
    CornerCounts corners;
    // The tolerance is that of extents in space.
    std::vector<ifs::Vector<Dim>> (*around)(const ifs::SupportFunction<Dim>&, double tolerance, int corners);
};

// The fits in the order of the menu.
template <int Dim> std::span<const CageFit<Dim>> cageFits();
template <> std::span<const CageFit<2>> cageFits<2>();
template <> std::span<const CageFit<3>> cageFits<3>();

} // namespace document
