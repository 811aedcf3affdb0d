// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/polygon.h"

#include <optional>
#include <vector>

namespace ifs {

// Reference sizes for copies of an attractor, in coordinates of the code: a polygon around it and the size of
// a pixel.
struct CopyFrame {
    // Thickness of a copy by a singular map, in pixels: thinner ones are hardly visible.
    static constexpr double minThickness = 1.2;

    Polygon hull;         // strictly convex
    double hullError = 0; // bound of the distance from the attractor to the hull
    double diameter = 0;  // diameter of the hull
    Vector<2> centre = Vector<2>::Zero();
    double pixel = 1;    // side of a pixel where `display` stretches the most
    double thinness = 0; // singular value below which a copy of the whole picture is hardly visible

    // `display` takes the code's coordinates to pixels. nullopt without an attractor of finite size.
    static std::optional<CopyFrame> of(const std::vector<AffineMap<2>>& maps, const AffineMap<2>& display);
};

// The largest distance between two corners.
double diameter(const Polygon& polygon);

// A convex polygon, counter-clockwise, pushed out so that it holds every point within `distance` of it (the
// corners are cut only beyond that). A point or a segment becomes a rectangle.
Polygon pushedOut(const Polygon& polygon, double distance);

// Bound of the distance between the images of one point of the attractor under `a` and `b`.
double maxShift(const CopyFrame& frame, const AffineMap<2>& a, const AffineMap<2>& b);

} // namespace ifs
