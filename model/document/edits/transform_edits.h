// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QString>

// The whole fractal moved by an affine map given in numbers.
namespace document {

// Reflect, then shear, scale and rotate, all about `about`; then translate. Angles in degrees,
// counter-clockwise.
struct Transformation {
    bool reflect = false;
    double axis = 0; // of the mirror through `about`: its angle with the x axis
    double shear = 0;
    double scaleX = 1;
    double scaleY = 1;
    double rotation = 0;
    ifs::Vector<2> translation = ifs::Vector<2>::Zero();
    ifs::Vector<2> about = ifs::Vector<2>::Zero();
};
ifs::AffineMap<2> affineMap(const Transformation& transformation);

// The code stays, the current cage moves: the picture is T of what it was.
Fractal placed(Fractal fractal, const ifs::AffineMap<2>& transformation);
// The code becomes T∘w∘T⁻¹ and the cage follows: the same picture as by placing, from new numbers. nullopt
// when T is too flat for that.
std::optional<Fractal> rewritten(Fractal fractal, const ifs::AffineMap<2>& transformation);

// Points to transform about, of the picture as displayed; nullopt when it has none.
std::optional<ifs::Vector<2>> middleOfBox(const Fractal& fractal);
std::optional<ifs::Vector<2>> displayedMean(const Fractal& fractal);

} // namespace document
