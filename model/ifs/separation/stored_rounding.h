// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

namespace ifs {

// How far the coefficients of a map may be off, at most, because those of the maps that it is composed of are
// stored as doubles: each by up to two units in its last place. What differs by more than that is different;
// "within rounding error" means this, and nothing wider.
template <int Dim> struct StoredRounding {
    Matrix<Dim> linear = Matrix<Dim>::Zero();
    Vector<Dim> translation = Vector<Dim>::Zero();

    static constexpr double share = 0x1p-52; // of a coefficient

    static StoredRounding of(const AffineMap<Dim>& stored) {
        return {share * stored.linear.cwiseAbs(), share * stored.translation.cwiseAbs()};
    }

    // Of outer∘inner, this being that of `outer`, to first order.
    StoredRounding after(const AffineMap<Dim>& outer, const AffineMap<Dim>& inner,
                         const StoredRounding& ofInner) const {
        const Matrix<Dim> size = outer.linear.cwiseAbs();
        return {linear * inner.linear.cwiseAbs() + size * ofInner.linear,
                translation + linear * inner.translation.cwiseAbs() + size * ofInner.translation};
    }

    // Of the image of a point that is off by `ofPoint`, this being that of `map`.
    Vector<Dim> ofImage(const AffineMap<Dim>& map, const Vector<Dim>& point,
                        const Vector<Dim>& ofPoint) const {
        return linear * point.cwiseAbs() + translation + map.linear.cwiseAbs() * ofPoint;
    }
};

} // namespace ifs
