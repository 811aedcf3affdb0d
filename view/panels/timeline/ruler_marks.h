// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/animation_edits.h"
#include "panels/timeline/ruler_scale.h"

#include <QRectF>
#include <QString>

#include <vector>

class QFont;
class QPainter;
class QPalette;

// Marks of a ruler: labels, ticks between them, and ticks where there are keys.
namespace view {

// The visible part of a ruler, in pixels.
struct RulerPlace {
    QRectF area;
    double start = 0; // x of frame 0
    double scale = 1; // pixels per frame
    document::Timing timing;
    RulerUnit unit = RulerUnit::Frames;
};

struct RulerLabel {
    int frame = 0;
    QString text;
    QRectF room; // area around the frame; areas of labels do not overlap
};

// Labels that are in sight, with the ones that the edges cut.
std::vector<RulerLabel> rulerLabels(const RulerPlace& place, const QFont& font);

// Labels that meet `covered` are left out. A tick is bold at the frames where any track has a key.
void paintRulerMarks(QPainter& painter, const RulerPlace& place, const QRectF& covered,
                     const std::vector<document::TrackKeys>& tracks, const QPalette& palette);

} // namespace view
