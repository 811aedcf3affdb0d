// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QImage>
#include <QString>

namespace io {

// A picture to steal colours from: what decodedPicture() reads, large ones reduced.
struct ReadPicture {
    attractor::MipPicture picture;
    Failure failure; // why there is none
};
ReadPicture readPicture(const QString& path);
ReadPicture decodePicture(const QByteArray& bytes);

// Whether a path that a file names leads from the folder of the file to a place below it, through any
// symbolic links. A path that leads elsewhere may not be read unless the user agrees: a file from a stranger
// could name any other file.
bool liesInside(const QString& folder, const QString& path);

attractor::MipPicture mipPicture(QImage image); // not empty, in sRGB

} // namespace io
