// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/prepared_space.h"
#include "attractor/solid/space_view.h"

#include <stop_token>

namespace attractor {

// Between which depths, in pixels of the plane of the target, all that is in view lies: certified, and within
// a few pixels where the search is not cut short. Empty, near > far, when nothing is in view.
struct DepthRange {
    // Beyond, 24 bits no longer tell a sixteenth of a pixel: what is farther has the farthest depth.
    static constexpr double maxLength = 0x1p20;

    double near = 0;
    double far = 0;
    bool isClamped = false; // something may lie beyond `far`
};
DepthRange depthRange(const PreparedSpace& system, const SpaceView& view, const std::stop_token& stop = {});

} // namespace attractor
