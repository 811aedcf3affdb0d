// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

#include <memory>
#include <vector>

namespace view {

class VertexHandle;

// The control cage over the picture: its edges and one numbered handle at every vertex.
class CageItem : public HandlesItem {
public:
    CageItem();
    ~CageItem() override;

    void setPolygon(const QPolygonF& polygon); // pixels of the view
    void setMarks(CanvasPart hovered, CanvasPart pressed, CanvasPart focused) override;
    void setStyle(const OverlayStyle& style) override;
    void setSelected(const std::vector<std::size_t>& vertices);
    void setQuiet(bool quiet); // true: pale and without handles, while something else is held

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QPolygonF m_polygon;
    std::vector<std::unique_ptr<VertexHandle>> m_handles;
    std::vector<std::size_t> m_selected;
    bool m_quiet = false;
};

} // namespace view
