// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <cstddef>
#include <vector>

namespace document {

// Label of a map of one entry beside another: with the colour and number of its counterpart there.
struct MapFace {
    attractor::Rgba colour;
    std::size_t number = 0; // 1-based; 0: without a counterpart, because it does not take part

    friend bool operator==(const MapFace&, const MapFace&) = default;
};
using MapFaces = std::vector<MapFace>;

// Faces of the maps of `to`, by their indices: the k-th of the maps that take part has the face of the k-th
// in `from`, whichever of them is on top. Maps that take no part keep their colours. Empty where the numbers
// of these maps differ, or where an entry is not a system of the plane.
MapFaces facesOfPartner(const Fractal& from, const Fractal& to);

} // namespace document
