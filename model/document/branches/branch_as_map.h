// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/branch.h"

namespace document {

// The system over the cut set of a branch, a word over the maps that take part, in which the branch is the
// first map. The maps have the colours and the labels of the maps they begin with, and blends that keep
// colours along the address. Maps that take no part stay, at the end; moved branches move as before. Maps
// must not be linked.
template <int Dim> Fractal withBranchAsMap(const Fractal& fractal, const ifs::Word& letters);

} // namespace document
