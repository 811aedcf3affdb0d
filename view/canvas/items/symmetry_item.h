// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QLineF>

#include <optional>
#include <vector>

namespace view {

// Handles of a symmetry, in pixels of the view.
struct SymmetryMarks {
    QPointF centre;
    QPointF knob; // handle of the centre, set off from it so as not to cover other handles
    std::vector<QLineF> mirrors;
    QPolygonF spokes; // ends of lines from the centre that are images of each other under the rotations

    friend bool operator==(const SymmetryMarks&, const SymmetryMarks&) = default;
};

// The centre of a symmetry with its handle, the mirrors, and spokes for the rotations.
class SymmetryItem : public OverlayItem {
public:
    void setMarks(const std::optional<SymmetryMarks>& marks);
    // The handle of the centre; nullopt without one, and while it is hidden.
    std::optional<QPointF> knob() const;
    void setHeld(bool held);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::optional<SymmetryMarks> m_marks;
    bool m_held = false;
};

} // namespace view
