// SPDX-License-Identifier: MIT
#include "io/picture/decoding/picture_decoder.h"

#include "document/text/text.h"
#include "io/picture/decoding/gif_check.h"
#include "io/picture/decoding/jpeg_check.h"
#include "io/raster/exr_reader.h"
#include "io/raster/raster_system.h"
#include "io/raster/tiff_reader.h"
#include "io/raster/webp_reader.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImageReader>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <utility>
#include <zlib.h>

namespace io {

namespace {

constexpr qint64 maxKeptScans = qint64{512} << 20; // bytes of a JPEG that cannot be read row by row

constexpr int megabytesOf(qint64 pixels) {
    return int(pixels * 8 >> 20) + 1; // for at most 16 bits per channel
}

bool isKnown(const QByteArray& format) {
    static const QList<QByteArray> formats{"png", "jpeg", "jpg", "gif", "bmp", "pbm", "pgm", "ppm"};
    return formats.contains(format);
}

// Returns true if every critical chunk is there with its checksum, to the last one. libpng would complain on
// the terminal.
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

bool changesPixels(QByteArrayView type) {
    constexpr std::array<QByteArrayView, 5> kinds{"tRNS", "gAMA", "cHRM", "sRGB", "iCCP"};
    return (type[0] & 0x20) == 0 || std::ranges::find(kinds, type) != kinds.end();
}

// A complete PNG reduced to the chunks that its pixels need, each ancillary one once. The library unpacks all
// texts and keeps them, and unpacks a profile each time that it comes.
QByteArray withPixelsOnly(const QByteArray& bytes) {
    // Length of the signature; length, name and checksum of a chunk.
    constexpr qsizetype signature = 8, around = 12;
    QByteArray kept = bytes.first(signature);
    std::set<QByteArray> seen;
    for (qsizetype at = signature; at + around <= bytes.size();) {
        const qsizetype size = qsizetype(qFromBigEndian<quint32>(bytes.constData() + at)) + around;
        const QByteArray type = bytes.mid(at + 4, 4);
        const bool isFirst = seen.insert(type).second;
        if (changesPixels(type) && (isFirst || (type[0] & 0x20) == 0)) kept += bytes.mid(at, size);
        if (type == "IEND") break;
        at += size;
    }
    return kept;
}

// Upper bound of the unpacked size of a PNG: each row with a byte for its filter, in up to seven passes.
quint64 unpackedSize(const QByteArray& png) {
    constexpr qsizetype widthAt = 16, depthAt = 24, coloursAt = 25;
    if (png.size() <= coloursAt) return 0;
    const quint64 width = qFromBigEndian<quint32>(png.constData() + widthAt);
    const quint64 height = qFromBigEndian<quint32>(png.constData() + widthAt + 4);
    constexpr std::array<quint64, 8> channelsOf{1, 1, 3, 1, 2, 1, 4, 1}; // indexed by the kind of pixels
    const quint64 channels = channelsOf[std::size_t(png[coloursAt] & 7)];
    return (width * channels * quint64(png[depthAt]) / 8 + 2) * height * 2;
}

// Returns true if the pixels unpack to far more than they need: the library would unpack all of it, a
// thousand times the file. Small files are not checked: they take a second at most.
bool isSwollen(const QByteArray& png, const std::stop_token& stop) {
    constexpr qsizetype small = 1 << 20;
    constexpr quint64 slack = quint64{64} << 20;
    if (png.size() <= small) return false;
    const quint64 allowed = unpackedSize(png) + slack;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return true;
    QByteArray room(1 << 18, Qt::Uninitialized);
    quint64 unpacked = 0;
    int status = Z_OK;
    for (qsizetype at = 8; at + 12 <= png.size() && status == Z_OK && unpacked <= allowed;) {
        const qsizetype length = qFromBigEndian<quint32>(png.constData() + at);
        if (png.mid(at + 4, 4) == "IDAT") {
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(png.constData() + at + 8));
            stream.avail_in = uInt(length);
            do {
                stream.next_out = reinterpret_cast<Bytef*>(room.data());
                stream.avail_out = uInt(room.size());
                status = inflate(&stream, Z_NO_FLUSH);
                unpacked += quint64(room.size()) - stream.avail_out;
            } while (status == Z_OK && stream.avail_out == 0 && unpacked <= allowed &&
                     !stop.stop_requested());
            if (status == Z_BUF_ERROR) status = Z_OK; // end of this chunk
        }
        at += length + 12;
    }
    inflateEnd(&stream);
    return unpacked > allowed;
}

// The bytes, which end with an error once the stop is requested: libraries then give up.
class StoppableBytes : public QBuffer {
public:
    explicit StoppableBytes(std::stop_token stop) : m_stop(std::move(stop)) {}

protected:
    qint64 readData(char* data, qint64 size) override {
        return m_stop.stop_requested() ? -1 : QBuffer::readData(data, size);
    }

private:
    std::stop_token m_stop;
};

// Returns true for damage that the reader would silently pass over. A PNG has been checked before.
bool isDamaged(const QByteArray& bytes, const QByteArray& format) {
    if (format.startsWith("jp")) return !jpegFacts(bytes).isComplete;
    if (format == "gif") {
        if (isSwollenGif(bytes)) return true;
        qsizetype end = bytes.size();
        while (end > 0 && bytes[end - 1] == '\0')
            --end;
        return end == 0 || bytes[end - 1] != ';';
    }
    if (format == "bmp" && bytes.size() > 6)
        return qFromLittleEndian<quint32>(bytes.constData() + 2) > quint32(bytes.size());
    return false;
}

bool isAnimatedPng(const QByteArray& bytes) {
    const qsizetype control = bytes.indexOf("acTL");
    return control >= 0 && control < bytes.indexOf("IDAT");
}

bool isAnimated(QImageReader& reader) {
    return reader.supportsAnimation() && reader.imageCount() > 1;
}

qint64 pixelsOf(const QSize& size) {
    return qint64(size.width()) * size.height();
}

QString tooLarge(const QSize& size) {
    return Text::tr("The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.")
        .arg(size.width())
        .arg(size.height());
}

QString damaged() {
    return Text::tr("The picture is damaged or incomplete.");
}

QString animated() {
    return Text::tr("The picture is animated. Save one of its frames as a picture of its own.");
}

// Returns true for the formats whose reader scales the rows as they come.
bool isReducible(const QByteArray& format, const QSize& size) {
    return (format == "png" || format.startsWith("jp")) && pixelsOf(size) <= maxReducedPixels;
}

QSize reduced(const QSize& size) {
    const double factor = std::sqrt(double(maxDecodedPixels) / double(pixelsOf(size)));
    return {std::max(1, int(size.width() * factor)), std::max(1, int(size.height() * factor))};
}

// An interlaced picture is not scaled row by row. If all of it needs more than may be allocated, Qt would
// tell the terminal.
bool isTooLargeAtOnce(const QByteArray& bytes, const QByteArray& format, const QSize& size) {
    constexpr qsizetype depthAt = 24, coloursAt = 25, interlaceAt = 28;
    if (format.startsWith("jp")) {
        const JpegFacts facts = jpegFacts(bytes);
        return facts.isKept && pixelsOf(size) * facts.components * qint64(sizeof(short)) > maxKeptScans;
    }
    if (format != "png" || bytes.size() <= interlaceAt || bytes[interlaceAt] == 0) return false;
    const bool isOneByte = bytes[coloursAt] == 0 || bytes[coloursAt] == 3; // greyscale or palette
    const qint64 bytesPerPixel = bytes[depthAt] == 16 ? 8 : isOneByte ? 1 : 4;
    return pixelsOf(size) * bytesPerPixel > qint64(megabytesOf(maxDecodedPixels)) << 20;
}

// Why the picture cannot be used, as far as can be told before it is decoded.
std::optional<QString> flawOf(QImageReader& reader, const QByteArray& bytes, LargePicture large) {
    const QByteArray format = reader.format();
    if (!isKnown(format))
        return Text::tr("This is not a PNG, JPEG, GIF, BMP, PNM, WebP, TIFF or OpenEXR picture.");
    const QSize size = reader.size();
    const bool isLarge = pixelsOf(size) > maxDecodedPixels;
    if (isLarge && (large == LargePicture::Refused || !isReducible(format, size))) return tooLarge(size);
    if (isTooLargeAtOnce(bytes, format, size)) return tooLarge(size);
    if (isDamaged(bytes, format)) return damaged();
    if (format.startsWith("jp") && jpegFacts(bytes).components > 3)
        return Text::tr(
            "The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB "
            "or grey levels.");
    if (format.startsWith("jp") && jpegFacts(bytes).scans > maxScans)
        return Text::tr("The picture is a JPEG with more than %1 scans. Save it as a PNG picture.")
            .arg(maxScans);
    if (isAnimated(reader)) return animated();
    return std::nullopt;
}

// The limit is that of the program, and pictures are decoded in several threads: it is only raised.
void allowDecoding(qint64 pixels) {
    static std::mutex mutex;
    static int allowed = 0;
    const std::lock_guard lock(mutex);
    allowed = std::max(allowed, megabytesOf(pixels));
    QImageReader::setAllocationLimit(allowed);
}

QString flawOf(const RasterPicture& picture) {
    switch (picture.flaw) {
    case RasterPicture::Flaw::TooLarge:
        return tooLarge(picture.size);
    case RasterPicture::Flaw::Animated:
        return animated();
    case RasterPicture::Flaw::Unreadable:
        return Text::tr(
            "The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.");
    case RasterPicture::Flaw::Damaged:
        break;
    }
    return damaged();
}

// Reads the formats for which Qt has a plug-in at best; none when the file has another.
std::optional<RasterPicture> rasterPicture(const QByteArray& bytes, const std::stop_token& stop) {
    const QString format = rasterFormat(bytes);
    if (format == u"webp") return readWebP(bytes, maxDecodedPixels, stop);
    if (format == u"tiff") return readTiff(bytes, maxDecodedPixels, stop);
    if (format == u"exr") return readExr(bytes, maxDecodedPixels, stop);
    return std::nullopt;
}

QByteArray formatOf(const QByteArray& bytes) {
    if (bytes.startsWith("\x89PNG\r\n\x1a\n")) return "png"; // by no reader, which looks for texts
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    return QImageReader::imageFormat(&buffer);
}

DecodedPicture inSrgb(QImage image) {
    const QColorSpace space = image.colorSpace(), srgb(QColorSpace::SRgb);
    if (space.isValid() && space != srgb) image.convertToColorSpace(srgb);
    return {std::move(image), std::nullopt};
}

} // namespace

const QStringList& pictureSuffixes() {
    static const QStringList suffixes =
        QStringLiteral("png jpg jpeg gif bmp pbm pgm ppm pnm webp tif tiff exr").split(u' ');
    return suffixes;
}

DecodedPicture decodedFrame(const QByteArray& png, const std::stop_token& stop) {
    if (formatOf(png) != "png" || !isWholePng(png)) return {{}, damaged()};
    const QByteArray bytes = withPixelsOnly(png);
    StoppableBytes source(stop);
    source.setData(bytes);
    source.open(QIODevice::ReadOnly);
    QImageReader reader(&source, "png");
    if (pixelsOf(reader.size()) > maxFramePixels || isSwollen(bytes, stop)) return {{}, damaged()};
    allowDecoding(maxFramePixels);
    DecodedPicture decoded{reader.read(), std::nullopt};
    if (decoded.image.isNull() || stop.stop_requested()) return {{}, damaged()};
    return decoded;
}

DecodedPicture decodedPicture(const QByteArray& given, LargePicture large, const std::stop_token& stop) {
    if (auto raster = rasterPicture(given, stop)) {
        if (raster->image.isNull()) return {{}, flawOf(*raster)};
        return inSrgb(std::move(raster->image));
    }
    // Recognised from the contents, and read by the plug-ins for these formats only, whatever others are
    // installed.
    const QByteArray format = formatOf(given);
    const bool isPng = format == "png";
    if (isPng && !isWholePng(given)) return {{}, damaged()};
    if (isPng && isAnimatedPng(given)) return {{}, animated()};
    const QByteArray bytes = isPng ? withPixelsOnly(given) : given;
    StoppableBytes source(stop);
    source.setData(bytes);
    source.open(QIODevice::ReadOnly);
    allowDecoding(maxDecodedPixels);
    QImageReader reader(&source, isKnown(format) ? format : QByteArray("none"));
    reader.setAutoTransform(true);
    if (const auto flaw = flawOf(reader, bytes, large)) return {{}, flaw};
    if (isPng && isSwollen(bytes, stop)) return {{}, damaged()};
    const QSize size = reader.size();
    const bool isLarge = pixelsOf(size) > maxDecodedPixels;
    if (isLarge) reader.setScaledSize(reduced(size));
    QImage image = reader.read();
    if (stop.stop_requested()) return {{}, damaged()}; // some readers accept incomplete data
    if (image.isNull()) return {{}, isLarge ? tooLarge(size) : damaged()};
    return inSrgb(std::move(image));
}

} // namespace io
