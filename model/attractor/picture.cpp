// SPDX-License-Identifier: MIT
#include "attractor/picture.h"

#include "attractor/arithmetic.h"
#include "attractor/linear_light.h"
#include "attractor/preattractor.h"
#include "attractor/splat.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace attractor {

namespace {

constexpr std::uint64_t mostPerSampleSet = 1U << 24;           // more samples are drawn from a fresh set
constexpr std::uint64_t mostUninstanced = 2 * SampleSet::size; // the same where there is but one word
constexpr std::uint64_t samplesPerJob = 1U << 16;              // between two looks at the stop token
constexpr std::size_t addressColours = 1024;

ColourCell colourCell(const Rgba& colour) {
    const auto channel = [](std::uint8_t code) {
        return static_cast<std::uint32_t>(linearLight(code) * 4095 + 0.5);
    };
    return {1, channel(colour.red), channel(colour.green), channel(colour.blue)};
}

double unitInterval(std::uint64_t random) {
    return static_cast<double>(random >> 11) * 0x1p-53;
}

} // namespace

int wordsFor(std::uint64_t samples) {
    return static_cast<int>(std::clamp<std::uint64_t>(samples / SampleSet::size, 128, 4096));
}

void Picture::start(RenderRequest newRequest) {
    const bool sameSystem =
        system.maps.size() > 0 && newRequest.system == request.system && newRequest.moved == request.moved;
    request = std::move(newRequest);
    request.threads = std::clamp(request.threads, 1, 256);
    request.appearance.supersample = std::clamp(request.appearance.supersample, 1, 4);
    if (!sameSystem) {
        system = attractor::drawable(request.system, request.moved);
        bent.clear();
    }
    const Camera& camera = request.camera;
    drawable = !system.maps.empty() && camera.width > 0 && camera.height > 0 && camera.pixelsPerUnit > 0 &&
               std::isfinite(camera.pixelsPerUnit) && camera.centre.allFinite();
    projection = attractor::projection(camera, placement(), request.appearance.supersample);
    iterations = request.algorithm == Algorithm::Deterministic
                     ? affordableIterations(system.maps.size(), request.iterations)
                     : 0;
    note = placementNote();
    if (!workers || workers->size() != static_cast<std::size_t>(request.threads))
        workers = std::make_unique<Workers>(static_cast<std::size_t>(request.threads));
    makeColours();
    cut.reset();
    passes = 0;
    exposure.reset();
    milliseconds = 0;
}

// Which coordinates bend the cage depends on system and rest alone, and is remembered with the rest.
ifs::Placement Picture::placement() {
    if (!request.cage || !ifs::isValid(*request.cage)) return {};
    if (ifs::bends(*request.cage) && bent != request.cage->rest) {
        const auto support = ifs::SupportFunction<2>::of(system.maps);
        coordinates =
            ifs::suitableCoordinates(request.cage->rest, support ? &*support : nullptr, shownPieces(system));
        bent = request.cage->rest;
    }
    return {*request.cage, coordinates};
}

void Picture::rewind(int firstRow, int endRow) {
    const int side = request.appearance.supersample;
    const int width = std::max(0, projection.grid.width);
    const CellWindow window{width, firstRow * side, std::max(firstRow, endRow) * side};
    sums.reset(coloured() ? CellKind::Colour : CellKind::Count, window, workers->size());
    orbit.reset();
    jobs.clear();
    nextJobs.clear();
    sampleSets = 0;
    sinceCarry = 0;
    remaining = 0;
    drawn = 0;
    overAttractor = 0;
}

RenderNote Picture::placementNote() const {
    if (system.note != RenderNote::None) return system.note;
    if (request.algorithm == Algorithm::Deterministic && iterations < request.iterations)
        return RenderNote::FewerIterations;
    const bool bends = projection.cage.bend() != nullptr;
    const ifs::Vector<2> stretch = ifs::singularValues<2>(projection.cage.affine().linear);
    if (!bends && !(stretch[1] > 1e-6 * stretch[0])) return RenderNote::Degenerate;
    // Beyond this the camera's own centre has no digits left for a pixel; a bend is evaluated in double.
    const double farthest =
        std::max(request.camera.centre.cwiseAbs().maxCoeff(), system.halfExtent.maxCoeff());
    return request.camera.pixelsPerUnit * farthest * (bends ? 0x1p-45 : 0x1p-53) > 0.5 ? RenderNote::TooDeep
                                                                                       : RenderNote::None;
}

void Picture::makeColours() {
    colours.clear();
    const Appearance& look = request.appearance;
    if (look.colourBy == ColourBy::Map) {
        for (const std::size_t place : system.index)
            colours.push_back(colourCell(mapColour(look, request.system.maps[place].id, place)));
    } else if (look.colourBy == ColourBy::Address) {
        for (std::size_t i = 0; i < addressColours; ++i)
            colours.push_back(
                colourCell(colourAt(look.palette, (static_cast<double>(i) + 0.5) / addressColours)));
    }
}

const ColourCell& Picture::colourOf(std::uint32_t map, double addressCoordinate) const {
    if (request.appearance.colourBy == ColourBy::Map) return colours[map];
    const auto at = static_cast<std::size_t>(addressCoordinate * static_cast<double>(addressColours));
    return colours[std::min(at, addressColours - 1)];
}

bool Picture::finished() const {
    if (!drawable) return true;
    if (request.algorithm == Algorithm::ChaosGame) return drawn >= request.samples;
    if (request.algorithm == Algorithm::Deterministic) return passes > 0;
    return cut && cut->words.empty();
}

bool Picture::complete(const std::stop_token& stop) {
    if (!drawable) return true;
    switch (request.algorithm) {
    case Algorithm::ChaosGame:
        return completeOrbit(stop);
    case Algorithm::Deterministic:
        return completePreattractor(stop);
    default:
        return completeDensity(stop);
    }
}

// For the next sample set. Words that stand for others are chosen anew, so that all get their turn.
bool Picture::makeCut(const std::stop_token& stop) {
    if (cut && (!cut->isThinned || cutOfSet == sampleSets)) return true;
    CutSettings settings;
    settings.words = wordsFor(request.samples);
    settings.seed = sampleSets == 0 ? request.seed : mixed(request.seed) + sampleSets;
    settings.samples = static_cast<double>(request.samples);
    if (request.appearance.colourBy == ColourBy::Map) settings.minDepth = 1;
    if (request.appearance.colourBy == ColourBy::Address)
        for (std::size_t words = 1; words < 64 && system.maps.size() > 1; words *= system.maps.size())
            ++settings.minDepth;
    if (!(system.meanLogarithm < 0)) settings.maxDepth = settings.minDepth;
    // Without an attractor there are words of every length that grow, and none is ever small enough.
    if (system.note != RenderNote::None) settings.mostLooks = 1U << 20;
    AddressCut fresh = addressCut(system, projection, settings, stop, &cutMemory);
    if (stop.stop_requested()) return false;
    // A map that does not contract may lead to words so deep that their measure is 0 to the arithmetic.
    if (fresh.probability < std::numeric_limits<double>::min()) fresh = {};
    cut = std::move(fresh);
    cutOfSet = sampleSets;
    return true;
}

bool Picture::completeDensity(const std::stop_token& stop) {
    if (!cut && !makeCut(stop)) return false;
    while (true) {
        runJobs(stop);
        if (jobsLeft()) return false;
        if (remaining == 0) return true;
        if (!makeCut(stop)) return false;
        if (cut->words.empty()) {
            remaining = 0;
            return true;
        }
        planSampleSet();
    }
}

// Systematic rounding: word k gets the whole numbers between two partial sums, so that its expectation is
// exact.
void Picture::planSampleSet() {
    const std::uint64_t number =
        std::min(remaining, system.meanLogarithm < 0 ? mostPerSampleSet : mostUninstanced);
    if (!coloured() && sinceCarry + number >= std::uint64_t{1} << 32) {
        sums.carryOverCounts();
        sinceCarry = 0;
    }
    drawSamples(system, request.seed, sampleSets, samples);
    const double perMeasure = static_cast<double>(number) / cut->probability;
    double sum = unitInterval(mixed(mixed(request.seed) ^ sampleSets));
    std::uint64_t before = 0;
    counts.clear();
    const CellWindow& window = sums.window();
    const bool whole = window.firstRow <= 0 && window.endRow >= projection.grid.height;
    for (std::size_t k = 0; k < cut->words.size(); ++k) {
        const Word& word = cut->words[k];
        sum += word.probability * perMeasure;
        const auto after = static_cast<std::uint64_t>(sum);
        // Where samples that go through the cage one by one may fall, the word does not tell.
        const bool counted = whole || k >= cut->firstExact || meets(word, samples, window, cut->curveOf(k));
        counts.push_back(counted ? after - before : 0);
        sinceCarry += counts.back();
        before = after;
    }
    planJobs();
    overAttractor += perMeasure;
    drawn += before;
    remaining -= number;
    ++sampleSets;
}

void Picture::planJobs() {
    jobs.clear();
    Job job;
    std::uint64_t planned = 0;
    const auto close = [&](std::size_t end) {
        job.endWord = static_cast<std::uint32_t>(end);
        if (job.endWord > job.firstWord) jobs.push_back(job);
        job.firstWord = job.endWord;
        planned = 0;
    };
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] > samplesPerJob) {
            close(k);
            for (std::uint64_t rest = counts[k]; rest > 0; rest -= std::min(rest, samplesPerJob))
                jobs.push_back({job.firstWord, job.firstWord + 1, std::min(rest, samplesPerJob)});
            ++job.firstWord;
            continue;
        }
        planned += counts[k];
        if (planned >= samplesPerJob) close(k + 1);
    }
    close(counts.size());
    nextJobs = std::vector<std::atomic<std::size_t>>(workers->size());
    for (std::size_t share = 1; share < nextJobs.size(); ++share)
        nextJobs[share] = endOfJobs(share - 1);
}

// Every thread begins with a share of its own, so that threads count in different parts of the picture, and
// then helps with the others'.
void Picture::runJobs(const std::stop_token& stop) {
    if (!jobsLeft()) return;
    workers->run([&](std::size_t thread) {
        for (std::size_t turn = 0; turn < nextJobs.size(); ++turn) {
            const std::size_t share = (thread + turn) % nextJobs.size();
            while (!stop.stop_requested()) {
                const std::size_t job = nextJobs[share].fetch_add(1);
                if (job >= endOfJobs(share)) break;
                runJob(jobs[job], thread);
            }
        }
    });
    for (std::size_t share = 0; share < nextJobs.size(); ++share)
        nextJobs[share] = std::min(nextJobs[share].load(), endOfJobs(share));
}

bool Picture::jobsLeft() const {
    for (std::size_t share = 0; share < nextJobs.size(); ++share)
        if (nextJobs[share] < endOfJobs(share)) return true;
    return false;
}

void Picture::runJob(const Job& job, std::size_t thread) {
    for (std::uint32_t k = job.firstWord; k < job.endWord; ++k) {
        const Word& word = cut->words[k];
        const std::uint64_t count = job.part > 0 ? job.part : counts[k];
        if (k >= cut->firstExact) {
            plotExactly(k, count, thread);
            continue;
        }
        const Curve* curve = cut->curveOf(k);
        const CellRegion cells = reachedCells(word, samples, sums.window(), curve);
        if (!coloured()) {
            splat(word, samples, count, sums.window(), sums.counts(thread, cells), curve);
        } else if (splat(word, samples, count, sums.window(), colourOf(word.firstMap, word.addressCoordinate),
                         sums.colours(thread, cells), curve)) {
            sums.carryOverColours(thread);
        }
    }
}

bool Picture::completeOrbit(const std::stop_token& stop) {
    if (!orbit) orbit.emplace(system, request.seed);
    remaining = std::min(remaining, request.samples - std::min(request.samples, drawn));
    while (remaining > 0) {
        if (stop.stop_requested()) return false;
        const std::uint64_t run = std::min<std::uint64_t>(remaining, 8192);
        if (!coloured() && sinceCarry + run >= std::uint64_t{1} << 32) {
            sums.carryOverCounts();
            sinceCarry = 0;
        }
        for (std::uint64_t n = 0; n < run; ++n) {
            const Orbit::Point point = orbit->next();
            if (plot(point.x, coloured() ? &colourOf(point.lastMap, point.addressCoordinate) : nullptr, 0))
                sums.carryOverColours(0);
        }
        sinceCarry += run;
        drawn += run;
        remaining -= run;
    }
    return true;
}

// The samples of a word that bends too much for a second-order map, in coordinates of the code.
void Picture::plotExactly(std::uint32_t k, std::uint64_t count, std::size_t thread) {
    const Word& word = cut->words[k];
    const ifs::AffineMap<2>& map = cut->exact[k - cut->firstExact];
    const ColourCell* colour = coloured() ? &colourOf(word.firstMap, word.addressCoordinate) : nullptr;
    for (std::uint64_t n = 0; n < count; ++n) {
        const std::size_t at = word.offset + static_cast<std::size_t>(n % SampleSet::size);
        if (plot(map({samples.x[at], samples.y[at]}), colour, thread)) sums.carryOverColours(thread);
    }
}

// Counts one point of the code; true when some sum of colours is past 2³¹ and wants to be carried over.
bool Picture::plot(const ifs::Vector<2>& x, const ColourCell* colour, std::size_t thread) {
    const ifs::Vector<2> place = projection.cell(projection.cage(x));
    const CellWindow& window = sums.window();
    if (!(place.x() >= 0 && place.x() < window.width && place.y() >= window.firstRow &&
          place.y() < window.endRow))
        return false;
    const std::size_t cell = static_cast<std::size_t>(static_cast<int>(place.y()) - window.firstRow) *
                                 static_cast<std::size_t>(window.width) +
                             static_cast<std::size_t>(place.x());
    if (colour == nullptr) {
        ++sums.counts(thread)[cell];
        return false;
    }
    ColourCell& sum = sums.colours(thread)[cell];
    sum.samples += 1;
    sum.red += colour->red;
    sum.green += colour->green;
    sum.blue += colour->blue;
    return (sum.samples | sum.red | sum.green | sum.blue) >> 31 != 0;
}

std::vector<ifs::Vector<2>> Picture::restPolygon() const {
    if (request.cage && ifs::isValid(*request.cage)) return request.cage->rest;
    const ifs::Vector<2> low = system.centre - system.halfExtent;
    const ifs::Vector<2> high = system.centre + system.halfExtent;
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

bool Picture::completePreattractor(const std::stop_token& stop) {
    if (remaining == 0) return true;
    sums.reset(sums.kind(), sums.window(), workers->size());
    const Preattractor job{system, restPolygon(), iterations};
    const auto colour = [this](std::uint32_t map, double place) {
        return coloured() ? colourOf(map, place) : ColourCell{};
    };
    if (!job.draw(projection, colour, sums, stop)) return false;
    remaining = 0;
    return true;
}

Frame Picture::frame(Frame reuse, const std::stop_token& stop, const std::optional<Exposure>& other) {
    Frame result;
    result.pixels = std::move(reuse.pixels);
    result.revision = request.revision;
    result.camera = request.camera;
    result.samples = drawn;
    result.measure = cut ? cut->probability : 1;
    result.passes = passes;
    result.iterations = iterations;
    result.note = note;
    result.opaque = request.appearance.background.alpha == 255;
    result.milliseconds = milliseconds;
    const auto width = static_cast<std::size_t>(std::max(0, request.camera.width));
    const auto height = static_cast<std::size_t>(std::max(0, request.camera.height));
    result.pixels.resize(width * height);
    if (width * height == 0) return result;
    measureExposure(stop);
    if (stop.stop_requested()) return result;
    result.exposure = *exposure;
    result.shown = other ? *other : *exposure;
    tonePixels(result.shown, result.pixels, stop);
    return result;
}

void Picture::measureExposure(const std::stop_token& stop) {
    if (request.algorithm == Algorithm::Deterministic)
        exposure = Exposure{1, 16, 1}; // what one image covers has density 1
    if (request.algorithm == Algorithm::ChaosGame && exposedAt != drawn) exposure.reset(); // few tell little
    if (exposure) return;
    exposedAt = drawn;
    const Exposure measured = measuredExposure(sums, request.appearance, request.appearance.supersample,
                                               samplesOverAttractor(), request.exposure, *workers, stop);
    if (!stop.stop_requested()) exposure = measured;
}

ToneSettings Picture::toneSettings(const Exposure& shown) const {
    const int side = request.appearance.supersample;
    ToneSettings settings{request.appearance, side, 0, shown.whitePoint, shown.gain};
    if (request.algorithm == Algorithm::Deterministic)
        settings.densityPerSample = 1;
    else if (samplesOverAttractor() > 0)
        settings.densityPerSample = side * side / (samplesOverAttractor() * shown.meanDensity);
    return settings;
}

std::uint64_t Picture::mostInACell() const {
    return request.algorithm == Algorithm::Deterministic ? 1U << 20 : drawn;
}

void Picture::tonePixels(const Exposure& shown, std::span<std::uint32_t> pixels,
                         const std::stop_token& stop) {
    const ToneMap toneMap(toneSettings(shown), mostInACell());
    const int side = request.appearance.supersample;
    const int rows = (sums.window().endRow - sums.window().firstRow) / side;
    constexpr int together = 16; // between two looks at the stop token
    std::atomic<int> next = 0;
    workers->run([&](std::size_t) {
        while (!stop.stop_requested()) {
            const int row = next.fetch_add(together);
            if (row >= rows) return;
            toneMap.apply(sums, row, std::min(rows, row + together), pixels);
        }
    });
}

} // namespace attractor
