// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <optional>

namespace document {

// The frames from `from` to `to` last until `end` instead.
struct Stretch {
    int from = 0;
    int to = 0;
    int end = 0;

    friend bool operator==(const Stretch&, const Stretch&) = default;
};

// The keys of all tracks in the range are spread evenly over its new length, at whole frames. Later ones keep
// their distance to its end, and so does the end of the animation. nullopt where nothing moves, the range is
// empty, two keys of a track would meet, or the animation would become too long.
std::optional<Fractal> withKeysStretched(Fractal entry, const Stretch& stretch);

} // namespace document
