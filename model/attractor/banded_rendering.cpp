// SPDX-License-Identifier: MIT
#include "attractor/banded_rendering.h"

#include "attractor/arithmetic.h"
#include "attractor/picture.h"
#include "attractor/tone_map.h"

#include <algorithm>
#include <cmath>

namespace attractor {

struct BandedRendering::State : Picture {
    bool draw(int firstRow, int rows, const std::stop_token& stop);
    std::optional<Exposure> smallExposure(const std::stop_token& stop) const;
    bool measure(const std::stop_token& stop);
};

bool BandedRendering::State::draw(int firstRow, int rows, const std::stop_token& stop) {
    rewind(firstRow, firstRow + rows);
    remaining = request.samples;
    return complete(stop);
}

// White point and gain, from a small picture of the same view.
std::optional<Exposure> BandedRendering::State::smallExposure(const std::stop_token& stop) const {
    constexpr double smallPixels = 1e6;
    if (request.exposure && request.exposure->whitePoint > 0) return request.exposure;
    RenderRequest small = request;
    const double pixels = static_cast<double>(request.camera.width) * request.camera.height;
    const double scale = std::min(1.0, std::sqrt(smallPixels / pixels));
    small.camera.width = std::max(1, static_cast<int>(request.camera.width * scale));
    small.camera.height = std::max(1, static_cast<int>(request.camera.height * scale));
    small.camera.pixelsPerUnit *= scale;
    small.samples = std::min<std::uint64_t>(request.samples, 8'000'000);
    Rendering rendering(small);
    if (!rendering.refine(stop)) return std::nullopt;
    return rendering.frame().exposure;
}

// The mean density comes from some strips of the large picture itself: how many of its pixels are occupied
// depends on their size.
bool BandedRendering::State::measure(const std::stop_token& stop) {
    constexpr int strips = 16;
    std::optional<Exposure> result = smallExposure(stop);
    if (!result) return false;
    if (!drawable || request.algorithm == Algorithm::Deterministic) {
        measureExposure();
        return true;
    }
    const Camera& camera = request.camera;
    const double share = referenceShare(static_cast<double>(camera.width) * camera.height,
                                        static_cast<double>(request.samples));
    const int pitch = std::max(1, camera.height / strips);
    const int height = std::clamp(100'000 / camera.width, 1, pitch);
    Occupancy whole;
    for (int strip = 0; strip * pitch + height <= camera.height; ++strip) {
        const auto room = static_cast<std::uint64_t>(pitch - height) + 1;
        const int jitter = static_cast<int>(mixed(static_cast<std::uint64_t>(strip)) % room);
        if (!draw(std::min(strip * pitch + jitter, camera.height - height), height, stop)) return false;
        const Occupancy part = occupancy(sums, request.appearance.supersample, share, *workers);
        whole.samples += part.samples;
        whole.occupied += part.occupied;
    }
    result->meanDensity = whole.occupied > 0 ? whole.samples / whole.occupied / samplesOverAttractor() : 1;
    exposure = result;
    return true;
}

BandedRendering::BandedRendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    m_state->start(std::move(request));
    m_state->rewind(0, 0);
}

BandedRendering::~BandedRendering() = default;
BandedRendering::BandedRendering(BandedRendering&&) noexcept = default;
BandedRendering& BandedRendering::operator=(BandedRendering&&) noexcept = default;

int BandedRendering::rowsWithin(std::size_t bytes) const {
    constexpr std::size_t mostCells = std::size_t{1} << 30; // cells are numbered with 32 bits
    const auto side = static_cast<std::size_t>(m_state->request.appearance.supersample);
    const std::size_t cell = m_state->coloured() ? sizeof(ColourCell) : sizeof(std::uint32_t);
    const auto width = static_cast<std::size_t>(std::max(1, m_state->request.camera.width));
    const auto height = static_cast<std::size_t>(std::max(1, m_state->request.camera.height));
    const std::size_t row = width * (side * side * cell * m_state->workers->size() + sizeof(std::uint32_t));
    return static_cast<int>(
        std::clamp<std::size_t>(std::min(bytes / row, mostCells / (width * side * side)), 1, height));
}

std::optional<std::vector<std::uint32_t>> BandedRendering::band(int firstRow, int rows,
                                                                std::stop_token stop) {
    const auto width = static_cast<std::size_t>(std::max(0, m_state->request.camera.width));
    std::vector<std::uint32_t> pixels(width * static_cast<std::size_t>(std::max(0, rows)));
    if (pixels.empty()) return pixels;
    if (!m_state->exposure && !m_state->measure(stop)) return std::nullopt;
    if (!m_state->draw(firstRow, rows, stop)) return std::nullopt;
    m_state->tonePixels(pixels);
    return pixels;
}

Exposure BandedRendering::exposure() const {
    return m_state->exposure.value_or(Exposure{});
}

RenderNote BandedRendering::note() const {
    return m_state->note;
}

} // namespace attractor
