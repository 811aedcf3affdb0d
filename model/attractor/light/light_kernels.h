// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_appearance.h"

#include <array>
#include <cstddef>
#include <cstdint>

// The loops that light a solid, row by row, compiled for several instruction sets; all give the same bits.
// docs/mathematics.md, "Light on a solid".
namespace attractor::kernels {

// Depth of an empty pixel: behind every depth code, by more than two codes can differ.
constexpr std::int32_t emptyDepth = 1 << 26;

// Keys of a raster → depth codes.
void depthCodes(const std::uint32_t* keys, std::size_t count, std::int32_t* codes);

// The number of pixels before the first and after the last that is not empty; both `count` where all are.
struct Margins {
    std::size_t before = 0;
    std::size_t after = 0;
};
Margins emptyMargins(const std::uint32_t* keys, std::size_t count);

// The smallest of three numbers each.
void minimumOf3(const std::int32_t* a, const std::int32_t* b, const std::int32_t* c, std::size_t count,
                std::int32_t* minimum);

// The row of a pixel's depth and those above and below it by a step, which is also taken to both sides: where
// its eight neighbours are. Readable `step` to either side of the pixels asked for.
struct Neighbours {
    const std::int32_t* above = nullptr;
    const std::int32_t* row = nullptr;
    const std::int32_t* below = nullptr;
    std::size_t step = 1;
};

// Eye-dome lighting at one radius.
struct OcclusionRadius {
    Neighbours neighbours;
    std::int32_t saturation = 1; // codes, 1 … 2²⁴: greater differences in depth count as this one
    float perCode = 0; // weight of one code of depth in front; the sum over radii and neighbours is at most 4
};
constexpr std::size_t occlusionRadii = 3;

// shade = exp(−Σ perCode · saturated (z − z_k)) over all neighbours: exactly 1 where none is nearer.
void shades(const std::int32_t* codes, const std::array<OcclusionRadius, occlusionRadii>& radii,
            std::size_t count, float* shade);

// The slope of the surface, away from the eye per pixel to the right and per pixel up: along each axis, the
// one-sided difference of smaller magnitude, 0 where both neighbours are empty. `scale` is pixels per code.
void slopes(const Neighbours& neighbours, float scale, std::size_t count, float* right, float* up);

// Light in [0, 1] that a surface of these slopes returns: headlight and key light, half-Lambert, times shade.
struct Lamps {
    ViewVector key;
    float headShare = 0.4F; // share of the headlight; the key light has the rest
};
void illuminate(const float* right, const float* up, const float* shade, const Lamps& lamps,
                std::size_t count, float* light);

// pixel = colours[tint · levels + light · (levels − 1)], or `ground` where there is nothing.
struct Ramp {
    const std::uint32_t* colours = nullptr;
    std::int32_t levels = 1;
    std::uint32_t ground = 0;
};
// `tints` holds the number of a tint for each pixel.
void paint(const std::int32_t* codes, const float* light, const std::int32_t* tints, const Ramp& ramp,
           std::size_t count, std::uint32_t* pixels);

// Mixes every channel with that of `ground`: of the pixel remains clear[code >> fogShift] / fullClear.
constexpr int fogShift = 12;
constexpr std::int32_t fullClear = 4096;
constexpr std::size_t fogSize = std::size_t{1} << (24 - fogShift);
void addFog(const std::int32_t* codes, const std::int32_t* clear, std::uint32_t ground, std::size_t count,
            std::uint32_t* pixels);

} // namespace attractor::kernels
