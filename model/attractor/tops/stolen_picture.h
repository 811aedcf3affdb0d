// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/request/camera.h"
#include "attractor/tops/coupled_system.h"
#include "attractor/tops/exact_tops.h"
#include "attractor/tops/key_tops.h"
#include "attractor/tops/mip_picture.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>

namespace attractor {

// Colour stealing: a pixel of F has the colour that a picture on G has at T_FG of it.
// docs/mathematics.md, "Fractal tops".
struct TheftRequest {
    Camera camera;               // of F
    ifs::AffineMap<2> toPicture; // from coordinates of G to pixels of the picture
    bool isExact = false;        // ExactTops; else KeyTops
    std::uint64_t points = 10'000'000;
    std::uint64_t seed = 1;
    int threads = 1; // never changes a pixel
    Rgba background{13, 16, 23, 255};
};

enum class TheftOutcome { Done, Stopped, CutShort, NotTaken };

// Draws some rows at a time; take(pixels) gets whole rows from the top on, 0xAARRGGBB premultiplied, in the
// calling thread, and says whether to go on. CutShort: the system has too many words for isExact.
TheftOutcome steal(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                   const std::function<bool(std::span<const std::uint32_t> pixels)>& take,
                   const std::stop_token& stop);

// The colours of pixels of F; `points` and `pixels` are as many.
void colour(std::span<const TopPoint> points, const MipPicture& picture, const TheftRequest& request,
            std::span<std::uint32_t> pixels);

} // namespace attractor
