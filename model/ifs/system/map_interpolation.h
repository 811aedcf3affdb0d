// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

// Maps that move. docs/mathematics.md, "Weaving".
namespace ifs {

// A branch swings about its base: w(x) ↦ q + R(angle)(w(x) − q) with q = w(root), angle in radians,
// counter-clockwise. With angle 0 exactly the map itself.
AffineMap<2> swung(const AffineMap<2>& map, const Vector<2>& root, double angle);

// amplitude·sin(2π·frequency·time + phase), in radians.
struct Swing {
    double amplitude = 0;
    double frequency = 1;
    double phase = 0;

    double angle(double time) const;
};

// Interpolates between two maps, t in [0, 1], exact at both ends: polar parts A = R·S with the rotation along
// the shortest way (half a turn: counter-clockwise) and S linear in t, so ‖A(t)‖ ≤ max(‖A_0‖, ‖A_1‖); the
// image of `reference` moves straight. A point, or a line in space, turns no more than it must: polarPair().
template <int Dim>
AffineMap<Dim> interpolated(const AffineMap<Dim>& from, const AffineMap<Dim>& to, double t,
                            const Vector<Dim>& reference);

// Returns true if the determinants have opposite signs, so that every path between the maps is singular
// somewhere.
template <int Dim> bool mirrors(const AffineMap<Dim>& from, const AffineMap<Dim>& to);

} // namespace ifs
