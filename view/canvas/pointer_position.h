// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_scene.h"
#include "ifs/system/barycentric.h"

#include <QMetaType>

#include <optional>

namespace view {

struct PointerPosition {
    ifs::Vector<2> world = ifs::Vector<2>::Zero();
    attractor::Camera camera{}; // camera of the view, which determines the number of digits
    // Coordinates with respect to the first three vertices of the current cage; nullopt while they lie on one
    // line.
    std::optional<ifs::Barycentric<2>> barycentric;
    // The address of the point of the attractor under the pointer, by indices in the system; empty where
    // there is none and while something is dragged. The fixed point, displayed, is that of its first
    // `fixedLength` maps.
    ifs::Word address{};
    std::size_t fixedLength = 0;
    std::optional<ifs::Vector<2>> fixedPoint{};
};

// The position without the address, which takes longer.
PointerPosition pointerPosition(const CanvasScene& scene, const QPointF& position);
void findAddress(PointerPosition& pointer, const CanvasScene& scene, int fixedLength);

} // namespace view

Q_DECLARE_METATYPE(view::PointerPosition)
