// SPDX-License-Identifier: MIT
#include "bench/light_bench.h"

#include "attractor/light/solid_light.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/space_systems.h"

#include <benchmark/benchmark.h>

#include <span>
#include <vector>

namespace light {

void addBenchmark() {
    benchmark::RegisterBenchmark(
        "light",
        [](benchmark::State& state) {
            const attractor::SpaceRequest request = systems::spaceRequest(systems::menger(), 1920, 1080);
            attractor::SolidRendering rendering(request);
            rendering.draw();
            const attractor::DepthRaster& raster = rendering.raster();
            const attractor::SolidLight light(attractor::appearanceOf(attractor::Look::Stone),
                                              attractor::solidView(request.camera, 0, 1));
            std::vector<std::uint32_t> pixels(raster.keys.size());
            for (auto _ : state) {
                light.apply(raster, 0, raster.height, std::span(pixels));
                benchmark::DoNotOptimize(pixels.data());
            }
        })
        ->Unit(benchmark::kMillisecond) // as "memcpy", to which it is compared
        ->UseRealTime();
}

} // namespace light
