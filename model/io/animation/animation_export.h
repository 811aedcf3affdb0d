// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "io/animation/frame_drawing.h"
#include "io/video/format/video_format.h"

#include <QImage>
#include <QSize>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace io {

// Frames of an entry in its own look, in the view of its camera keys or else of all frames, as a video or as
// pictures. They are what `barycage-cli animate` draws with options().
struct AnimationExport {
    document::Fractal entry;           // animated entry; embedded as text
    std::optional<VideoFormat> format; // nullopt: PNG pictures
    QSize size;
    std::optional<std::uint64_t> points; // points of each frame; nullopt: 100 a pixel
    std::optional<int> supersample{};    // solids only, 1 … 4; nullopt: 2
    FrameOptions frames;
    int first = 0; // counted from 0
    int last = 0;
    // Whence the frames show all of a solid whose camera has no keys; withViewKeyed() makes it one.
    std::optional<attractor::OrbitCamera> seenFrom{};
};

// Replaces `seenFrom` by a key of the camera, so that the text of the entry says everything. It may take
// long.
AnimationExport withViewKeyed(AnimationExport what);

// The options of `animate` that say the same, to be put between the names of files.
QStringList options(const AnimationExport& what);

// Number of frames to draw.
int frameCount(const document::Fractal& entry);
// The number with which the last picture is written decides how many digits all have, at least four.
// `path` is "NAME.png": frame 6 of "wind.png" is "wind.0007.png".
QString framePath(const QString& path, int frame, int last);

// The files that pictures would replace: those that exist and are not complete and of the same request.
QStringList replacedFiles(const AnimationExport& what, const QString& path);

// Why it cannot be written: an encoder is missing, or the format does not have this size or rate.
Failure animationObstacle(const AnimationExport& what);

// A frame at a size of `pixels`, with its own exposure, for a dialog. nullopt when stopped, and where there
// is no room for it.
std::optional<QImage> framePreview(AnimationExport what, int frame, const QSize& pixels,
                                   const std::stop_token& stop = {});

// The same for many frames of one entry: what all of them share is found out with the first. One thread at a
// time.
class FramePreviews {
public:
    FramePreviews(AnimationExport what, const QSize& pixels);
    ~FramePreviews();

    std::optional<QImage> draw(int frame, const std::stop_token& stop = {});

private:
    AnimationExport m_what;
    std::unique_ptr<FrameDrawing> m_drawing;
};

// Draws the frames one after the other and writes them. A video appears whole or not at all. So does each
// picture; those that are complete and of the same request stay as they are, so that stopped work goes on
// where it was. `path` of pictures is "NAME.png".
ExportOutcome exportAnimation(const AnimationExport& what, const QString& path, const Progress& progress = {},
                              const std::stop_token& stop = {});

} // namespace io
