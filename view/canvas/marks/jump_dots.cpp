// SPDX-License-Identifier: MIT
#include "canvas/marks/jump_dots.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/scene/canvas_scene.h"

#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr double large = 3.2; // pixels; radius of the first points
constexpr double small = 1;   // pixels; radius of so many points that they form a picture
constexpr double ring = 4;
constexpr double manyPoints = 3000;

} // namespace

void JumpDots::paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle&) {
    const std::vector<Construction::Jump>& jumps = m_construction->trail();
    if (jumps.size() < m_construction->jumps()) return; // too many to be told apart
    const auto& faces = m_construction->faces();
    const double share = std::min(1.0, double(jumps.size()) / manyPoints);
    const double radius = large + (small - large) * share;
    for (const Construction::Jump& jump : jumps) {
        if (jump.map >= faces.size()) continue;
        const attractor::Rgba& face = faces[jump.map].colour;
        const QColor colour(face.red, face.green, face.blue);
        painter.setBrush(jump.isPlotted ? QBrush(colour) : QBrush(Qt::NoBrush));
        painter.setPen(jump.isPlotted ? QPen(Qt::NoPen) : QPen(colour, 1.5));
        const double reach = jump.isPlotted ? radius : ring;
        painter.drawEllipse(pixelOf(canvas.camera(), jump.x), reach, reach);
    }
}

} // namespace view
