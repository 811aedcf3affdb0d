// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <QList>
#include <QString>

#include <algorithm>

class QXmlStreamAttributes;

namespace io {

// A transform of a flame, as its attributes say it.
struct Xform {
    ifs::AffineMap<2> coefs; // of x and y; the others are JWildfire's
    ifs::AffineMap<2> yz;
    ifs::AffineMap<2> zx; // from z and x to z and x as (x, z)
    ifs::AffineMap<2> post;
    double linear = 0;   // the amount of `linear`, which leaves z out
    double linear3D = 0; // the amount of `linear3D`
    double before = 1;   // `pre_linear`: the factor before the variations
    bool isFlat = false; // `flatten`: z becomes 0, which says nothing in the plane
    double weight = 0;
    double opacity = 1;       // of its points
    bool standsStill = false; // in animations, as transforms do that stand for a symmetry
    QList<double> chaos;      // P_ij of its successors; 1 beyond the last
    QString refusal;          // why it is no row of an iterated function system; empty when it is one

    bool isLinked() const {
        return std::ranges::any_of(chaos, [](double link) { return link != 1; });
    }
    bool isSpatial() const { return !(yz == ifs::AffineMap<2>()) || !(zx == ifs::AffineMap<2>()); }
    ifs::AffineMap<2> inPlane() const;
    ifs::AffineMap<3> inSpace(bool keepsZ) const; // docs/formats.md, "Flame XML"
};

Xform readXform(const QXmlStreamAttributes& attributes);

} // namespace io
