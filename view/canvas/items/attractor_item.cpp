// SPDX-License-Identifier: MIT
#include "canvas/items/attractor_item.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/grid_item.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double square = 8;    // pixels; side of a square of the checkerboard
constexpr double maxZoom = 256; // limit beyond which an old picture consists of a few blurred pixels

// Returns true if the picture falls on the pixels of the screen one to one.
bool isAligned(const QTransform& toDevice) {
    constexpr double tolerance = 1e-6;
    return std::abs(toDevice.m11() - 1) < tolerance && std::abs(toDevice.m22() - 1) < tolerance &&
           std::abs(toDevice.m12()) < tolerance &&
           std::abs(toDevice.dx() - std::round(toDevice.dx())) < tolerance * 1000 &&
           std::abs(toDevice.dy() - std::round(toDevice.dy())) < tolerance * 1000;
}

} // namespace

QImage imageOf(const attractor::Frame& frame) {
    return QImage(reinterpret_cast<const uchar*>(frame.pixels.data()), frame.camera.width,
                  frame.camera.height,
                  frame.opaque ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
}

void AttractorItem::setFrame(std::shared_ptr<const attractor::Frame> frame) {
    m_frame = std::move(frame);
    update();
}

void AttractorItem::setView(const attractor::Camera& camera, double devicePixelRatio) {
    if (camera.width != m_camera.width || camera.height != m_camera.height) prepareGeometryChange();
    m_camera = camera;
    m_ratio = devicePixelRatio;
    update();
}

QRectF AttractorItem::boundingRect() const {
    return {0, 0, double(m_camera.width), double(m_camera.height)};
}

void AttractorItem::paintBackdrop(QPainter& painter) const {
    painter.fillRect(boundingRect(), m_style.backdrop);
    if (!m_style.checker.isValid()) return;
    for (int row = 0; row * square < m_camera.height; ++row)
        for (int column = row % 2; column * square < m_camera.width; column += 2)
            painter.fillRect(QRectF(column * square, row * square, square, square), m_style.checker);
}

// Two passes over the memory of the screen would be as slow as two pictures.
void AttractorItem::paintWithGrid(QPainter& painter, const QImage& picture) const {
    const QImage lines = m_grid->uprightLines(m_ratio);
    for (int top = 0; top < picture.height(); top += GridItem::band) {
        const int rows = std::min(GridItem::band, picture.height() - top);
        painter.drawImage(0, top, picture, 0, top, picture.width(), rows);
        painter.drawImage(0, top, lines);
    }
    m_grid->leaveOutUprightLines();
}

void AttractorItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    // True if the picture is opaque and has exactly this view: it is copied, and nothing below it is painted.
    const bool covers = m_frame && m_frame->opaque && m_frame->camera == deviceCamera(m_camera, m_ratio) &&
                        m_frame->camera.width >= m_camera.width * m_ratio &&
                        m_frame->camera.height >= m_camera.height * m_ratio;
    if (!covers) paintBackdrop(*painter);
    if (m_frame) {
        const QTransform shift = pixelTransform(m_frame->camera, deviceCamera(m_camera, m_ratio)) *
                                 QTransform::fromScale(1 / m_ratio, 1 / m_ratio);
        const double zoom = std::hypot(shift.m11(), shift.m12());
        if (zoom < maxZoom && zoom > 1 / maxZoom) {
            painter->setTransform(shift, true);
            const bool aligned = isAligned(painter->deviceTransform());
            painter->setRenderHint(QPainter::SmoothPixmapTransform, !aligned);
            if (covers && aligned && m_grid != nullptr && m_grid->isVisible() && m_camera.rotation == 0)
                paintWithGrid(*painter, imageOf(*m_frame));
            else
                painter->drawImage(QPointF(0, 0), imageOf(*m_frame));
        }
    }
    painter->restore();
}

} // namespace view
