// SPDX-License-Identifier: MIT
#include "attractor/render/cloud_rendering.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"
#include "attractor/cut/space_cut.h"
#include "attractor/folds/sample_colours.h"
#include "attractor/light/tone_map.h"
#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/space_samples.h"
#include "attractor/solid/depth_range.h"
#include "attractor/threads/job_shares.h"
#include "attractor/threads/workers.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace attractor {

namespace {

constexpr std::uint64_t maxPerSampleSet = 1U << 24; // samples; further ones come from a new set
constexpr int maxDepthLevel = 4095;                 // greatest depth level of a sample
constexpr std::size_t maxWordsPerJob = 64;          // words between two checks of the stop token
constexpr std::size_t samplesPerJob = 1U << 18; // approximate samples between two checks of the stop token

// Cells that a word can reach, with room for rounding; empty where it is not seen.
CellRegion reachedCells(const SpaceWord& word, float reach, const CellWindow& window) {
    constexpr float room = 1.0F / 64;
    const auto within = [](float value, int first, int end) {
        if (!(value > static_cast<float>(first))) return first;
        return value < static_cast<float>(end) ? static_cast<int>(value) : end;
    };
    const kernels::CloudWord& shown = word.shown;
    return {within(shown.x - reach * word.halfX - room, 0, window.width),
            std::min(window.width, within(shown.x + reach * word.halfX + room, 0, window.width) + 1),
            within(shown.y - reach * word.halfY - room, window.firstRow, window.endRow),
            std::min(window.endRow,
                     within(shown.y + reach * word.halfY + room, window.firstRow, window.endRow) + 1)};
}

bool isInside(const SpaceWord& word, float reach, const CellWindow& window) {
    return word.shown.x - reach * word.halfX >= 1 &&
           word.shown.x + reach * word.halfX <= static_cast<float>(window.width - 1) &&
           word.shown.y - reach * word.halfY >= static_cast<float>(window.firstRow + 1) &&
           word.shown.y + reach * word.halfY <= static_cast<float>(window.endRow - 1);
}

} // namespace

struct CloudRendering::State {
    SpaceRequest request;
    PreparedSpace system;
    SpaceView view; // view in cells
    SampleColours colours;
    ColourCoordinates coordinates;
    RenderNote note = RenderNote::None;
    std::unique_ptr<Workers> workers;
    CellSums sums;
    std::optional<SpaceCut> cut;
    SpaceSamples sampleSet;
    std::vector<std::uint64_t> counts; // samples of each word
    std::uint64_t sampleSets = 0;
    std::uint64_t drawn = 0;
    std::uint64_t sinceCarry = 0;
    DepthRange depths; // depths for CloudColour::MeanDepth, in cells; found on demand
    bool knowsDepths = false;
    double overAttractor = 0; // number of samples, including those outside the view as if drawn
    std::optional<Exposure> exposure;
    std::optional<double> firstProbability; // probability of the cut of the first pass
    bool isFollowing = false;
    PicturePart part;

    bool showsDepth() const { return request.cloudColour == CloudColour::MeanDepth; }
    bool coloured() const { return showsDepth() || coloursSamples(request.appearance.colourBy); }
    bool isDrawable() const { return !system.maps.empty() && isUsable(request.camera); }
    void start(SpaceRequest newRequest);
    void clear(int firstRow, int endRow); // rows of cells
    std::uint64_t asDense(std::uint64_t samples);
    bool makeCut(std::uint64_t samples, const std::stop_token& stop);
    void plan(std::uint64_t samples);
    bool clearAll(std::size_t thread, const std::stop_token& stop);
    void drawWord(std::size_t k, std::size_t thread, const std::stop_token& stop);
    void plotExactly(std::size_t k, std::uint64_t count, const ColourCell* colour, std::size_t thread);
    bool pass(std::uint64_t samples, const std::stop_token& stop);
    CellSums coloursOfDepth(const std::stop_token& stop) const;
    Appearance shownAppearance() const;
    ToneSettings toneSettings(const Exposure& shown) const;
    template <class Tones, class Pixel>
    bool toneRows(const Tones& tones, std::span<Pixel> pixels, const std::stop_token& stop) const;
};

void CloudRendering::State::start(SpaceRequest newRequest) {
    const bool sameSystem =
        !system.maps.empty() && newRequest.system == request.system && newRequest.moved == request.moved;
    request = std::move(newRequest);
    request.appearance.supersample = std::clamp(request.appearance.supersample, 1, 4);
    if (!sameSystem) system = preparedSpace(request.system, request.moved);
    const int side = request.appearance.supersample;
    OrbitCamera camera = request.camera;
    camera.size.width = std::max(0, camera.size.width) * side;
    camera.size.height = std::max(0, camera.size.height) * side;
    const bool isPlaced = request.cage && ifs::isValid(*request.cage);
    const ifs::AffineMap<3> cage = isPlaced ? ifs::displayMap(*request.cage) : ifs::AffineMap<3>();
    SpaceRequest inCells = request;
    inCells.camera = camera;
    view = spaceView(inCells, cage);
    const ifs::Vector<3> stretch = ifs::singularValues<3>(cage.linear);
    note = system.note != RenderNote::None                   ? system.note
           : !view.bend && !(stretch[2] > 1e-6 * stretch[0]) ? RenderNote::Degenerate
                                                             : RenderNote::None;
    std::vector<ifs::MapId> ids;
    for (const std::size_t index : system.index)
        ids.push_back(request.system.maps[index].id);
    colours = SampleColours(request.appearance, ids, system.index);
    coordinates = colourCoordinates<3>(request.appearance, request.system, system);
    const auto threads = static_cast<std::size_t>(std::clamp(request.threads, 1, 256));
    if (!workers || workers->size() != threads) workers = std::make_unique<Workers>(threads);
    cut.reset();
    exposure.reset();
}

void CloudRendering::State::clear(int firstRow, int endRow) {
    sums.reset(coloured() ? CellKind::Colour : CellKind::Count, {view.size.width, firstRow, endRow},
               workers->size());
    part = {};
    sampleSets = drawn = sinceCarry = 0;
    overAttractor = 0;
    knowsDepths = false;
    firstProbability.reset();
    isFollowing = false;
}

// Number of samples that keeps the density of the first pass: more where a pass sees more of the attractor.
std::uint64_t CloudRendering::State::asDense(std::uint64_t samples) {
    if (!firstProbability) return samples;
    return static_cast<std::uint64_t>(static_cast<double>(samples) * (cut->probability / *firstProbability) +
                                      0.5);
}

// Words that stand for others are chosen anew for every sample set, so that all get their turn.
bool CloudRendering::State::makeCut(std::uint64_t samples, const std::stop_token& stop) {
    if (cut && !cut->isThinned) return true;
    SpaceCutSettings settings;
    settings.words = static_cast<int>(std::clamp<std::uint64_t>(samples / SampleSet::size, 128, 4096));
    settings.samples = static_cast<double>(samples);
    settings.seed = sampleSets == 0 ? request.seed : mixed(request.seed) + sampleSets;
    if (showsDepth()) settings.exactness = Exactness::All;
    if (!showsDepth()) settings.colours = coordinates;
    if (!showsDepth() && request.appearance.colourBy == ColourBy::Map) settings.minDepth = 1;
    const bool isBlend = request.appearance.colourBy == ColourBy::Blend && !system.contracts;
    if (!showsDepth() && (request.appearance.colourBy == ColourBy::Address || isBlend))
        for (std::size_t words = 1; words < 64 && system.maps.size() > 1; words *= system.maps.size())
            ++settings.minDepth;
    cut = spaceCut(system, view, settings, stop);
    return !stop.stop_requested();
}

// Systematic rounding: word k gets the whole numbers between two partial sums, so that its expectation is
// exact.
void CloudRendering::State::plan(std::uint64_t samples) {
    const std::uint64_t firstUnit = sampleSets * PicturePart::unitsPerSet;
    if (part.meets(firstUnit, firstUnit + PicturePart::unitsPerSet))
        drawSamples(system, request.seed, sampleSets, sampleSet);
    const double perMeasure = static_cast<double>(samples) / cut->probability;
    if (!firstProbability) firstProbability = cut->probability;
    double sum = static_cast<double>(mixed(mixed(request.seed) ^ sampleSets) >> 11) * 0x1p-53;
    std::uint64_t before = 0;
    counts.clear();
    for (std::size_t k = 0; k < cut->words.size(); ++k) {
        sum += cut->words[k].probability * perMeasure;
        const auto after = static_cast<std::uint64_t>(sum);
        const std::uint64_t unit = firstUnit + k * PicturePart::unitsPerSet / cut->words.size();
        counts.push_back(part.holds(unit) ? after - before : 0);
        before = after;
    }
    drawn += before;
    overAttractor += perMeasure;
    ++sampleSets;
}

void CloudRendering::State::plotExactly(std::size_t k, std::uint64_t count, const ColourCell* colour,
                                        std::size_t thread) {
    const ifs::AffineMap<3>& map = cut->exact[k - cut->firstExact];
    const CellWindow& window = sums.window();
    const double perDepth = maxDepthLevel / std::max(depths.far - depths.near, 1e-300);
    for (std::uint64_t n = 0; n < count; ++n) {
        const std::size_t i = cut->words[k].offset + static_cast<std::size_t>(n % SampleSet::size);
        const ifs::Vector<3> at = map({sampleSet.x[i], sampleSet.y[i], sampleSet.z[i]});
        if (view.clip && !view.clip->keeps(at)) continue;
        const double away = view.eyeDistance + at.z();
        if (view.isPerspective() && !(away >= nearestShare * view.eyeDistance)) continue;
        const auto seenAt = [&](double x) { return view.isPerspective() ? x * view.eyeDistance / away : x; };
        const double column = view.size.width / 2.0 + seenAt(at.x());
        const double row = view.size.height / 2.0 + seenAt(at.y());
        if (!(column >= 0 && column < window.width && row >= window.firstRow && row < window.endRow))
            continue;
        const auto rowOfWindow = static_cast<std::size_t>(row) - static_cast<std::size_t>(window.firstRow);
        const std::size_t cell =
            rowOfWindow * static_cast<std::size_t>(window.width) + static_cast<std::size_t>(column);
        if (!coloured()) {
            ++sums.counts(thread)[cell];
            continue;
        }
        ColourCell& found = sums.colours(thread)[cell];
        if (showsDepth()) {
            ++found.samples;
            found.red += static_cast<std::uint32_t>(
                std::clamp((at.z() - depths.near) * perDepth, 0.0, double{maxDepthLevel}) + 0.5);
            if ((found.samples | found.red) >> 31 != 0) sums.carryOverColours(thread);
            continue;
        }
        found.samples += colour->samples;
        found.red += colour->red;
        found.green += colour->green;
        found.blue += colour->blue;
        if ((found.samples | found.red | found.green | found.blue) >> 31 != 0) sums.carryOverColours(thread);
    }
}

// Clears everything, which takes a second for a large picture, once. False when stopped.
bool CloudRendering::State::clearAll(std::size_t thread, const std::stop_token& stop) {
    constexpr int together = 64;
    const CellWindow& window = sums.window();
    for (int row = window.firstRow; row < window.endRow; row += together) {
        if (stop.stop_requested()) return false;
        const CellRegion strip{0, window.width, row, std::min(window.endRow, row + together)};
        coloured() ? void(sums.colours(thread, strip)) : void(sums.counts(thread, strip));
    }
    return true;
}

void CloudRendering::State::drawWord(std::size_t k, std::size_t thread, const std::stop_token& stop) {
    const SpaceWord& word = cut->words[k];
    const ColourCell* colour =
        coloured() && !showsDepth() ? &colours.of(word.firstMap, word.addressCoordinate) : nullptr;
    if (k >= cut->firstExact) {
        if (clearAll(thread, stop)) plotExactly(k, counts[k], colour, thread);
        return;
    }
    const CellWindow& window = sums.window();
    if (counts[k] == 0) return;
    const CellRegion region = reachedCells(word, sampleSet.reach, window);
    if (region.firstColumn >= region.endColumn || region.firstRow >= region.endRow) return;
    std::uint32_t seen = 0;
    for (std::uint64_t left = counts[k]; left > 0;) {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left, SampleSet::size));
        left -= count;
        const kernels::SpaceRun run{sampleSet.x.data() + word.offset, sampleSet.y.data() + word.offset,
                                    sampleSet.z.data() + word.offset, count};
        if (colour == nullptr) {
            std::uint32_t* cells = sums.counts(thread, region);
            if (isInside(word, sampleSet.reach, window))
                kernels::addInside(word.shown, run, window, cells);
            else
                kernels::addToCounts(word.shown, run, window, cells);
            continue;
        }
        ColourCell* cells = sums.colours(thread, region);
        // Cleared: samples outside the window must not influence the overflow check of its cells.
        std::fill_n(cells + window.cells(), overflowCells, ColourCell{});
        seen |= kernels::addToColours(word.shown, run, window, *colour, cells);
    }
    if (seen >> 31 != 0) sums.carryOverColours(thread);
}

bool CloudRendering::State::pass(std::uint64_t samples, const std::stop_token& stop) {
    if (isFollowing) {
        if (!makeCut(std::min(samples, maxPerSampleSet), stop)) return false;
        samples = asDense(samples);
    }
    if (showsDepth() && !knowsDepths) {
        depths = depthRange(system, view, stop);
        knowsDepths = !stop.stop_requested();
    }
    while (samples > 0) {
        const std::uint64_t number = std::min(samples, maxPerSampleSet);
        if (!makeCut(number, stop)) return false;
        if (!(cut->probability > 0)) return true;
        if (!coloured() && sinceCarry + number >= std::uint64_t{1} << 32) {
            sums.carryOverCounts();
            sinceCarry = 0;
        }
        sinceCarry += number;
        plan(number);
        const std::size_t words = cut->words.size();
        const std::size_t together =
            std::clamp<std::size_t>(samplesPerJob * words / number, 1, maxWordsPerJob);
        JobShares shares;
        shares.reset((words + together - 1) / together, *workers);
        shares.run(*workers, stop, [&](std::size_t job, std::size_t thread) {
            const std::size_t end = std::min(words, (job + 1) * together);
            for (std::size_t k = job * together; k < end; ++k)
                drawWord(k, thread, stop);
        });
        if (stop.stop_requested()) return false;
        samples -= number;
    }
    return true;
}

ToneSettings CloudRendering::State::toneSettings(const Exposure& shown) const {
    const int side = request.appearance.supersample;
    const double density = overAttractor > 0 ? side * side / (overAttractor * shown.meanDensity) : 0;
    return {shownAppearance(), side, density, shown.whitePoint, shown.gain};
}

template <class Tones, class Pixel>
bool CloudRendering::State::toneRows(const Tones& tones, std::span<Pixel> pixels,
                                     const std::stop_token& stop) const {
    constexpr int together = 16;
    const CellSums ofDepth = showsDepth() ? coloursOfDepth(stop) : CellSums();
    const CellSums& shown = showsDepth() ? ofDepth : sums;
    const int rows = std::max(0, request.camera.size.height);
    std::atomic<int> next = 0;
    workers->run([&](std::size_t) {
        while (!stop.stop_requested()) {
            const int row = next.fetch_add(together);
            if (row >= rows) return;
            tones.apply(shown, row, std::min(rows, row + together), pixels);
        }
    });
    return !stop.stop_requested();
}

// The appearance, with colours in the sums where they have some.
Appearance CloudRendering::State::shownAppearance() const {
    Appearance result = request.appearance;
    if (showsDepth()) result.colourBy = ColourBy::Address;
    return result;
}

// The sums with the colour of its mean depth in every cell; of some rows only when stopped.
CellSums CloudRendering::State::coloursOfDepth(const std::stop_token& stop) const {
    std::vector<LinearColour> palette;
    for (int level = 0; level <= maxDepthLevel; ++level)
        palette.push_back(linearColourAt(request.appearance.palette, 1 - level / double{maxDepthLevel}));
    CellSums result;
    const CellWindow& window = sums.window();
    result.reset(CellKind::Colour, window, 1);
    std::vector<CellSums::Sum> row;
    for (int y = window.firstRow; y < window.endRow && !stop.stop_requested(); ++y) {
        if (!sums.sumsOfRow(y, row)) continue;
        for (CellSums::Sum& sum : row) {
            if (sum.samples == 0) continue;
            const LinearColour& colour =
                palette[std::min<std::uint64_t>(maxDepthLevel, (sum.red + sum.samples / 2) / sum.samples)];
            const auto channel = [&](double linear) {
                return sum.samples * static_cast<std::uint64_t>(linear * maxDepthLevel + 0.5);
            };
            sum = {sum.samples, channel(colour.red), channel(colour.green), channel(colour.blue)};
        }
        result.addSums(y, 0, row);
    }
    return result;
}

CloudRendering::CloudRendering(SpaceRequest request) : m_state(std::make_unique<State>()) {
    restart(std::move(request));
}

CloudRendering::~CloudRendering() = default;
CloudRendering::CloudRendering(CloudRendering&&) noexcept = default;
CloudRendering& CloudRendering::operator=(CloudRendering&&) noexcept = default;

void CloudRendering::restart(SpaceRequest request) {
    m_state->start(std::move(request));
    m_state->clear(0, m_state->view.size.height);
}

void CloudRendering::follow(SpaceRequest request) {
    m_state->start(std::move(request));
    m_state->isFollowing = true;
}

void CloudRendering::setPart(const PicturePart& part) {
    m_state->part = part;
}

std::uint64_t CloudRendering::units(std::span<const std::uint64_t> samples) {
    std::uint64_t sets = 0;
    for (const std::uint64_t pass : samples)
        sets += (pass + maxPerSampleSet - 1) / maxPerSampleSet;
    return sets * PicturePart::unitsPerSet;
}

void CloudRendering::keepRows(int firstRow, int endRow) {
    const int side = m_state->request.appearance.supersample;
    m_state->clear(firstRow * side, endRow * side);
}

CellSums& CloudRendering::sums() {
    return m_state->sums;
}

void CloudRendering::useExposure(const Exposure& exposure) {
    m_state->exposure = exposure;
}

bool CloudRendering::refine(const std::stop_token& stop, std::uint64_t samples) {
    State& state = *m_state;
    if (!state.isDrawable()) return !stop.stop_requested();
    state.exposure.reset();
    return state.pass(samples > 0 ? samples : state.request.samples, stop);
}

Exposure CloudRendering::exposure(const std::stop_token& stop) const {
    State& state = *m_state;
    if (!state.exposure)
        state.exposure = measuredExposure(state.sums, state.shownAppearance(), state.overAttractor,
                                          state.request.exposure, *state.workers, stop);
    return *state.exposure;
}

bool CloudRendering::tone(std::span<std::uint32_t> pixels, const std::stop_token& stop) const {
    if (pixels.empty()) return true;
    const ToneSettings settings = m_state->toneSettings(exposure(stop));
    return m_state->toneRows(ToneMap(settings, m_state->drawn), pixels, stop);
}

bool CloudRendering::tone(std::span<Rgba16> pixels, const std::stop_token& stop) const {
    if (pixels.empty()) return true;
    const ToneSettings settings = m_state->toneSettings(exposure(stop));
    return m_state->toneRows(ToneMap16(settings), pixels, stop);
}

std::uint64_t CloudRendering::samples() const {
    return m_state->drawn;
}

RenderNote CloudRendering::note() const {
    return m_state->note;
}

} // namespace attractor
