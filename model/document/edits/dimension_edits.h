// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

#include <optional>

// Conversions between plane and space, as functions from fractal to fractal.
namespace document {

// The loss when the entry goes to the other dimension, as a sentence; empty if everything is kept.
QString dimensionLoss(const Fractal& entry);

// Why the entry cannot be lifted; empty when it can.
QString liftObstacle(const Fractal& fractal);
// Lifts to space: every map acts on z as well, by the factor `scale`, else √|det A|, which keeps a similarity
// one; the attractor lies in z = 0 until its maps are moved. A triangle that holds it becomes a tetrahedron
// that moves it alike. nullopt when there is an obstacle.
std::optional<Fractal> lifted(Fractal fractal, std::optional<double> scale = std::nullopt);

// Why the projection along `direction` is no system in the plane, or not known to be; empty when it is one:
// every map takes the line into itself. The direction is one of the displayed picture.
QString flattenObstacle(const Fractal& fractal, const ifs::Vector<3>& direction);
// The projection of the displayed picture, seen against the direction: y stays up unless that is the
// direction, and then −z is. Along an axis no number is rounded. nullopt when there is an obstacle.
std::optional<Fractal> flattened(Fractal fractal, const ifs::Vector<3>& direction);

} // namespace document
