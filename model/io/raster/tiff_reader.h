// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/raster_picture.h"

#include <QByteArray>

#include <stop_token>

namespace io {

// The first picture of a TIFF or BigTIFF, with channels of at most 16 bits, read as 8 bits; at most
// `maxPixels` pixels.
RasterPicture readTiff(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop = {});

} // namespace io
