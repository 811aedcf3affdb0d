// SPDX-License-Identifier: MIT
#include "io/raster/webp_reader.h"

#include <QColorSpace>

#include <memory>

#include <webp/decode.h>
#include <webp/mux.h>

namespace io {

namespace {

QByteArray profileOf(const WebPData& file) {
    constexpr int notCopied = 0;
    const std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)> mux(WebPMuxCreate(&file, notCopied),
                                                                 WebPMuxDelete);
    WebPData profile{};
    if (!mux || WebPMuxGetChunk(mux.get(), "ICCP", &profile) != WEBP_MUX_OK) return {};
    return {reinterpret_cast<const char*>(profile.bytes), qsizetype(profile.size)};
}

} // namespace

RasterPicture readWebP(const QByteArray& bytes, qint64 maxPixels) {
    using enum RasterPicture::Flaw;
    const WebPData file{reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())};
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(file.bytes, file.size, &features) != VP8_STATUS_OK) return {};
    const QSize size(features.width, features.height);
    if (features.has_animation) return {{}, size, Animated};
    if (qint64(size.width()) * size.height() > maxPixels) return {{}, size, TooLarge};
    QImage image(size, features.has_alpha ? QImage::Format_RGBA8888 : QImage::Format_RGBX8888);
    if (image.isNull() || !WebPDecodeRGBAInto(file.bytes, file.size, image.bits(),
                                              std::size_t(image.sizeInBytes()), int(image.bytesPerLine())))
        return {{}, size, Damaged};
    if (const QByteArray profile = profileOf(file); !profile.isEmpty())
        image.setColorSpace(QColorSpace::fromIccProfile(profile));
    return {std::move(image), size};
}

} // namespace io
