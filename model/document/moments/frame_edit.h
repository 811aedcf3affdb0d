// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

namespace document {

// An edit of what an entry shows at a moment, as an edit of the entry itself: docs/decisions/0010.
struct FrameEdit {
    Fractal fractal;
    int frame = 0;        // at which keys were written
    bool isKeyed = false; // whether any were
};

// `before` is what frameAt(entry, moment) shows, `after` what it is to show. What has keys gets a key at this
// frame; what has none changes for all times. What does not differ keeps its bits, and motions are undone up
// to rounding. Tracks of maps and branches that are gone go with them, and so do the keys of a cage that now
// has another number of vertices. An entry without an animation, and one of another dimension than `after`,
// is replaced.
FrameEdit withFrameEdited(const Fractal& entry, const animation::Moment& moment, const Fractal& before,
                          Fractal after);

} // namespace document
