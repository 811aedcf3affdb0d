// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <vector>

namespace document {

// Displayed path of a point of an animation in the plane: at evenly spaced frames, every one if there are not
// too many.
struct MotionPath {
    std::size_t index = 0; // index of the vertex in the cage, or of the map in the system
    std::vector<ifs::Vector<2>> points;
    std::vector<ifs::Vector<2>> keys; // places at the frames of its keys
    std::vector<int> frames;          // frames of the keys
    // Images of the cage under a map at these frames.
    std::vector<std::vector<ifs::Vector<2>>> outlines{};
};

// Paths of the vertices of the cage in their order, and of the centres of the maps that have keys: the images
// of the middle of the cage. Empty where there are no such keys.
struct MotionPaths {
    std::vector<MotionPath> vertices;
    std::vector<MotionPath> maps;
};
MotionPaths motionPaths(const Fractal& entry);

} // namespace document
