// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"

#include <string>
#include <vector>

// How much noisier density pictures are than independent samples would make them; docs/testing.md, "Noise".
namespace noise {

struct Row {
    std::string name; // noise.pixel.SYSTEM or noise.tile.SYSTEM
    double value = 0; // the worst group at 10⁶ and 10⁷ samples
};

std::vector<Row> rowsOf(const std::string& system, const attractor::RenderRequest& request);

} // namespace noise
