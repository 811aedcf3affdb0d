// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QStringList>

// Placements in files: other programs read the code alone, and show its picture where it is without one.
namespace document {

// Returns true if the cage shows the picture elsewhere than the code draws it, in an animation at frame 0.
bool isPlaced(const Fractal& entry);
QStringList placedEntries(const FractalFile& file); // names in the order of the file

struct BakedFile {
    FractalFile file;
    QStringList left; // names of entries that other programs still show differently
};

// Bakes every placement that a code can have: the picture of a bent or flat cage has none, and that of keys
// changes.
BakedFile withPlacementsBaked(FractalFile file);

// The same, and the maps of symmetric and linked systems listed one by one, where that is possible.
BakedFile forOtherPrograms(FractalFile file);

} // namespace document
