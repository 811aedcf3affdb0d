// SPDX-License-Identifier: MIT
#include "panels/collage/target_preview.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int usualSide = 140; // pixels
constexpr int minCrop = 8;     // pixels of the picture

QRectF rectOf(const collage::PixelBox& box) {
    return {double(box.left), double(box.top), double(box.width()), double(box.height())};
}

} // namespace

TargetPreview::TargetPreview(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Preview of the target"));
    setToolTip(tr("Drag a rectangle to crop the picture; double-click to use all of it"));
}

QSize TargetPreview::sizeHint() const {
    return {usualSide, usualSide};
}

void TargetPreview::setPicture(std::shared_ptr<const collage::GreyPicture> picture) {
    m_picture = std::move(picture);
    m_grey = {};
    m_shape = {};
    m_crop.reset();
    if (m_picture) {
        m_grey = QImage(m_picture->width, m_picture->height, QImage::Format_Grayscale8);
        for (int y = 0; y < m_picture->height; ++y)
            std::copy_n(m_picture->grey.begin() + std::ptrdiff_t(y) * m_picture->width, m_picture->width,
                        m_grey.scanLine(y));
    }
    setVisible(m_picture != nullptr);
    update();
}

void TargetPreview::setShape(const collage::Mask& mask, const std::optional<collage::PixelBox>& crop) {
    m_crop = crop;
    m_shape = QImage(mask.width, mask.height, QImage::Format_ARGB32_Premultiplied);
    QColor tint = palette().color(QPalette::Highlight);
    tint.setAlpha(150);
    m_shape.fill(Qt::transparent);
    const QRgb pixel = qPremultiply(tint.rgba());
    for (int y = 0; y < mask.height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(m_shape.scanLine(y));
        for (int x = 0; x < mask.width; ++x)
            if (mask(x, y)) line[x] = pixel;
    }
    update();
}

QRectF TargetPreview::pictureArea() const {
    const QSizeF size = QSizeF(m_grey.size()).scaled(QSizeF(rect().size()), Qt::KeepAspectRatio);
    QRectF area(QPointF(), size);
    area.moveCenter(QRectF(rect()).center());
    return area;
}

QRectF TargetPreview::dragged() const {
    const QRectF area = pictureArea();
    const double scale = m_grey.width() / area.width();
    const QRectF there = QRectF(*m_pressed, m_pointer).normalized() & area;
    return {(there.topLeft() - area.topLeft()) * scale, there.size() * scale};
}

void TargetPreview::paintEvent(QPaintEvent*) {
    if (m_grey.isNull()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF area = pictureArea();
    painter.drawImage(area, m_grey);
    const QTransform place =
        QTransform::fromScale(area.width() / m_grey.width(), area.height() / m_grey.height()) *
        QTransform::fromTranslate(area.x(), area.y());
    const QRectF crop = place.mapRect(m_crop ? rectOf(*m_crop) : QRectF(m_grey.rect()));
    painter.drawImage(crop, m_shape);
    QPainterPath outside;
    outside.addRect(area);
    outside.addRect(crop);
    painter.fillPath(outside, QColor(0, 0, 0, 140));
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.drawRect(crop.adjusted(0.5, 0.5, -0.5, -0.5));
    if (m_pressed) painter.drawRect(QRectF(*m_pressed, m_pointer).normalized() & area);
}

void TargetPreview::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_grey.isNull()) return;
    m_pressed = m_pointer = event->position();
}

void TargetPreview::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = event->position();
    if (m_pressed) update();
}

void TargetPreview::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_pressed) return;
    m_pointer = event->position();
    const QRect box = dragged().toAlignedRect() & m_grey.rect();
    m_pressed.reset();
    update();
    if (box.width() < minCrop || box.height() < minCrop) return; // mere click
    emit cropChosen(
        collage::PixelBox{box.left(), box.top(), box.left() + box.width(), box.top() + box.height()});
}

void TargetPreview::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_crop) emit cropChosen(std::nullopt);
}

} // namespace view
