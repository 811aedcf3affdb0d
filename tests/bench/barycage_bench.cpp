// SPDX-License-Identifier: MIT
// Prints the targets table of docs/performance.md as ratios of times measured in this run, and writes them as
// one flat JSON object. barycage_bench [--quick] [--json FILE] [Google Benchmark's own options]
#include "attractor/kernels/kernels.h"
#include "attractor/light/tone_map.h"
#include "attractor/render/renderer.h"
#include "attractor/space_systems.h"
#include "attractor/systems.h"
#include "bench/addresses_bench.h"
#include "bench/canvas_drag.h"
#include "bench/collage_bench.h"
#include "bench/engine_bench.h"
#include "bench/frames_bench.h"
#include "bench/geometry_bench.h"
#include "bench/light_bench.h"
#include "bench/noise_bench.h"
#include "bench/orbit_bench.h"
#include "bench/plain_rivals.h"
#include "bench/space_bench.h"
#include "bench/start_bench.h"
#include "bench/time_bench.h"

#include <QApplication>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <malloc.h>
#include <map>
#include <numeric>
#include <random>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

using namespace attractor;
using engine::Case;
using engine::cases;
using engine::dragged;
using engine::tenMillion;

namespace {

double milliseconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

// One thread over two, whole frames, pair by pair.
double threadRatio(const Case& c, int pairs) {
    RenderRequest request = c.request;
    Rendering one(request);
    request.threads = 2;
    Rendering two(request);
    Frame shown;
    std::vector<double> ratios;
    for (int frame = 0; frame < pairs + 3; ++frame) {
        const auto redraw = [&](Rendering& rendering, int threads) {
            RenderRequest next = dragged(c.request, frame);
            next.threads = threads;
            return milliseconds([&] {
                rendering.restart(next);
                rendering.refine();
                shown = rendering.frame(std::move(shown));
            });
        };
        const double alone = redraw(one, 1);
        const double together = redraw(two, 2);
        if (frame >= 3) ratios.push_back(alone / together); // warm
    }
    return median(ratios);
}

// Keeps the shortest time of every benchmark's repetitions, in milliseconds.
class Shortest : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            const std::string name = run.run_name.function_name;
            const double time = run.GetAdjustedRealTime();
            const auto [entry, fresh] = times.emplace(name, time);
            entry->second = std::min(entry->second, time);
        }
    }
    std::map<std::string, double> times;
};

double peakMegabytes() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
        if (word == "VmHWM:") {
            double kilobytes = 0;
            status >> kilobytes;
            return kilobytes / 1024;
        }
    return 0;
}

// The most that a process of its own takes for it.
double engineMemory(std::uint64_t samples, ColourBy colourBy = ColourBy::Density, int supersample = 1,
                    int height = 1080) {
    malloc_trim(0); // what is kept for later would be used again unseen
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return std::nan("");
    const pid_t child = fork();
    if (child == 0) {
        const double before = peakMegabytes();
        RenderRequest request = systems::request(systems::maple(), tenMillion, height * 16 / 9, height);
        request.threads = 2;
        request.appearance.colourBy = colourBy;
        request.appearance.supersample = supersample;
        Rendering rendering(request);
        Frame frame;
        for (std::uint64_t done = 0; done < samples; done += std::max(tenMillion, samples / 4)) {
            rendering.refine({}, std::max(tenMillion, samples / 4));
            frame = rendering.frame(std::move(frame));
        }
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

// 8-bit grey against a chaos game of `reference` points, after one second of refinement on two threads.
double refinementPsnr(const Case& c, std::size_t reference) {
    RenderRequest request = c.request;
    request.appearance.colourBy = ColourBy::Plain;
    request.appearance.plain = {255, 255, 255, 255};
    request.appearance.background = {0, 0, 0, 255};
    request.threads = 2;
    Rendering rendering(request);
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(1))
        rendering.refine({}, 20'000'000);
    const Frame frame = rendering.frame();
    std::vector<std::uint32_t> counts(frame.pixels.size());
    rivals::chaosIntoGrid(c.drawable, c.request.camera, reference, counts);
    double squares = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double density = counts[i] / static_cast<double>(reference) / frame.exposure.meanDensity;
        const double expected = std::floor(255 * tone(density, request.appearance.brightness,
                                                      frame.exposure.whitePoint, request.appearance.gamma) +
                                           0.5);
        const double difference = expected - static_cast<double>(frame.pixels[i] & 255U);
        squares += difference * difference;
    }
    return 10 * std::log10(255.0 * 255.0 * static_cast<double>(counts.size()) / squares);
}

struct Metric {
    std::string name;
    double value = 0;
    std::string target;
};

std::vector<Metric> ratios(const std::map<std::string, double>& times) {
    std::vector<Metric> metrics;
    const bool wide = simdName() == "avx512";
    const auto roof = [&](const char* what) { return times.contains(what) ? times.at(what) : std::nan(""); };
    for (const Case& c : cases()) {
        const auto time = [&](const char* what) {
            const auto found = times.find(what + ("/" + c.name));
            return found == times.end() ? std::nan("") : found->second;
        };
        const auto add = [&](const char* name, double value, const char* target) {
            metrics.push_back({std::string(name) + "." + c.name, value, target});
        };
        add("chaos_game.vs_scalar_f64", time("orbit_scalar") / time("orbit_engine"),
            wide ? ">= 30" : ">= 15");
        add("chaos_game.vs_plain", time("grid_plain") / time("grid_engine"), wide ? ">= 5" : ">= 1.5");
        add("redraw.vs_scalar", time("redraw_scalar") / time("redraw"), wide ? ">= 5" : ">= 1.5");
        add("redraw.vs_read", time("splat") / roof("read"), wide ? "<= 3.5" : "<= 7");
        add("redraw.zoom_out", time("splat_zoom_out") / time("splat"), "<= 1.3");
        add("redraw.zoom16", time("splat_zoom16") / time("splat"), "<= 0.04");
        add("tone_map.vs_memcpy", time("tone") / roof("memcpy"), "reported");
        add("tone_map.vs_memcpy_cold", time("tone") / roof("memcpy_cold"), "<= 1.1");
        add("edit.vs_redraw", time("edit") / time("redraw"), "<= 1.6");
        add("redraw.ms", time("redraw"), "reported");
        add("chaos_game.sample_set_ms", time("sample_set"), "reported");
    }
    metrics.push_back(
        {"chaos_game.many_maps", roof("orbit_engine/random32") / roof("orbit_engine/maple"), "<= 1.1"});
    metrics.push_back({"space.light.vs_memcpy", roof("light") / roof("memcpy"), "<= 4"});
    metrics.push_back({"cage8.vs_triangle", roof("cage8/maple") / roof("redraw/maple"), "<= 1.4"});
    metrics.push_back(
        {"redraw.random32.vs_maple", roof("redraw/random32") / roof("redraw/maple"), "<= 1.15"});
    metrics.push_back({"redraw.by_map.vs_density", roof("by_map/maple") / roof("redraw/maple"), "<= 1.4"});
    metrics.push_back(
        {"redraw.by_address.vs_density", roof("by_address/maple") / roof("redraw/maple"), "<= 1.4"});
    return metrics;
}

void addDrag(std::vector<Metric>& metrics, bool quick) {
    struct Drag {
        const char* label;
        std::uint64_t samples;
        QSize size;
        const char* target; // of the 99th percentile
    };
    for (const Drag& drag : {Drag{"1e6", 1'000'000, {1920, 1080}, "reported"},
                             {"1e7", tenMillion, {1920, 1080}, "<= 8.3"},
                             {"1e8", 10 * tenMillion, {1920, 1080}, "<= 33"},
                             {"4k", tenMillion, {3840, 2160}, "<= 16.7"}}) {
        std::vector<double> times =
            dragInCanvas(cases()[2].request.system, drag.samples, quick ? 100 : 300, drag.size);
        std::sort(times.begin(), times.end());
        metrics.push_back(
            {std::string("drag.latency_ms.p50.") + drag.label, times[times.size() / 2], "reported"});
        metrics.push_back(
            {std::string("drag.latency_ms.p99.") + drag.label, times[times.size() * 99 / 100], drag.target});
    }
}

void addStart(std::vector<Metric>& metrics, const char* program, bool quick) {
    for (const start::Row& row : start::measure(program, quick ? 5 : 15))
        metrics.push_back({row.name, row.value, row.target});
}

void addCollage(std::vector<Metric>& metrics, bool quick) {
    metrics.push_back(
        {"collage.starts_per_second.vs_plain", collage_bench::startsRatio(quick ? 20 : 60), ">= 3"});
    using collage_bench::WithTarget;
    for (const auto& [label, target, limit] : {std::tuple{"without_target", WithTarget::No, "reported"},
                                               std::tuple{"picture", WithTarget::Yes, "<= 16.7"}}) {
        collage_bench::Drag drag = collage_bench::drag(target, quick ? 100 : 300);
        const auto add = [&](const std::string& what, std::vector<double>& times, const char* wanted) {
            if (times.empty()) return;
            std::sort(times.begin(), times.end());
            const std::string name = "collage.drag_ms." + what;
            metrics.push_back({name + ".p50", times[times.size() / 2], "reported"});
            metrics.push_back({name + ".p99", times[times.size() * 99 / 100], wanted});
        };
        add(label, drag.picture, limit);
        if (target == WithTarget::Yes) add("numbers", drag.numbers, "reported");
    }
}

void addWholeEngine(std::vector<Metric>& metrics, bool quick) {
    metrics.push_back({"memory.mb.1e7", engineMemory(tenMillion), "< 64"});
    metrics.push_back({quick ? "memory.mb.1e8" : "memory.mb.1e9",
                       engineMemory(quick ? 10 * tenMillion : 100 * tenMillion), "< 64"});
    metrics.push_back({"memory.mb.by_map", engineMemory(tenMillion, ColourBy::Map), "< 64"});
    metrics.push_back({"memory.mb.4k", engineMemory(tenMillion, ColourBy::Density, 1, 2160), "< 200"});
    metrics.push_back({"memory.mb.by_map.4k", engineMemory(tenMillion, ColourBy::Map, 1, 2160), "< 200"});
    metrics.push_back({"memory.mb.supersample2", engineMemory(tenMillion, ColourBy::Density, 2), "reported"});
    metrics.push_back({"memory.mb.supersample4", engineMemory(tenMillion, ColourBy::Density, 4), "reported"});
    for (const Case& c : cases())
        metrics.push_back({"redraw.threads2." + c.name, threadRatio(c, quick ? 15 : 60), ">= 1.8"});
    const Case& fern = cases()[1];
    const Case& maple = cases()[2];
    const std::size_t reference = quick ? 200'000'000 : 1'000'000'000;
    metrics.push_back({"refine.psnr_db.fern", refinementPsnr(fern, reference), ">= 40"});
    metrics.push_back({"refine.psnr_db.maple", refinementPsnr(maple, reference), ">= 40"});
}

void addNoise(std::vector<Metric>& metrics) {
    for (const Case& c : cases())
        for (const auto& [name, value] : noise::rowsOf(c.name, c.request))
            metrics.push_back({name, value, "<= 1.5"});
}

void addGeometry(std::vector<Metric>& metrics, bool quick) {
    for (const auto& distribution : geometry::measureCollection(quick ? 1 : 5)) {
        const auto& times = distribution.milliseconds;
        const auto add = [&](const char* what, double value, const char* target) {
            metrics.push_back({distribution.name + "." + what, value, target});
        };
        add("ms.p50", times[times.size() / 2], "reported");
        add("ms.p95", times[times.size() * 95 / 100], "<= 16");
        add("ms.max", times.back(), "reported");
        add("missed", distribution.missed, ("of " + std::to_string(times.size())).c_str());
    }
}

// On as many threads as the machine has.
void addOrbit(std::vector<Metric>& metrics, bool quick) {
    for (const auto& [label, system] :
         {std::pair{"menger", systems::menger()}, std::pair{"fern3", systems::fern3()}}) {
        orbit_bench::Orbit orbit = orbit_bench::measure(system, quick ? 100 : 300);
        const double moves = static_cast<double>(orbit.steps.size());
        const double step = std::accumulate(orbit.steps.begin(), orbit.steps.end(), 0.0) / moves;
        std::vector<double>& times = orbit.milliseconds;
        std::sort(times.begin(), times.end());
        const auto add = [&](const char* what, double value, const char* target) {
            metrics.push_back({std::string("space.orbit.") + what + "." + label, value, target});
        };
        add("p50", times[times.size() / 2], "reported");
        add("p99", times[times.size() * 99 / 100], "<= 16.7");
        add("step", step, "reported");
    }
}

void addSpace(std::vector<Metric>& metrics, bool quick) {
    for (const space::Ratio& ratio : space::measure(quick ? 12 : 40))
        metrics.push_back({ratio.name, ratio.value, ratio.target});
    addOrbit(metrics, quick);
}

void addAddresses(std::vector<Metric>& metrics, bool quick) {
    for (const addresses::Ratio& ratio : addresses::measure(quick ? 12 : 40))
        metrics.push_back({ratio.name, ratio.value, ratio.target});
}

void addTime(std::vector<Metric>& metrics, bool quick) {
    for (const timing::Row& row : timing::measure(quick ? 5 : 20))
        metrics.push_back({row.name, row.value, row.target});
    const document::Fractal moving = frames_bench::windyMaple(48);
    metrics.push_back(
        {"time.playback.late.1e7", lateInCanvas(moving, tenMillion, quick ? 72 : 240), "< 0.01"});
    std::vector<double> scrubbed = scrubInCanvas(moving, tenMillion, quick ? 100 : 300);
    std::sort(scrubbed.begin(), scrubbed.end());
    metrics.push_back({"time.scrub_ms.p50", scrubbed[scrubbed.size() / 2], "reported"});
    metrics.push_back({"time.scrub_ms.p99", scrubbed[scrubbed.size() * 99 / 100], "<= 16.7"});
    for (const timing::Row& row : frames_bench::measure(quick ? 12 : 240, quick ? 3 : 10))
        metrics.push_back({row.name, row.value, row.target});
}

// "--drag" and the like: this part alone.
bool isPart(std::string_view argument) {
    constexpr std::array parts{"--start", "--drag", "--collage", "--addresses", "--time", "--space"};
    return std::ranges::find(parts, argument) != parts.end();
}

void writeJson(const std::vector<Metric>& metrics, const std::string& path) {
    std::ofstream file(path);
    file << "{\n";
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        file << "  \"" << metrics[i].name << "\": ";
        std::isfinite(metrics[i].value) ? file << metrics[i].value : file << "null";
        file << (i + 1 < metrics.size() ? ",\n" : "\n");
    }
    file << "}\n";
    if (!file) std::cerr << "Could not write " << path << ".\n";
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], start::argument) == 0) return start::main(argc, argv);
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    bool quick = false;
    std::string only; // one part alone
    std::string json = BARYCAGE_BENCH_JSON;
    std::vector<char*> rest{argv[0]};
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0)
            quick = true;
        else if (isPart(argv[i]))
            only = argv[i] + 2;
        else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc)
            json = argv[++i];
        else
            rest.push_back(argv[i]);
    }
    std::string repetitions = quick ? "--benchmark_repetitions=6" : "--benchmark_repetitions=25";
    std::string minTime = quick ? "--benchmark_min_time=0.01" : "--benchmark_min_time=0.05";
    // So that a neighbour who is busy for a while falls on all alike, and nobody's shortest time.
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    rest.insert(rest.begin() + 1, {repetitions.data(), minTime.data(), interleaved.data()});
    int count = static_cast<int>(rest.size());
    benchmark::Initialize(&count, rest.data());
    if (benchmark::ReportUnrecognizedArguments(count, rest.data())) return 2;
    std::vector<Metric> whole;
    std::vector<Metric> metrics;
    const auto isWanted = [&only](const char* part) { return only.empty() || only == part; };
    if (isWanted("start")) addStart(whole, argv[0], quick);
    if (isWanted("drag")) addDrag(whole, quick);
    if (isWanted("collage")) addCollage(whole, quick);
    if (isWanted("addresses")) addAddresses(whole, quick);
    if (isWanted("time")) addTime(whole, quick);
    if (isWanted("space")) addSpace(whole, quick);
    if (only.empty()) {
        addGeometry(whole, quick);
        addNoise(whole);
        addWholeEngine(whole, quick);
        for (Case& c : cases())
            engine::addBenchmarks(c);
        engine::addRoofline();
        light::addBenchmark();
        Shortest shortest;
        benchmark::RunSpecifiedBenchmarks(&shortest);
        metrics = ratios(shortest.times);
    }
    metrics.insert(metrics.end(), whole.begin(), whole.end());
    std::printf("instruction set: %s\n%-42s %10s   %s\n", simdName().c_str(), "metric", "value", "target");
    for (const Metric& metric : metrics)
        std::printf("%-42s %10.3f   %s\n", metric.name.c_str(), metric.value, metric.target.c_str());
    if (only.empty()) writeJson(metrics, json);
    return 0;
}
