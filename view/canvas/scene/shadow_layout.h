// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/shadow_item.h"
#include "document/fractal/fractal.h"

#include <optional>

namespace view {

// Handle of the shadow of a fractal in the plane; nullopt without a shadow.
std::optional<ShadowMarks> shadowLayout(const document::Fractal& fractal, const attractor::Camera& camera);

} // namespace view
