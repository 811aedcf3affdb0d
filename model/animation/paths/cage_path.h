// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/control_cage.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace animation {

// The current vertices of a cage, as a key holds them.
template <int Dim> using CagePose = std::vector<ifs::Vector<Dim>>;

// How a cage gets from one pose to another. Vertices that both have in the same place stay there.
struct CageWay {
    bool isByVertex = false; // each vertex goes straight; else the placement takes the path of maps,
    std::optional<std::size_t> pivot{}; // about this vertex, which stays; nullopt: about the middle

    friend bool operator==(const CageWay&, const CageWay&) = default;
};

// One vertex that stays is the pivot. With more of them all go straight, unless the cage would turn over on
// the way and be right again at its end; then the first of them is the pivot.
// docs/decisions/0030-vertices-that-stay.md.
template <int Dim>
CageWay wayOf(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to);

// What the path of maps goes about, in the coordinates of the cage at rest.
template <int Dim> ifs::Vector<Dim> referenceOf(const CageWay& way, const ifs::ControlCage<Dim>& cage);

// Between two positions of a cage at rest, exact at both ends. On the path of maps, a cage that is turned
// keeps its size; what a cage of more vertices bends is added evenly.
template <int Dim>
CagePose<Dim> between(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to,
                      double share);

} // namespace animation
