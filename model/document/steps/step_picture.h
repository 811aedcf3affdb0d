// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/frame.h"
#include "document/fractal/fractal.h"
#include "document/steps/start_shape.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace document {

// Wⁿ(B) for a shape B over the attractor, moved by the cage as the attractor is.
struct StepJob {
    std::shared_ptr<const Fractal> fractal; // must be a system of the plane
    std::shared_ptr<const StartShape> shape;
    int iterations = 0;
    attractor::Camera camera;
    std::uint64_t revision = 0;
};

// Draws every image in the colour of the first map of its word, or along the palette where the fractal is
// coloured by address; B itself is grey. Images smaller than a pixel are not divided further. nullopt when
// stopped.
std::optional<attractor::Frame> stepPicture(const StepJob& job, const std::stop_token& stop);

} // namespace document
