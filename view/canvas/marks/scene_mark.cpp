// SPDX-License-Identifier: MIT
#include "canvas/marks/scene_mark.h"

#include "canvas/scene/canvas_scene.h"

#include <QPainter>
#include <QWidget>

namespace view {

namespace {

constexpr double level = 3.5; // above the grid, the analysis and the trail, below the handles

} // namespace

SceneMark::SceneMark() {
    setZValue(level);
}

QRectF SceneMark::boundingRect() const {
    const auto* canvas = qobject_cast<const CanvasScene*>(scene());
    return canvas ? QRectF(0, 0, canvas->camera().width, canvas->camera().height) : QRectF();
}

void SceneMark::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) {
    const auto* canvas = qobject_cast<const CanvasScene*>(scene());
    if (!canvas || !canvas->overlaysVisible()) return;
    painter->setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    paintOver(*painter, *canvas,
              overlayStyle(canvas->document().fractal().appearance.background,
                           widget ? widget->palette() : QPalette()));
}

} // namespace view
