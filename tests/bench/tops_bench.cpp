// SPDX-License-Identifier: MIT
#include "bench/tops_bench.h"

#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "attractor/tops/deferred_theft.h"
#include "attractor/tops/picture_patterns.h"

#include <algorithm>
#include <chrono>
#include <limits>

using namespace attractor;

namespace tops_bench {

namespace {

constexpr int width = 1920;
constexpr int height = 1080;
constexpr std::uint64_t points = 10'000'000;

double milliseconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

std::vector<space::Ratio> measure(int repetitions) {
    RenderRequest request = systems::request(systems::fern(), points, width, height);
    request.exposure = Exposure{0, 5, 1};
    Rendering rendering(request);
    Frame frame;
    const std::vector<ifs::AffineMap<2>> from = ifs::mapsOf(systems::fern()),
                                         to = ifs::mapsOf(systems::maple());
    const CoupledSystem system(*ifs::SupportFunction<2>::of(from), to, ifs::probabilities(systems::fern()));
    const MipPicture picture = attractor::picture(Pattern::Grid, 1024);
    TheftRequest theft;
    theft.camera = request.camera;
    theft.toPicture = ifs::affineMap(400, 0, 0, -400, 512, 512);
    theft.points = points;
    DeferredTheft deferred(1);
    std::vector<std::uint32_t> keys(std::size_t(width) * height), pixels(keys.size());
    deferred.draw(system, picture, theft, pixels, {});
    double counting = std::numeric_limits<double>::infinity(), toning = counting, keying = counting,
           recolouring = counting;
    for (int k = 0; k < repetitions; ++k) {
        counting = std::min(counting, milliseconds([&] {
                                rendering.restart(request);
                                rendering.refine();
                            }));
        toning = std::min(toning, milliseconds([&] { frame = rendering.frame(std::move(frame)); }));
        keying = std::min(keying, milliseconds([&] {
                              KeyTops(system, theft.camera, points, 1, {}).drawKeys(0, keys, {});
                          }));
        recolouring =
            std::min(recolouring, milliseconds([&] { deferred.draw(system, picture, theft, pixels, {}); }));
    }
    return {{"tops.keys.vs_counting", keying / counting, "<= 1.3"},
            {"tops.recolour.vs_tone_map", recolouring / toning, "<= 2.5"}};
}

} // namespace tops_bench
