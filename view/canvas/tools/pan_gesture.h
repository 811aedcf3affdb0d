// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QPointF>

#include <optional>

namespace view {

// Dragging the plane under the window: every position from the camera at the press.
class PanGesture {
public:
    void press(const attractor::Camera& camera, const QPointF& position) { m_start = {camera, position}; }
    void release() { m_start.reset(); }
    bool isActive() const { return m_start.has_value(); }

    attractor::Camera cameraAt(const QPointF& position) const {
        const QPointF delta = position - m_start->position;
        return attractor::panned(m_start->camera, {delta.x(), delta.y()});
    }
    const attractor::Camera& before() const { return m_start->camera; }

private:
    struct Start {
        attractor::Camera camera;
        QPointF position;
    };
    std::optional<Start> m_start;
};

} // namespace view
