// SPDX-License-Identifier: MIT
#include "io/overlay/cage_overlay.h"

#include "io/overlay/overlay_marks.h"

#include <QPainter>

namespace io {

void paintCage(QImage& rows, const document::Fractal& fractal, const attractor::Camera& camera,
               const attractor::Rgba& background, int firstRow) {
    QPainter painter(&rows);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0, -firstRow);
    paint(painter, {cageMarks(fractal, camera, inkOn(background)).back()}); // current cage
    paint(painter, cornerMarks(fractal, camera, background));
}

} // namespace io
