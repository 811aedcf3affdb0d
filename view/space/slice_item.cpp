// SPDX-License-Identifier: MIT
#include "space/slice_item.h"

#include "space/seen_line.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double sliceGrip = 12; // pixels around the handle that hold it
constexpr double arrowLength = 34;

} // namespace

void SliceItem::layOut(const attractor::OrbitCamera& camera, const std::optional<SlicePlane>& plane) {
    prepareGeometryChange();
    m_plane = plane;
    m_bounds = {0, 0, double(camera.size.width), double(camera.size.height)};
    m_border.clear();
    if (!plane) return update();
    const std::size_t count = plane->corners.size();
    for (std::size_t k = 0; k < count; ++k)
        if (const auto edge = seenLine(camera, plane->corners[k], plane->corners[(k + 1) % count]))
            m_border.push_back(*edge);
    m_handle = seenPoint(camera, plane->centre);
    // Scale of the arrow in perspective: it looks short if it points at the eye.
    const double unit = arrowLength / pixelsPerUnit(camera);
    m_arrow = seenPoint(camera, plane->centre + unit * plane->normal) - m_handle;
    update();
}

void SliceItem::setHeld(bool hovered, bool pressed) {
    m_isHovered = hovered;
    m_isPressed = pressed;
    update();
}

bool SliceItem::isHandleAt(const QPointF& position) const {
    return m_plane && isVisible() && QLineF(m_handle, position).length() <= sliceGrip;
}

void SliceItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_plane) return;
    painter->setRenderHint(QPainter::Antialiasing);
    const QColor colour = m_isHovered || m_isPressed ? m_style.accent : m_style.line;
    QPainterPath border;
    for (const QLineF& edge : m_border) {
        if (border.currentPosition() != edge.p1() || border.elementCount() == 0) border.moveTo(edge.p1());
        border.lineTo(edge.p2());
    }
    strokeWithHalo(*painter, border, m_style, colour, m_style.lineWidth / 2, Qt::DashLine);
    QPainterPath arrow;
    for (const QPointF& tip : {m_handle + m_arrow, m_handle - m_arrow}) {
        arrow.moveTo(m_handle);
        arrow.lineTo(tip);
    }
    strokeWithHalo(*painter, arrow, m_style, colour, m_style.lineWidth);
    painter->setPen(QPen(m_style.rim, 1.5));
    painter->setBrush(m_isHovered || m_isPressed ? m_style.accent : m_style.core);
    const QPointF diamond[] = {m_handle + QPointF(0, -8), m_handle + QPointF(8, 0), m_handle + QPointF(0, 8),
                               m_handle + QPointF(-8, 0)};
    painter->drawPolygon(diamond, 4);
}

} // namespace view
