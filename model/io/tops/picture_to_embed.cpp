// SPDX-License-Identifier: MIT
#include "io/tops/picture_to_embed.h"

#include "document/tops/kept_theft.h"
#include "io/picture/decoding/picture_decoder.h"

#include <QBuffer>
#include <QImage>

#include <algorithm>

namespace io {

namespace {

constexpr int largestSide = 1024; // first size to try
constexpr int jpegQuality = 85;

QByteArray encoded(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.hasAlphaChannel() && image.save(&buffer, "JPEG", jpegQuality)) return bytes;
    bytes.clear();
    buffer.seek(0);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace

PictureToEmbed pictureToEmbed(const QString& path, const std::stop_token& stop) {
    const Loaded loaded = loadFile(path);
    if (loaded.failure) return {{}, loaded.failure};
    const DecodedPicture decoded = decodedPicture(loaded.bytes, LargePicture::Reduced, stop);
    if (decoded.flaw) return {{}, decoded.flaw};
    if (loaded.bytes.size() <= document::maxEmbeddedPicture) return {loaded.bytes, std::nullopt};
    int side = std::min(largestSide, std::max(decoded.image.width(), decoded.image.height()));
    QByteArray bytes;
    do {
        bytes = encoded(decoded.image.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        side = side * 3 / 4;
    } while (bytes.size() > document::maxEmbeddedPicture); // 100 pixels a side always fit
    return {bytes, std::nullopt};
}

} // namespace io
