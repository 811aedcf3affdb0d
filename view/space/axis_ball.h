// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_navigation.h"
#include "canvas/items/overlay_item.h"

#include <QPointF>

#include <array>
#include <optional>

namespace view {

// The ball of axes in the top right corner: shows how the camera is turned, and takes it along an axis.
class AxisBall : public OverlayItem {
public:
    // One end of an axis.
    struct End {
        int axis = 0;
        bool isPositive = true;

        friend bool operator==(const End&, const End&) = default;
    };

    void layOut(const attractor::OrbitCamera& camera); // for a view of camera.size, in its pixels

    bool covers(const QPointF& position) const;
    std::optional<End> endAt(const QPointF& position) const; // the nearest to the eye
    void setHovered(std::optional<End> end);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

    // From where one looks along the axis at this end.
    static attractor::Direction towards(const End& end, attractor::UpAxis up = attractor::UpAxis::Y);
    // Whether the camera already looks from there.
    static bool looksFrom(const attractor::OrbitCamera& camera, const End& end);

private:
    struct Spot {
        End end;
        QPointF centre;
        double depth = 0; // away from the eye, −1 … 1
    };
    QPointF m_centre;
    std::array<Spot, 6> m_spots; // the farthest first
    std::optional<End> m_hovered;
};

} // namespace view
