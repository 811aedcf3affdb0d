// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>
#include <QString>

#include <optional>
#include <vector>

namespace view {

// A pointer to a corner of the cage outside the view.
struct BorderArrow {
    QPointF at;      // middle of the arrow, just inside the border
    QPointF towards; // unit vector towards the corner
    int vertex = 0;  // first of the corners at this place
    int others = 0;  // number of further corners behind the arrow
};

// Arrows at the border of `view`, one for each corner outside; corners in nearly the same place share one.
std::vector<BorderArrow> borderArrows(const QPolygonF& corners, const QRectF& view);

// The description of a click on an arrow.
QString cornerOutside();

// Draws the arrows, each with the number of its corner.
class BorderArrowsItem : public OverlayItem {
public:
    void setView(const QRectF& view);
    void setArrows(std::vector<BorderArrow> arrows);
    const std::vector<BorderArrow>& arrows() const { return m_arrows; }
    // The arrow under a position, within `reach` pixels of its middle.
    std::optional<BorderArrow> arrowAt(const QPointF& position, double reach) const;
    static constexpr double mouseReach = 14, fingerReach = 22;
    void setHovered(int vertex); // vertex whose arrow is lit; −1: none
    int hovered() const { return m_hovered; }

    QRectF boundingRect() const override { return m_view; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QRectF m_view;
    std::vector<BorderArrow> m_arrows;
    int m_hovered = -1;
};

} // namespace view
