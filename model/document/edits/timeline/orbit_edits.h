// SPDX-License-Identifier: MIT
#pragma once

#include "animation/motions/motion.h"
#include "document/fractal/fractal.h"

#include <cstddef>
#include <optional>

// The place of an orbit: its axis and its pivot.
namespace document {

// In the plane the axis has no meaning, the pivot is the centre, and z is 0.
struct OrbitPlace {
    ifs::Vector<3> axis = ifs::Vector<3>::UnitY(); // unit length
    animation::OrbitPivot pivot = animation::OrbitPivot::Centre;
    ifs::Vector<3> centre = ifs::Vector<3>::Zero(); // displayed coordinates

    friend bool operator==(const OrbitPlace&, const OrbitPlace&) = default;
};

// nullopt where the entry has no motion of this index, or it is no orbit.
std::optional<OrbitPlace> orbitPlace(const Fractal& entry, std::size_t motion);
// Sets the place. An invalid one leaves the entry as it is, as does a motion that is no orbit.
Fractal withOrbitPlace(Fractal entry, std::size_t motion, const OrbitPlace& place);

// The middle of the attractor as it is displayed while nothing moves: of the box around it. nullopt without
// an attractor.
std::optional<ifs::Vector<3>> orbitCentre(const Fractal& entry);

// A direction as a coordinate axis that leans: `lean` degrees away from it, towards the next axis (y after x,
// x after z) where `towards` is 0 and the one after that where it is 90.
struct LeaningAxis {
    int axis = 1; // index: x, y, z
    double lean = 0;
    double towards = 0;
};
ifs::Vector<3> directionOf(const LeaningAxis& leaning); // unit length
// The axis next to the direction among those of the coordinates.
LeaningAxis leaningAxisOf(const ifs::Vector<3>& direction);

} // namespace document
