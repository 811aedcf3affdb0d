// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "attractor/request/camera.h"
#include "attractor/request/render_request.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/iterated_function_system.h"

#include <cstdint>
#include <optional>

// The shadow of a picture in the plane: shadow pixel = camera · shadow map · cage · w_σ · sample, in darker
// colours. docs/mathematics.md, "Shadow".
namespace attractor {

// The map from world coordinates to those of the shadow. The horizontal line at `ground` stays; a point h
// above it goes to the right by shadowLean·h, and its height becomes shadowLength·h. With the y axis down,
// above is smaller.
ifs::AffineMap<2> shadowMap(const Appearance& appearance, double ground, YAxis yAxis);

// The colours of the shadow, opaque and without a background, of a picture of this system.
Appearance shadowAppearance(const Appearance& appearance, const ifs::IteratedFunctionSystem<2>& system);

// The cage that shows what `cage` shows, moved by `map`; of none, of the picture as the code has it.
ifs::ControlCage<2> movedCage(const std::optional<ifs::ControlCage<2>>& cage, const ifs::AffineMap<2>& map);

bool hasShadow(const RenderRequest& request);
// Draws the shadow alone: the same samples in darker colours and under a cage that is moved, so that it is as
// exact as the picture under every cage, at every zoom and in every band. As many samples for its area as the
// picture has. nullopt where the picture has no shadow.
std::optional<RenderRequest> shadowRequest(const RenderRequest& request);
// Draws the picture alone, to be laid over its shadow.
RenderRequest requestAboveShadow(RenderRequest request);
// Number of samples of the shadow for `samples` of the picture.
std::uint64_t shadowSamples(const RenderRequest& request, std::uint64_t samples);

} // namespace attractor
