// SPDX-License-Identifier: MIT
#include "io/picture/decoding/grey_picture.h"

#include "document/text/text.h"
#include "io/picture/decoding/picture_decoder.h"

#include <QImage>

#include <algorithm>

namespace io {

namespace {

collage::GreyPicture greyOf(const QImage& image) {
    collage::GreyPicture grey{image.width(), image.height(), {}, {}};
    grey.grey.reserve(std::size_t(image.width()) * std::size_t(image.height()));
    grey.opacity.reserve(grey.grey.capacity());
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const int alpha = qAlpha(row[x]);
            grey.grey.push_back(std::uint8_t((qGray(row[x]) * alpha + 255 * (255 - alpha)) / 255));
            grey.opacity.push_back(std::uint8_t(alpha));
        }
    }
    return grey;
}

} // namespace

LoadedGrey readGreyPicture(const QByteArray& bytes, const std::stop_token& stop) {
    LoadedGrey loaded;
    DecodedPicture decoded = decodedPicture(bytes, LargePicture::Refused, stop);
    loaded.flaw = decoded.flaw;
    if (loaded.flaw) return loaded;
    QImage& image = decoded.image;
    if (std::min(image.width(), image.height()) < minTracedSide) {
        loaded.flaw = Text::tr("The picture has %1 × %2 pixels. Each side needs at least %3 pixels.")
                          .arg(image.width())
                          .arg(image.height())
                          .arg(minTracedSide);
        return loaded;
    }
    const QSize traced(maxTracedSide, maxTracedSide);
    loaded.isReduced = std::max(image.width(), image.height()) > maxTracedSide;
    if (loaded.isReduced) image = image.scaled(traced, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (std::min(image.width(), image.height()) < minTracedSide) {
        loaded.flaw = Text::tr("The picture is too long and thin to be traced.");
        return loaded;
    }
    loaded.picture = greyOf(image.convertToFormat(QImage::Format_ARGB32));
    return loaded;
}

} // namespace io
