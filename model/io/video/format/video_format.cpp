// SPDX-License-Identifier: MIT
#include "io/video/format/video_format.h"

#include <QCoreApplication>
#include <QLatin1String>

#include <algorithm>
#include <array>

namespace io {

std::span<const VideoFormatFacts> videoFormats() {
    static constexpr std::array formats{
        VideoFormatFacts{.format = VideoFormat::Mp4,
                         .suffix = "mp4",
                         .title = "MP4",
                         .listed = QT_TRANSLATE_NOOP("Text", "MP4: plays everywhere"),
                         .details = "H.264",
                         .storesAlpha = false,
                         .needsEvenSides = true},
        VideoFormatFacts{.format = VideoFormat::WebM,
                         .suffix = "webm",
                         .title = "WebM",
                         .listed = QT_TRANSLATE_NOOP("Text", "WebM: for web pages, with transparency"),
                         .details = "VP9, with transparency"},
        VideoFormatFacts{.format = VideoFormat::Mkv,
                         .suffix = "mkv",
                         .title = "MKV",
                         .listed = QT_TRANSLATE_NOOP("Text", "MKV: lossless, for editing"),
                         .details = "FFV1, lossless"},
        VideoFormatFacts{.format = VideoFormat::Gif,
                         .suffix = "gif",
                         .title = "GIF",
                         .listed = QT_TRANSLATE_NOOP("Text", "GIF: 256 colours"),
                         .details = "one palette for all frames",
                         .isPaletted = true,
                         .maxRate = 50}, // delays are hundredths of a second, and players show 1 as 10
        VideoFormatFacts{.format = VideoFormat::WebP,
                         .suffix = "webp",
                         .title = "WebP",
                         .listed = QT_TRANSLATE_NOOP("Text", "WebP: a lossless animated image"),
                         .details = "lossless",
                         .maxRate = 1000, // delays are milliseconds
                         .maxSide = 16'383},
        VideoFormatFacts{.format = VideoFormat::Apng,
                         .suffix = "apng",
                         .title = "APNG",
                         .listed = QT_TRANSLATE_NOOP("Text", "APNG: a lossless animated image"),
                         .details = "lossless"},
    };
    return formats;
}

const VideoFormatFacts& factsOf(VideoFormat format) {
    return *std::ranges::find(videoFormats(), format, &VideoFormatFacts::format);
}

std::optional<VideoFormat> videoFormat(const QString& suffix) {
    for (const VideoFormatFacts& facts : videoFormats())
        if (suffix.compare(QLatin1String(facts.suffix), Qt::CaseInsensitive) == 0) return facts.format;
    return std::nullopt;
}

QString videoSuffix(VideoFormat format) {
    return QLatin1String(factsOf(format).suffix);
}

} // namespace io
