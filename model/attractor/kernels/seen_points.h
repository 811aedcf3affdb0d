// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace attractor::kernels {

// Points in pixels: columns, rows and depths.
struct PixelPoints {
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    std::size_t size = 0; // a multiple of solidLanes
};

// Bounds of the position errors of points. Relative to another point at a distance (dx, dy, dz), pixel
// coordinates are off by at most flat·(|dx| + |dy|) + deep·|dz| + pixels, and depths by at most deep·(|dx| +
// |dy| + |dz|) + depth.
struct PointTolerance {
    float flat = 0;
    float deep = 0;
    float pixels = 0;
    float depth = 0;
};

// Writes 0 for points that share their pixel with a nearer one wherever in it they may be, 1 for the others;
// of points from about the nearest to the farthest, fewest. Instruction sets may differ in a few points.
void markSeen(const PixelPoints& points, const PointTolerance& tolerance, std::uint8_t* seen);

} // namespace attractor::kernels
