// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

namespace document {

// An edit of what an entry shows at a moment, as an edit of the entry itself: docs/decisions/0010.
struct FrameEdit {
    Fractal fractal;
    int frame = 0;        // frame at which keys were written
    bool isKeyed = false; // true if keys were written
};

// The entry for which frameAt(entry, moment), which was `before`, becomes `after`. Values with keys get a key
// at this frame; values without keys change for all times. Equal values keep their bits, and motions are
// undone up to rounding. Tracks of maps and branches that are gone go with them, and so do the keys of a cage
// that now has another number of vertices. An entry without an animation, and one of another dimension than
// `after`, is replaced.
FrameEdit withFrameEdited(const Fractal& entry, const animation::Moment& moment, const Fractal& before,
                          Fractal after);

} // namespace document
