// SPDX-License-Identifier: MIT
#include "canvas/scene/shadow_layout.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/edits/shadow_edits.h"

namespace view {

std::optional<ShadowMarks> shadowLayout(const document::Fractal& fractal, const attractor::Camera& camera) {
    const auto stick = document::shadowStick(fractal, camera.yAxis);
    if (!stick) return std::nullopt;
    return ShadowMarks{pixelOf(camera, stick->foot), pixelOf(camera, stick->tip)};
}

} // namespace view
