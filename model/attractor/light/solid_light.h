// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/light/solid_appearance.h"
#include "attractor/light/solid_ramp.h"
#include "attractor/light/surface_rows.h"
#include "attractor/light/tone_map16.h"
#include "attractor/threads/workers.h"

#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// Depths → pixels, the same bytes for every instruction set, in whatever bands the rows are made.
// docs/mathematics.md, "Light on a solid".
class SolidLight {
public:
    SolidLight(const SolidAppearance& appearance, const SolidView& view);

    // Rows [firstRow, endRow) of the raster, into `pixels` from its beginning: 0xAARRGGBB, premultiplied; or
    // 16 bits per channel, with light and normals as fine. Different rows may be made by different threads.
    void apply(const DepthRaster& raster, int firstRow, int endRow, std::span<std::uint32_t> pixels) const;
    void apply(const DepthRaster& raster, int firstRow, int endRow, std::span<Rgba16> pixels) const;

private:
    struct Band;
    const float* light(const SurfaceRow& row, Band& band) const;
    void tints(const DepthRaster& raster, const SurfaceRow& row, int y,
               std::vector<std::int32_t>& tints) const;
    void heightTints(const DepthRaster& raster, const SurfaceRow& row, int y,
                     std::vector<std::int32_t>& tints) const;
    Rgba16 surfaceColour(const SurfaceRow& row, std::size_t at, const Band& band) const;

    SolidAppearance m_appearance;
    SolidView m_view;
    SolidRamp m_ramp;
    std::vector<std::int32_t> m_clear; // share left by fog for each depth, in units of 1 / kernels::fullClear
};

// The whole picture.
std::vector<std::uint32_t> lit(const DepthRaster& raster, const SolidAppearance& appearance,
                               const SolidView& view, Workers& workers);

// Rows [firstRow, endRow) of the Depth look as numbers: depth = near + (far − near)·v/65534, 65535 is
// nothing.
void depthValues(const DepthRaster& raster, int firstRow, int endRow, std::span<std::uint16_t> values);

} // namespace attractor
