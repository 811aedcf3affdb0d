// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/tops/coupled_system.h"

#include <span>
#include <stop_token>

namespace attractor {

// Tops at the resolution of the pixels, without chance: addresses in increasing order, of which the first
// that reaches a pixel stays. The address of a pixel begins one of a point of the attractor within a pixel of
// it, and no point in the pixel has an address above. docs/mathematics.md, "Fractal tops".
class ExactTops {
public:
    ExactTops(const CoupledSystem& system, const Camera& camera) // references, which must outlive the object
        : m_system(system), m_camera(camera) {}

    // Rows of the picture from `firstRow` on, as many as there are points; the same in whatever bands they
    // are drawn. False when stopped, or given up because there are too many words.
    bool draw(int firstRow, std::span<TopPoint> points, const std::stop_token& stop) const;

private:
    const CoupledSystem& m_system;
    const Camera& m_camera;
};

} // namespace attractor
