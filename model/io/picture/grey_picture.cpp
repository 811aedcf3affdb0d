// SPDX-License-Identifier: MIT
#include "io/picture/grey_picture.h"

#include "io/picture/jpeg_check.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QImageReader>
#include <QtEndian>

#include <zlib.h>

#include <algorithm>

namespace io {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

constexpr qint64 maxPixels = 32'000'000;

bool isKnown(const QByteArray& format) {
    static const QList<QByteArray> formats{"png", "jpeg", "jpg", "gif", "bmp", "pbm", "pgm", "ppm"};
    return formats.contains(format);
}

// Whether every chunk that matters is there with its checksum, to the last one. libpng would tell the
// terminal.
bool isWholePng(const QByteArray& bytes) {
    for (qsizetype at = 8; at + 12 <= bytes.size();) {
        const qsizetype length = qFromBigEndian<quint32>(bytes.constData() + at);
        if (length > bytes.size() - at - 12) return false;
        const char* type = bytes.constData() + at + 4;
        const auto* checked = reinterpret_cast<const Bytef*>(type);
        const bool matters = (type[0] & 0x20) == 0;
        if (matters && crc32(0, checked, uInt(length + 4)) != qFromBigEndian<quint32>(type + 4 + length))
            return false;
        if (bytes.mid(at + 4, 4) == "IEND") return true;
        at += length + 12;
    }
    return false;
}

// What its reader would pass over in silence.
bool isDamaged(const QByteArray& bytes, const QByteArray& format) {
    if (format == "png") return !isWholePng(bytes);
    if (format.startsWith("jp")) return !jpegFacts(bytes).isComplete;
    if (format == "gif") {
        qsizetype end = bytes.size();
        while (end > 0 && bytes[end - 1] == '\0')
            --end;
        return end == 0 || bytes[end - 1] != ';';
    }
    if (format == "bmp" && bytes.size() > 6)
        return qFromLittleEndian<quint32>(bytes.constData() + 2) > quint32(bytes.size());
    return false;
}

bool isAnimated(QImageReader& reader, const QByteArray& bytes, const QByteArray& format) {
    if (format == "png") {
        const qsizetype control = bytes.indexOf("acTL");
        return control >= 0 && control < bytes.indexOf("IDAT");
    }
    return reader.supportsAnimation() && reader.imageCount() > 1;
}

// Why the picture cannot be used, as far as can be told before it is decoded.
std::optional<QString> flawOf(QImageReader& reader, const QByteArray& bytes) {
    const QByteArray format = reader.format();
    if (!isKnown(format)) return Text::tr("This is not a PNG, JPEG, GIF, BMP or PNM picture.");
    const QSize size = reader.size();
    if (qint64(size.width()) * size.height() > maxPixels)
        return Text::tr(
                   "The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.")
            .arg(size.width())
            .arg(size.height());
    if (size.isValid() && std::min(size.width(), size.height()) < minTracedSide)
        return Text::tr("The picture has %1 × %2 pixels. Each side needs at least %3 pixels.")
            .arg(size.width())
            .arg(size.height())
            .arg(minTracedSide);
    if (isDamaged(bytes, format)) return Text::tr("The picture is damaged or incomplete.");
    if (format.startsWith("jp") && jpegFacts(bytes).components > 3)
        return Text::tr(
            "The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB "
            "or grey levels.");
    if (isAnimated(reader, bytes, format))
        return Text::tr("The picture is animated. Save one of its frames as a picture of its own.");
    return std::nullopt;
}

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

LoadedGrey readGreyPicture(const QByteArray& bytes) {
    LoadedGrey loaded;
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    // Its content decides, and nothing but the readers of pixels is asked.
    const QByteArray format = QImageReader::imageFormat(&buffer);
    buffer.seek(0);
    QImageReader reader(&buffer, isKnown(format) ? format : QByteArray("none"));
    reader.setAutoTransform(true);
    loaded.flaw = flawOf(reader, bytes);
    if (loaded.flaw) return loaded;
    const QSize size = reader.size();
    const QSize traced(maxTracedSide, maxTracedSide);
    loaded.isReduced = std::max(size.width(), size.height()) > maxTracedSide;
    QImage image = reader.read();
    if (image.isNull()) {
        loaded.flaw = Text::tr("The picture is damaged or incomplete.");
        return loaded;
    }
    if (loaded.isReduced) image = image.scaled(traced, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (std::min(image.width(), image.height()) < minTracedSide) {
        loaded.flaw = Text::tr("The picture is too long and thin to be traced.");
        return loaded;
    }
    loaded.picture = greyOf(image.convertToFormat(QImage::Format_ARGB32));
    return loaded;
}

} // namespace io
