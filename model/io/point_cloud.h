// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"
#include "io/png_export.h"

namespace io {

enum class PointFormat { Csv, Ply };

// Points of the chaos game where they are displayed: the first 14 are dropped, exactly `points` are written.
// CSV: x, y and the place of the last map, from 1. PLY: binary, doubles x y z with z = 0, coloured as the
// fractal is.
struct PointCloud {
    static constexpr std::uint64_t mostPoints = 20'000'000;

    document::Fractal fractal;
    std::uint64_t points = 0; // 1 … mostPoints
    std::uint64_t seed = 1;
    PointFormat format = PointFormat::Csv;
};

// Why there can be no such points; nullopt where there can.
Failure obstacle(const PointCloud& cloud);

ExportOutcome exportPoints(const PointCloud& cloud, const QString& path, const Progress& progress = {},
                           std::stop_token stop = {});

} // namespace io
