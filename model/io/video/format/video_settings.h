// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "io/video/format/video_format.h"

#include <QByteArray>
#include <QString>

namespace io {

struct VideoSettings {
    VideoFormat format = VideoFormat::Mp4;
    int width = 0; // pixels
    int height = 0;
    bool isTransparent = false; // MP4 shows transparent parts on black
    animation::FrameRate rate;  // > 0
    bool repeats = false;       // true: GIF, WebP and APNG play for ever; false: once
    QByteArray systemText;      // UTF-8, embedded for readVideoSystem(); empty: nothing
    QString title;
};

} // namespace io
