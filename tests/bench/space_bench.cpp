// SPDX-License-Identifier: MIT
#include "bench/space_bench.h"

#include "attractor/render/cloud_rendering.h"
#include "attractor/render/renderer.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/space_systems.h"
#include "attractor/systems.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace attractor;

namespace space {

namespace {

constexpr int width = 1920;
constexpr int height = 1080;

double milliseconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

// A frame of something that is orbited.
std::function<void()> solidFrame(const systems::System3& system, int divisor = 1,
                                 OrbitCamera::Projection projection = OrbitCamera::Projection::Orthographic) {
    SpaceRequest request = systems::spaceRequest(system, width / divisor, height / divisor);
    request.camera.projection = projection;
    request.camera = fitted(request.camera, *ifs::SupportFunction<3>::of(ifs::mapsOf(system)), {});
    return [request, rendering = std::make_shared<SolidRendering>(request), frame = 0]() mutable {
        request.camera.orientation = orbit(30 + 0.2 * (++frame % 20), 20);
        rendering->restart(request);
        rendering->draw();
    };
}

// Of a sponge held by the hull, of which two corners are pulled, or by a tetrahedron pulled as far.
std::function<void()> caged(bool byHull) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), width, height);
    std::vector<ifs::Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        if (byHull || k == 0 || k == 1 || k == 2 || k == 4) corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    request.cage = ifs::polygonAtRest<3>(corners);
    request.cage->current.back() += ifs::Vector<3>(0.3, 0.2, 0.2);
    request.cage->current[1] += ifs::Vector<3>(0.2, -0.2, 0.1);
    request.camera = fitted(request.camera, {0, -0.2, 0}, {1.3, 1.2, 1.2});
    return [request, rendering = std::make_shared<SolidRendering>(request), frame = 0]() mutable {
        request.camera.orientation = orbit(30 + 0.2 * (++frame % 20), 20);
        rendering->restart(request);
        rendering->draw();
    };
}

std::function<void()> cloudFrame(const systems::System3& system) {
    SpaceRequest request = systems::spaceRequest(system, width, height);
    request.exposure = Exposure{0, 5, 1};
    const auto pixels = std::make_shared<std::vector<std::uint32_t>>(width * height);
    return [request, pixels, rendering = std::make_shared<CloudRendering>(request), frame = 0]() mutable {
        request.camera.orientation = orbit(30 + 0.2 * (++frame % 20), 20);
        rendering->restart(request);
        rendering->refine();
        rendering->tone(*pixels);
    };
}

std::function<void()> planeFrame() {
    RenderRequest request = systems::request(systems::fern(), 10'000'000, width, height);
    request.appearance = Appearance{};
    request.exposure = Exposure{0, 5, 1};
    const auto shown = std::make_shared<Frame>();
    return [request, shown, rendering = std::make_shared<Rendering>(request), frame = 0]() mutable {
        const double shift = 1e-3 * (++frame % 20);
        request.cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1 + shift, 0}, {shift, 1}}};
        rendering->restart(request);
        rendering->refine();
        *shown = rendering->frame(std::move(*shown));
    };
}

// One thread over two, median of pairs.
double threadRatio(int pairs) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), width, height);
    SolidRendering one(request);
    request.threads = 2;
    SolidRendering two(request);
    std::vector<double> ratios;
    for (int k = 0; k < pairs + 1; ++k) {
        const double alone = milliseconds([&] { one.draw(); });
        const double together = milliseconds([&] { two.draw(); });
        if (k > 0) ratios.push_back(alone / together); // warm
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

double peakMegabytes() {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kilobytes = 0;
    while (status >> word)
        if (word == "VmHWM:") status >> kilobytes;
    return kilobytes / 1024;
}

// The most that a process of its own takes for a Menger sponge on two threads.
double memory() {
    malloc_trim(0); // what is kept for later would be used again unseen
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return std::nan("");
    const pid_t child = fork();
    if (child == 0) {
        const double before = peakMegabytes();
        SpaceRequest request = systems::spaceRequest(systems::menger(), width, height);
        request.threads = 2;
        SolidRendering(request).draw();
        const double megabytes = peakMegabytes() - before;
        _exit(write(ends[1], &megabytes, sizeof megabytes) == sizeof megabytes ? 0 : 1);
    }
    close(ends[1]);
    double megabytes = std::nan("");
    if (child < 0 || read(ends[0], &megabytes, sizeof megabytes) != sizeof megabytes)
        megabytes = std::nan("");
    close(ends[0]);
    if (child > 0) waitpid(child, nullptr, 0);
    return megabytes;
}

} // namespace

std::vector<Ratio> measure(int repetitions) {
    constexpr auto perspective = OrbitCamera::Projection::Perspective;
    std::vector<Ratio> result;
    result.push_back({"space.memory.mb", memory(), "< 96"});
    enum { Plane, Cloud, Drag, Menger, Tetrahedron, Fern, Perspective, Hull, Simplex, Works };
    std::array<std::function<void()>, Works> works{
        planeFrame(),
        cloudFrame(systems::fern3()),
        solidFrame(systems::menger(), 2),
        solidFrame(systems::menger()),
        solidFrame(systems::tetrahedron()),
        solidFrame(systems::fern3()),
        solidFrame(systems::menger(), 1, perspective),
        caged(true),
        caged(false),
    };
    std::array<double, Works> shortest{};
    shortest.fill(std::numeric_limits<double>::infinity());
    for (int k = 0; k < repetitions; ++k)
        for (std::size_t work = 0; work < Works; ++work)
            shortest[work] = std::min(shortest[work], milliseconds(works[work]));
    const auto add = [&](const char* name, int work, int other, const char* target) {
        result.push_back({name, shortest[std::size_t(work)] / shortest[std::size_t(other)], target});
    };
    add("space.cloud.vs_2d", Cloud, Plane, "<= 1.5");
    add("space.drag.vs_2d", Drag, Plane, "<= 1.5");
    add("space.exact.vs_2d.menger", Menger, Plane, "<= 8");
    add("space.exact.vs_2d.tetrahedron", Tetrahedron, Plane, "<= 1.2");
    add("space.exact.vs_2d.fern3", Fern, Plane, "<= 1.2");
    add("space.perspective.vs_orthographic", Perspective, Menger, "<= 1.3");
    add("space.hull_cage.vs_tetrahedron", Hull, Simplex, "<= 1.5");
    result.push_back({"space.exact.threads2", threadRatio(repetitions), ">= 1.7"});
    return result;
}

} // namespace space
