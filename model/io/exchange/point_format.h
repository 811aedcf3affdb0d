// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <cstdint>

namespace io {

enum class PointFormat { Csv, Ply };

// Points of the chaos game where they are displayed: the first 14 are dropped, exactly `points` are written.
// CSV: x, y (and z) and the number of the last map, from 1. PLY: binary, coloured as the fractal is; in the
// plane doubles x y z with z = 0, in space also normals, maps and addresses.
struct PointCloud {
    static constexpr std::uint64_t maxPoints = 20'000'000;

    document::Fractal fractal;
    std::uint64_t points = 0; // 1 … maxPoints
    std::uint64_t seed = 1;
    PointFormat format = PointFormat::Csv;
};

} // namespace io
