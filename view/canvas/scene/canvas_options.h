// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_scene.h"

namespace view {

// Options of the canvas that the user can switch.
class CanvasOptions : public QObject {
    Q_OBJECT

public:
    explicit CanvasOptions(CanvasScene& scene) : m_scene(scene) {}

    void setGridVisible(bool visible);
    bool isGridVisible() const { return m_scene.grid().isGridVisible(); }
    void setAxesVisible(bool visible);
    bool areAxesVisible() const { return m_scene.grid().areAxesVisible(); }
    void setOverlaysVisible(bool visible); // all but the picture
    bool overlaysVisible() const { return m_scene.overlaysVisible(); }
    void setMapNumbersVisible(bool visible); // includes fixed points
    bool areMapNumbersVisible() const { return m_areMapNumbersVisible; }
    void setSnapping(Snapping snapping) { m_scene.setSnapping(snapping); }
    Snapping snapping() const { return m_scene.snapping(); }

signals:
    void gridVisibleChanged(bool visible);
    void axesVisibleChanged(bool visible);
    void overlaysVisibleChanged(bool visible);
    void mapNumbersVisibleChanged(bool visible);

private:
    CanvasScene& m_scene;
    bool m_areMapNumbersVisible = false;
};

} // namespace view
