// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QPointF>

#include <optional>

namespace view {

// Two fingers on the plane: what was under them stays under them, but for turning.
class PinchGesture {
public:
    void press(const attractor::Camera& camera, const QPointF& a, const QPointF& b);
    void release() { m_start.reset(); }
    bool isActive() const { return m_start.has_value(); }
    attractor::Camera cameraAt(const QPointF& a, const QPointF& b) const;

private:
    struct Start {
        attractor::Camera camera;
        QPointF middle;
        double distance;
    };
    std::optional<Start> m_start;
};

} // namespace view
