// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/barycentric.h"
#include "ifs/iterated_function_system.h"

#include <optional>
#include <vector>

namespace ifs {

// The polygon by which an attractor is held. The rest vertices say where the attractor is held, and are never
// degenerate; the current vertices are where the user has dragged them, and may be anything finite.
// Both lists have the same length ≥ Dim + 1. With exactly Dim + 1 vertices the deformation is affine.
template <int Dim> struct ControlCage {
    std::vector<Vector<Dim>> rest;
    std::vector<Vector<Dim>> current;

    friend bool operator==(const ControlCage&, const ControlCage&) = default;
};

template <int Dim> ControlCage<Dim> cageAtRest(const Simplex<Dim>& simplex);

// Whether the lists match, every number is finite, and the rest vertices hold coordinates.
template <int Dim> bool isValid(const ControlCage<Dim>& cage);

// M_c = T_c·T_0⁻¹ of a cage with Dim + 1 vertices: rest coordinates → displayed coordinates. Only T_0 is
// inverted, so the current vertices may lie on one line. Exactly the identity when current equals rest.
template <int Dim> AffineMap<Dim> displayMap(const ControlCage<Dim>& cage);

// Whether the display map can be undone: σ_min > 1e-6·σ_max. Baking and picking need it.
template <int Dim> bool isInvertible(const ControlCage<Dim>& cage);

// "Bake": the code becomes M_c∘w∘M_c⁻¹ and the cage rests where it is. nullopt when the cage is too flat.
template <int Dim> struct Baked {
    IteratedFunctionSystem<Dim> system;
    ControlCage<Dim> cage;
};
template <int Dim>
std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>& system, const ControlCage<Dim>& cage);

// The cage that shows the same picture through other vertices: the current ones are `clicks`, the rest ones
// M_c⁻¹(clicks). nullopt when the clicks are no affine basis or the present placement is flat.
template <int Dim>
std::optional<ControlCage<Dim>> redefine(const ControlCage<Dim>& present, const Simplex<Dim>& clicks);

} // namespace ifs
