// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

#include <span>
#include <vector>

namespace view {

// The image of the cage under one map, in pixels of the view.
struct MapFrame {
    int index = 0; // index of the map in the system
    QPolygonF corners;
    QPolygonF outline; // polygon with edges bent like the cage
    QColor colour;
    bool selected = false;
    bool takesPart = true;
    bool isLocked = false; // true: corners are shown, but cannot be dragged
};

const MapFrame* frameOf(const std::vector<MapFrame>& frames, int index); // nullptr: none

// The part of the frames taken by a press at `position`: a corner within `corner` pixels, those of selected
// frames first; else the smallest frame that holds the position or has it within `edge` of its outline.
CanvasPart framePartAt(const std::vector<MapFrame>& frames, const QPointF& position, double corner,
                       double edge);

// The maps as children of the cage, each in its colour, corners numbered as those of the cage.
class MapFramesItem : public HandlesItem {
public:
    // Held: with corners. Else only a hint of the selected frames.
    enum class Mode { Hint, Held };

    void setFrames(std::vector<MapFrame> frames, Mode mode);
    const std::vector<MapFrame>& frames() const { return m_frames; } // sorted by index

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    bool isHovered(const MapFrame& frame) const;
    void paintFrame(QPainter& painter, const MapFrame& frame) const;
    void paintCorners(QPainter& painter, const MapFrame& frame) const;
    void paintDot(QPainter& painter, const MapFrame& frame) const;
    void paintThin(QPainter& painter, std::span<const MapFrame* const> frames) const;

    std::vector<MapFrame> m_frames;
    Mode m_mode = Mode::Hint;
};

} // namespace view
