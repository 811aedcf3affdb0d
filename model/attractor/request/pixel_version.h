// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Version of the pixels that this program draws for a request. Raise it by 1 with every change after which
// any picture, in the plane or in space, has other pixels than before, even a single one; redrawing the
// golden pictures means raising it. Frames and sums of another version are not mixed with ours; they are
// drawn again or refused.
inline constexpr int pixelVersion = 5;

} // namespace attractor
