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
    bool isTransparent = false; // MP4 shows what is transparent on black
    animation::FrameRate rate;  // positive
    bool repeats = false;       // GIF, WebP and APNG are played again and again rather than once
    QByteArray systemText;      // UTF-8, embedded for readVideoSystem(); empty: nothing
    QString title;
};

} // namespace io
