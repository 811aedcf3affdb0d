// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"

#include <vector>

namespace animation {

// The current vertices of a cage, as a key holds them.
template <int Dim> using CagePose = std::vector<ifs::Vector<Dim>>;

// Between two positions of a cage at rest, exact at both ends. The placement takes the path of maps, so that
// a cage that is turned keeps its size; what a cage of more vertices bends is added evenly.
template <int Dim>
CagePose<Dim> between(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to,
                      double share);

} // namespace animation
