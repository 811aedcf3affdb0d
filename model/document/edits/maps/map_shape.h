// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <vector>

namespace document {

template <int Dim> struct MapShapePart;
template <> struct MapShapePart<2> {
    enum Part { Rotation, ScaleX, ScaleY, Shear, PartCount };
};
template <> struct MapShapePart<3> {
    enum Part { AxisX, AxisY, AxisZ, Angle, ScaleX, ScaleY, ScaleZ, ShearXY, ShearXZ, ShearYZ, PartCount };
};

// The linear part of one map as rotation (degrees, counter-clockwise with y up; in space about an axis of any
// length), scales and shear; see ifs::RotationScaleShear. A change of one of these keeps the bits of the
// coefficients that do not depend on it, and going back to numbers shown before gives the coefficients of
// that time.
template <int Dim> class MapShapeIn : public MapShapePart<Dim> {
public:
    using typename MapShapePart<Dim>::Part;
    using Parts = std::array<double, std::size_t(MapShapePart<Dim>::PartCount)>;

    MapShapeIn() { show(ifs::Matrix<Dim>::Identity()); }

    // Takes over the linear part that is in the document now, whatever changed it.
    void show(const ifs::Matrix<Dim>& linear);
    const Parts& parts() const { return m_parts; }
    // The coefficients after this change.
    ifs::Matrix<Dim> changed(Part part, double value);

private:
    struct Known {
        ifs::Matrix<Dim> linear;
        Parts parts;
    };
    ifs::Matrix<Dim> composed(const Parts& parts) const;

    std::vector<Known> m_known; // first: the matrix from which the others were derived
    Parts m_parts{};
};

using MapShape = MapShapeIn<2>;
using MapShape3 = MapShapeIn<3>;

extern template class MapShapeIn<2>;
extern template class MapShapeIn<3>;

} // namespace document
