// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "canvas/items/symmetry_item.h"
#include "document/fractal/fractal.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

// The symmetry of a fractal in space as it is seen under its cage. There is none to see where the cage bends.
namespace view {

std::optional<ifs::Vector<3>> displayedCentre(const document::Fractal& fractal);

// The centre with its handle, and lines through it: the axis of rotations, the lines of mirrors, the three
// axes of a polyhedron.
std::optional<SymmetryMarks> symmetryLayout(const document::Fractal& fractal,
                                            const attractor::OrbitCamera& camera);

// The fractal with the centre displayed at the only one of these points; nullptr where it cannot be moved.
std::function<document::Fractal(const std::vector<ifs::Vector<3>>&)>
afterCentreMoved(const std::shared_ptr<const document::Fractal>& before);

} // namespace view
