// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/light/light_kernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// Darkening of creases.
struct Occlusion {
    static constexpr std::array<int, kernels::occlusionRadii> radii{1, 3, 9}; // pixels
    double strength = 1;                                                      // κ, 0 … 4
    double saturation = 2; // pixels of depth per pixel of radius, > 0
    std::array<double, kernels::occlusionRadii> shares{1.0 / 3, 1.0 / 3, 1.0 / 3}; // weights; their sum is 1
};

// The surface in one row: pixels [first, end); the others are empty. Pointers are valid up to the next row.
struct SurfaceRow {
    int first = 0;
    int end = 0;
    const std::int32_t* codes = nullptr; // kernels::emptyDepth in empty pixels
    const float* shade = nullptr;        // exp(−κ · response); 1 if nothing around is nearer
    const float* right = nullptr;        // slope away from the eye, per pixel to the right
    const float* up = nullptr;           // slope away from the eye, per pixel up
};

// Walks down the rows of a raster and keeps of them what the light at one row depends on: those up to 13
// away. The larger radii look at the nearest depth within 3 × 3 and 9 × 9 pixels around each neighbour.
// docs/mathematics.md, "Light on a solid".
class SurfaceRows {
public:
    // The first next() gives row `firstRow`. `unitsPerPixel` is a length in space, that of a pixel at the
    // target.
    SurfaceRows(const DepthRaster& raster, double unitsPerPixel, const Occlusion& occlusion, int firstRow);

    // The next row. Call only within the raster.
    SurfaceRow next();

private:
    // Rows of which the last `Kept` can be read, with margins in which nothing is.
    template <std::size_t Kept> class Ring {
    public:
        void resize(std::size_t stride) {
            m_stride = stride;
            m_cells.assign(stride * Kept, kernels::emptyDepth);
        }
        std::int32_t* row(int y) {
            return m_cells.data() + (static_cast<std::size_t>(y) & (Kept - 1)) * m_stride;
        }

    private:
        static_assert((Kept & (Kept - 1)) == 0);
        std::size_t m_stride = 0;
        std::vector<std::int32_t> m_cells;
    };

    void load(int y);
    kernels::Neighbours around(std::size_t radius, int y);

    const DepthRaster& m_raster;
    float m_pixelsPerCode = 0;
    std::array<kernels::OcclusionRadius, kernels::occlusionRadii> m_radii;
    int m_row;                                  // next row to return
    int m_loaded;                               // next row to load
    int m_first, m_end;                         // columns that bound everything loaded so far
    std::array<kernels::Margins, 16> m_margins; // margins of the rows in m_codes
    Ring<16> m_codes;
    Ring<4> m_three;   // minima over 3 pixels of a row
    Ring<16> m_square; // minima over 3 × 3 pixels
    Ring<8> m_nine;    // minima over 9 × 3 pixels
    Ring<32> m_large;  // minima over 9 × 9 pixels
    std::vector<float> m_shade, m_right, m_up;
};

} // namespace attractor
