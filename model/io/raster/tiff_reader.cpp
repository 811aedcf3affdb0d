// SPDX-License-Identifier: MIT
#include "io/raster/tiff_reader.h"

#include <QColorSpace>
#include <QTransform>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include <tiffio.h>

namespace io {

namespace {

constexpr tmsize_t maxAllocation = tmsize_t{512} << 20; // bytes of one strip or tile, and of any table
constexpr std::uint16_t maxSamples = 16;                // samples per pixel
// Limits of all strips or tiles together, which may be the same ones again and again: as they are in the
// file, and decompressed.
constexpr std::uint64_t maxStored = std::uint64_t{512} << 20, maxUnpacked = std::uint64_t{2} << 30;

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

struct Source {
    const QByteArray& bytes;
    std::stop_token stop;
    toff_t at = 0;
};

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) {
    auto* source = static_cast<Source*>(handle);
    const auto size = toff_t(source->bytes.size());
    if (count < 0 || source->at >= size || source->stop.stop_requested()) return 0;
    const auto read = std::min(toff_t(count), size - source->at);
    std::memcpy(to, source->bytes.constData() + source->at, std::size_t(read));
    source->at += read;
    return tmsize_t(read);
}

toff_t seekBytes(thandle_t handle, toff_t offset, int whence) {
    auto* source = static_cast<Source*>(handle);
    const toff_t from = whence == SEEK_SET   ? 0
                        : whence == SEEK_END ? toff_t(source->bytes.size())
                                             : source->at;
    return source->at = from + offset;
}

Tiff opened(Source& source) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    const auto isSaid = [](TIFF*, void*, const char*, const char*, va_list) { return 1; };
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), isSaid, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), isSaid, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), maxAllocation);
    const auto write = [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; };
    const auto close = [](thandle_t) { return 0; };
    const auto sizeOf = [](thandle_t handle) { return toff_t(static_cast<Source*>(handle)->bytes.size()); };
    constexpr const char* readOnlyUnmapped = "rm";
    return {TIFFClientOpenExt("", readOnlyUnmapped, &source, readBytes, write, seekBytes, close, sizeOf,
                              nullptr, nullptr, options.get()),
            TIFFClose};
}

// The transform that brings the first row to the top and the first column to the left, by the tag
// Orientation.
QTransform upright(std::uint16_t orientation) {
    switch (orientation) {
    case ORIENTATION_TOPRIGHT:
        return {-1, 0, 0, 1, 0, 0};
    case ORIENTATION_BOTRIGHT:
        return {-1, 0, 0, -1, 0, 0};
    case ORIENTATION_BOTLEFT:
        return {1, 0, 0, -1, 0, 0};
    case ORIENTATION_LEFTTOP:
        return {0, 1, 1, 0, 0, 0};
    case ORIENTATION_RIGHTTOP:
        return {0, 1, -1, 0, 0, 0};
    case ORIENTATION_RIGHTBOT:
        return {0, -1, -1, 0, 0, 0};
    case ORIENTATION_LEFTBOT:
        return {0, -1, 1, 0, 0, 0};
    default:
        return {};
    }
}

// libtiff's packed pixels, premultiplied, row by row from the top.
QImage imageOf(const std::vector<std::uint32_t>& packed, const QSize& size) {
    QImage image(size, QImage::Format_ARGB32);
    const std::uint32_t* from = packed.data();
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, ++from) {
            const int alpha = int(TIFFGetA(*from));
            const auto channel = [alpha](std::uint32_t value) { return std::min(int(value), alpha); };
            row[x] = qUnpremultiply(
                qRgba(channel(TIFFGetR(*from)), channel(TIFFGetG(*from)), channel(TIFFGetB(*from)), alpha));
        }
    }
    return image;
}

// The profile of pictures in colours; nothing where there is none.
QByteArray profileOf(TIFF* tiff) {
    std::uint32_t size = 0;
    void* profile = nullptr;
    std::uint16_t photometric = 0;
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
    const bool isInColours = photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_PALETTE;
    if (!isInColours || !TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile)) return {};
    return {static_cast<const char*>(profile), qsizetype(size)};
}

bool isTooMuch(TIFF* tiff) {
    const bool isTiled = TIFFIsTiled(tiff) != 0;
    const std::uint32_t count = isTiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
    const std::uint64_t size = isTiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff);
    if (size == 0 || size > maxUnpacked / std::max<std::uint32_t>(count, 1)) return true;
    std::uint64_t stored = 0;
    for (std::uint32_t k = 0; k < count && stored <= maxStored; ++k)
        stored += std::min(TIFFGetStrileByteCount(tiff, k), maxStored + 1);
    return stored > maxStored;
}

} // namespace

RasterPicture readTiff(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop) {
    using enum RasterPicture::Flaw;
    Source source{bytes, stop};
    const Tiff tiff = opened(source);
    std::uint32_t width = 0, height = 0;
    if (!tiff || !TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) ||
        !TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height) || width == 0 || height == 0)
        return {};
    constexpr std::uint32_t longest = 0x7fffffff;
    const QSize size(int(std::min(width, longest)), int(std::min(height, longest)));
    if (std::uint64_t(width) * height > std::uint64_t(maxPixels)) return {{}, size, TooLarge};
    std::uint16_t samples = 0, orientation = 0;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &orientation);
    char reason[1024];
    if (samples > maxSamples || !TIFFRGBAImageOK(tiff.get(), reason)) return {{}, size, Unreadable};
    if (isTooMuch(tiff.get())) return {{}, size, Unreadable};
    // Libtiff mirrors, but does not rotate.
    TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    constexpr int stopsAtErrors = 1;
    std::vector<std::uint32_t> packed(std::size_t(width) * height);
    if (!TIFFReadRGBAImageOriented(tiff.get(), width, height, packed.data(), ORIENTATION_TOPLEFT,
                                   stopsAtErrors))
        return {{}, size, Damaged};
    QImage image = imageOf(packed, size);
    if (image.isNull()) return {{}, size, Damaged};
    if (const QByteArray profile = profileOf(tiff.get()); !profile.isEmpty())
        image.setColorSpace(QColorSpace::fromIccProfile(profile));
    return {orientation == ORIENTATION_TOPLEFT ? image : image.transformed(upright(orientation)), size};
}

} // namespace io
