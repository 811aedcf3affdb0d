// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

#include <cstddef>

// The symmetry of an entry, for the window and the command line.
namespace document {

bool isSymmetric(const Fractal& fractal);
std::size_t symmetryOrder(const Fractal& fractal); // |Γ|; 1 without a symmetry

// Why the entry cannot have a group of this order, as a sentence; empty where it can.
QString symmetryObstacle(const Fractal& fractal, std::size_t groupOrder);

// The entry with this symmetry, which belongs to its dimension and to which there is no obstacle.
Fractal withSymmetry(Fractal fractal, const ifs::Symmetry<2>& symmetry);
Fractal withSymmetry(Fractal fractal, const ifs::Symmetry<3>& symmetry);

// Why the maps that a symmetry stands for cannot be listed without changing the picture; empty where they
// can.
QString expandObstacle(const Fractal& fractal);

// The same picture from plain maps: those that the symmetry stands for, in the colours that they have. An
// entry without a symmetry stays as it is.
Fractal expanded(Fractal fractal);

} // namespace document
