// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"
#include "ifs/names.h"
#include "io/file/save_file.h"

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace io {

// File formats for pictures of pixels.
enum class PictureFile {
    Png,
    Jpeg,
    WebP,
    Tiff,
    ExrHalf,  // OpenEXR: linear light, 16-bit floating point
    ExrFloat, // OpenEXR: linear light, 32-bit floating point
};

struct PictureFormat {
    enum class Pixels { Opaque, Transparent, Grey }; // Grey: one channel of numbers, not light
    enum class Depth { Bits8, Bits16 };              // bits per channel of the rows given to the writer

    int width = 0;
    int height = 0;
    Pixels pixels = Pixels::Opaque; // Opaque: without the alpha channel
    Depth depth = Depth::Bits8;
    std::optional<double> dotsPerInch;
    QByteArray systemText; // UTF-8, embedded for readPictureSystem(); empty: nothing
    // Further texts, Latin-1: keyword (1 to 79 characters) and value.
    std::vector<std::pair<QByteArray, QByteArray>> texts{};
    std::optional<int> quality{}; // 1 … 100; nullopt: 92 for JPEG, lossless for WebP
};

// Writes a picture row by row. Any failure is remembered, and the calls that follow return it at once.
class PictureWriter {
public:
    PictureWriter() = default;
    virtual ~PictureWriter() = default;
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    // Whole rows from the top on, 0xAARRGGBB premultiplied, into a picture of 8 bits per channel …
    virtual Failure writeRows(std::span<const std::uint32_t> pixels) = 0;
    // … or of 16.
    virtual Failure writeRows(std::span<const attractor::Rgba16> pixels) = 0;
    virtual Failure finish() = 0; // called after the last row
};

} // namespace io

// Names in recipes.
template <>
inline constexpr auto ifs::names<io::PictureFile> = std::to_array<ifs::Named<io::PictureFile>>({
    {io::PictureFile::Png, "png"},
    {io::PictureFile::Jpeg, "jpeg"},
    {io::PictureFile::WebP, "webp"},
    {io::PictureFile::Tiff, "tiff"},
    {io::PictureFile::ExrHalf, "exr"},
    {io::PictureFile::ExrFloat, "exr-float"},
});
