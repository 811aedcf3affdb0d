// SPDX-License-Identifier: MIT
#include "canvas/marks/map_numbers.h"

#include "canvas/scene/canvas_scene.h"
#include "io/overlay/picture_overlay.h"

#include <QPainter>

namespace view {

void MapNumbers::paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle&) {
    const document::Fractal& fractal = canvas.document().fractal();
    const document::System2* system = document::system2(fractal);
    if (!system || system->maps.size() > maxMaps) return;
    io::PictureOverlay overlay;
    overlay.fixedPoints = true;
    overlay.numbers = true;
    io::paint(painter, io::overlayMarks(fractal, canvas.camera(), overlay, canvas.handles().faces()));
}

} // namespace view
