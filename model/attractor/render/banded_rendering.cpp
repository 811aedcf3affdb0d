// SPDX-License-Identifier: MIT
#include "attractor/render/banded_rendering.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/folds/density_fold.h"
#include "attractor/light/shadow_layer.h"
#include "attractor/render/render_state.h"
#include "attractor/request/shadow.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace attractor {

namespace {

using Progress = BandedRendering::Progress;

constexpr double shareOfMeasuring = 0.1;  // share of the first band's progress
constexpr double shareOfPicture = 0.6;    // share of the progress if there is a shadow
constexpr double maxRelativeMeasure = 16; // largest ratio of a moment's measure to that of the first moment

void tell(const Progress& progress, double fraction) {
    if (progress) progress(fraction);
}

} // namespace

struct BandedRendering::State {
    RenderState render;
    std::optional<Exposure> exposure; // exposure of the whole picture
    std::optional<DividedPicture> divided;
    std::vector<RenderRequest> moments; // moments of a shutter
    std::unique_ptr<State> shadow;      // nullptr: no shadow
    ShadowLayer layer;                  // layer of the shadow

    void start(RenderRequest request);
    bool drawPass(std::uint64_t number, const std::stop_token& stop, const Progress& progress);
    bool draw(int firstRow, int rows, std::uint64_t number, const std::stop_token& stop);
    bool drawAll(int firstRow, int rows, const std::stop_token& stop, const Progress& progress);
    bool drawMoment(const RenderRequest& moment, double& firstMeasure, const std::stop_token& stop,
                    const Progress& progress);
    bool drawMoments(const std::stop_token& stop, const Progress& progress);
    std::optional<double> measureSmall(const std::stop_token& stop);
    bool measureStrips(double inView, const std::stop_token& stop);
    bool measure(const std::stop_token& stop);
    template <class Pixel>
    bool band(int firstRow, int rows, std::span<Pixel> pixels, const std::stop_token& stop,
              const Progress& progress);
    template <class Pixel>
    bool layOverShadow(int firstRow, int rows, std::span<Pixel> pixels, const std::stop_token& stop,
                       const Progress& progress);
};

void BandedRendering::State::start(RenderRequest request) {
    if (std::optional<RenderRequest> ofShadow = shadowRequest(request)) {
        shadow = std::make_unique<State>();
        shadow->start(*std::move(ofShadow));
        layer = {request.appearance.shadow, request.appearance.background};
        request = requestAboveShadow(std::move(request));
    }
    render.start(std::move(request));
    render.rewind(0, 0);
}

bool BandedRendering::State::drawPass(std::uint64_t number, const std::stop_token& stop,
                                      const Progress& progress) {
    constexpr std::uint64_t slice = std::uint64_t{1} << 26; // whole sample sets
    for (std::uint64_t done = 0; done < number; done += std::min(slice, number - done)) {
        tell(progress, static_cast<double>(done) / static_cast<double>(number));
        render.fold().begin(std::min(slice, number - done));
        if (!render.complete(stop)) return false;
        if (render.finished()) return true;
    }
    return true;
}

// The first `number` samples of the picture, those that fall into the rows.
bool BandedRendering::State::draw(int firstRow, int rows, std::uint64_t number, const std::stop_token& stop) {
    render.rewind(firstRow, firstRow + rows);
    return drawPass(number, stop, {});
}

// Draws all samples of the picture in the rows.
bool BandedRendering::State::drawAll(int firstRow, int rows, const std::stop_token& stop,
                                     const Progress& progress) {
    render.rewind(firstRow, firstRow + rows);
    if (!moments.empty()) return drawMoments(stop, progress);
    if (!divided) return drawPass(render.request().samples, stop, progress);
    auto& fold = dynamic_cast<DensityFold&>(render.fold());
    const double share = 1 / static_cast<double>(divided->passes.size());
    double before = 0;
    for (const DividedPicture::Pass& pass : divided->passes) {
        fold.setPart(pass.part);
        const auto told = [&](double fraction) { tell(progress, before + share * fraction); };
        if (!drawPass(pass.samples, stop, told)) return false;
        before += share;
    }
    return !divided->others || divided->others(fold.sums());
}

// Shows the attractor as densely as the first moment does: where more of it is in view, it takes more
// samples.
bool BandedRendering::State::drawMoment(const RenderRequest& moment, double& firstMeasure,
                                        const std::stop_token& stop, const Progress& progress) {
    render.start(moment);
    render.fold().begin(0);
    if (!render.complete(stop)) return false;
    const double measure = render.fold().measure();
    if (!(firstMeasure > 0)) firstMeasure = measure;
    const double relative = firstMeasure > 0 ? std::min(measure / firstMeasure, maxRelativeMeasure) : 1;
    return drawPass(static_cast<std::uint64_t>(static_cast<double>(moment.samples) * relative + 0.5), stop,
                    progress);
}

// Sample sets go on counting, so that a moment of the next frame has the same ones.
bool BandedRendering::State::drawMoments(const std::stop_token& stop, const Progress& progress) {
    const RenderRequest whole = render.request();
    const double share = 1 / static_cast<double>(moments.size());
    double firstMeasure = 0;
    bool isDrawn = true;
    for (std::size_t k = 0; k < moments.size() && isDrawn; ++k)
        isDrawn = drawMoment(moments[k], firstMeasure, stop, [&](double fraction) {
            tell(progress, share * (static_cast<double>(k) + fraction));
        });
    render.start(whole);
    return isDrawn;
}

// White point and gain, from a small picture of the same view. Returns the share of the samples that fall
// into the view; nullopt when stopped.
std::optional<double> BandedRendering::State::measureSmall(const std::stop_token& stop) {
    RenderRequest job = render.request();
    const int side = job.appearance.supersample;
    const double smallPixels = std::min(1e6, 4e6 / (side * side));
    if (coloursSamples(job.appearance.colourBy)) job.appearance.colourBy = ColourBy::Plain;
    const double pixels = static_cast<double>(job.camera.width) * job.camera.height;
    const double scale = std::min(1.0, std::sqrt(smallPixels / pixels));
    job.camera.width = std::max(1, static_cast<int>(job.camera.width * scale));
    job.camera.height = std::max(1, static_cast<int>(job.camera.height * scale));
    job.camera.pixelsPerUnit *= scale;
    job.samples = std::min<std::uint64_t>(job.samples, 8'000'000);
    RenderState small;
    small.start(std::move(job));
    small.rewind(0, small.request().camera.height);
    small.fold().begin(small.request().samples);
    if (!small.complete(stop)) return std::nullopt;
    exposure = small.fold().exposure({});
    const double drawnSamples = small.fold().samplesOverAttractor();
    return drawnSamples > 0 ? small.fold().occupancy(1).samples / drawnSamples : 0;
}

// The mean density comes from some strips of the large picture itself: how many of its pixels are occupied
// depends on their size. Two samples per pixel tell it as well as many.
bool BandedRendering::State::measureStrips(double inView, const std::stop_token& stop) {
    constexpr int strips = 16;
    const Camera& camera = render.request().camera;
    const Fold& fold = render.fold();
    const double pixels = static_cast<double>(camera.width) * camera.height;
    const auto number = std::min(render.request().samples,
                                 std::max<std::uint64_t>(1'000'000, static_cast<std::uint64_t>(2 * pixels)));
    const int pitch = std::max(1, camera.height / strips);
    const int height = std::clamp(100'000 / camera.width, 1, pitch);
    Occupancy whole;
    for (int strip = 0; strip * pitch + height <= camera.height; ++strip) {
        const auto room = static_cast<std::uint64_t>(pitch - height) + 1;
        const int jitter = static_cast<int>(mixed(static_cast<std::uint64_t>(strip)) % room);
        if (!draw(std::min(strip * pitch + jitter, camera.height - height), height, number, stop))
            return false;
        const double share = referenceShare(pixels, inView * fold.samplesOverAttractor());
        const Occupancy part = fold.occupancy(share);
        whole.samples += part.samples;
        whole.occupied += part.occupied;
    }
    exposure->meanDensity =
        whole.occupied > 0 ? whole.samples / whole.occupied / fold.samplesOverAttractor() : 1;
    return true;
}

// False when stopped: there is no exposure then.
bool BandedRendering::State::measure(const std::stop_token& stop) {
    if (!render.isDrawable() || render.fold().hasFixedExposure()) {
        exposure = render.fold().exposure({});
        return true;
    }
    const std::optional<double> inView = measureSmall(stop);
    if (inView && measureStrips(*inView, stop)) return true;
    exposure.reset();
    return false;
}

template <class Pixel>
bool BandedRendering::State::band(int firstRow, int rows, std::span<Pixel> pixels,
                                  const std::stop_token& stop, const Progress& progress) {
    if (pixels.empty()) return true;
    const double begin = exposure ? 0 : shareOfMeasuring;
    if (!exposure && !measure(stop)) return false;
    const double end = shadow ? shareOfPicture : 1;
    const auto drawing = [&](double fraction) { tell(progress, end * (begin + (1 - begin) * fraction)); };
    if (!drawAll(firstRow, rows, stop, drawing)) return false;
    if (!render.fold().tone(*exposure, pixels, stop)) return false;
    if (shadow && !layOverShadow(firstRow, rows, pixels, stop,
                                 [&](double fraction) { tell(progress, end + (1 - end) * fraction); }))
        return false;
    tell(progress, 1);
    return true;
}

// The shadow has its own mean density, which follows from its size, and else the exposure of the picture.
template <class Pixel>
bool BandedRendering::State::layOverShadow(int firstRow, int rows, std::span<Pixel> pixels,
                                           const std::stop_token& stop, const Progress& progress) {
    if (!shadow->exposure && !shadow->measure(stop)) return false;
    shadow->exposure->whitePoint = exposure->whitePoint;
    shadow->exposure->gain = exposure->gain;
    std::vector<Pixel> under(pixels.size());
    if (!shadow->band(firstRow, rows, std::span<Pixel>(under), stop, progress)) return false;
    layer.putUnder(pixels, under);
    return true;
}

BandedRendering::BandedRendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    m_state->start(std::move(request));
}

BandedRendering::~BandedRendering() = default;
BandedRendering::BandedRendering(BandedRendering&&) noexcept = default;
BandedRendering& BandedRendering::operator=(BandedRendering&&) noexcept = default;

std::size_t BandedRendering::bytesPerRow(const RenderRequest& request) {
    const auto side = static_cast<std::size_t>(std::clamp(request.appearance.supersample, 1, 4));
    const auto threads = static_cast<std::size_t>(std::clamp(request.threads, 1, 256));
    // Includes the 64-bit sums that receive full counters.
    const std::size_t cell = coloursSamples(request.appearance.colourBy)
                                 ? threads * (sizeof(ColourCell) + sizeof(CellSums::Sum))
                                 : threads * sizeof(std::uint32_t) + sizeof(std::uint64_t);
    const std::size_t layers = hasShadow(request) ? 2 : 1;
    return static_cast<std::size_t>(std::max(1, request.camera.width)) * side * side * cell * layers;
}

int BandedRendering::rowsWithin(const RenderRequest& request, std::size_t bytes) {
    constexpr std::size_t maxCells = std::size_t{1} << 30; // limit of 32-bit cell numbers
    const auto side = static_cast<std::size_t>(std::clamp(request.appearance.supersample, 1, 4));
    const auto width = static_cast<std::size_t>(std::max(1, request.camera.width));
    const auto height = static_cast<std::size_t>(std::max(1, request.camera.height));
    return static_cast<int>(std::clamp<std::size_t>(
        std::min(bytes / bytesPerRow(request), maxCells / (width * side * side)), 1, height));
}

bool BandedRendering::band(int firstRow, int rows, std::span<std::uint32_t> pixels,
                           const std::stop_token& stop, const Progress& progress) {
    return m_state->band(firstRow, rows, pixels, stop, progress);
}

bool BandedRendering::band(int firstRow, int rows, std::span<Rgba16> pixels, const std::stop_token& stop,
                           const Progress& progress) {
    return m_state->band(firstRow, rows, pixels, stop, progress);
}

void BandedRendering::divide(DividedPicture picture) {
    State& state = *m_state;
    // Drawn completely in this run, with the samples of all passes.
    if (state.shadow && !picture.passes.empty()) {
        double samples = 0;
        for (const DividedPicture::Pass& pass : picture.passes)
            samples += static_cast<double>(pass.samples);
        RenderRequest ofShadow = state.shadow->render.request();
        const double passes =
            samples / static_cast<double>(std::max<std::uint64_t>(1, picture.passes.front().samples));
        ofShadow.samples = static_cast<std::uint64_t>(static_cast<double>(ofShadow.samples) * passes);
        state.shadow->start(std::move(ofShadow));
    }
    state.divided = std::move(picture);
}

void BandedRendering::openShutter(std::vector<RenderRequest> moments) {
    State& state = *m_state;
    if (state.shadow) state.shadow->moments.clear();
    for (RenderRequest& moment : moments) {
        moment.samples = std::max<std::uint64_t>(1, moment.samples / moments.size());
        moment.threads = state.render.request().threads;
        if (!state.shadow) continue;
        state.shadow->moments.push_back(shadowRequest(moment).value_or(state.shadow->render.request()));
        moment = requestAboveShadow(std::move(moment));
    }
    state.moments = std::move(moments);
}

std::uint64_t BandedRendering::units(std::span<const std::uint64_t> samples) const {
    std::uint64_t sets = 0;
    for (const std::uint64_t pass : samples)
        sets += sampleSetsFor(pass, m_state->render.prepared().system());
    return sets * PicturePart::unitsPerSet;
}

const CellSums* BandedRendering::sums(int firstRow, int rows, const std::stop_token& stop,
                                      const Progress& progress) {
    if (!m_state->drawAll(firstRow, rows, stop, progress)) return nullptr;
    return &dynamic_cast<const DensityFold&>(m_state->render.fold()).sums();
}

Exposure BandedRendering::exposure() const {
    return m_state->exposure.value_or(Exposure{});
}

void BandedRendering::useExposure(const Exposure& exposure) {
    m_state->exposure = exposure;
}

std::optional<Exposure> BandedRendering::measuredExposure(const std::stop_token& stop) {
    if (!m_state->exposure && !m_state->measure(stop)) return std::nullopt;
    return m_state->exposure;
}

RenderNote BandedRendering::note() const {
    return m_state->render.note();
}

} // namespace attractor
