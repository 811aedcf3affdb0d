// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/solid_thread.h"
#include "canvas/items/overlay_item.h"

#include <QImage>

#include <memory>

namespace view {

// The picture of a solid: the newest frame there is, in device pixels.
class SolidItem : public OverlayItem {
public:
    void setFrame(std::shared_ptr<const attractor::SolidFrame> frame);
    void setView(const QSizeF& size, double devicePixelRatio); // device-independent pixels
    QImage picture() const;                                    // null before the first frame

    QRectF boundingRect() const override { return {QPointF(), m_size}; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void paintEye(QPainter& painter, int eye, int eyes) const;
    QImage image() const; // shares the memory of the frame

    std::shared_ptr<const attractor::SolidFrame> m_frame;
    QSizeF m_size;
    double m_ratio = 1;
};

} // namespace view
