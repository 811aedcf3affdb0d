// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/banded_rendering.h"
#include "document/fractal/fractal.h"
#include "io/overlay/cage_overlay.h"
#include "io/overlay/picture_overlay.h"
#include "io/picture/export_outcome.h"
#include "io/picture/png/png_writer.h"

#include <QImage>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

namespace io {

// A picture of an entry in the plane, in any kind of file that is made of pixels.
struct PlaneExport {
    document::Fractal fractal;        // embedded in the picture as text
    attractor::RenderRequest request; // number of samples of the whole picture
    std::optional<double> dotsPerInch;
    CageVisibility cage = CageVisibility::Hidden;
    PictureFormat::Depth depth = PictureFormat::Depth::Bits8;
    std::optional<attractor::DividedPicture> divided{};     // share drawn here
    std::vector<std::pair<QByteArray, QByteArray>> texts{}; // further texts for PictureFormat
    // The moments seen by an open shutter, in place of the request's own; see BandedRendering::openShutter().
    std::vector<attractor::RenderRequest> moments{};
    // Includes the mean density; nullopt: exposure of the picture itself.
    std::optional<attractor::Exposure> exposure{};
    PictureFile file = PictureFile::Png; // must take this depth
    std::optional<int> quality{};        // same meaning as in PictureFormat
    PictureOverlay overlay{};
    bool withLegend = false; // table of maps to the right, which widens the picture: mapLegend()
    std::shared_ptr<const document::Fractal> explained{}; // subject of overlay and legend; null: the fractal
    std::size_t bandBytes = 256U << 20; // memory for the cells of rows drawn together; no effect on pixels
};

// Draws and writes the picture, of whatever kind of file, some rows at a time; `path` appears whole or not at
// all.
ExportOutcome exportPlane(const PlaneExport& picture, const QString& path, const Progress& progress = {},
                          std::stop_token stop = {});

// Why the kind of file cannot hold the picture, before it is drawn.
Failure whyImpossible(const PlaneExport& picture);

// The same picture in memory, without the legend, 8 bits per channel; null when stopped.
struct Picture {
    QImage image;
    attractor::RenderNote note = attractor::RenderNote::None;
};
Picture drawPicture(const PlaneExport& picture, const Progress& progress = {}, std::stop_token stop = {});

// Memory that exportPlane() takes for this picture, in bytes, about.
std::uint64_t memoryFor(const PlaneExport& picture);

int threadsOfThisMachine(); // ≥ 1

} // namespace io
