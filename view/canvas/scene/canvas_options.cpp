// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_options.h"

namespace view {

void CanvasOptions::setGridVisible(bool visible) {
    if (visible == isGridVisible()) return;
    m_scene.grid().setGridVisible(visible);
    emit gridVisibleChanged(visible);
}

void CanvasOptions::setAxesVisible(bool visible) {
    if (visible == areAxesVisible()) return;
    m_scene.grid().setAxesVisible(visible);
    emit axesVisibleChanged(visible);
}

void CanvasOptions::setOverlaysVisible(bool visible) {
    if (visible == overlaysVisible()) return;
    m_scene.setOverlaysVisible(visible);
    emit overlaysVisibleChanged(visible);
}

void CanvasOptions::setMapNumbersVisible(bool visible) {
    if (visible == m_areMapNumbersVisible) return;
    m_areMapNumbersVisible = visible;
    emit mapNumbersVisibleChanged(visible);
}

} // namespace view
