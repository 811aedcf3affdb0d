// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <cstddef>

namespace io {

// The colour of a point that this map has drawn; by density, that of the bright part, as in the pictures made
// of shapes.
attractor::Rgba pointColour(const attractor::Appearance& appearance, ifs::MapId id, std::size_t map,
                            double colourCoordinate);

} // namespace io
