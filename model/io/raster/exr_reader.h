// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/raster_picture.h"

#include <QByteArray>

#include <stop_token>

namespace io {

// The first part of an OpenEXR picture within its display window, at most `maxPixels` pixels: colours (or
// luminance) and alpha in linear light, the Rec. 709 primaries taken for granted. Values above 1 become 1.
RasterPicture readExr(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop = {});

} // namespace io
