// SPDX-License-Identifier: MIT
#pragma once

namespace view {

// A part of the cage, or of its images under the maps, that can be dragged.
struct CanvasPart {
    enum class Kind { None, Vertex, Edge, Inside, Pivot, Rotate, Scale };

    Kind kind = Kind::None;
    int index = 0; // 0-based index of the vertex, or of the edge's first vertex
    int map = -1;  // index in the system of the map of the image; −1: none

    friend bool operator==(const CanvasPart&, const CanvasPart&) = default;
};

} // namespace view
