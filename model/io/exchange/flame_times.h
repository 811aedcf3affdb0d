// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <optional>
#include <vector>

namespace io {

// Flames at different times are the control points of an animation: they become keys of the maps of one
// entry, in place of them, a frame for every unit of time. Only where every entry has a time of its own and
// all are plain systems of the plane with as many maps.
void joinByTime(document::FractalFile& file, const std::vector<std::optional<double>>& times);

} // namespace io
