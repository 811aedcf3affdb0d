// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/light/solid_appearance.h"
#include "attractor/light/stereo.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/request/space_request.h"
#include "document/fractal/fractal.h"
#include "io/overlay/overlay_marks.h"
#include "io/picture/plane_export.h"
#include "io/picture/vector/picture_page.h"

#include <QByteArray>
#include <QIODevice>
#include <QString>

#include <cstdint>
#include <optional>
#include <stop_token>

namespace io {

using attractor::Stereo;

struct SpaceExport {
    document::Fractal fractal;                                   // embedded in the picture as text
    attractor::SpaceRequest request;                             // request of one eye
    attractor::LookInSpace look = attractor::LookInSpace::Cloud; // Depth: 16-bit grey
    attractor::SolidAppearance solid;                            // solid looks only
    Stereo stereo = Stereo::None;                                // ignored by Depth
    int supersample = 2;                                         // solids only, 1 … 4
    PictureFormat::Depth depth = PictureFormat::Depth::Bits8;    // clouds and solids only
    std::optional<double> dotsPerInch;
    std::vector<std::pair<QByteArray, QByteArray>> texts{}; // further texts for PictureFormat
    // The moments seen by an open shutter, in place of the request's own: requests that differ from it in
    // system, cage and camera only. Not for depths.
    std::vector<attractor::SpaceRequest> moments{};
    // Clouds only, mean density included; nullopt: exposure of the picture itself.
    std::optional<attractor::Exposure> exposure{};
    PictureFile file = PictureFile::Png; // must be PNG for Depth
    std::optional<int> quality{};        // same meaning as in PictureFormat
    OverlayMarks marks{};                // drawn over the picture, except over Depth and in stereo
    std::optional<ShapeFile>
        page{};      // page in which a PNG of 8 bits is embedded, with the marks as shapes; not for Depth
    QImage legend{}; // picture of equal height, placed to the right in the file; not for Depth
    // The share of a cloud that is drawn here, when the rest is drawn elsewhere. Not in stereo, nor with
    // moments.
    std::optional<attractor::DividedPicture> divided{};
    std::uint64_t bandBytes = std::uint64_t{1} << 28; // solids only; same meaning as in SolidPicture
};

// The format of its file.
PictureFormat formatOf(const SpaceExport& picture); // without the texts of Depth
PictureFormat formatOfDepths(const SpaceExport& picture, const attractor::DepthRaster& raster);
// The pixel of Depth for the nearest point there.
std::uint16_t depthValue(std::uint32_t key);
// Why the kind of file cannot hold the picture, before it is drawn.
Failure whyImpossible(const SpaceExport& picture);

// Memory that exportSpace() takes, in bytes, about.
std::uint64_t memoryFor(const SpaceExport& picture);

// Draws the picture and encodes it; a solid some rows at a time. A picture of depths has two texts,
// barycage:near and barycage:far: depths along the view from the plane of the target, away from the eye, in
// units of the system; a pixel v shows depth near + (far − near)·v/65534, and 65535 shows nothing.
ExportOutcome drawSpaceFile(const SpaceExport& picture, QIODevice& file, const Progress& progress = {},
                            std::stop_token stop = {});
ExportOutcome drawSpaceFile(const SpaceExport& picture, QByteArray& bytes, const Progress& progress = {},
                            std::stop_token stop = {});
// Exports to a file that appears whole or not at all.
ExportOutcome exportSpace(const SpaceExport& picture, const QString& path, const Progress& progress = {},
                          std::stop_token stop = {});

// The same as one more page of a file, of 8 bits per channel and not of depths.
ExportOutcome drawSpacePage(const SpaceExport& picture, PdfFile& file, const Progress& progress = {},
                            std::stop_token stop = {});

// The same picture in memory, 8 bits per channel, without texts; null when stopped. Depths are as one sees
// them: near white, far black.
Picture drawSpacePicture(const SpaceExport& picture, const Progress& progress = {},
                         std::stop_token stop = {});

// The rendering of a cloud, and all of its samples: of its moments or its parts. False when stopped, or the
// others' sums cannot be had.
attractor::CloudRendering cloudRendering(const SpaceExport& picture);
bool drawSamples(const SpaceExport& picture, attractor::CloudRendering& rendering,
                 const Progress& progress = {}, const std::stop_token& stop = {});

// The exposure of a cloud at the request's moment, from some of its samples; nullopt when stopped.
std::optional<attractor::Exposure> cloudExposure(const SpaceExport& picture,
                                                 const std::stop_token& stop = {});

} // namespace io
