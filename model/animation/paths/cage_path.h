// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace animation {

// The current vertices of a cage, as a key holds them.
template <int Dim> using CagePose = std::vector<ifs::Vector<Dim>>;

// The way of a cage from one pose to another. Vertices that are at the same place in both stay there.
struct CageWay {
    bool isByVertex = false; // true: vertices go straight; false: the placement follows the path of maps
    std::optional<std::size_t> pivot{}; // vertex that stays on that path; nullopt: the middle stays

    friend bool operator==(const CageWay&, const CageWay&) = default;
};

// A single vertex that stays is the pivot. If more stay, all vertices go straight, unless the cage would then
// flip over on the way and back before the end; in that case the first of them is the pivot.
// docs/decisions/0030-vertices-that-stay.md.
template <int Dim>
CageWay wayOf(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to);

// The point about which the path of maps turns, in the coordinates of the cage at rest.
template <int Dim> ifs::Vector<Dim> referenceOf(const CageWay& way, const ifs::ControlCage<Dim>& cage);

// Interpolates between two positions of a cage at rest, exact at both ends. On the path of maps, a cage that
// is turned keeps its size, and the bending of a cage with more vertices than a simplex is added evenly.
template <int Dim>
CagePose<Dim> between(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to,
                      double share);

} // namespace animation
