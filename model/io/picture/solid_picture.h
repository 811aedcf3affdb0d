// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_appearance.h"
#include "attractor/request/space_request.h"
#include "io/picture/png_export.h"

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

namespace io {

// A lit solid.
struct SolidPicture {
    attractor::SpaceRequest request;
    attractor::SolidAppearance appearance;
    PngFormat::Depth depth = PngFormat::Depth::Bits8;
    int supersample = 1; // 1 … 4; the looks that are numbers, Depth and Normals, have none
};

// Memory that writeSolid() takes, in bytes, about.
std::uint64_t memoryFor(const SolidPicture& picture);

// Takes whole rows from the top on; a failure ends the drawing.
struct RowSink {
    std::function<Failure(std::span<const std::uint32_t>)> narrow;     // 8 bits a channel …
    std::function<Failure(std::span<const attractor::Rgba16>)> wide{}; // … or 16
};

// Draws all rows in the picture's depth.
ExportOutcome drawSolid(const SolidPicture& picture, const RowSink& sink, const Progress& progress = {},
                        const std::stop_token& stop = {});
// Draws all rows into a writer of that size and depth, and finishes it.
ExportOutcome writeSolid(const SolidPicture& picture, PngWriter& writer, const Progress& progress = {},
                         const std::stop_token& stop = {});

} // namespace io
