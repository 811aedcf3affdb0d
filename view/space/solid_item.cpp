// SPDX-License-Identifier: MIT
#include "space/solid_item.h"

#include <QPainter>

#include <utility>

namespace view {

void SolidItem::setFrame(std::shared_ptr<const attractor::SolidFrame> frame) {
    m_frame = std::move(frame);
    update();
}

void SolidItem::setView(const QSizeF& size, double devicePixelRatio) {
    prepareGeometryChange();
    m_size = size;
    m_ratio = devicePixelRatio;
}

QImage SolidItem::image() const {
    const int width = m_frame->raster.width * picturesAcross(m_frame->stereo);
    return QImage(reinterpret_cast<const uchar*>(m_frame->pixels.data()), width, m_frame->raster.height,
                  QImage::Format_ARGB32_Premultiplied);
}

QImage SolidItem::picture() const {
    return m_frame ? image().copy() : QImage();
}

void SolidItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->fillRect(boundingRect(), m_style.backdrop);
    if (!m_frame) return;
    painter->setRenderHint(QPainter::SmoothPixmapTransform, m_frame->step > 1);
    painter->setRenderHint(QPainter::Antialiasing, false);
    const int eyes = picturesAcross(m_frame->stereo);
    for (int eye = 0; eye < eyes; ++eye)
        paintEye(*painter, eye, eyes);
}

// The middles coincide; a coarse picture covers a little more than the view.
void SolidItem::paintEye(QPainter& painter, int eye, int eyes) const {
    const double step = m_frame->step / m_ratio;
    const QSizeF shown(m_frame->raster.width * step, m_frame->raster.height * step);
    const QSizeF view(m_frame->camera.size.width / m_ratio, m_frame->camera.size.height / m_ratio);
    const QPointF corner(eye * view.width(), 0);
    const QPointF middle = corner + QPointF(view.width() / 2, view.height() / 2);
    painter.save();
    if (eyes > 1) painter.setClipRect(QRectF(corner, view));
    painter.drawImage(QRectF(middle - QPointF(shown.width() / 2, shown.height() / 2), shown), image(),
                      QRectF(eye * m_frame->raster.width, 0, m_frame->raster.width, m_frame->raster.height));
    painter.restore();
}

} // namespace view
