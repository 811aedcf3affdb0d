// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/gizmo_item.h"
#include "canvas/items/map_frames_item.h"
#include "canvas/scene/handle_model.h"
#include "gestures/pointer.h"

namespace view {

// Finds parts by position, in pixels of the view: from the geometry, whatever has been painted. Keeps
// references to its arguments.
class HitTester {
public:
    HitTester(const HandleModel& handles, const attractor::Camera& camera, const GizmoLayout& gizmo,
              const std::vector<MapFrame>& frames)
        : m_handles(handles), m_camera(camera), m_gizmo(gizmo), m_frames(frames) {}

    CanvasPart partAt(const QPointF& position, Reach reach) const; // part that a press would hold
    QPointF positionOf(const CanvasPart& part) const;
    // The maps whose frames, the images of the cage, lie in `band`.
    std::vector<std::size_t> mapsWithin(const QRectF& band) const;

private:
    CanvasPart vertexAt(const QPointF& position, double reach) const; // vertex of the cage or of a map

    const HandleModel& m_handles;
    const attractor::Camera& m_camera;
    const GizmoLayout& m_gizmo;
    const std::vector<MapFrame>& m_frames;
};

} // namespace view
