// SPDX-License-Identifier: MIT
#include "io/overlay/cage_overlay.h"

#include "io/overlay/overlay_marks.h"

#include <QPainter>

#include <cstddef>

namespace io {

namespace {

// Each drawn by itself, so that it is the same in every band of rows.
void paintCorner(QPainter& painter, const OverlayMark& disc, const OverlayMark& digits) {
    const double reach = disc.radius + disc.width;
    const QRect box =
        QRectF(disc.centre.x() - reach, disc.centre.y() - reach, 2 * reach, 2 * reach).toAlignedRect();
    QImage corner(box.size(), QImage::Format_ARGB32_Premultiplied);
    corner.fill(Qt::transparent);
    {
        QPainter own(&corner);
        own.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        own.translate(-box.topLeft());
        paint(own, {disc, digits});
    }
    painter.drawImage(box.topLeft(), corner);
}

} // namespace

void paintCage(QImage& rows, const document::Fractal& fractal, const attractor::Camera& camera,
               const attractor::Rgba& background, int firstRow) {
    QPainter painter(&rows);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0, -firstRow);
    paint(painter, {cageMarks(fractal, camera, inkOn(background)).back()}); // current cage
    const OverlayMarks corners = cornerMarks(fractal, camera, background);
    for (std::size_t i = 0; i + 1 < corners.size(); i += 2) // a disc and its digits
        paintCorner(painter, corners[i], corners[i + 1]);
}

} // namespace io
