// SPDX-License-Identifier: MIT
#include "attractor/banded_rendering.h"

#include "attractor/arithmetic.h"
#include "attractor/picture.h"
#include "attractor/tone_map.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

using Progress = BandedRendering::Progress;

constexpr double shareOfMeasuring = 0.1; // of the progress of the first band

void tell(const Progress& progress, double fraction) {
    if (progress) progress(fraction);
}

} // namespace

struct BandedRendering::State : Picture {
    bool draw(int firstRow, int rows, std::uint64_t number, const std::stop_token& stop,
              const Progress& progress = {});
    std::optional<double> measureSmall(const std::stop_token& stop);
    bool measure(const std::stop_token& stop);
    template <class Pixel>
    bool band(int firstRow, int rows, std::span<Pixel> pixels, const std::stop_token& stop,
              const Progress& progress);
    template <class Tones, class Pixel>
    bool tone(const Tones& tones, std::span<Pixel> pixels, const std::stop_token& stop);
};

// The first `number` samples of the picture, those that fall into the rows.
bool BandedRendering::State::draw(int firstRow, int rows, std::uint64_t number, const std::stop_token& stop,
                                  const Progress& progress) {
    constexpr std::uint64_t slice = std::uint64_t{1} << 26; // whole sample sets
    rewind(firstRow, firstRow + rows);
    if (request.algorithm == Algorithm::Deterministic) {
        remaining = number;
        return complete(stop);
    }
    for (std::uint64_t done = 0; done < number; done += std::min(slice, number - done)) {
        tell(progress, static_cast<double>(done) / static_cast<double>(number));
        remaining = std::min(slice, number - done);
        if (!complete(stop)) return false;
    }
    return true;
}

// White point and gain, from a small picture of the same view. Returns the share of the samples that fall
// into the view; nullopt when stopped.
std::optional<double> BandedRendering::State::measureSmall(const std::stop_token& stop) {
    const int side = request.appearance.supersample;
    const double smallPixels = std::min(1e6, 4e6 / (side * side));
    Picture small;
    RenderRequest job = request;
    if (coloured()) job.appearance.colourBy = ColourBy::Plain;
    const double pixels = static_cast<double>(request.camera.width) * request.camera.height;
    const double scale = std::min(1.0, std::sqrt(smallPixels / pixels));
    job.camera.width = std::max(1, static_cast<int>(request.camera.width * scale));
    job.camera.height = std::max(1, static_cast<int>(request.camera.height * scale));
    job.camera.pixelsPerUnit *= scale;
    job.samples = std::min<std::uint64_t>(request.samples, 8'000'000);
    small.start(std::move(job));
    small.rewind(0, small.request.camera.height);
    small.remaining = small.request.samples;
    if (!small.complete(stop)) return std::nullopt;
    small.measureExposure();
    exposure = small.exposure;
    const double drawnSamples = small.samplesOverAttractor();
    return drawnSamples > 0 ? occupancy(small.sums, side, 1, *small.workers).samples / drawnSamples : 0;
}

// The mean density comes from some strips of the large picture itself: how many of its pixels are occupied
// depends on their size. Two samples a pixel tell it as well as many.
bool BandedRendering::State::measure(const std::stop_token& stop) {
    constexpr int strips = 16;
    if (!drawable || request.algorithm == Algorithm::Deterministic) {
        measureExposure();
        return true;
    }
    const std::optional<double> inView = measureSmall(stop);
    if (!inView) return false;
    const Camera& camera = request.camera;
    const double pixels = static_cast<double>(camera.width) * camera.height;
    const auto number =
        std::min(request.samples, std::max<std::uint64_t>(1'000'000, static_cast<std::uint64_t>(2 * pixels)));
    const int pitch = std::max(1, camera.height / strips);
    const int height = std::clamp(100'000 / camera.width, 1, pitch);
    Occupancy whole;
    for (int strip = 0; strip * pitch + height <= camera.height; ++strip) {
        const auto room = static_cast<std::uint64_t>(pitch - height) + 1;
        const int jitter = static_cast<int>(mixed(static_cast<std::uint64_t>(strip)) % room);
        if (!draw(std::min(strip * pitch + jitter, camera.height - height), height, number, stop)) {
            exposure.reset();
            return false;
        }
        const double share = referenceShare(pixels, *inView * samplesOverAttractor());
        const Occupancy part = occupancy(sums, request.appearance.supersample, share, *workers);
        whole.samples += part.samples;
        whole.occupied += part.occupied;
    }
    exposure->meanDensity = whole.occupied > 0 ? whole.samples / whole.occupied / samplesOverAttractor() : 1;
    return true;
}

template <class Tones, class Pixel>
bool BandedRendering::State::tone(const Tones& tones, std::span<Pixel> pixels, const std::stop_token& stop) {
    constexpr int slab = 8; // rows between two looks at the stop token
    const int rows = (sums.window().endRow - sums.window().firstRow) / request.appearance.supersample;
    std::atomic<int> next = 0;
    workers->run([&](std::size_t) {
        for (int row = next.fetch_add(slab); row < rows && !stop.stop_requested(); row = next.fetch_add(slab))
            tones.apply(sums, row, std::min(row + slab, rows), pixels);
    });
    return !stop.stop_requested();
}

template <class Pixel>
bool BandedRendering::State::band(int firstRow, int rows, std::span<Pixel> pixels,
                                  const std::stop_token& stop, const Progress& progress) {
    if (pixels.empty()) return true;
    const double begin = exposure ? 0 : shareOfMeasuring;
    if (!exposure && !measure(stop)) return false;
    const auto drawing = [&](double fraction) { tell(progress, begin + (1 - begin) * fraction); };
    if (!draw(firstRow, rows, request.samples, stop, drawing)) return false;
    if constexpr (sizeof(Pixel) == sizeof(std::uint32_t)) {
        if (!tone(ToneMap(toneSettings(*exposure), mostInACell()), pixels, stop)) return false;
    } else {
        if (!tone(ToneMap16(toneSettings(*exposure)), pixels, stop)) return false;
    }
    tell(progress, 1);
    return true;
}

BandedRendering::BandedRendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    m_state->start(std::move(request));
    m_state->rewind(0, 0);
}

BandedRendering::~BandedRendering() = default;
BandedRendering::BandedRendering(BandedRendering&&) noexcept = default;
BandedRendering& BandedRendering::operator=(BandedRendering&&) noexcept = default;

std::size_t BandedRendering::bytesPerRow(const RenderRequest& request) {
    const auto side = static_cast<std::size_t>(std::clamp(request.appearance.supersample, 1, 4));
    const auto threads = static_cast<std::size_t>(std::clamp(request.threads, 1, 256));
    const bool coloured =
        request.appearance.colourBy == ColourBy::Map || request.appearance.colourBy == ColourBy::Address;
    // The 64-bit sums into which full counters are carried over are counted as well.
    const std::size_t cell = coloured ? threads * (sizeof(ColourCell) + sizeof(CellSums::Sum))
                                      : threads * sizeof(std::uint32_t) + sizeof(std::uint64_t);
    return static_cast<std::size_t>(std::max(1, request.camera.width)) * side * side * cell;
}

int BandedRendering::rowsWithin(const RenderRequest& request, std::size_t bytes) {
    constexpr std::size_t mostCells = std::size_t{1} << 30; // cells are numbered with 32 bits
    const auto side = static_cast<std::size_t>(std::clamp(request.appearance.supersample, 1, 4));
    const auto width = static_cast<std::size_t>(std::max(1, request.camera.width));
    const auto height = static_cast<std::size_t>(std::max(1, request.camera.height));
    return static_cast<int>(std::clamp<std::size_t>(
        std::min(bytes / bytesPerRow(request), mostCells / (width * side * side)), 1, height));
}

bool BandedRendering::band(int firstRow, int rows, std::span<std::uint32_t> pixels,
                           const std::stop_token& stop, const Progress& progress) {
    return m_state->band(firstRow, rows, pixels, stop, progress);
}

bool BandedRendering::band(int firstRow, int rows, std::span<Rgba16> pixels, const std::stop_token& stop,
                           const Progress& progress) {
    return m_state->band(firstRow, rows, pixels, stop, progress);
}

Exposure BandedRendering::exposure() const {
    return m_state->exposure.value_or(Exposure{});
}

RenderNote BandedRendering::note() const {
    return m_state->note;
}

} // namespace attractor
