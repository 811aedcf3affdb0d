// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"

#include <cstdint>
#include <vector>

namespace attractor {

// A finished picture: an immutable result.
struct Frame {
    std::uint64_t revision = 0;
    Camera camera;
    // 0xAARRGGBB, premultiplied, rows from the top, camera.width × camera.height
    std::vector<std::uint32_t> pixels;
    bool opaque = false;       // true: every pixel has alpha 255
    std::uint64_t samples = 0; // samples accumulated so far
    double measure = 0; // estimated measure of the words that meet the view; 1 if the whole attractor does
    int passes = 0;
    int iterations = 0; // steps drawn; Deterministic only
    Exposure exposure;  // exposure of the request, else of this picture
    Exposure shown;     // exposure of the pixels: differs from `exposure` while brightness eases
    RenderNote note = RenderNote::None;
    double milliseconds = 0; // duration of the last pass
};

} // namespace attractor
