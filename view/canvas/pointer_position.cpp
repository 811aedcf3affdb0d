// SPDX-License-Identifier: MIT
#include "canvas/pointer_position.h"

#include "canvas/geometry/canvas_geometry.h"

#include <algorithm>

namespace view {

PointerPosition pointerPosition(const CanvasScene& scene, const QPointF& position) {
    PointerPosition pointer{worldAt(scene.camera(), position), scene.camera(), std::nullopt};
    if (const auto& cage = scene.handles().cage(); cage && cage->current.size() == 3) {
        const ifs::Simplex<2> triangle{cage->current[0], cage->current[1], cage->current[2]};
        if (ifs::isAffineBasis<2>(triangle))
            pointer.barycentric = ifs::barycentric<2>(triangle, pointer.world);
    }
    return pointer;
}

void findAddress(PointerPosition& pointer, const CanvasScene& scene, int fixedLength) {
    if (!scene.handles().knownAddresses()) return; // reported when they are found
    pointer.address = scene.handles().addressAt(pointer.world, 1 / scene.camera().pixelsPerUnit);
    pointer.fixedLength = std::min(std::size_t(fixedLength), pointer.address.size());
    const auto end = pointer.address.begin() + std::ptrdiff_t(pointer.fixedLength);
    pointer.fixedPoint = scene.handles().addresses().fixedPoint({pointer.address.begin(), end});
}

} // namespace view
