// SPDX-License-Identifier: MIT
#include "bench/engine_bench.h"

#include "attractor/cells/cell_sums.h"
#include "attractor/cells/splat.h"
#include "attractor/cut/address_cut.h"
#include "attractor/folds/density_fold.h"
#include "attractor/kernels/kernels.h"
#include "attractor/light/tone_map.h"
#include "attractor/samples/chaos_game.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <utility>

using namespace attractor;

namespace engine {

namespace {

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

constexpr std::size_t cells = 1920 * 1080;

void add(const std::string& what, const Case& c, auto work) {
    benchmark::RegisterBenchmark((what + "/" + c.name).c_str(),
                                 [work](benchmark::State& state) mutable { work(state); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

void drawOnce(Rendering& rendering, const RenderRequest& request) {
    rendering.restart(request);
    rendering.refine();
}

// Orbits and sample sets, without a picture.
void addChaosGame(const Case& c) {
    add("orbit_scalar", c, [&c](benchmark::State& state) {
        std::vector<double> xy(2 * SampleSet::size);
        for (auto _ : state) {
            rivals::scalarOrbit(c.drawable, xy);
            benchmark::DoNotOptimize(xy.data());
        }
    });
    add("orbit_engine", c, [&c](benchmark::State& state) {
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
    add("sample_set", c, [&c](benchmark::State& state) {
        SampleSet samples;
        std::uint64_t pass = 0;
        for (auto _ : state) {
            drawSamples(c.drawable, 1, ++pass, samples);
            benchmark::DoNotOptimize(samples.x.data());
        }
    });
}

// The plain rivals beside the engine.
void addRivals(Case& c) {
    add("grid_plain", c, [&c](benchmark::State& state) {
        std::vector<std::uint32_t> counts(cells);
        for (auto _ : state)
            rivals::chaosIntoGrid(c.drawable, c.request.camera, tenMillion, counts);
    });
    add("grid_engine", c, [&c](benchmark::State& state) {
        Rendering rendering(c.request);
        int frame = 0;
        for (auto _ : state)
            drawOnce(rendering, dragged(c.request, ++frame));
    });
    add("redraw_scalar", c, [&c](benchmark::State& state) {
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
}

// Whole frames, of which each one's request differs from the one before.
void addFrames(const std::string& what, const Case& c, auto requestOf) {
    add(what, c, [&c, requestOf](benchmark::State& state) {
        Rendering rendering(c.request);
        Frame shown;
        int frame = 0;
        for (auto _ : state) {
            drawOnce(rendering, requestOf(c.request, ++frame));
            shown = rendering.frame(std::move(shown));
        }
    });
}

RenderRequest edited(RenderRequest request, int frame) {
    request.system.maps[0].map.translation.x() += 1e-5 * frame;
    return request;
}

// Counts samples alone, at another zoom.
void addSplat(const std::string& what, const Case& c, double zoom) {
    add(what, c, [&c, zoom](benchmark::State& state) {
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
                splat(word, samples, static_cast<std::uint64_t>(word.probability * tenMillion), sums.window(),
                      sums.counts(0, reachedCells(word, samples, sums.window())));
    });
}

// What a frame pays besides counting: tones of one picture, and clearing what the next one reaches.
void addTone(const Case& c) {
    add("tone", c, [&c](benchmark::State& state) {
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

} // namespace

void addBenchmarks(Case& c) {
    addChaosGame(c);
    addRivals(c);
    addFrames("redraw", c, dragged);
    if (c.name == "maple") addFrames("cage8", c, bent);
    if (c.name == "maple")
        for (const auto& [what, colourBy] :
             {std::pair{"by_map", ColourBy::Map}, std::pair{"by_address", ColourBy::Address}})
            addFrames(what, c, [colourBy](RenderRequest request, int frame) {
                request.appearance.colourBy = colourBy;
                return dragged(std::move(request), frame);
            });
    addFrames("edit", c, edited);
    addSplat("splat", c, 1);
    addSplat("splat_zoom_out", c, 12.0 / 1080);
    addSplat("splat_zoom16", c, 16);
    addTone(c);
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
        const std::vector<std::uint32_t> from(cells, 5);
        std::vector<std::uint32_t> to(cells);
        for (auto _ : state) {
            std::memcpy(to.data(), from.data(), cells * sizeof(std::uint32_t));
            benchmark::DoNotOptimize(to.data());
        }
    });
    // The same bytes, which come from memory and go there.
    add("memcpy_cold", [](benchmark::State& state) {
        constexpr std::size_t pictures = 24;
        const std::vector<std::uint32_t> from(pictures * cells, 5);
        std::vector<std::uint32_t> to(pictures * cells);
        std::size_t next = 0;
        for (auto _ : state) {
            std::memcpy(to.data() + next * cells, from.data() + next * cells, cells * sizeof(std::uint32_t));
            benchmark::DoNotOptimize(to.data());
            next = (next + 1) % pictures;
        }
    });
}

} // namespace engine
