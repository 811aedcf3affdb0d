// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/solid_walk.h"
#include "attractor/solid/space_view.h"

namespace attractor {

// Draws a word of which the clip keeps a part only: the points of the cover whose cells may reach into the
// clip, which is too much by less than a pixel. `word` maps box coordinates to those of SpaceView::toPixels,
// `shown` to the band. Finite numbers. docs/mathematics.md, "Slices".
void drawClipped(const ifs::AffineMap<3>& word, const kernels::SolidWord& shown, const PixelClip& clip,
                 const kernels::Cover& cover, kernels::KeyBand& band);

} // namespace attractor
