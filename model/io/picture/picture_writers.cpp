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

template <class Writer>
std::unique_ptr<PictureWriter> writerOf(QIODevice& device, const PictureFormat& format) {
    return std::make_unique<Writer>(device, format);
}

template <PictureFile file>
std::unique_ptr<PictureWriter> exrWriter(QIODevice& device, const PictureFormat& format) {
    return std::make_unique<ExrWriter>(device, file, format);
}

} // namespace

std::span<const PictureFileFacts> pictureFiles() {
    static const std::vector<PictureFileFacts> files{
        {.file = PictureFile::Png,
         .title = "PNG",
         .inPlane = QT_TRANSLATE_NOOP("Text", "PNG: pixels"),
         .inSpace = QT_TRANSLATE_NOOP("Text", "PNG: pixels"),
         .suffixes = {"png"},
         .writer = writerOf<PngWriter>},
        {.file = PictureFile::Jpeg,
         .title = "JPEG",
         .inPlane = QT_TRANSLATE_NOOP("Text", "JPEG: pixels, a small file"),
         .inSpace = QT_TRANSLATE_NOOP("Text", "JPEG: pixels, a small file"),
         .suffixes = {"jpg", "jpeg"},
         .takes16Bits = false,
         .hasQuality = true,
         .canBeTransparent = false,
         .maxSide = 65'500,
         .writer = writerOf<JpegWriter>},
        {.file = PictureFile::WebP,
         .title = "WebP",
         .inPlane = QT_TRANSLATE_NOOP("Text", "WebP: pixels, for web pages"),
         .inSpace = QT_TRANSLATE_NOOP("Text", "WebP: pixels, for web pages"),
         .suffixes = {"webp"},
         .takes16Bits = false,
         .hasQuality = true,
         .maxSide = 16'383,
         .writer = writerOf<WebPWriter>},
        {.file = PictureFile::Tiff,
         .title = "TIFF",
         .inPlane = QT_TRANSLATE_NOOP("Text", "TIFF: pixels, for print"),
         .inSpace = QT_TRANSLATE_NOOP("Text", "TIFF: pixels, for print"),
         .suffixes = {"tiff", "tif"},
         .writer = writerOf<TiffWriter>},
        {.file = PictureFile::ExrHalf,
         .title = "OpenEXR",
         .inPlane = QT_TRANSLATE_NOOP("Text", "OpenEXR: linear light, for compositing"),
         .inSpace = QT_TRANSLATE_NOOP("Text", "OpenEXR: linear light, for compositing"),
         .suffixes = {"exr"},
         .takes8Bits = false,
         .writer = exrWriter<PictureFile::ExrHalf>},
        {.file = PictureFile::ExrFloat,
         .title = "OpenEXR",
         .inPlane = nullptr,
         .inSpace = nullptr,
         .suffixes = {},
         .takes8Bits = false,
         .writer = exrWriter<PictureFile::ExrFloat>},
    };
    return files;
}

const PictureFileFacts& factsOf(PictureFile file) {
    return *std::ranges::find(pictureFiles(), file, &PictureFileFacts::file);
}

std::optional<PictureFile> pictureFileOf(const QString& suffix) {
    for (const PictureFileFacts& facts : pictureFiles())
        for (const char* known : facts.suffixes)
            if (suffix.compare(QLatin1String(known), Qt::CaseInsensitive) == 0) return facts.file;
    return std::nullopt;
}

bool takes(PictureFile file, PictureFormat::Depth depth) {
    const PictureFileFacts& facts = factsOf(file);
    return depth == PictureFormat::Depth::Bits8 ? facts.takes8Bits : facts.takes16Bits;
}

Failure whyImpossible(PictureFile file, const PictureFormat& format) {
    constexpr double maxJpegDots = 65535;
    const PictureFileFacts& facts = factsOf(file);
    const QLatin1String title(facts.title);
    if (facts.maxSide && std::max(format.width, format.height) > *facts.maxSide)
        return Text::tr("A %1 picture has at most %2 pixels along a side.").arg(title).arg(*facts.maxSide);
    if (file == PictureFile::Jpeg && format.pixels == PictureFormat::Pixels::Transparent)
        return Text::tr(
            "A JPEG picture cannot be transparent. Choose a background colour or another format.");
    if (file == PictureFile::Jpeg && format.dotsPerInch.value_or(0) > maxJpegDots)
        return Text::tr("A JPEG picture has at most %1 dots per inch.").arg(int(maxJpegDots));
    const bool isOnlyOfPng = format.pixels == PictureFormat::Pixels::Grey || !format.texts.empty();
    if ((file != PictureFile::Png && isOnlyOfPng) || !takes(file, format.depth))
        return Text::tr("Such a picture cannot be written as %1.").arg(title);
    return std::nullopt;
}

std::unique_ptr<PictureWriter> pictureWriter(PictureFile file, QIODevice& device,
                                             const PictureFormat& format) {
    return factsOf(file).writer(device, format);
}

} // namespace io
