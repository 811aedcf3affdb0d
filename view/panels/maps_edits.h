// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <vector>

// Edits of the list of maps, as functions from fractal to fractal. The fractal must hold a plane system; rows
// are places in it, in increasing order.
namespace view {

using Rows = std::vector<int>;
using MapRows = std::vector<ifs::WeightedMap<2>>;

struct MapsEdit {
    document::Fractal fractal;
    std::vector<ifs::MapId> touched; // what to select afterwards
};

// One more map at the end: half the size, fixing the middle of the rest cage.
MapsEdit withNewMap(document::Fractal fractal);
// A copy of each row, right after the last of them.
MapsEdit withDuplicates(document::Fractal fractal, const Rows& rows);
MapsEdit withoutMaps(document::Fractal fractal, const Rows& rows);
// The rows as one block, before the row that now is at `before` (the number of maps: at the end).
MapsEdit withMapsMoved(document::Fractal fractal, const Rows& rows, int before);
// The pasted maps in place of the rows, which keep their ids as far as they go; appended when there are no
// rows.
MapsEdit withMapsPasted(document::Fractal fractal, const Rows& rows, const MapRows& pasted);

// As one step of the document; returns the maps to select afterwards.
std::vector<ifs::MapId> duplicateMaps(document::Document& document, const Rows& rows);
std::vector<ifs::MapId> deleteMaps(document::Document& document, const Rows& rows);

// The weight of one map. Where none were given, the others get the probability they have now: a single weight
// would mean nothing.
document::Fractal withWeight(document::Fractal fractal, int row, double weight);

enum class WeightRule { Determinant, Equal, Dimension, Normalise };
// Weights of the maps that are on; those that are off keep theirs.
document::Fractal withWeights(document::Fractal fractal, WeightRule rule);

} // namespace view
