// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_style.h"

#include <QGraphicsItem>

namespace view {

class CanvasScene;

// A mark that explains the picture and lies under the handles. It finds its content when it is painted, and
// is hidden with all other overlays. To be added to a CanvasScene, which then owns it.
class SceneMark : public QGraphicsItem {
public:
    SceneMark();

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) final;

protected:
    // Paints in pixels of the view, with antialiasing on.
    virtual void paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) = 0;
};

} // namespace view
