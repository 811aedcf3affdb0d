// SPDX-License-Identifier: MIT
// Prints the targets table of docs/performance.md as ratios of times measured in this run, and writes them as
// one flat JSON object. barycage_bench [--quick] [--json FILE] [Google Benchmark's own options]
#include "attractor/cells/cell_sums.h"
#include "attractor/cells/splat.h"
#include "attractor/cut/address_cut.h"
#include "attractor/folds/density_fold.h"
#include "attractor/kernels/kernels.h"
#include "attractor/light/tone_map.h"
#include "attractor/render/renderer.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "bench/canvas_drag.h"
#include "bench/geometry_bench.h"
#include "bench/light_bench.h"
#include "bench/noise_bench.h"
#include "bench/plain_rivals.h"
#include "bench/space_bench.h"
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
#include <random>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace attractor;

namespace {

constexpr std::uint64_t tenMillion = 10'000'000;

struct Case {
    std::string name;
    RenderRequest request;
    PreparedSystem drawable;
    rivals::Points points;
};

ifs::IteratedFunctionSystem<2> randomSystem(int maps) {
    std::mt19937 random(32);
    std::uniform_real_distribution<double> u(-1, 1);
    ifs::IteratedFunctionSystem<2> result;
    for (int i = 0; i < maps; ++i)
        ifs::append<2>(result, ifs::affineMap(0.3 * u(random), 0.2 * u(random), 0.2 * u(random),
                                              0.3 * u(random), u(random), u(random)));
    return result;
}

std::vector<Case>& cases() {
    static std::vector<Case> all = [] {
        std::vector<Case> result;
        for (const auto& [name, system] :
             {std::pair<std::string, ifs::IteratedFunctionSystem<2>>{"sierpinski", systems::sierpinski()},
              {"fern", systems::fern()},
              {"maple", systems::maple()},
              {"flower", systems::flower()},
              {"random32", randomSystem(32)}}) {
            Case c{name, systems::request(system, tenMillion, 1920, 1080), prepared(system), {}};
            c.request.appearance = Appearance{};
            c.request.exposure = Exposure{0, 5, 1};
            result.push_back(std::move(c));
        }
        return result;
    }();
    return all;
}

// A drag: every frame has another cage, so nothing but the system stays.
RenderRequest dragged(RenderRequest request, int frame) {
    const double shift = 1e-3 * (frame % 100);
    request.cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1 + shift, 0}, {shift, 1}}};
    return request;
}

// The same in a cage of eight corners around the maple, of which two are moved by 20 % of its size.
RenderRequest bent(RenderRequest request, int frame) {
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{3.264, 1.794},
                                                      {2.045, 4.100},
                                                      {0.992, 5.113},
                                                      {-1.210, 5.113},
                                                      {-3.018, 2.776},
                                                      {-3.434, 1.320},
                                                      {-0.116, -3.215},
                                                      {3.428, -0.152}});
    const double shift = 1e-3 * (frame % 100);
    cage.current[0] += ifs::Vector<2>(1.65 + shift, 0);
    cage.current[4] += ifs::Vector<2>(0, 1.65);
    request.cage = cage;
    return request;
}

// The maps of a system in box coordinates as the engine's chaos game has them.
struct BoxMaps {
    explicit BoxMaps(const PreparedSystem& system) : table(system.probabilities) {
        for (auto& row : rows)
            row.assign(table.size(), 0);
        const ifs::Vector<2>& h = system.halfExtent;
        for (std::size_t i = 0; i < system.maps.size(); ++i) {
            const ifs::Matrix<2>& a = system.maps[i].linear;
            const ifs::Vector<2> shift = system.maps[i](system.centre) - system.centre;
            const std::array<double, 6> row{a(0, 0), a(0, 1) * h.y() / h.x(), a(1, 0) * h.x() / h.y(),
                                            a(1, 1), shift.x() / h.x(),       shift.y() / h.y()};
            for (std::size_t k = 0; k < row.size(); ++k)
                rows[k][i] = static_cast<float>(row[k]);
        }
    }
    kernels::ChaosTables tables() const {
        kernels::ChaosTables result;
        result.size = table.size();
        result.threshold = table.thresholds().data();
        result.alias = table.aliases().data();
        for (std::size_t k = 0; k < rows.size(); ++k)
            result.coefficients[k] = rows[k].data();
        return result;
    }
    AliasTable table;
    std::array<std::vector<float>, 6> rows;
};

void addBenchmarks(Case& c) {
    const auto add = [&](const std::string& what, auto work) {
        benchmark::RegisterBenchmark((what + "/" + c.name).c_str(),
                                     [work](benchmark::State& state) mutable { work(state); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    const std::size_t cells = 1920 * 1080;
    add("orbit_scalar", [&c](benchmark::State& state) {
        std::vector<double> xy(2 * SampleSet::size);
        for (auto _ : state) {
            rivals::scalarOrbit(c.drawable, xy);
            benchmark::DoNotOptimize(xy.data());
        }
    });
    add("orbit_engine", [&c](benchmark::State& state) {
        const BoxMaps maps(c.drawable);
        std::mt19937 random(1);
        kernels::Lanes lanes;
        for (auto& word : lanes.random)
            for (std::uint32_t& value : word)
                value = static_cast<std::uint32_t>(random()) | 1U;
        std::vector<float> x(SampleSet::size);
        std::vector<float> y(SampleSet::size);
        for (auto _ : state) {
            kernels::iterate(lanes, maps.tables(), kernels::Guard::Off, SampleSet::size / SampleSet::lanes,
                             x.data(), y.data());
            benchmark::DoNotOptimize(y.data());
        }
    });
    add("sample_set", [&c](benchmark::State& state) {
        SampleSet samples;
        std::uint64_t pass = 0;
        for (auto _ : state) {
            drawSamples(c.drawable, 1, ++pass, samples);
            benchmark::DoNotOptimize(samples.x.data());
        }
    });
    add("grid_plain", [&c, cells](benchmark::State& state) {
        std::vector<std::uint32_t> counts(cells);
        for (auto _ : state)
            rivals::chaosIntoGrid(c.drawable, c.request.camera, tenMillion, counts);
    });
    const auto engineGrid = [](Rendering& rendering, const RenderRequest& request) {
        rendering.restart(request);
        rendering.refine();
    };
    add("grid_engine", [&c, engineGrid](benchmark::State& state) {
        Rendering rendering(c.request);
        int frame = 0;
        for (auto _ : state)
            engineGrid(rendering, dragged(c.request, ++frame));
    });
    add("redraw_scalar", [&c, cells](benchmark::State& state) {
        if (c.points.xy.empty()) c.points = rivals::storedPoints(c.drawable, tenMillion);
        std::vector<std::uint32_t> counts(cells);
        std::vector<std::uint32_t> pixels(cells);
        std::vector<std::uint32_t> palette(kernels::toneIndex(tenMillion) + 1, 7);
        for (auto _ : state) {
            std::fill(counts.begin(), counts.end(), 0U);
            rivals::redrawStored(c.points, c.request.camera, counts);
            const std::uint32_t* pointer = counts.data();
            kernels::mapTones({&pointer, 1}, cells, palette.data(), pixels.data());
        }
    });
    add("redraw", [&c, engineGrid](benchmark::State& state) {
        Rendering rendering(c.request);
        Frame shown;
        int frame = 0;
        for (auto _ : state) {
            engineGrid(rendering, dragged(c.request, ++frame));
            shown = rendering.frame(std::move(shown));
        }
    });
    if (c.name == "maple")
        add("cage8", [&c, engineGrid](benchmark::State& state) {
            Rendering rendering(c.request);
            Frame shown;
            int frame = 0;
            for (auto _ : state) {
                engineGrid(rendering, bent(c.request, ++frame));
                shown = rendering.frame(std::move(shown));
            }
        });
    add("edit", [&c, engineGrid](benchmark::State& state) {
        Rendering rendering(c.request);
        Frame shown;
        int frame = 0;
        for (auto _ : state) {
            RenderRequest request = c.request;
            request.system.maps[0].map.translation.x() += 1e-5 * ++frame;
            engineGrid(rendering, request);
            shown = rendering.frame(std::move(shown));
        }
    });
    const auto splatBench = [&c](double zoom) {
        return [&c, zoom](benchmark::State& state) {
            Camera camera = c.request.camera;
            camera.pixelsPerUnit *= zoom;
            if (zoom > 1) camera.centre = *ifs::fixedPoint(c.drawable.maps.back()); // something is there
            const PreparedSystem& system = c.drawable;
            const Projection view = projection(camera, {}, 1);
            CutSettings settings;
            settings.words = wordsFor(tenMillion);
            if (zoom > 1) { // as many words as the engine takes for what is in view
                settings.samples = addressCut(system, view, settings).probability * tenMillion;
                settings.words = wordsFor(static_cast<std::uint64_t>(settings.samples));
            }
            const AddressCut cut = addressCut(system, view, settings);
            SampleSet samples;
            drawSamples(system, 1, 0, samples);
            CellSums sums;
            sums.reset(CellKind::Count, {1920, 0, 1080}, 1);
            for (auto _ : state)
                for (const Word& word : cut.words)
                    splat(word, samples, static_cast<std::uint64_t>(word.probability * tenMillion),
                          sums.window(), sums.counts(0, reachedCells(word, samples, sums.window())));
        };
    };
    add("splat", splatBench(1));
    add("splat_zoom_out", splatBench(12.0 / 1080));
    add("splat_zoom16", splatBench(16));
    // What a frame pays besides counting: tones of one picture, and clearing what the next one reaches.
    add("tone", [&c, cells](benchmark::State& state) {
        const ToneMap toneMap({c.request.appearance, 1, 1e-1, 5, 1}, tenMillion);
        SampleSet samples;
        drawSamples(c.drawable, 1, 0, samples);
        CutSettings settings;
        settings.words = wordsFor(tenMillion);
        const AddressCut cut = addressCut(c.drawable, projection(c.request.camera, {}, 1), settings);
        CellSums sums;
        CellSums next;
        const CellWindow window{1920, 0, 1080};
        sums.reset(CellKind::Count, window, 1);
        for (const Word& word : cut.words)
            splat(word, samples, static_cast<std::uint64_t>(word.probability * tenMillion), window,
                  sums.counts(0, reachedCells(word, samples, window)));
        std::vector<std::uint32_t> pixels(cells);
        for (auto _ : state) {
            toneMap.apply(sums, 0, 1080, pixels);
            next.reset(CellKind::Count, window, 1);
            for (const Word& word : cut.words)
                benchmark::DoNotOptimize(next.counts(0, reachedCells(word, samples, window)));
        }
    });
}

void addRoofline() {
    const auto add = [](const char* what, auto work) {
        benchmark::RegisterBenchmark(what, work)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    add("read", [](benchmark::State& state) {
        const std::vector<std::uint32_t> data(tenMillion, 3);
        for (auto _ : state) {
            std::uint32_t sum = 0;
            for (const std::uint32_t value : data)
                sum += value;
            benchmark::DoNotOptimize(sum);
        }
    });
    add("memcpy", [](benchmark::State& state) {
        constexpr std::size_t cells = 1920 * 1080;
        const std::vector<std::uint32_t> from(cells, 5);
        std::vector<std::uint32_t> to(cells);
        for (auto _ : state) {
            std::memcpy(to.data(), from.data(), cells * sizeof(std::uint32_t));
            benchmark::DoNotOptimize(to.data());
        }
    });
}

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
double engineMemory(std::uint64_t samples, ColourBy colourBy = ColourBy::Density, int supersample = 1) {
    malloc_trim(0); // what is kept for later would be used again unseen
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return std::nan("");
    const pid_t child = fork();
    if (child == 0) {
        const double before = peakMegabytes();
        RenderRequest request = systems::request(systems::maple(), tenMillion, 1920, 1080);
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
        add("redraw.zoom16", time("splat_zoom16") / time("splat"), "<= 0.05");
        add("tone_map.vs_memcpy", time("tone") / roof("memcpy"), "<= 1.1");
        add("edit.vs_redraw", time("edit") / time("redraw"), "<= 1.6");
        add("redraw.ms", time("redraw"), "reported");
        add("chaos_game.sample_set_ms", time("sample_set"), "reported");
    }
    metrics.push_back(
        {"chaos_game.many_maps", roof("orbit_engine/random32") / roof("orbit_engine/maple"), "<= 1.1"});
    metrics.push_back({"space.light.vs_memcpy", roof("light") / roof("memcpy"), "<= 4"});
    metrics.push_back({"cage8.vs_triangle", roof("cage8/maple") / roof("redraw/maple"), "<= 1.5"});
    return metrics;
}

void addDrag(std::vector<Metric>& metrics, bool quick) {
    for (const auto& [label, samples] : {std::pair<const char*, std::uint64_t>{"1e6", 1'000'000},
                                         {"1e7", tenMillion},
                                         {"1e8", 10 * tenMillion}}) {
        std::vector<double> times = dragInCanvas(cases()[2].request.system, samples, quick ? 100 : 300);
        std::sort(times.begin(), times.end());
        metrics.push_back({std::string("drag.latency_ms.p50.") + label, times[times.size() / 2], "reported"});
        metrics.push_back({std::string("drag.latency_ms.p99.") + label, times[times.size() * 99 / 100],
                           samples == tenMillion ? "< 16.7" : "reported"});
    }
}

void addWholeEngine(std::vector<Metric>& metrics, bool quick) {
    metrics.push_back({"memory.mb.1e7", engineMemory(tenMillion), "< 64"});
    metrics.push_back({quick ? "memory.mb.1e8" : "memory.mb.1e9",
                       engineMemory(quick ? 10 * tenMillion : 100 * tenMillion), "< 64"});
    metrics.push_back({"memory.mb.by_map", engineMemory(tenMillion, ColourBy::Map), "reported"});
    metrics.push_back({"memory.mb.supersample2", engineMemory(tenMillion, ColourBy::Density, 2), "reported"});
    metrics.push_back({"memory.mb.supersample4", engineMemory(tenMillion, ColourBy::Density, 4), "reported"});
    for (const Case& c : cases())
        metrics.push_back({"redraw.threads2." + c.name, threadRatio(c, quick ? 15 : 60), ">= 1.75"});
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

void addSpace(std::vector<Metric>& metrics, bool quick) {
    for (const space::Ratio& ratio : space::measure(quick ? 12 : 40))
        metrics.push_back({ratio.name, ratio.value, ratio.target});
}

void addTime(std::vector<Metric>& metrics, bool quick) {
    for (const timing::Row& row : timing::measure(quick ? 5 : 20))
        metrics.push_back({row.name, row.value, row.target});
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
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    bool quick = false;
    bool dragOnly = false;
    std::string json = BARYCAGE_BENCH_JSON;
    std::vector<char*> rest{argv[0]};
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0)
            quick = true;
        else if (std::strcmp(argv[i], "--drag") == 0)
            dragOnly = true;
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
    addDrag(whole, quick);
    if (!dragOnly) {
        addGeometry(whole, quick);
        addNoise(whole);
        addSpace(whole, quick);
        addTime(whole, quick);
        addWholeEngine(whole, quick);
        for (Case& c : cases())
            addBenchmarks(c);
        addRoofline();
        light::addBenchmark();
        Shortest shortest;
        benchmark::RunSpecifiedBenchmarks(&shortest);
        metrics = ratios(shortest.times);
    }
    metrics.insert(metrics.end(), whole.begin(), whole.end());
    std::printf("instruction set: %s\n%-42s %10s   %s\n", simdName().c_str(), "metric", "value", "target");
    for (const Metric& metric : metrics)
        std::printf("%-42s %10.3f   %s\n", metric.name.c_str(), metric.value, metric.target.c_str());
    if (!dragOnly) writeJson(metrics, json);
    return 0;
}
