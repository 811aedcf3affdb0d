// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"

#include <array>

// Eases: the share of the way between two keys as a function of time.
namespace animation {

constexpr double maxSlope = 20; // largest slope of a custom curve

struct Ease {
    enum class Kind {
        Hold, // constant until the next key
        Linear,
        In,     // slow start
        Out,    // slow end
        Both,   // slow start and end
        Cubic,  // the Bézier curve from (0, 0) by (x1, y1) and (x2, y2) to (1, 1)
        Smooth, // linear in time, with a path that has no corner at its keys
    };
    Kind kind = Kind::Linear;
    double x1 = 0, y1 = 0, x2 = 1, y2 = 1; // control points of Cubic

    friend bool operator==(const Ease&, const Ease&) = default;
};

// The share of the way after the share `u` of the time: from exactly 0 at u ≤ 0 to exactly 1 at u ≥ 1, and
// always between the two. Needs a valid ease; then |e(u + δ) − e(u)| ≤ maxSlope·δ unless it is Hold.
double eased(const Ease& ease, double u);

// Returns true if every number of a curve is from 0 to 1, so that x grows and nothing overshoots, and no
// slope is above maxSlope.
bool isValid(const Ease& ease);

// The curve through these handles; where it would be too steep, they are drawn towards the straight line as
// little as makes it valid. Numbers outside of 0 … 1 are taken to the nearer end.
Ease cubicEase(double x1, double y1, double x2, double y2);

} // namespace animation

template <>
inline constexpr auto ifs::names<animation::Ease::Kind> = std::to_array<ifs::Named<animation::Ease::Kind>>({
    {animation::Ease::Kind::Hold, "hold"},
    {animation::Ease::Kind::Linear, "linear"},
    {animation::Ease::Kind::In, "in"},
    {animation::Ease::Kind::Out, "out"},
    {animation::Ease::Kind::Both, "both"},
    {animation::Ease::Kind::Cubic, "cubic"},
    {animation::Ease::Kind::Smooth, "smooth"},
});
