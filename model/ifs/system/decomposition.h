// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

// A linear map as the user thinks of it. docs/mathematics.md, "Decomposition".
namespace ifs {

// A = R(rotation)·diag(scaleX, scaleY)·[[1, shear],[0, 1]]: shear first, rotation last. Angles in radians,
// counter-clockwise with y up. scaleX ≥ 0; the sign of scaleY is the orientation. Finite for singular A too.
struct RotationScaleShear {
    double rotation = 0;
    double scaleX = 1;
    double scaleY = 1;
    double shear = 0;
};
RotationScaleShear rotationScaleShear(const Matrix<2>& linear);
Matrix<2> linearPart(const RotationScaleShear& parts);

// A = rotation·stretch, rotation proper orthogonal, stretch symmetric (indefinite when det A < 0).
template <int Dim> struct Polar {
    Matrix<Dim> rotation;
    Matrix<Dim> stretch;
};
template <int Dim> Polar<Dim> polar(const Matrix<Dim>& linear);

// Returns true if the rotation of the decomposition is not unique: the image is a point, or in space a line.
template <int Dim> bool isRotationOpen(const Matrix<Dim>& linear);
// The decomposition whose rotation, if it is not unique, is nearest to `rotation`.
template <int Dim> Polar<Dim> polarNear(const Matrix<Dim>& linear, const Matrix<Dim>& rotation);

// Decompositions of two maps one of which becomes the other: what is open turns no more than it must.
template <int Dim> struct PolarPair {
    Polar<Dim> from;
    Polar<Dim> to;
};
template <int Dim> PolarPair<Dim> polarPair(const Matrix<Dim>& from, const Matrix<Dim>& to);

// A = rotation·diag(scale)·shear, shear unit upper triangular, scale ≥ 0 except the last entry, which carries
// sign(det).
struct RotationScaleShear3 {
    Matrix<3> rotation;
    Vector<3> scale;
    Matrix<3> shear;
};
RotationScaleShear3 rotationScaleShear(const Matrix<3>& linear);
Matrix<3> linearPart(const RotationScaleShear3& parts);

// A rotation in space: by `angle` radians, counter-clockwise as seen from the tip of the axis looking back.
// Its axis has length 1, its angle is in [0, π]; the identity turns about x. To build one, any length will
// do, and no direction at all is no rotation.
struct AxisAngle {
    Vector<3> axis;
    double angle = 0;
};
AxisAngle axisAngle(const Matrix<3>& rotation);
Matrix<3> rotationAbout(const AxisAngle& turn);

enum class MapKind { Similarity, ReflectedSimilarity, Affine, Singular, Constant };
// Geometric kind of the map: similarities to a relative 1e-12, Singular for rank < Dim, Constant for rank 0.
template <int Dim> MapKind kind(const Matrix<Dim>& linear);

} // namespace ifs
