// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/overlay_item.h"

#include <QImage>
#include <QLineF>

#include <vector>

namespace view {

// A quiet grid whose spacing follows the zoom, the two axes, and numbers along the axes.
class GridItem : public OverlayItem {
public:
    void setView(const attractor::Camera& camera);
    void setGridVisible(bool visible);
    void setAxesVisible(bool visible);
    bool isGridVisible() const { return m_grid; }
    bool areAxesVisible() const { return m_axes; }

    // Support for the item below, which paints a picture that fills the view band by band: it draws the
    // upright lines over each band while the band is in the cache, and paint() then leaves them out once. In
    // device pixels.
    static constexpr int band = 16; // rows
    QImage uprightLines(double ratio) const;
    void leaveOutUprightLines() { m_areUprightPainted = true; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    struct Line {
        int at; // first device pixel of the line
        int thickness;
        QColor colour;
    };
    struct TurnedLine {
        double index; // multiple of the step
        QLineF line;  // visible part
    };
    std::vector<Line> linesAlong(int axis, double ratio) const;
    void paintLines(QPainter& painter);
    void paintLabels(QPainter& painter) const;
    void paintTurnedLines(QPainter& painter) const;
    void paintTurnedLabels(QPainter& painter) const;
    QRectF paintBase(QPainter& painter) const; // returns the area of the text
    std::vector<TurnedLine> turnedLines(int axis, double step) const;

    attractor::Camera m_camera;
    bool m_grid = true;
    bool m_axes = true;
    bool m_areUprightPainted = false;
};

} // namespace view
