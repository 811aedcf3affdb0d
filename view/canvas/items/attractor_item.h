// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "canvas/items/overlay_item.h"

#include <memory>

namespace view {

class GridItem;

// The newest picture, where the view sees it now: until the next one arrives it is shown moved and scaled.
class AttractorItem : public OverlayItem {
public:
    void setFrame(std::shared_ptr<const attractor::Frame> frame);
    void setView(const attractor::Camera& camera, double devicePixelRatio);
    // Item of the same view that is painted just after this one.
    void setGrid(GridItem* grid) { m_grid = grid; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void paintBackdrop(QPainter& painter) const;
    void paintWithGrid(QPainter& painter, const QImage& picture) const;

    std::shared_ptr<const attractor::Frame> m_frame;
    attractor::Camera m_camera; // device-independent camera of the view
    double m_ratio = 1;
    GridItem* m_grid = nullptr;
};

// The pixels of a frame, not copied: valid as long as the frame.
QImage imageOf(const attractor::Frame& frame);

} // namespace view
