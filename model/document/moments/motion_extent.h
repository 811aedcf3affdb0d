// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal_geometry.h"

#include <functional>
#include <optional>
#include <vector>

namespace document {

// The extent of an animation in the plane, from its first moment to its last.
struct MotionExtent {
    // Contains the picture at each of the moments that were looked at; nullopt where none has a picture.
    std::optional<Box> picture;
    std::vector<ifs::Vector<2>> corners; // corners of the cage at these moments
};

// The smallest box around both.
Box united(const Box& a, const Box& b);

// The extent, including the shadow, over evenly spaced moments and the keys. An entry without an animation
// has a single moment. `stopped` is asked before each; after it returned true the result is meaningless.
// Thread-safe.
MotionExtent motionExtent(
    const Fractal& entry, const std::function<bool()>& stopped = [] { return false; },
    attractor::YAxis yAxis = attractor::YAxis::Up);

// The same in space: the corners of a box around the picture at each of these moments, and of the cage. Empty
// where nothing moves, or only the view. Any thread.
std::vector<ifs::Vector<3>> motionCorners(
    const Fractal& entry, const std::function<bool()>& stopped = [] { return false; });

} // namespace document
