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
    bool opaque = false;       // every pixel has alpha 255
    std::uint64_t samples = 0; // accumulated so far
    double measure = 0;        // of the words that meet the view, estimated; 1 when all of the attractor does
    int passes = 0;
    int iterations = 0; // Deterministic: drawn
    Exposure exposure;  // that of the request, else of this picture
    Exposure shown;     // in the pixels: another one while brightness eases
    RenderNote note = RenderNote::None;
    double milliseconds = 0; // time the last pass took
};

} // namespace attractor
