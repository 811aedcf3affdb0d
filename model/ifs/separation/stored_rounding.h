// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

namespace ifs {

// Bounds of the errors of a map's coefficients that arise because the coefficients of the maps it is composed
// of are stored as doubles: each by up to two units in its last place. Coefficients that differ by more are
// different; "within rounding error" means this, and nothing wider.
template <int Dim> struct StoredRounding {
    Matrix<Dim> linear = Matrix<Dim>::Zero();
    Vector<Dim> translation = Vector<Dim>::Zero();

    static constexpr double share = 0x1p-52; // rounding error relative to a coefficient

    static StoredRounding of(const AffineMap<Dim>& stored) {
        return {share * stored.linear.cwiseAbs(), share * stored.translation.cwiseAbs()};
    }

    // The rounding of outer∘inner, this being that of `outer`, to first order.
    StoredRounding after(const AffineMap<Dim>& outer, const AffineMap<Dim>& inner,
                         const StoredRounding& ofInner) const {
        const Matrix<Dim> size = outer.linear.cwiseAbs();
        return {linear * inner.linear.cwiseAbs() + size * ofInner.linear,
                translation + linear * inner.translation.cwiseAbs() + size * ofInner.translation};
    }

    // The rounding of the image of a point that is off by `ofPoint`, this being that of `map`.
    Vector<Dim> ofImage(const AffineMap<Dim>& map, const Vector<Dim>& point,
                        const Vector<Dim>& ofPoint) const {
        return linear * point.cwiseAbs() + translation + map.linear.cwiseAbs() * ofPoint;
    }
};

// The sum of the sizes of the products that the determinant is made of.
inline double determinantTerms(const Matrix<2>& m) {
    const Matrix<2> size = m.cwiseAbs();
    return size(0, 0) * size(1, 1) + size(0, 1) * size(1, 0);
}

inline double determinantTerms(const Matrix<3>& m) {
    const Matrix<3> size = m.cwiseAbs();
    double result = 0;
    for (int k = 0; k < 3; ++k)
        result += size(0, k) *
                  (size(1, (k + 1) % 3) * size(2, (k + 2) % 3) + size(1, (k + 2) % 3) * size(2, (k + 1) % 3));
    return result;
}

// Error of a determinant whose coefficients are off by their rounding.
template <int Dim> double offDeterminant(const Matrix<Dim>& linear) {
    constexpr double ofProducts = 0x1p-53;
    return Dim * (StoredRounding<Dim>::share + ofProducts) * determinantTerms(linear);
}

} // namespace ifs
