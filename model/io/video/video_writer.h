// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"
#include "io/video/format/video_settings.h"

#include <QImage>
#include <QString>

#include <functional>
#include <memory>
#include <stop_token>

namespace io {

// Why no video of these settings can be written here: a library or an encoder that is missing, or a size or a
// rate that the format does not have.
Failure videoObstacle(const VideoSettings& settings);

// Writes a video through FFmpeg's libraries; `path` appears whole or not at all. The same frames give the
// same bytes with the same versions of the libraries. Where a format needs even sides, the last column and
// the last row are shown twice. A GIF has one palette for all frames, so that its frames wait, compressed, in
// a file without a name until finish(). Any failure is remembered and makes the calls that follow return it
// at once.
class VideoWriter {
public:
    using Progress = std::function<void(double fraction)>;

    VideoWriter(const QString& path, const VideoSettings& settings);
    ~VideoWriter();

    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    const Failure& failure() const;

    // The next frame, sRGB of any QImage format, of the size in the settings. It is encoded while the caller
    // draws the one after it, so that its failure may be that of the next call.
    Failure writeFrame(const QImage& frame);
    // Call after the last frame, of which there is at least one. When stopped, nothing is written.
    Failure finish(const Progress& progress = {}, const std::stop_token& stop = {});

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
