// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"
#include "ifs/support_function.h"

#include <QString>

// What panels do with the cage as a whole, and why it may not be possible.
namespace view {

bool isAtRest(const document::Fractal& fractal);

// Why the placement cannot become the code, as a sentence; empty when it can.
QString bakeObstacle(const document::Fractal& fractal);
// The code that shows what is displayed, its cage at rest; nullopt when there is an obstacle.
std::optional<document::Fractal> baked(const document::Fractal& fractal);

// The cage back to rest: the code as it is.
document::Fractal withCageAtRest(document::Fractal fractal);

// The displayed picture held by its smallest right isosceles triangle with legs along the axes, over all
// orientations or for one; nullopt without an attractor or while the placement is flat.
enum class SimplexChoice { Minimal, PlusPlus, MinusPlus, PlusMinus, MinusMinus };
std::optional<ifs::CanonicalSimplex<2>> displayedSimplex(const document::Fractal& fractal,
                                                         SimplexChoice choice);
std::optional<document::Fractal> withCageFitted(const document::Fractal& fractal, SimplexChoice choice);
// Why no simplex can be fitted; empty when one can.
QString fitObstacle(const document::Fractal& fractal);

// "(+, −)"
QString orientationText(const ifs::Orientation<2>& orientation);

} // namespace view
