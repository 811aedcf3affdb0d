// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/analysis/analysis.h"

#include <QPointF>

#include <vector>

namespace view {

// The cylinders that an analysis outlines, of which a click chooses one.
class CylinderChoice {
public:
    // The same one stays chosen as long as it is among them; `outer` contain them.
    void setShapes(const std::vector<document::OutlineShape>& shapes,
                   std::vector<document::OutlineShape> outer);
    // The smallest at a pixel, or none where there is none. Whether something else is chosen than before.
    bool chooseAt(const attractor::Camera& camera, const QPointF& position);
    // The chosen one, last, and before it those that contain it, the largest first; empty: none is chosen.
    std::vector<const document::OutlineShape*> walk() const;

private:
    const document::OutlineShape* find(const ifs::Word& word) const;

    std::vector<document::OutlineShape> m_shapes; // includes the outer ones
    std::size_t m_first = 0;                      // index of the first outlined shape
    ifs::Word m_word;                             // empty: none
};

} // namespace view
