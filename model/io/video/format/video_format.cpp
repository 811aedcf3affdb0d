// SPDX-License-Identifier: MIT
#include "io/video/format/video_format.h"

#include <QStringList>

namespace io {

namespace {

const QStringList& suffixes() {
    static const QStringList list{QStringLiteral("mp4"), QStringLiteral("webm"), QStringLiteral("mkv"),
                                  QStringLiteral("gif"), QStringLiteral("webp"), QStringLiteral("apng")};
    return list;
}

} // namespace

std::optional<VideoFormat> videoFormat(const QString& suffix) {
    const qsizetype index = suffixes().indexOf(suffix.toLower());
    return index >= 0 ? std::optional(VideoFormat(index)) : std::nullopt;
}

QString videoSuffix(VideoFormat format) {
    return suffixes().at(qsizetype(format));
}

VideoFormatFacts factsOf(VideoFormat format) {
    constexpr int common = 16384;
    switch (format) {
    case VideoFormat::Mp4:
        return {false, true, std::nullopt, common};
    case VideoFormat::WebP:
        return {true, false, 1000, 16383}; // milliseconds
    case VideoFormat::Gif:
        return {true, false, 50, common}; // hundredths of a second, and one of them is shown as ten
    case VideoFormat::WebM:
    case VideoFormat::Mkv:
    case VideoFormat::Apng:
        break;
    }
    return {true, false, std::nullopt, common};
}

} // namespace io
