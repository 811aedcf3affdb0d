// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cstddef>
#include <vector>

// Finite groups of symmetries of the plane and of space. docs/mathematics.md, "Symmetry".
namespace ifs {

// Symmetry groups. In space, the first four act in the plane of x and y and leave z alone, so that a lifted
// system keeps its symmetry. The last three are the rotations of the polyhedra, in space alone.
enum class SymmetryGroup { None, Mirror, Rotation, Dihedral, Tetrahedral, Octahedral, Icosahedral };

// The group {T∘ρ∘T⁻¹}: ρ runs over the group in its standard position at the origin, and
// T(x) = frame·R(angle)·x + centre, R turning the plane of x and y.
// Standard positions: the mirror and one of the mirrors of the dihedral group lie along x; the axes of
// the rotations of order 2 of the tetrahedral and icosahedral and of order 4 of the octahedral group are the
// axes of coordinates.
template <int Dim> struct Symmetry {
    SymmetryGroup group = SymmetryGroup::None;
    int order = 1;    // n for Rotation and Dihedral; 1 for all others
    double angle = 0; // degrees; direction of a mirror for Mirror and Dihedral
    Vector<Dim> centre = Vector<Dim>::Zero();
    Matrix<Dim> frame = Matrix<Dim>::Identity(); // invertible; other than the identity only after baking

    friend bool operator==(const Symmetry& a, const Symmetry& b) {
        return a.group == b.group && a.order == b.order && a.angle == b.angle && a.centre == b.centre &&
               a.frame == b.frame;
    }
};

constexpr int minSymmetryOrder = 2;
constexpr int maxSymmetryOrder = 24;
// A system of more maps than this, counted with the symmetry, is not drawn with it.
constexpr std::size_t maxSymmetricMaps = 100'000;
// Smaller limit for linked maps, whose links form a matrix.
constexpr std::size_t maxSymmetricLinkedMaps = 1024;

// Returns true if the group exists in this dimension, its order is allowed, the numbers are finite and the
// frame can be inverted.
template <int Dim> bool isValid(const Symmetry<Dim>& symmetry);

std::size_t groupOrder(SymmetryGroup group, int order); // |Γ|

// The |Γ| elements, the identity first, then in a fixed order. The symmetry must be valid.
template <int Dim> std::vector<AffineMap<Dim>> elements(const Symmetry<Dim>& symmetry);

// The symmetry of the picture under a transformation that can be inverted: {T∘γ∘T⁻¹}. A transformation that
// keeps angles leaves the frame the identity, where the group allows it.
template <int Dim> Symmetry<Dim> conjugate(const AffineMap<Dim>& transformation, Symmetry<Dim> symmetry);

Symmetry<2> flipped(Symmetry<2> symmetry);   // exact picture under y ↦ −y
Symmetry<3> lifted(const Symmetry<2>& flat); // same symmetry about the axis through (centre, 0) along z

// The symmetries of the plane that consist of exactly these maps, to `tolerance` in every coefficient: what a
// list of isometries that contains the identity stands for. The centre is the point that all of them fix.
// None when they are no such group.
Symmetry<2> symmetryOf(const std::vector<AffineMap<2>>& maps, double tolerance);

} // namespace ifs
