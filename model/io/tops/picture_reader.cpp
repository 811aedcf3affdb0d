// SPDX-License-Identifier: MIT
#include "io/tops/picture_reader.h"

#include <QBuffer>
#include <QColorSpace>
#include <QCoreApplication>
#include <QImage>
#include <QImageReader>

#include <vector>

namespace io {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PictureReader)
};

constexpr int bytesPerPixel = 8; // the most that a decoder takes

ReadPicture failed(const QString& sentence) {
    return {{}, sentence};
}

// Shapes have no pixels of their own, and what draws them wants fonts and a display.
bool isShapes(const QByteArray& format) {
    return format.startsWith("svg") || format == "pdf";
}

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

ReadPicture decodePicture(const QByteArray& bytes, const QString& path) {
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    QImageReader::setAllocationLimit(int(maxPicturePixels * bytesPerPixel >> 20) + 1);
    if (!reader.canRead() || isShapes(reader.format()))
        return failed(Text::tr("“%1” is not a picture that can be read; PNG and JPEG always can.").arg(path));
    const QSize size = reader.size();
    if (size.isValid() && qint64(size.width()) * size.height() > maxPicturePixels)
        return failed(Text::tr("“%1” has %2 × %3 pixels, and the limit is 64 million; make it smaller first.")
                          .arg(path)
                          .arg(size.width())
                          .arg(size.height()));
    QImage image = reader.read();
    if (image.isNull() || image.width() < 1 || image.height() < 1)
        return failed(Text::tr("“%1” is damaged: %2.").arg(path, reader.errorString()));
    if (image.colorSpace().isValid() && image.colorSpace() != QColorSpace(QColorSpace::SRgb))
        image.convertToColorSpace(QColorSpace(QColorSpace::SRgb));
    image.convertTo(QImage::Format_RGBA8888);
    return {attractor::MipPicture(image.width(), image.height(), pixelsOf(image)), std::nullopt};
}

ReadPicture readPicture(const QString& path) {
    const Loaded loaded = loadFile(path);
    return loaded.failure ? failed(*loaded.failure) : decodePicture(loaded.bytes, path);
}

} // namespace io
