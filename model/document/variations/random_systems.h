// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <cstdint>

// Random systems. docs/mathematics.md, "Random systems and variations".
namespace document {

constexpr int maxRandomMaps = 16;

// Properties of a random system.
struct RandomChoice {
    int dimension = 2;
    int maps = 0; // at most maxRandomMaps; 0: two to five, with a symmetry one to three
    ifs::SymmetryGroup symmetry = ifs::SymmetryGroup::None;
    int order = 1; // order of a rotation or dihedral group

    friend bool operator==(const RandomChoice&, const RandomChoice&) = default;
};

// The same seed gives the same system. It has an attractor, which fills its view. Of the N maps of the
// system, counted with its symmetry, ½(5 + N) ≤ Σ(σ₁ + 2σ₂) ≤ ½(6 + N), where σ₁ ≥ σ₂ are the two largest
// singular values of a map. That rule is one of the plane; in space, σ₃ is between 0.3 σ₂ and σ₂.
Fractal randomFractal(const RandomChoice& choice, std::uint64_t seed);

} // namespace document
