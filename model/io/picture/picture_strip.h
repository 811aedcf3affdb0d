// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/plane_export.h"

#include <vector>

namespace io {

// Pictures of one height side by side in one, from left to right, 8 bits per channel. The kind of file, the
// system and the resolution are those of the first. The pictures are in memory until all are drawn.
ExportOutcome exportStrip(const std::vector<PlaneExport>& pictures, const QString& path,
                          const Progress& progress = {}, std::stop_token stop = {});

} // namespace io
