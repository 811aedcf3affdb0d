// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"

#include <QColor>
#include <QPixmap>

#include <cstdint>
#include <optional>
#include <vector>

namespace view {

// Returns true if the entry has few enough maps for moving pictures.
bool isPreviewed(const document::Fractal& entry);

struct PreviewStyle {
    QSize size; // logical pixels
    double pixelRatio = 1;
    QColor ink; // colour of the points, unless the palette itself moves
};

constexpr int previewFrames = 24;

// A few points of an animated entry at one frame after the other, as small pictures: the same points in all
// of them, so that they move. No frames where the entry does not move, or has so many maps that this would
// take long.
class MotionPreview {
public:
    MotionPreview(document::Fractal entry, const PreviewStyle& style);

    bool findNext(); // points of one further frame, in a few milliseconds; false if all are found
    std::vector<QPixmap> pictures() const; // pictures of the frames found

private:
    struct Frame {
        std::vector<QPointF> points; // y up
        std::optional<attractor::View> view;
        QColor colour;
    };
    document::Fractal m_entry;
    PreviewStyle m_style;
    std::int64_t m_length = 0; // frames of the animation; 0: no preview
    std::vector<Frame> m_frames;
};

} // namespace view
