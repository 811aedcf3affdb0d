// SPDX-License-Identifier: MIT
#pragma once

namespace view {

// What of the cage, or of the images of the cage under the maps, can be dragged.
struct CanvasPart {
    enum class Kind { None, Vertex, Edge, Inside, Pivot, Rotate, Scale };

    Kind kind = Kind::None;
    int index = 0; // of the vertex, or of the edge's first vertex, from 0
    int map = -1;  // index in the system of the map that the image belongs to; −1: none

    friend bool operator==(const CanvasPart&, const CanvasPart&) = default;
};

} // namespace view
