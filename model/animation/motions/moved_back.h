// SPDX-License-Identifier: MIT
#pragma once

#include "animation/motions/motion.h"

#include <vector>

namespace animation {

// The maps from which the motions, in their order, make those of `shown` at this moment, which is folded: the
// inverse of moveMaps(), up to rounding. A map that no motion moves stays as it is, bit by bit.
// docs/mathematics.md, "Animation".
template <int Dim>
ifs::IteratedFunctionSystem<Dim> movedBack(const std::vector<Motion<Dim>>& motions, const Moment& moment,
                                           int length, ifs::IteratedFunctionSystem<Dim> shown);

// The same for the cage that Orbit turns.
void turnBack(const std::vector<Motion<2>>& motions, const Moment& moment, int length,
              ifs::ControlCage<2>& cage);

} // namespace animation
