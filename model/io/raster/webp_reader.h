// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/raster_picture.h"

#include <QByteArray>

#include <stop_token>

namespace io {

// A WebP picture, lossy or lossless, that is not animated; at most `maxPixels` pixels.
RasterPicture readWebP(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop = {});

} // namespace io
