// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/request/camera.h"
#include "ifs/system/affine_map.h"

#include <cmath>
#include <cstdint>

namespace attractor {

// Colour stealing: a pixel of F has the colour that a picture on G has at T_FG of it.
// docs/mathematics.md, "Fractal tops".
struct TheftRequest {
    Camera camera;               // camera of F
    ifs::AffineMap<2> toPicture; // coordinates of G → pixels of the picture
    bool isExact = false;        // true: ExactTops; false: KeyTops
    std::uint64_t points = 10'000'000;
    std::uint64_t seed = 1;
    int threads = 1; // no effect on pixels
    Rgba background{13, 16, 23, 255};
};

// Number of pixels of the picture that one pixel of F covers where T preserves areas.
inline double picturePixels(const TheftRequest& request) {
    const double pixel = request.camera.pixelsPerUnit;
    return std::abs(ifs::determinant<2>(request.toPicture.linear)) / (pixel * pixel);
}

} // namespace attractor
