// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/raster_picture.h"

#include <QByteArray>

#include <stop_token>

namespace io {

// The first part of an OpenEXR picture within its display window, at most so many pixels: colours (or
// luminance) and alpha in linear light, the Rec. 709 primaries taken for granted. What is brighter than 1
// is 1.
RasterPicture readExr(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop = {});

} // namespace io
