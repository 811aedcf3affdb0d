// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/support_function.h"

#include <QString>

// What panels do with the cage as a whole, and why it may not be possible.
namespace view {

bool isAtRest(const document::Fractal& fractal);

// Why nothing that is meant for systems of the plane can be done; empty for those.
QString planeObstacle(const document::Fractal& fractal);

// Whether the vertices are the same to what rounding leaves of them.
bool isCageAlike(const document::Fractal& a, const document::Fractal& b);

// Why the placement cannot become the code, as a sentence; empty when it can.
QString bakeObstacle(const document::Fractal& fractal);
// The code that shows what is displayed, its cage at rest; nullopt when there is an obstacle.
std::optional<document::Fractal> baked(const document::Fractal& fractal);

// Why there is nothing to reset; empty when there is.
QString resetObstacle(const document::Fractal& fractal);
// The cage back to rest: the code as it is.
document::Fractal withCageAtRest(document::Fractal fractal);

// The fractal with its cage moved there. In the mode Rewrite the code follows and the cage rests; where no
// affine code does (the cage is flat or bends), it is placed.
document::Fractal withCageMoved(document::Fractal fractal, ifs::ControlCage<2> cage, document::CageMode mode);
// What moving the cage will do to the code, as a sentence.
QString modeText(const document::Fractal& fractal, document::CageMode mode);

// The opposite of baking for a triangle: the code becomes that of the triangle (0, 0), (1, 0), (0, 1), and
// the cage places it where the picture is.
QString unbakeObstacle(const document::Fractal& fractal);
std::optional<document::Fractal> unbaked(const document::Fractal& fractal);

// What the user should know about a cage that bends: concave or folded, as a sentence; empty when it is
// sound.
QString cageWarning(const document::Fractal& fractal);

// The displayed picture held by its smallest right isosceles triangle with legs along the axes, over all
// orientations or for one; nullopt without an attractor or while the placement is flat.
enum class SimplexChoice { Minimal, PlusPlus, MinusPlus, PlusMinus, MinusMinus };
std::optional<ifs::CanonicalSimplex<2>> displayedSimplex(const document::Fractal& fractal,
                                                         SimplexChoice choice);
std::optional<document::Fractal> withCageFitted(const document::Fractal& fractal, SimplexChoice choice);
// The displayed picture held by its bounding box, by its convex hull simplified from outside to so many
// corners, or by the smallest regular polygon with so many; nullopt as above.
enum class PolygonChoice { Box, Hull, Regular };
std::optional<document::Fractal> withCageAround(const document::Fractal& fractal, PolygonChoice choice,
                                                int corners = 4);
// Why no cage can be fitted; empty when one can.
QString fitObstacle(const document::Fractal& fractal);

// "(+, −)"
QString orientationText(const ifs::Orientation<2>& orientation);

} // namespace view
