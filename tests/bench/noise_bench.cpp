// SPDX-License-Identifier: MIT
#include "bench/noise_bench.h"

#include "attractor/noise.h"

#include <algorithm>

namespace noise {

std::vector<Row> rowsOf(const std::string& system, const attractor::RenderRequest& request) {
    double pixel = 0;
    double tile = 0;
    for (const std::uint64_t samples : {1'000'000, 10'000'000}) {
        attractor::RenderRequest job = request;
        job.samples = samples;
        const Report report = measured(job);
        pixel = std::max(pixel, report.pixels.worst);
        tile = std::max(tile, report.tiles.worst);
    }
    return {{"noise.pixel." + system, pixel}, {"noise.tile." + system, tile}};
}

} // namespace noise
