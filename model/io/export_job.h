// SPDX-License-Identifier: MIT
#pragma once

#include "io/animation/animation_export.h"
#include "io/exchange/point_cloud.h"
#include "io/picture/picture_strip.h"
#include "io/picture/plane_export.h"
#include "io/picture/space_export.h"
#include "io/picture/vector/pdf_writer.h"
#include "io/solid/solid_export.h"

#include <QFuture>
#include <QImage>

#include <stop_token>
#include <variant>

namespace io {

struct SvgExport {
    document::Fractal fractal;
    attractor::Camera camera;
    SvgFormat format;
    ShapeFile file = ShapeFile::Svg;
};
using PictureStrip = std::vector<PlaneExport>; // pictures side by side in one PNG
using Export =
    std::variant<PlaneExport, SvgExport, PointCloud, PictureStrip, SolidExport, SpaceExport, AnimationExport>;

// Writes the picture in the calling thread; `path` appears whole or not at all.
ExportOutcome exportTo(const Export& what, const QString& path, const Progress& progress = {},
                       std::stop_token stop = {});

// The picture, drawn beside and kept in memory, with per cent as progress; null when there is no room for it.
QFuture<QImage> drawBeside(const PlaneExport& what);
QFuture<QImage> drawBeside(const SpaceExport& what);

} // namespace io
