// SPDX-License-Identifier: MIT
#include "io/tops/picture_reader.h"

#include "io/picture/decoding/picture_decoder.h"

#include <vector>

namespace io {

namespace {

std::vector<attractor::Rgba> pixelsOf(const QImage& image) {
    std::vector<attractor::Rgba> pixels;
    pixels.reserve(std::size_t(image.width()) * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        const uchar* row = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x, row += 4)
            pixels.push_back({row[0], row[1], row[2], row[3]});
    }
    return pixels;
}

} // namespace

attractor::MipPicture mipPicture(QImage image) {
    image.convertTo(QImage::Format_RGBA8888);
    return {image.width(), image.height(), pixelsOf(image)};
}

ReadPicture decodePicture(const QByteArray& bytes, const std::stop_token& stop) {
    DecodedPicture decoded = decodedPicture(bytes, LargePicture::Reduced, stop);
    if (decoded.flaw) return {{}, decoded.flaw};
    return {mipPicture(std::move(decoded.image)), std::nullopt};
}

ReadPicture readPicture(const QString& path, const std::stop_token& stop) {
    const Loaded loaded = loadFile(path);
    return loaded.failure ? ReadPicture{{}, loaded.failure} : decodePicture(loaded.bytes, stop);
}

} // namespace io
