// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/raster_picture.h"

#include <QByteArray>

#include <stop_token>

namespace io {

// WebP, lossy or without loss, that is not animated; at most so many pixels.
RasterPicture readWebP(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop = {});

} // namespace io
