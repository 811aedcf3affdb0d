// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/iterated_function_system.h"
#include "notation/moments/animation_lines.h"

#include <optional>

namespace notation {

// What the lines mean for these maps and this cage; nullopt when something does not fit.
template <int Dim>
std::optional<animation::Animation<Dim>> animationOf(const AnimationLines::Stored& stored,
                                                     const ifs::IteratedFunctionSystem<Dim>& system,
                                                     const std::optional<ifs::ControlCage<Dim>>& cage);

} // namespace notation
