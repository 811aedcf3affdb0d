// SPDX-License-Identifier: MIT
#include "io/picture/picture_writers.h"

#include "document/text/text.h"
#include "io/picture/png/png_writer.h"
#include "io/raster/exr_writer.h"
#include "io/raster/jpeg_writer.h"
#include "io/raster/tiff_writer.h"
#include "io/raster/webp_writer.h"

#include <algorithm>

namespace io {

namespace {

// Pixels along a side, where there is a limit.
std::optional<int> maxSide(PictureFile file) {
    switch (file) {
    case PictureFile::Jpeg:
        return 65'500;
    case PictureFile::WebP:
        return 16'383;
    default:
        return std::nullopt;
    }
}

QString nameOf(PictureFile file) {
    switch (file) {
    case PictureFile::Png:
        return QStringLiteral("PNG");
    case PictureFile::Jpeg:
        return QStringLiteral("JPEG");
    case PictureFile::WebP:
        return QStringLiteral("WebP");
    case PictureFile::Tiff:
        return QStringLiteral("TIFF");
    default:
        return QStringLiteral("OpenEXR");
    }
}

} // namespace

std::optional<PictureFile> pictureFileOf(const QString& suffix) {
    const QString name = suffix.toLower();
    if (name == u"png") return PictureFile::Png;
    if (name == u"jpg" || name == u"jpeg") return PictureFile::Jpeg;
    if (name == u"webp") return PictureFile::WebP;
    if (name == u"tif" || name == u"tiff") return PictureFile::Tiff;
    if (name == u"exr") return PictureFile::ExrHalf;
    return std::nullopt;
}

bool takes(PictureFile file, PictureFormat::Depth depth) {
    using enum PictureFormat::Depth;
    switch (file) {
    case PictureFile::Jpeg:
    case PictureFile::WebP:
        return depth == Bits8;
    case PictureFile::ExrHalf:
    case PictureFile::ExrFloat:
        return depth == Bits16;
    default:
        return true;
    }
}

Failure whyImpossible(PictureFile file, const PictureFormat& format) {
    constexpr double maxJpegDots = 65535;
    if (const auto limit = maxSide(file); limit && std::max(format.width, format.height) > *limit)
        return Text::tr("A %1 picture has at most %2 pixels along a side.").arg(nameOf(file)).arg(*limit);
    if (file == PictureFile::Jpeg && format.pixels == PictureFormat::Pixels::Transparent)
        return Text::tr(
            "A JPEG picture cannot be transparent. Choose a background colour or another format.");
    if (file == PictureFile::Jpeg && format.dotsPerInch.value_or(0) > maxJpegDots)
        return Text::tr("A JPEG picture has at most %1 dots per inch.").arg(int(maxJpegDots));
    const bool isOnlyOfPng = format.pixels == PictureFormat::Pixels::Grey || !format.texts.empty();
    if ((file != PictureFile::Png && isOnlyOfPng) || !takes(file, format.depth))
        return Text::tr("Such a picture cannot be written as %1.").arg(nameOf(file));
    return std::nullopt;
}

std::unique_ptr<PictureWriter> pictureWriter(PictureFile file, QIODevice& device,
                                             const PictureFormat& format) {
    switch (file) {
    case PictureFile::Jpeg:
        return std::make_unique<JpegWriter>(device, format);
    case PictureFile::WebP:
        return std::make_unique<WebPWriter>(device, format);
    case PictureFile::Tiff:
        return std::make_unique<TiffWriter>(device, format);
    case PictureFile::ExrHalf:
    case PictureFile::ExrFloat:
        return std::make_unique<ExrWriter>(device, file, format);
    case PictureFile::Png:
        break;
    }
    return std::make_unique<PngWriter>(device, format);
}

} // namespace io
