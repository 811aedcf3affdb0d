// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/steps/start_shape.h"

#include <optional>
#include <stop_token>

namespace document {

// Hausdorff distance of Wⁿ(B) from the attractor A, in the plane as it is displayed or, where the cage bends
// or flattens it, in that of the code.
struct StepDistance {
    double contraction = 0; // s, the largest spectral norm of a map
    // The distance measured on cells; nullopt where the maps are linked or s ≥ 1.
    std::optional<double> distance;
    double cell = 0;             // side of a cell; distances below a few cells are not resolved
    std::optional<double> bound; // sⁿ·d(B, A), an upper bound of d(Wⁿ(B), A); nullopt as above
    bool isOfCode = false;
};

// Measures B, a shape over the attractor, or the cage at rest without one. nullopt when stopped, and for
// entries that are no system of the plane. docs/mathematics.md, "Steps and their distance".
std::optional<StepDistance> stepDistance(const Fractal& fractal, const StartShape* shape, int iterations,
                                         const std::stop_token& stop);

} // namespace document
