// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "attractor/request/appearance.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/iterated_function_system.h"

#include <variant>
#include <vector>

// Motions: animation without keys. Every motion returns to its start at the end of the animation, with the
// same bits as at the beginning. Angles are in degrees, counter-clockwise; in space about an axis through the
// pivot. docs/mathematics.md, "Animation".
namespace animation {

using MapIds = std::vector<ifs::MapId>; // empty: all maps

// amplitude·sin(360°·cycles·t/T + phase + j·lag) of the map with index j in the system.
struct Wave {
    double amplitude = 1;
    int cycles = 1;   // number of cycles in the length of the animation
    double phase = 0; // degrees
    double lag = 0;   // degrees from one map to the next

    friend bool operator==(const Wave&, const Wave&) = default;
};

// Wind: w ↦ q + R(strength·Σ waves)(w − q) with q = w(root), so that branches swing about their bases.
template <int Dim> struct Sway {
    MapIds maps;
    double strength = 0; // degrees
    ifs::Vector<Dim> root = ifs::Vector<Dim>::Zero();
    ifs::Vector<3> axis = ifs::Vector<3>::UnitZ(); // space only; unit length
    std::vector<Wave> waves;

    friend bool operator==(const Sway&, const Sway&) = default;
};

// w ↦ q + R(360°·turns·t/T)(w − q) with q = w(reference).
template <int Dim> struct Turn {
    MapIds maps;
    int turns = 1;
    ifs::Vector<Dim> reference = ifs::Vector<Dim>::Zero();
    ifs::Vector<3> axis = ifs::Vector<3>::UnitZ(); // space only; unit length

    friend bool operator==(const Turn&, const Turn&) = default;
};

// The point that the axis of an orbit in space passes through: the centre of the orbit or the camera's
// target.
enum class OrbitPivot { Centre, Target };

// The eye goes round: in the plane the picture turns about a centre, by its cage; in space the camera goes
// round an axis through its pivot.
template <int Dim> struct Orbit {
    int turns = 1;
    ifs::Vector<Dim> centre = ifs::Vector<Dim>::Zero(); // displayed coordinates
    ifs::Vector<3> axis = ifs::Vector<3>::UnitY();      // space only; unit length
    OrbitPivot pivot = OrbitPivot::Centre;

    friend bool operator==(const Orbit&, const Orbit&) = default;
};

// w ↦ q + (1 + strength·sin(360°·cycles·t/T))(w − q) with q = w(reference).
template <int Dim> struct Breathe {
    MapIds maps;
    double strength = 0; // below 1
    int cycles = 1;
    ifs::Vector<Dim> reference = ifs::Vector<Dim>::Zero();

    friend bool operator==(const Breathe&, const Breathe&) = default;
};

// The palette goes round, to its end and back.
struct PaletteCycle {
    int cycles = 1;

    friend bool operator==(const PaletteCycle&, const PaletteCycle&) = default;
};

template <int Dim> using Motion = std::variant<Sway<Dim>, Turn<Dim>, Orbit<Dim>, Breathe<Dim>, PaletteCycle>;

// Returns true if every number is finite and in its range: 1 … maxCycles cycles, turns either way, axes of
// length 1.
template <int Dim> bool isValid(const Motion<Dim>& motion);

// The same with `share` of its strength; one that has none is returned as it is.
template <int Dim> Motion<Dim> weakened(Motion<Dim> motion, double share);

// Applies a motion to the maps of a system at a moment that Loop has already folded into the animation.
template <int Dim>
void moveMaps(const Motion<Dim>& motion, const Moment& moment, int length,
              ifs::IteratedFunctionSystem<Dim>& system);
// The angle that Orbit has reached, 0 of any other motion.
template <int Dim> double orbitAngle(const Motion<Dim>& motion, const Moment& moment, int length);
// Turns the cage by an angle about a centre.
void turnCage(ifs::ControlCage<2>& cage, const ifs::Vector<2>& centre, double degrees);

} // namespace animation
