// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Which pixels this program draws of a request. Raise it by 1 with every change after which any picture, in
// the plane or in space, has other pixels than before, even a single one: whoever draws the golden pictures
// anew raises it, too. Frames and sums of another number are not mixed with ours; they are drawn again or
// refused.
inline constexpr int pixelVersion = 5;

} // namespace attractor
