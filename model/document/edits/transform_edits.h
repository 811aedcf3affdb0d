// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// The whole fractal moved by an affine map given in numbers.
namespace document {

// Reflect, then shear, scale and rotate, all about `about`; then translate. Angles in degrees,
// counter-clockwise.
struct Transformation {
    bool reflect = false;
    double axis = 0; // angle of the mirror through `about` with the x axis
    double shear = 0;
    double scaleX = 1;
    double scaleY = 1;
    double rotation = 0;
    ifs::Vector<2> translation = ifs::Vector<2>::Zero();
    ifs::Vector<2> about = ifs::Vector<2>::Zero();
};
ifs::AffineMap<2> affineMap(const Transformation& transformation);

// Scale and then rotate, both about `about`; then translate. The angle in degrees, counter-clockwise as seen
// from the tip of the axis, which may have any length; without a direction, nothing is rotated.
struct SpaceTransformation {
    ifs::Vector<3> scale = ifs::Vector<3>::Ones();
    ifs::Vector<3> axis = ifs::Vector<3>::UnitY();
    double rotation = 0;
    ifs::Vector<3> translation = ifs::Vector<3>::Zero();
    ifs::Vector<3> about = ifs::Vector<3>::Zero();
};
ifs::AffineMap<3> affineMap(const SpaceTransformation& transformation);

// The fractal must have the dimension of the transformation.

// Moves the current cage and keeps the code: the picture becomes its image under T.
template <int Dim> Fractal placed(Fractal fractal, const ifs::AffineMap<Dim>& transformation);
// The code becomes T∘w∘T⁻¹ and the cage follows: the same picture as by placing, from new numbers. nullopt
// when T is too flat for that, or where the cage of a solid bends it and T is no similarity, because mean
// value coordinates would then bend it otherwise.
template <int Dim>
std::optional<Fractal> rewritten(const Fractal& fractal, const ifs::AffineMap<Dim>& transformation);

// Points to transform about, of the picture as displayed; nullopt when it has none.
template <int Dim> std::optional<ifs::Vector<Dim>> middleOfBox(const Fractal& fractal);
template <int Dim> std::optional<ifs::Vector<Dim>> displayedMean(const Fractal& fractal);

} // namespace document
