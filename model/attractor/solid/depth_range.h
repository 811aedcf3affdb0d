// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/prepared_space.h"
#include "attractor/solid/space_view.h"

#include <stop_token>

namespace attractor {

// Range of the depths of everything in view, in pixels of the plane of the target: certified, and tight
// within a few pixels unless the search is cut short. Empty, near > far, when nothing is in view.
struct DepthRange {
    // The length beyond which 24 bits no longer distinguish a sixteenth of a pixel: anything farther has the
    // farthest depth.
    static constexpr double maxLength = 0x1p20;

    double near = 0;
    double far = 0;
    bool isClamped = false; // true if something may lie beyond `far`
};
DepthRange depthRange(const PreparedSpace& system, const SpaceView& view, const std::stop_token& stop = {});

} // namespace attractor
