// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// Edits that put other maps in the place of those of an entry, or change all of them at once, and keys, which
// belong to single maps and branches. `entry` is the entry with its animation.
namespace document {

// Why a branch cannot become a map of its own, as a sentence; empty where nothing moves that would be
// divided.
QString branchAsMapObstacle(const Fractal& entry);

// Why the code cannot take up its placement, or give it up, as a sentence: values with keys would change at
// this frame alone, the others at all frames. Empty where no map and no branch has keys.
QString rewriteObstacle(const Fractal& entry);

} // namespace document
