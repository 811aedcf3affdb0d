// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <optional>
#include <stop_token>

namespace io {

// The one decoder of pictures that a user gives. Reads PNG, JPEG, GIF, BMP, PNM, WebP, TIFF and OpenEXR,
// turned upright, in sRGB. Refused are animations, JPEG pictures in CMYK, whose colours depend on the program
// that reads them, incomplete pictures, and those with more pixels or scans than this. Memory is bounded by
// these. Texts and what else changes no pixel are not read. A stop makes it end with a flaw.
inline constexpr qint64 maxDecodedPixels = 32'000'000;
// Number of pixels to which a larger PNG or JPEG picture is scaled down while it is read, in its proportions,
// where the size does not matter.
inline constexpr qint64 maxReducedPixels = 256'000'000;
inline constexpr int maxScans = 100; // limit for a JPEG; encoders write some ten
enum class LargePicture { Refused, Reduced };

struct DecodedPicture {
    QImage image;                // any pixel format
    std::optional<QString> flaw; // reason why there is no picture, as a sentence
};
const QStringList& pictureSuffixes(); // lower-case suffixes of such pictures
DecodedPicture decodedPicture(const QByteArray& bytes, LargePicture large = LargePicture::Refused,
                              const std::stop_token& stop = {});

// A frame of a video: a PNG with at most `maxFramePixels` pixels, as videos have at most, in its own colour
// space.
inline constexpr qint64 maxFramePixels = 1 << 28;
DecodedPicture decodedFrame(const QByteArray& png, const std::stop_token& stop = {});

} // namespace io
