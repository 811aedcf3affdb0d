// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/canonical_systems.h"
#include "ifs/copies/copy_hierarchy.h"
#include "ifs/extent/extent.h"

// Systems as they are seen in a picture, for the tests of the copies that it is put together from.
namespace canonical {

struct Pictured {
    ifs::AffineMap<2> display; // y down, the attractor's box fitted into 300 × 240 pixels
    ifs::BoundingBox<2> box;
    double pixelsPerUnit = 0;
};

inline Pictured pictured(const Maps2& maps, double width = 300, double height = 240) {
    const ifs::BoundingBox<2> box = ifs::boundingBox(*ifs::SupportFunction<2>::of(maps));
    const ifs::Vector<2> size = box.max - box.min;
    const double scale = 0.9 * std::min(width / size.x(), height / size.y());
    const ifs::Vector<2> middle = (box.min + box.max) / 2;
    return {
        ifs::affineMap(scale, 0, 0, -scale, width / 2 - scale * middle.x(), height / 2 + scale * middle.y()),
        box, scale};
}

inline ifs::CopyHierarchy hierarchyOf(const Maps2& maps) {
    return *ifs::CopyHierarchy::of(system<2>(maps), pictured(maps).display);
}

} // namespace canonical
