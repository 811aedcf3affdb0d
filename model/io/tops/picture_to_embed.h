// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

#include <stop_token>

namespace io {

// A file of the picture that is small enough to be embedded in an entry: the file itself, or else a smaller
// picture.
struct PictureToEmbed {
    QByteArray bytes;
    Failure failure; // reason why there is none
};
PictureToEmbed pictureToEmbed(const QString& path, const std::stop_token& stop = {});

} // namespace io
