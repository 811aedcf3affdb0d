// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"
#include "space/slice_plane.h"

#include <QLineF>
#include <QPointF>

#include <optional>

namespace view {

// The plane of a slice over the solid, with the handle in its middle by which it is dragged.
class SliceItem : public OverlayItem {
public:
    // nullopt: there is no slice.
    void layOut(const attractor::OrbitCamera& camera, const std::optional<SlicePlane>& plane);
    void setHeld(bool hovered, bool pressed);

    const std::optional<SlicePlane>& plane() const { return m_plane; }
    QPointF handle() const { return m_handle; }
    bool isHandleAt(const QPointF& position) const;

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::optional<SlicePlane> m_plane;
    std::vector<QLineF> m_border; // part of the border in front of the eye
    QPointF m_handle;
    QPointF m_arrow; // vector in pixels from the handle along the normal
    QRectF m_bounds;
    bool m_isHovered = false;
    bool m_isPressed = false;
};

} // namespace view
