// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/stolen_picture.h"
#include "document/fractal/fractal.h"
#include "io/file/save_file.h"
#include "io/picture/plane_export.h"

#include <QImage>
#include <QString>

#include <stop_token>

namespace io {

// The camera through which a picture of that size lies on an attractor: its certified box fills the picture,
// in its proportions, but for the margin that `render` leaves, 5 % on each side at least.
attractor::Camera pictureCamera(int width, int height, const ifs::Vector<2>& min, const ifs::Vector<2>& max);

struct StealExport {
    document::Fractal fractal; // F, embedded in the picture as text
    attractor::CoupledSystem system;
    attractor::MipPicture picture;
    attractor::TheftRequest request;
};

// Draws some rows at a time and writes them as PNG; `path` appears whole or not at all. A system with too
// many words for an exact picture is a failure.
ExportOutcome exportStolen(const StealExport& what, const QString& path, const Progress& progress = {},
                           const std::stop_token& stop = {});

// The same picture in memory; null when stopped.
QImage drawStolen(const StealExport& what, const std::stop_token& stop = {});

} // namespace io
