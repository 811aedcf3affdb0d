// SPDX-License-Identifier: MIT
#pragma once

#include "io/exchange/point_format.h"
#include "io/picture/plane_export.h"

namespace io {

// Why there can be no such points; nullopt where there can.
Failure obstacle(const PointCloud& cloud);

ExportOutcome exportPoints(const PointCloud& cloud, const QString& path, const Progress& progress = {},
                           std::stop_token stop = {});

} // namespace io
