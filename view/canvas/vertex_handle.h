// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/overlay_style.h"

#include <QFlags>
#include <QGraphicsItem>

namespace view {

enum class HandleState { Hovered = 1, Pressed = 2, Focused = 4 };
Q_DECLARE_FLAGS(HandleStates, HandleState)
Q_DECLARE_OPERATORS_FOR_FLAGS(HandleStates)

// A numbered round handle: dark core, light rim, a dark line around it, so that it is seen on any picture.
class VertexHandle : public QGraphicsItem {
public:
    VertexHandle(int number, QGraphicsItem* parent);

    void setState(HandleStates state);
    void setStyle(const OverlayStyle& style);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    int m_number;
    HandleStates m_state;
    OverlayStyle m_style;
};

} // namespace view
