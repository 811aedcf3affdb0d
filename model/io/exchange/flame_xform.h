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
    ifs::AffineMap<2> coefs; // map of x and y; the other maps are JWildfire's
    ifs::AffineMap<2> yz;
    ifs::AffineMap<2> zx; // map of z and x, in the order (x, z)
    ifs::AffineMap<2> post;
    double linear = 0;   // amount of `linear`, which leaves z unchanged
    double linear3D = 0; // amount of `linear3D`
    double before = 1;   // factor of `pre_linear`, applied before the variations
    bool isFlat = false; // `flatten`: sets z to 0, without effect in the plane
    double weight = 0;
    double opacity = 1;       // opacity of its points
    bool standsStill = false; // constant in animations, like transforms that stand for a symmetry
    QList<double> chaos;      // P_ij of the next transforms; 1 beyond the last
    QString refusal;          // reason why it is no map of an iterated function system; empty if it is one

    bool isLinked() const {
        return std::ranges::any_of(chaos, [](double link) { return link != 1; });
    }
    bool isSpatial() const { return !(yz == ifs::AffineMap<2>()) || !(zx == ifs::AffineMap<2>()); }
    ifs::AffineMap<2> inPlane() const;
    ifs::AffineMap<3> inSpace(bool keepsZ) const; // docs/formats.md, "Flame XML"
};

Xform readXform(const QXmlStreamAttributes& attributes);

} // namespace io
