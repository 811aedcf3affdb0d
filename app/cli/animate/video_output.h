// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"
#include "process/interrupt.h"
#include "process/progress_bar.h"

#include "io/video/video_writer.h"

#include <QImage>
#include <QString>

#include <functional>
#include <optional>

namespace cli {

// The frames of a video, one after the other.
struct VideoSource {
    int count = 0;
    io::VideoSettings settings; // without a size, which follows from the first frame
    // Draws or reads a frame, counted from 0. Null after a message, or when stopped.
    std::function<QImage(int index, const io::VideoWriter::Progress& progress)> frame;
};

// Writes the video and reports failures. A warning is given for a format that changes the frames.
ExitStatus writeVideo(const QString& path, VideoSource source, ProgressBar& bar, const Interrupt& interrupt);

} // namespace cli
