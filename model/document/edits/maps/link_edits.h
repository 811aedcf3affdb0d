// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// Edits of the links between maps, as functions from fractal to fractal; maps by their rows.
namespace document {

constexpr std::size_t maxLinkedMaps = 256;

// Why the maps cannot be linked; empty when they can.
QString linkObstacle(const Fractal& fractal);

// Multiplies the weight of map `to` by `weight`, ≥ 0, after map `from`. The fractal must allow links.
Fractal withLink(Fractal fractal, int from, int to, double weight);
Fractal withoutLinks(Fractal fractal);

} // namespace document
