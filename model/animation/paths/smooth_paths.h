// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/keys.h"
#include "animation/paths/cage_path.h"
#include "animation/paths/camera_path.h"
#include "animation/paths/look_path.h"
#include "animation/paths/map_path.h"

// Values within a segment of a track. A smooth segment is a Catmull–Rom curve of time, exact at both keys and
// without a corner at a key between two of them. Any other, and a segment without neighbours, follows
// between(). docs/mathematics.md, "Smooth ways".
namespace animation {

// Angle, S and the image of the reference of the polar path in the coordinates of the norm. There ‖A‖ stays
// at or below the larger end: the tangents of S are as long as leaves it so.
template <int Dim>
MapPose<Dim> along(const Segment<MapPose<Dim>>& way, const ifs::Vector<Dim>& reference,
                   const CommonNorm<Dim>& norm);

// The same in Euclidean coordinates, of what moves a branch.
template <int Dim>
ifs::AffineMap<Dim> along(const Segment<ifs::AffineMap<Dim>>& way, const ifs::Vector<Dim>& reference);

// The placement goes the way of maps, and what the cage bends is added on a curve of its own. Vertices that
// both keys have in the same place stay there: see CageWay. A key between two kinds of ways is an end.
template <int Dim> CagePose<Dim> along(const Segment<CagePose<Dim>>& way, const ifs::ControlCage<Dim>& cage);

// Zoom and pan as they are seen in the picture; in space, the orientation as well. The field of view stays
// between its ends.
attractor::View along(const Segment<attractor::View>& way);
attractor::OrbitCamera along(const Segment<attractor::OrbitCamera>& way);

// Brightness and gamma are smooth and stay between their ends; colours mix evenly.
Look along(const Segment<Look>& way);

} // namespace animation
