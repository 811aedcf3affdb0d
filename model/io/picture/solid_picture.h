// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_appearance.h"
#include "attractor/request/space_request.h"
#include "io/picture/plane_export.h"

#include <cstdint>
#include <span>
#include <stop_token>

namespace io {

// A lit solid.
struct SolidPicture {
    attractor::SpaceRequest request;
    attractor::SolidAppearance appearance;
    PictureFormat::Depth depth = PictureFormat::Depth::Bits8;
    int supersample = 1; // 1 … 4; ignored by Depth and Normals, whose pixels are numbers
    std::uint64_t bandBytes = std::uint64_t{1} << 28; // approximate memory for the depths held at a time
};

// Rows of the picture that are drawn together.
int rowsTogether(const SolidPicture& picture);
// Memory that writeSolid() takes, in bytes, about.
std::uint64_t memoryFor(const SolidPicture& picture);

// Draws all rows into a writer of that size and depth, and finishes it.
ExportOutcome writeSolid(const SolidPicture& picture, PictureWriter& writer, const Progress& progress = {},
                         const std::stop_token& stop = {});
// Draws rows [firstRow, endRow) into memory, of 8 or 16 bits per channel, whatever the depth of the picture.
ExportOutcome drawSolidRows(const SolidPicture& picture, int firstRow, int endRow,
                            std::span<std::uint32_t> pixels, const Progress& progress = {},
                            const std::stop_token& stop = {});
ExportOutcome drawSolidRows(const SolidPicture& picture, int firstRow, int endRow,
                            std::span<attractor::Rgba16> pixels, const Progress& progress = {},
                            const std::stop_token& stop = {});

} // namespace io
