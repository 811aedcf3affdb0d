// SPDX-License-Identifier: MIT
#include "bench/addresses_bench.h"

#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "attractor/tops/deferred_theft.h"
#include "attractor/tops/key_tops.h"
#include "attractor/tops/picture_patterns.h"
#include "bench/canvas_drag.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/tops/theft_thread.h"
#include "ifs/system/links.h"
#include "support/fractals.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <semaphore>
#include <utility>

using namespace attractor;

namespace addresses {

namespace {

using System = ifs::IteratedFunctionSystem<2>;

constexpr int width = 1920, height = 1080;
constexpr std::uint64_t points = 10'000'000;

double milliseconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

struct Shortest {
    double time = std::numeric_limits<double>::infinity();
    void take(const auto& work) { time = std::min(time, milliseconds(work)); }
};

// What a drag does of one frame: from a new system to counted samples.
double pictureRatio(const System& one, const System& other, int repetitions) {
    RenderRequest first = systems::request(other, points, width, height), second = first;
    first.system = one;
    Rendering ofFirst(first), ofSecond(second);
    Shortest a, b;
    for (int k = 0; k < repetitions; ++k) {
        first.seed = second.seed = std::uint64_t(k) + 1; // nothing is kept from the picture before
        a.take([&] {
            ofFirst.restart(first);
            ofFirst.refine();
        });
        b.take([&] {
            ofSecond.restart(second);
            ofSecond.refine();
        });
    }
    return a.time / b.time;
}

std::vector<Ratio> tops(int repetitions) {
    const System fern = systems::fern();
    RenderRequest request = systems::request(fern, points, width, height);
    request.exposure = Exposure{0, 5, 1};
    Rendering rendering(request);
    Frame frame;
    const CoupledSystem system(*ifs::SupportFunction<2>::of(ifs::mapsOf(fern)),
                               *ifs::SupportFunction<2>::of(ifs::mapsOf(systems::maple())),
                               ifs::probabilities(fern));
    const MipPicture picture = attractor::picture(Pattern::Grid);
    TheftRequest theft;
    theft.camera = request.camera;
    theft.toPicture = ifs::affineMap(400, 0, 0, -400, 512, 512);
    theft.points = points;
    DeferredTheft deferred(1);
    std::vector<std::uint32_t> keys(std::size_t(width) * height), pixels(keys.size());
    deferred.draw(system, picture, theft, pixels, {});
    Shortest counting, toning, keying, recolouring;
    for (int k = 0; k < repetitions; ++k) {
        counting.take([&] {
            rendering.restart(request);
            rendering.refine();
        });
        toning.take([&] { frame = rendering.frame(std::move(frame)); });
        keying.take([&] { KeyTops(system, theft.camera, points, 1, {}).drawKeys(0, keys, {}); });
        recolouring.take([&] { deferred.draw(system, picture, theft, pixels, {}); });
    }
    return {{"tops.keys.vs_counting", keying.time / counting.time, "<= 1.3"},
            {"tops.recolour.vs_tone_map", recolouring.time / toning.time, "<= 2.5"}};
}

// Milliseconds from the move of a cage to both finished pictures, side by side, with two threads, sorted.
std::vector<double> cageDrag(int moves) {
    constexpr int warm = 60; // until the number of points fits the machine
    document::TheftJob job;
    const document::Fractal fern = support::fractalOf(systems::fern());
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{-3, 0}, {3, 0}, {0, 10}});
    job.to.fractal = std::make_shared<const document::Fractal>(support::fractalOf(systems::maple()));
    const auto camera = [](const document::Fractal& fractal) {
        Camera made;
        made.width = width / 2;
        made.height = height;
        const auto box = document::displayedBox(fractal);
        return fitted(made, box->min, box->max, 0.05);
    };
    job.from.camera = camera(fern);
    job.to.camera = camera(*job.to.fractal);
    job.picture = std::make_shared<const MipPicture>(attractor::picture(Pattern::Wheel));
    job.isLive = true;
    std::binary_semaphore ready(0);
    document::TheftThread thread(2, [&] { ready.release(); });
    std::vector<double> times;
    for (int k = 0; k < warm + moves; ++k) {
        cage.current[2].x() = 2 * std::sin(0.1 * k);
        job.from.fractal = std::make_shared<const document::Fractal>(
            document::withCageMoved(fern, cage, document::CageMode::Place));
        const double time = milliseconds([&] {
            thread.submit(job);
            ready.acquire();
            thread.newest();
        });
        if (k >= warm) times.push_back(time);
    }
    std::ranges::sort(times);
    return times;
}

} // namespace

std::vector<Ratio> measure(int repetitions) {
    std::vector<Ratio> ratios = tops(repetitions);
    const std::vector<double> drag = cageDrag(10 * repetitions);
    ratios.push_back({"tops.drag_ms.p50", drag[drag.size() / 2], "reported"});
    ratios.push_back({"tops.drag_ms.p99", drag[drag.size() * 99 / 100], "<= 16.7"});
    std::vector<double> inWindow = dragWithStolenColours(systems::fern(), systems::maple(), 10 * repetitions);
    std::ranges::sort(inWindow);
    ratios.push_back({"tops.window_drag_ms.p50", inWindow[inWindow.size() / 2], "reported"});
    ratios.push_back({"tops.window_drag_ms.p99", inWindow[inWindow.size() * 99 / 100], "<= 16.7"});
    System round = systems::maple();
    round.symmetry = {ifs::SymmetryGroup::Rotation, 12, 0, {0, 0}, ifs::Matrix<2>::Identity()};
    ratios.push_back(
        {"symmetry.expanded.vs_listed", pictureRatio(round, ifs::expanded(round), repetitions), "<= 1.1"});
    System even = systems::maple(); // linked, but alike
    std::vector<double> matrix(even.maps.size() * even.maps.size(), 2);
    ifs::setLinks(even, matrix);
    ratios.push_back({"linked.vs_unlinked", pictureRatio(even, systems::maple(), repetitions), "<= 1.05"});
    return ratios;
}

} // namespace addresses
