// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/banded_rendering.h"
#include "document/fractal.h"
#include "io/picture/cage_overlay.h"
#include "io/picture/png_writer.h"

#include <QImage>
#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

namespace io {

using Progress = std::function<void(double fraction)>; // 0 … 1, called in the thread that works

struct PngExport {
    document::Fractal fractal;        // embedded in the picture as text
    attractor::RenderRequest request; // what is drawn; its samples are those of the whole picture
    std::optional<double> dotsPerInch;
    CageVisibility cage = CageVisibility::Hidden;
    PngFormat::Depth depth = PngFormat::Depth::Bits8;
    std::optional<attractor::DividedPicture> divided{};     // what of it is drawn here, and what elsewhere
    std::vector<std::pair<QByteArray, QByteArray>> texts{}; // further ones, as in PngFormat
    // What a shutter sees in place of the request's moment; see BandedRendering::openShutter().
    std::vector<attractor::RenderRequest> moments{};
    std::optional<attractor::Exposure> exposure{}; // mean density included; else that of the picture itself
    std::size_t bandBytes = 256U << 20; // for the cells of the rows that are drawn at a time; same picture
};

struct ExportOutcome {
    Failure failure;
    bool stopped = false; // on request; nothing was written
    attractor::RenderNote note = attractor::RenderNote::None;
};

// Draws and writes the picture, some rows at a time; `path` appears whole or not at all.
ExportOutcome exportPng(const PngExport& picture, const QString& path, const Progress& progress = {},
                        std::stop_token stop = {});

// The same picture in memory, 8 bits a channel; null when stopped.
struct Picture {
    QImage image;
    attractor::RenderNote note = attractor::RenderNote::None;
};
Picture drawPicture(const PngExport& picture, const Progress& progress = {}, std::stop_token stop = {});

// Memory that exportPng() takes for this picture, in bytes, about.
std::uint64_t memoryFor(const PngExport& picture);

int threadsOfThisMachine(); // ≥ 1

} // namespace io
