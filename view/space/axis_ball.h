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
    // An end of an axis.
    struct End {
        int axis = 0;
        bool isPositive = true;

        friend bool operator==(const End&, const End&) = default;
    };

    void layOut(const attractor::OrbitCamera& camera); // view of camera.size, in its pixels

    bool covers(const QPointF& position) const;
    std::optional<End> endAt(const QPointF& position) const; // end nearest to the eye
    End front() const { return m_spots.back().end; }         // end nearest to the eye of all
    // The nearest to `from` on the screen in the direction of an arrow key; nullopt where that leads off the
    // ball.
    std::optional<End> beside(const End& from, const QPointF& direction) const;
    void setHovered(std::optional<End> end);
    void setFocused(std::optional<End> end); // end chosen with the keyboard
    std::optional<End> focused() const { return m_focused; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

    // The direction from which a camera looks along the axis at this end.
    static attractor::Direction towards(const End& end, attractor::UpAxis up = attractor::UpAxis::Y);
    // Returns true if the camera already looks from there.
    static bool looksFrom(const attractor::OrbitCamera& camera, const End& end);

private:
    struct Spot {
        End end;
        QPointF centre;
        double depth = 0; // distance away from the eye, −1 … 1
    };
    QColor colourOf(const End& end) const;
    void paintSpot(QPainter& painter, const Spot& at, const QColor& ground) const;
    void paintFocus(QPainter& painter) const;
    static void paintDisc(QPainter& painter, const Spot& at, const QColor& rim, const QColor& fill);
    static void paintName(QPainter& painter, const Spot& at);

    QPointF m_centre;
    std::array<Spot, 6> m_spots; // farthest first
    std::optional<End> m_hovered;
    std::optional<End> m_focused;
};

} // namespace view
