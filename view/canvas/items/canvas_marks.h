// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/snapping.h"
#include "canvas/items/overlay_item.h"

#include <QPolygonF>

#include <optional>

namespace view {

// Mark of a snapped point: a ring on a vertex, short guides along the lines of the grid and the axes.
class SnapMark : public OverlayItem {
public:
    void setSnap(const std::optional<Snapped>& snap, const QPointF& pixel);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::optional<Snapped> m_snap;
};

// The triangle being defined: the points clicked, and rubber lines to the pointer.
class RubberItem : public OverlayItem {
public:
    void setPoints(const QPolygonF& clicked, const std::optional<QPointF>& pointer); // pixels of the view

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QPolygonF m_clicked;
    std::optional<QPointF> m_pointer;
};

// The rectangle that selects what it encloses.
class BandItem : public OverlayItem {
public:
    void setBand(const QRectF& band); // pixels of the view; empty: none

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QRectF m_band;
};

} // namespace view
