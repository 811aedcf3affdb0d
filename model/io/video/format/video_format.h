// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <optional>

namespace io {

enum class VideoFormat {
    Mp4,  // H.264
    WebM, // VP9
    Mkv,  // FFV1, without loss
    Gif,
    WebP, // without loss
    Apng, // without loss
};

// By the suffix of a file name, whatever its case; nullopt for any other.
std::optional<VideoFormat> videoFormat(const QString& suffix);

QString videoSuffix(VideoFormat format); // "mp4", …

struct VideoFormatFacts {
    bool storesAlpha = true;
    bool needsEvenSides = false;
    std::optional<int> maxRate; // frames per second
    std::optional<int> maxSide; // pixels
};
VideoFormatFacts factsOf(VideoFormat format);

} // namespace io
