// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

namespace io {

// A picture of any format that Qt reads pixel by pixel, turned upright and in sRGB; of an animation the first
// frame. At most maxPicturePixels.
inline constexpr qint64 maxPicturePixels = 64'000'000;

struct ReadPicture {
    attractor::MipPicture picture;
    Failure failure; // why there is none
};
ReadPicture readPicture(const QString& path);
ReadPicture decodePicture(const QByteArray& bytes, const QString& path); // which the sentences name

} // namespace io
