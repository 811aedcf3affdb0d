// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/symmetry_item.h"
#include "document/fractal/fractal.h"

#include <optional>

namespace view {

// Displayed symmetry of a fractal in the plane, under its cage; nullopt without one.
std::optional<SymmetryMarks> symmetryLayout(const document::Fractal& fractal,
                                            const attractor::Camera& camera);

} // namespace view
