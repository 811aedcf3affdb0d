// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QFlags>

namespace view {

enum class HandleState {
    Hovered = 1,
    Pressed = 2,
    Focused = 4,
    Selected = 8,
    Hidden = 16, // hollow, because something is in front of it
};
Q_DECLARE_FLAGS(HandleStates, HandleState)
Q_DECLARE_OPERATORS_FOR_FLAGS(HandleStates)

// A numbered round handle: dark core, light rim, a dark line around it, so that it is seen on any picture.
class VertexHandle : public OverlayItem {
public:
    // 0: without a number
    VertexHandle(int number, QGraphicsItem* parent);

    void setState(HandleStates state);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    int m_number;
    HandleStates m_state;
};

} // namespace view
