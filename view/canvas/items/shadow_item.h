// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <optional>

namespace view {

// Handle of a shadow, in pixels of the view.
struct ShadowMarks {
    QPointF foot; // foot of a stick as high as the picture
    QPointF tip;  // tip of its shadow: the handle

    friend bool operator==(const ShadowMarks&, const ShadowMarks&) = default;
};

// The shadow of a stick, with a handle at its tip.
class ShadowItem : public OverlayItem {
public:
    void setMarks(const std::optional<ShadowMarks>& marks);
    std::optional<QPointF> knob() const; // nullopt if there is no shadow or it is hidden
    void setHeld(bool held);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::optional<ShadowMarks> m_marks;
    bool m_held = false;
};

} // namespace view
