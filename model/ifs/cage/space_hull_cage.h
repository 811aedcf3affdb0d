// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"

#include <vector>

// Cages around an attractor in space that have more than four vertices. docs/mathematics.md, "Hull cages in
// space". All contain the attractor, but for coordinates of the box that are 0 to within their error: they
// are 0.
namespace ifs {

// The corners of its certified box, x changing fastest. Where the attractor is flat, the box has a thickness
// of a thousandth of its size.
std::vector<Vector<3>> boxCage(const SupportFunction<3>& support, double tolerance);
// The smallest regular octahedron with its corners on the axes through the middle of the box: −x, x, −y, …
std::vector<Vector<3>> octahedronCage(const SupportFunction<3>& support, double tolerance);
// A polyhedron of 8 to `corners` corners: the box, from which planes that touch the attractor cut those
// corners first with which most volume goes. corners ≥ 8.
std::vector<Vector<3>> hullCage(const SupportFunction<3>& support, int corners, double tolerance);

} // namespace ifs
