// SPDX-License-Identifier: MIT
#pragma once

#include "collage/fit/map_fit.h"
#include "collage/target/target.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace collage {

struct AttractorSchedule {
    Constraints constraints;
    int iterations = 12;
    double maxNorm = 0.95;
};

// Moves the maps so that their attractor, not only the collage, comes closer to the target: Gauss–Newton
// through the dynamics, where a point x = w_i(y) of the attractor has the derivative A_i ∂y + ∂w_i(y).
// docs/mathematics.md, "Collages". Maps of the plane, contractions all; visibleError() does not grow, except
// that maps which break a constraint are first moved to meet it. Maps
// with `locked` stay bit for bit; an empty span locks none. A stop ends it between two steps.
std::vector<ifs::AffineMap<2>> fittedAttractor(const Target& target, std::vector<ifs::AffineMap<2>> maps,
                                               const AttractorSchedule& schedule,
                                               std::span<const std::uint8_t> locked = {},
                                               const std::stop_token& stop = {});

} // namespace collage
