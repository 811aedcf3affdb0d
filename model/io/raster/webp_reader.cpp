// SPDX-License-Identifier: MIT
#include "io/raster/webp_reader.h"

#include <QColorSpace>

#include <algorithm>
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

// Decodes in pieces, between which it may be stopped.
bool isDecoded(const WebPData& file, QImage& image, const std::stop_token& stop) {
    constexpr std::size_t piece = 1 << 16;
    const std::unique_ptr<WebPIDecoder, decltype(&WebPIDelete)> decoder(
        WebPINewRGB(MODE_RGBA, image.bits(), std::size_t(image.sizeInBytes()), int(image.bytesPerLine())),
        WebPIDelete);
    VP8StatusCode status = VP8_STATUS_SUSPENDED;
    for (std::size_t end = 0; decoder && status == VP8_STATUS_SUSPENDED && end < file.size;) {
        if (stop.stop_requested()) return false;
        end = std::min(end + piece, file.size);
        status = WebPIUpdate(decoder.get(), file.bytes, end);
    }
    return status == VP8_STATUS_OK;
}

} // namespace

RasterPicture readWebP(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop) {
    using enum RasterPicture::Flaw;
    const WebPData file{reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())};
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(file.bytes, file.size, &features) != VP8_STATUS_OK) return {};
    const QSize size(features.width, features.height);
    if (features.has_animation) return {{}, size, Animated};
    if (qint64(size.width()) * size.height() > maxPixels) return {{}, size, TooLarge};
    QImage image(size, features.has_alpha ? QImage::Format_RGBA8888 : QImage::Format_RGBX8888);
    if (image.isNull() || !isDecoded(file, image, stop)) return {{}, size, Damaged};
    if (const QByteArray profile = profileOf(file); !profile.isEmpty())
        image.setColorSpace(QColorSpace::fromIccProfile(profile));
    return {std::move(image), size};
}

} // namespace io
