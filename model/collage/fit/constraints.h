// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cstddef>

// Constraints on the maps of a fit. docs/mathematics.md, "Collages".
namespace collage {

enum class MapClass { Affine, Similarity };
enum class Mirrors { Allowed, Excluded };
enum class FirstMap { Free, Stem };

struct Constraints {
    Constraints() = default;
    Constraints(MapClass kind) : mapClass(kind) {} // NOLINT: a class alone is a constraint

    MapClass mapClass = MapClass::Affine;
    Mirrors mirrors = Mirrors::Allowed;
    int angleStep = 0; // degrees; maps turn by multiples of it; 0: by any angle
    // The first map flattens everything to a line, like the stem of a fern, and is free of the rest.
    FirstMap first = FirstMap::Free;

    MapClass classOf(std::size_t map) const { return isStem(map) ? MapClass::Affine : mapClass; }
    bool isStem(std::size_t map) const { return first == FirstMap::Stem && map == 0; }
};

// The turn Q of the polar decomposition A = Q S with a symmetric S ≥ 0: a rotation, or one after a mirror.
ifs::Matrix<2> turnOf(const ifs::Matrix<2>& a);

// The map of that index moved to meet what its class does not say: mirrors, angles and the stem. The image of
// `centre` stays. A map that meets them keeps its bits.
ifs::AffineMap<2> constrained(const Constraints& constraints, std::size_t index, ifs::AffineMap<2> map,
                              const ifs::Vector<2>& centre);

} // namespace collage
