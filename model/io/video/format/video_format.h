// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <optional>
#include <span>

namespace io {

enum class VideoFormat {
    Mp4,  // H.264
    WebM, // VP9
    Mkv,  // FFV1, lossless
    Gif,
    WebP, // lossless
    Apng, // lossless
};

// Names and capabilities of a kind of video.
struct VideoFormatFacts {
    VideoFormat format;
    const char* suffix;  // "mp4", also its name in settings and requests
    const char* title;   // "MP4"
    const char* listed;  // text of lists, for Text::tr()
    const char* details; // text of the help on the command line
    bool storesAlpha = true;
    bool isPaletted = false; // one palette of 256 colours serves all frames
    bool needsEvenSides = false;
    std::optional<int> maxRate = std::nullopt; // frames per second
    int maxSide = 16'384;                      // pixels
};
std::span<const VideoFormatFacts> videoFormats(); // order of lists
const VideoFormatFacts& factsOf(VideoFormat format);

// The format with this file suffix, in any case; nullopt for any other.
std::optional<VideoFormat> videoFormat(const QString& suffix);

QString videoSuffix(VideoFormat format); // "mp4", …

} // namespace io
