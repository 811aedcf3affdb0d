// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <stop_token>

namespace io {

// A picture to steal colours from: what decodedPicture() reads, large ones reduced.
struct ReadPicture {
    attractor::MipPicture picture;
    Failure failure; // reason why there is none
};
ReadPicture readPicture(const QString& path, const std::stop_token& stop = {});
ReadPicture decodePicture(const QByteArray& bytes, const std::stop_token& stop = {});

attractor::MipPicture mipPicture(QImage image); // requires an image in sRGB that is not empty

} // namespace io
