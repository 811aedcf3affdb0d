// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

#include <optional>

// From the plane to space and back, as functions from fractal to fractal.
namespace document {

// What of the entry does not go from one dimension to the other, as a sentence; empty: everything does.
QString dimensionLoss(const Fractal& entry);

// Why the entry cannot be lifted; empty when it can.
QString liftObstacle(const Fractal& fractal);
// Every map acts on z as well, by the factor `scale`, else √|det A|, which keeps a similarity one; the
// attractor lies in z = 0 until its maps are moved. A triangle that holds it becomes a tetrahedron that moves
// it alike. nullopt when there is an obstacle.
std::optional<Fractal> lifted(Fractal fractal, std::optional<double> scale = std::nullopt);

// Why the projection along `direction` is no system in the plane, or not known to be; empty when it is one:
// every map takes the line into itself. The direction is one of the displayed picture.
QString flattenObstacle(const Fractal& fractal, const ifs::Vector<3>& direction);
// The projection of what is displayed, seen against the direction: y stays up unless that is the direction,
// and then −z is. Along an axis no number is rounded. nullopt when there is an obstacle.
std::optional<Fractal> flattened(Fractal fractal, const ifs::Vector<3>& direction);

} // namespace document
