// SPDX-License-Identifier: MIT
#include "canvas/items/gizmo_item.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace view {

namespace {

constexpr double distance = 26;    // pixels from the cage
constexpr double gizmoMargin = 20; // pixels to the edge of the view
constexpr double gizmoApart = 34;  // pixels; least distance between handles
constexpr double gizmoRadius = 9;
constexpr double pivotReach = 13; // pixels to a vertex whose number it would hide

QPointF clamped(const QPointF& p, const QRectF& area) {
    return {std::clamp(p.x(), area.left(), std::max(area.left(), area.right())),
            std::clamp(p.y(), area.top(), std::max(area.top(), area.bottom()))};
}

bool isClear(const QPointF& p, const QPolygonF& cage, const QPointF& pivot) {
    const auto far = [&](const QPointF& q) { return QLineF(p, q).length() >= gizmoApart * 0.75; };
    return far(pivot) && std::ranges::all_of(cage, far);
}

// Down or up along the edge of the view until no vertex is under the handle.
QPointF cleared(QPointF p, double step, const QPolygonF& cage, const QPointF& pivot, const QRectF& area) {
    for (int attempt = 0; attempt < 8 && !isClear(p, cage, pivot); ++attempt) {
        const double y = p.y() + step;
        if (y < area.top() || y > area.bottom()) break;
        p.setY(y);
    }
    return p;
}

// An open circle with a head where it ends, along its direction.
QPainterPath rotateGlyph() {
    constexpr double r = 4.6;
    QPainterPath glyph;
    glyph.arcMoveTo(QRectF(-r, -r, 2 * r, 2 * r), 60);
    glyph.arcTo(QRectF(-r, -r, 2 * r, 2 * r), 60, 285);
    const QPointF tip = glyph.currentPosition();
    const QLineF back = QLineF(QPointF(), tip).normalVector();
    for (const double spread : {-42.0, 42.0}) {
        QLineF barb = QLineF::fromPolar(3.6, back.angle() + 180 + spread);
        barb.translate(tip);
        glyph.moveTo(tip);
        glyph.lineTo(barb.p2());
    }
    return glyph;
}

QPainterPath scaleGlyph() {
    QPainterPath glyph(QPointF(-4, -4));
    glyph.lineTo(4, 4);
    glyph.moveTo(-4, -0.8);
    glyph.lineTo(-4, -4);
    glyph.lineTo(-0.8, -4);
    glyph.moveTo(4, 0.8);
    glyph.lineTo(4, 4);
    glyph.lineTo(0.8, 4);
    return glyph;
}

} // namespace

GizmoLayout gizmoLayout(const QPolygonF& cage, const QPointF& pivot, const QRectF& view) {
    const QRectF area = view.adjusted(gizmoMargin, gizmoMargin, -gizmoMargin, -gizmoMargin);
    const QRectF box = cage.boundingRect().adjusted(-distance, -distance, distance, distance);
    GizmoLayout layout;
    layout.pivot = pivot;
    layout.isPivotCovered =
        std::ranges::any_of(cage, [&](const QPointF& q) { return QLineF(q, pivot).length() < pivotReach; });
    layout.rotate = cleared(clamped(box.topRight(), area), gizmoApart / 2, cage, pivot, area);
    QPointF scale = clamped(box.bottomRight(), area);
    if (QLineF(scale, layout.rotate).length() < gizmoApart)
        scale.setY(layout.rotate.y() +
                   (layout.rotate.y() + gizmoApart <= area.bottom() ? gizmoApart : -gizmoApart));
    layout.scale =
        cleared(scale, scale.y() < layout.rotate.y() ? gizmoApart / 2 : -gizmoApart / 2, cage, pivot, area);
    if (QLineF(layout.scale, layout.rotate).length() < gizmoApart) layout.scale = scale;
    return layout;
}

void GizmoItem::setView(const QRectF& view) {
    prepareGeometryChange();
    m_view = view;
}

void GizmoItem::setLayout(const GizmoLayout& layout) {
    m_layout = layout;
    update();
}

QRectF GizmoItem::boundingRect() const {
    return m_view;
}

void GizmoItem::paintPivot(QPainter& painter) const {
    constexpr CanvasPart self{CanvasPart::Kind::Pivot, 0};
    const bool lit = m_hovered == self || m_pressed == self;
    if (m_layout.isPivotCovered && !lit && m_focused != self) return;
    QPainterPath cross;
    cross.addEllipse(m_layout.pivot, 5, 5);
    for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        cross.moveTo(m_layout.pivot + direction * 5);
        cross.lineTo(m_layout.pivot + direction * 9);
    }
    if (lit)
        strokeLit(painter, cross, m_style, m_style.lineWidth);
    else
        strokeWithHalo(painter, cross, m_style, m_style.line, m_style.lineWidth);
    if (m_focused == self) strokeFocusRing(painter, m_layout.pivot, 14, m_style);
}

void GizmoItem::paintKnob(QPainter& painter, CanvasPart::Kind kind, const QPointF& at) const {
    const CanvasPart self{kind, 0};
    const bool lit = m_hovered == self || m_pressed == self;
    painter.save();
    painter.translate(at);
    if (m_focused == self) strokeFocusRing(painter, QPointF(), 14, m_style);
    painter.setPen(QPen(m_style.line, 1));
    painter.setBrush(m_style.halo);
    painter.drawEllipse(QPointF(), gizmoRadius + 2, gizmoRadius + 2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(lit ? m_style.accent : m_style.line, m_style.lineWidth, Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.drawPath(kind == CanvasPart::Kind::Rotate ? rotateGlyph() : scaleGlyph());
    painter.restore();
}

void GizmoItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    paintPivot(*painter);
    const auto shown = [&](CanvasPart::Kind kind) {
        return m_pressed.kind == CanvasPart::Kind::None || m_pressed.kind == kind;
    };
    if (shown(CanvasPart::Kind::Rotate)) paintKnob(*painter, CanvasPart::Kind::Rotate, m_layout.rotate);
    if (shown(CanvasPart::Kind::Scale)) paintKnob(*painter, CanvasPart::Kind::Scale, m_layout.scale);
}

} // namespace view
