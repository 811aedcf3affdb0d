// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/canvas_part.h"
#include "canvas/items/overlay_style.h"

#include <QGraphicsItem>

namespace view {

// Something on the canvas that wears the colours of the overlay.
class OverlayItem : public QGraphicsItem {
public:
    using QGraphicsItem::QGraphicsItem;

    virtual void setStyle(const OverlayStyle& style) {
        m_style = style;
        update();
    }

protected:
    OverlayStyle m_style;
};

// An overlay with parts that can be dragged.
class HandlesItem : public OverlayItem {
public:
    virtual void setMarks(CanvasPart hovered, CanvasPart pressed, CanvasPart focused) {
        m_hovered = hovered;
        m_pressed = pressed;
        m_focused = focused;
        update();
    }

protected:
    CanvasPart m_hovered;
    CanvasPart m_pressed;
    CanvasPart m_focused;
};

} // namespace view
