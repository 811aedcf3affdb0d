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
    return QImage(reinterpret_cast<const uchar*>(m_frame->pixels.data()), m_frame->raster.width,
                  m_frame->raster.height, QImage::Format_ARGB32_Premultiplied);
}

QImage SolidItem::picture() const {
    return m_frame ? image().copy() : QImage();
}

void SolidItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->fillRect(boundingRect(), m_style.backdrop);
    if (!m_frame) return;
    const double step = m_frame->step / m_ratio;
    const QSizeF shown(m_frame->raster.width * step, m_frame->raster.height * step);
    painter->setRenderHint(QPainter::SmoothPixmapTransform, m_frame->step > 1);
    painter->setRenderHint(QPainter::Antialiasing, false);
    // The middles coincide; a coarse picture covers a little more than the view.
    const QPointF middle(m_frame->camera.size.width / 2.0 / m_ratio,
                         m_frame->camera.size.height / 2.0 / m_ratio);
    painter->drawImage(QRectF(middle - QPointF(shown.width() / 2, shown.height() / 2), shown), image());
}

} // namespace view
