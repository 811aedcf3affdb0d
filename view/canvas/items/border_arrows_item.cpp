// SPDX-License-Identifier: MIT
#include "canvas/items/border_arrows_item.h"

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double arrowInset = 22; // pixels from the border to the middle of an arrow
constexpr double arrowApart = 26; // pixels; least distance between two arrows
constexpr double arrowRadius = 10;
constexpr double tipLength = 17; // pixels from the middle

// The point of `area` nearest to the corner, where an edge that ends there leaves the view, or nearly so.
QPointF nearestIn(const QRectF& area, const QPointF& corner) {
    return {std::clamp(corner.x(), area.left(), area.right()),
            std::clamp(corner.y(), area.top(), area.bottom())};
}

// A disc with a tip towards the right.
QPainterPath drop() {
    QPainterPath path(QPointF(tipLength, 0));
    constexpr double spread = 48; // degrees from the tip to the point where it touches the disc
    path.arcTo(QRectF(-arrowRadius, -arrowRadius, 2 * arrowRadius, 2 * arrowRadius), spread,
               360 - 2 * spread);
    path.closeSubpath();
    return path;
}

} // namespace

std::vector<BorderArrow> borderArrows(const QPolygonF& corners, const QRectF& view) {
    std::vector<BorderArrow> arrows;
    const QRectF area = view.adjusted(arrowInset, arrowInset, -arrowInset, -arrowInset);
    if (area.isEmpty()) return arrows;
    for (int i = 0; i < corners.size(); ++i) {
        const QPointF& corner = corners[i];
        if (view.contains(corner) || !std::isfinite(corner.x()) || !std::isfinite(corner.y())) continue;
        const QPointF at = nearestIn(area, corner);
        const auto near = std::ranges::find_if(
            arrows, [&](const BorderArrow& arrow) { return QLineF(arrow.at, at).length() < arrowApart; });
        if (near != arrows.end()) {
            ++near->others;
            continue;
        }
        const QPointF way = corner - at;
        arrows.push_back({at, way / std::hypot(way.x(), way.y()), i});
    }
    return arrows;
}

QString cornerOutside() {
    return QCoreApplication::translate("view::CanvasInput",
                                       "Corner outside the view: click to fit the picture and its cage");
}

void BorderArrowsItem::setView(const QRectF& view) {
    prepareGeometryChange();
    m_view = view;
}

void BorderArrowsItem::setArrows(std::vector<BorderArrow> arrows) {
    m_arrows = std::move(arrows);
    update();
}

std::optional<BorderArrow> BorderArrowsItem::arrowAt(const QPointF& position, double reach) const {
    for (const BorderArrow& arrow : m_arrows)
        if (QLineF(arrow.at + arrow.towards * (tipLength - arrowRadius) / 2, position).length() <= reach)
            return arrow;
    return std::nullopt;
}

void BorderArrowsItem::setHovered(int vertex) {
    if (std::exchange(m_hovered, vertex) != vertex) update();
}

void BorderArrowsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    for (const BorderArrow& arrow : m_arrows) {
        const bool lit = arrow.vertex == m_hovered;
        painter->save();
        painter->translate(arrow.at);
        painter->save();
        painter->rotate(std::atan2(arrow.towards.y(), arrow.towards.x()) * 180 / M_PI);
        painter->setPen(
            QPen(m_style.core, m_style.lineWidth + 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(lit ? m_style.accent : m_style.core);
        painter->drawPath(drop());
        painter->setPen(QPen(m_style.rim, m_style.lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(drop());
        painter->restore();
        QFont font = painter->font();
        font.setPixelSize(arrow.others == 0 && arrow.vertex < 9 ? 11 : 9);
        font.setBold(true);
        painter->setFont(font);
        painter->setPen(lit ? m_style.onAccent : m_style.number);
        const QString number = QString::number(arrow.vertex + 1);
        painter->drawText(QRectF(-12, -12, 24, 24), Qt::AlignCenter,
                          arrow.others > 0 ? number + QChar(0x2026) : number);
        painter->restore();
    }
}

} // namespace view
