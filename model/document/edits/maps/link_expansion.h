// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// Linked maps written as plain ones, where that is possible.
// docs/decisions/0019-plain-maps-and-pictures-without-files.md.
namespace document {

bool isLinked(const Fractal& fractal); // true if some link is not 1, even one without effect

// Why no plain maps can be written, as a sentence; empty where they can. Of an entry without a symmetry.
QString linkExpansionObstacle(const Fractal& fractal);

// The same attractor from plain maps; there must be no obstacle. An entry that is not linked stays as it is.
Fractal withLinksExpanded(Fractal fractal);

// Returns true if these maps, with their weights, also have the same density everywhere.
bool linkExpansionKeepsDensity(const Fractal& fractal);

} // namespace document
