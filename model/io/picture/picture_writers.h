// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/picture_writer.h"

#include <QIODevice>
#include <QString>

#include <memory>
#include <optional>

namespace io {

// The part of the progress of an export in which it is drawn; the rest is compression.
inline constexpr double shareOfDrawing = 0.8;

// By the ending of a file's name, in any case: png, jpg, jpeg, webp, tif, tiff or exr (with 16 bits).
std::optional<PictureFile> pictureFileOf(const QString& suffix);

// How deep the rows of such a picture are: JPEG and WebP take only 8 bits, OpenEXR only 16.
bool takes(PictureFile file, PictureFormat::Depth depth);

// Why no picture of this format can be written to such a file, in a sentence, before it is drawn.
Failure whyImpossible(PictureFile file, const PictureFormat& format);

// The device is open for writing, can seek, and outlives the writer. Nothing is impossible.
std::unique_ptr<PictureWriter> pictureWriter(PictureFile file, QIODevice& device,
                                             const PictureFormat& format);

} // namespace io
