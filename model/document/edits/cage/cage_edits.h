// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/cage/cage_fits.h"
#include "ifs/extent/extent.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

// Edits of the control cage as functions from fractal to fractal, and why they may not be possible.
// cage_actions.h has those of the current entry as steps of the history.
namespace document {

bool isAtRest(const Fractal& fractal);

// Why nothing that is meant for systems of the plane can be done; empty for those.
QString planeObstacle(const Fractal& fractal);

// Why the entry has no cage; empty when it has one. Cheap.
QString cageObstacle(const Fractal& fractal);

// Returns true if the vertices are the same up to rounding.
bool isCageAlike(const Fractal& a, const Fractal& b);

// Why the placement cannot become the code, as a sentence; empty when it can.
QString bakeObstacle(const Fractal& fractal);
// The code of the displayed picture, its cage at rest; nullopt when there is an obstacle.
std::optional<Fractal> baked(const Fractal& fractal);

// Why there is nothing to reset; empty when there is.
QString resetObstacle(const Fractal& fractal);
// The cage back to rest: the code as it is.
Fractal withCageAtRest(Fractal fractal);

// The fractal with its cage moved there. In the mode Rewrite the code follows and the cage rests; where no
// affine code does (the cage is flat or bends), it is placed.
template <int Dim> Fractal withCageMoved(Fractal fractal, ifs::ControlCage<Dim> cage, CageMode mode);
// The effect on the code of moving the cage, as a sentence.
QString modeText(const Fractal& fractal, CageMode mode);

// The opposite of baking for a triangle or a tetrahedron: the code becomes that of the corners 0, e₁, e₂ and,
// in space, e₃, and the cage places it where the picture is.
QString unbakeObstacle(const Fractal& fractal);
std::optional<Fractal> unbaked(const Fractal& fractal);

// A warning about a cage that bends, concave or folded, as a sentence; empty when it is sound.
QString cageWarning(const Fractal& fractal);

// The displayed picture held by its smallest right isosceles triangle with legs along the axes, over all
// orientations or for one; nullopt without an attractor or while the placement is flat.
enum class SimplexChoice { Minimal, PlusPlus, MinusPlus, PlusMinus, MinusMinus };
std::optional<ifs::CanonicalSimplex<2>> displayedSimplex(const Fractal& fractal, SimplexChoice choice);
std::optional<Fractal> withCageFitted(const Fractal& fractal, SimplexChoice choice);
// The chosen polygon around the displayed picture, certified to hold it; nullopt as above. And the picture
// held by it.
std::optional<std::vector<ifs::Vector<2>>> verticesAround(const Fractal& fractal, PolygonChoice choice,
                                                          int corners = 4);
std::optional<Fractal> withCageAround(const Fractal& fractal, PolygonChoice choice, int corners = 4);
// Why no cage can be fitted; empty when one can.
QString fitObstacle(const Fractal& fractal);

// "(+, −)"
QString orientationText(std::span<const int> orientation);

} // namespace document
