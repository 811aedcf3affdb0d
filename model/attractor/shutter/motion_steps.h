// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"
#include "attractor/request/space_request.h"

#include <vector>

// Motion of a picture while a shutter is open. docs/mathematics.md, "Shutter".
namespace attractor {

constexpr int maxSteps = 64;

// Pixels of some thousand points of the attractor. Requests with equally many active maps track points with
// the same addresses.
struct TrackedPoints {
    std::vector<ifs::Vector<2>> pixels;
    RasterSize size;
};
TrackedPoints trackedPoints(const RenderRequest& request);
TrackedPoints trackedPoints(const SpaceRequest& request);

// The steps into which evenly spaced moments have to be divided so that no tracked point that is in the
// picture moves more than a pixel in a step; 1 … maxSteps, and maxSteps where the points do not correspond.
int stepsFor(const std::vector<TrackedPoints>& moments);

} // namespace attractor
