// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/picture_writer.h"

#include <QIODevice>
#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace io {

// The part of the progress of an export in which it is drawn; the rest is compression.
inline constexpr double shareOfDrawing = 0.8;

// Capabilities of a kind of picture file, and its writer.
struct PictureFileFacts {
    PictureFile file;
    const char* title;   // "PNG"
    const char* inPlane; // title in the list of pictures of the plane, for Text::tr(); null: not listed
    const char* inSpace; // title in the list of pictures of solids; null: not listed
    std::vector<const char*> suffixes; // default first; empty: files are named like those of another kind
    bool takes8Bits = true;            // 8-bit rows
    bool takes16Bits = true;
    bool hasQuality = false; // true for lossy formats with an adjustable quality
    bool canBeTransparent = true;
    std::optional<int> maxSide = std::nullopt; // pixels
    std::unique_ptr<PictureWriter> (*writer)(QIODevice& device, const PictureFormat& format);
};
std::span<const PictureFileFacts> pictureFiles(); // order of lists
const PictureFileFacts& factsOf(PictureFile file);

// The kind of file with this suffix, in any case; OpenEXR with 16 bits.
std::optional<PictureFile> pictureFileOf(const QString& suffix);

bool takes(PictureFile file, PictureFormat::Depth depth); // true for rows of this depth

// Why no picture of this format can be written to such a file, in a sentence, before it is drawn.
Failure whyImpossible(PictureFile file, const PictureFormat& format);

// The device is open for writing, can seek, and outlives the writer. Nothing is impossible.
std::unique_ptr<PictureWriter> pictureWriter(PictureFile file, QIODevice& device,
                                             const PictureFormat& format);

} // namespace io
