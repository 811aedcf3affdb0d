// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <vector>

// Edits of the list of maps, as functions from fractal to fractal. The fractal must hold a system, in the
// plane or in space; rows are indices into it, in increasing order. Where the weights of the maps that are on
// sum to 1 (within 1e-6), they do so after maps are added, pasted or deleted, too: all of them are scaled,
// which changes no map's share in relation to another's. Other sums are left alone.
namespace document {

using Rows = std::vector<int>;
using MapRows = std::vector<ifs::WeightedMap<2>>;
using SpaceMapRows = std::vector<ifs::WeightedMap<3>>;

struct MapsEdit {
    Fractal fractal;
    std::vector<ifs::MapId> touched; // maps to select afterwards
};

// Appends a map of half the size that fixes the middle of the rest cage.
MapsEdit withNewMap(Fractal fractal);
// A copy of each row, right after the last of them.
MapsEdit withDuplicates(Fractal fractal, const Rows& rows);
MapsEdit withoutMaps(Fractal fractal, const Rows& rows);
// The rows as one block, before the row that now is at `before` (the number of maps: at the end).
MapsEdit withMapsMoved(Fractal fractal, const Rows& rows, int before);
// The pasted maps, of the dimension of the fractal, in place of the rows, which keep their ids and names as
// far as they go; appended when there are no rows.
MapsEdit withMapsPasted(Fractal fractal, const Rows& rows, const MapRows& pasted);
MapsEdit withMapsPasted(Fractal fractal, const Rows& rows, const SpaceMapRows& pasted);

// Duplicates in one undo step; returns the maps to select afterwards.
std::vector<ifs::MapId> duplicateMaps(Document& document, const Rows& rows);
// Returns none and changes nothing if one of them is locked: lockObstacle() has the sentence for that.
std::vector<ifs::MapId> deleteMaps(Document& document, const Rows& rows);

// The weight of one map. Where none were given, the others get the probability they have now: a single weight
// would mean nothing.
Fractal withWeight(Fractal fractal, int row, double weight);

enum class WeightRule { Determinant, Equal, Dimension, Normalise };
// Weights of the maps that are on; those that are off keep theirs. So do locked maps: the others share what
// these leave of 1, or of the sum of now where they leave nothing of it.
Fractal withWeights(Fractal fractal, WeightRule rule);

} // namespace document
