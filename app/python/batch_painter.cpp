// SPDX-License-Identifier: MIT
#include "python/batch_painter.h"

#include "attractor/kernels/kernels.h"
#include "attractor/samples/prepared_system.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace python {

namespace {

constexpr std::size_t most = std::size_t{1} << 17; // points at once
constexpr double margin = 0.05;                    // as of other pictures

std::size_t roundedUp(std::size_t count, std::size_t step) {
    return (count + step - 1) / step * step;
}

// Where a few points lie is enough for the coordinates in which the others are drawn.
void boxAround(attractor::PreparedSystem& system, std::uint64_t seed) {
    constexpr int looks = 64;
    attractor::Orbit orbit(system, seed);
    ifs::Vector<2> low = orbit.next().x, high = low;
    for (int i = 1; i < looks; ++i) {
        const ifs::Vector<2> x = orbit.next().x;
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const double least = std::max((high - low).maxCoeff() * 1e-3, 1e-12);
    system.centre = (low + high) / 2;
    system.halfExtent = ((high - low) / 2).cwiseMax(least);
}

attractor::PreparedSystem preparedWithoutBox(const std::vector<ifs::AffineMap<2>>& maps,
                                             std::vector<double> probabilities) {
    attractor::PreparedSystem system;
    system.maps = maps;
    system.probabilities = std::move(probabilities);
    for (std::size_t i = 0; i < maps.size(); ++i) {
        system.index.push_back(i);
        const double norm = ifs::spectralNorm<2>(maps[i].linear);
        if (norm > 0) system.meanLogarithm += system.probabilities[i] * std::log(norm);
    }
    return system;
}

// The position as the kernel computes it, which only grows or only falls between the extremes.
bool liesWithin(float scale, float shift, float low, float high, int size) {
    const float atLow = scale * low + 0.0F + shift, atHigh = scale * high + 0.0F + shift;
    return std::min(atLow, atHigh) >= 0 && std::max(atLow, atHigh) < float(size);
}

} // namespace

BatchPainter::BatchPainter(int height, int width, std::uint64_t samples)
    : m_height(height),
      m_width(width),
      m_samples(samples),
      m_x(roundedUp(std::size_t(std::min<std::uint64_t>(samples, most)), attractor::kernels::chunk)),
      m_y(m_x.size()) {}

std::size_t BatchPainter::sizeOf(std::uint64_t first) const {
    return std::size_t(std::min<std::uint64_t>(m_samples - first, most));
}

attractor::PointExtremes BatchPainter::draw(const attractor::PreparedSystem& system, std::uint64_t seed,
                                            std::uint64_t first) {
    const std::size_t size = roundedUp(sizeOf(first), attractor::kernels::Lanes::count);
    return attractor::drawPoints(system, seed, first / most, std::span(m_x).first(size),
                                 std::span(m_y).first(size));
}

attractor::Word BatchPainter::placed(const attractor::PreparedSystem& system,
                                     const attractor::PointExtremes& extremes) const {
    const auto [lowX, highX, lowY, highY] = extremes;
    // The least extent, that of a point, keeps the shifts small enough for a float.
    const auto extent = [](float low, float high) {
        return std::max(double(high) - double(low), 1e-4 * std::max({1.0F, std::abs(low), std::abs(high)}));
    };
    const ifs::Vector<2>& half = system.halfExtent;
    const double scale = (1 - 2 * margin) * std::min(m_width / (extent(lowX, highX) * half.x()),
                                                     m_height / (extent(lowY, highY) * half.y()));
    attractor::Word word;
    word.xx = float(scale * half.x());
    word.yy = float(-scale * half.y());
    word.x = float(m_width) / 2 - word.xx * ((lowX + highX) / 2);
    word.y = float(m_height) / 2 - word.yy * ((lowY + highY) / 2);
    if (liesWithin(word.xx, word.x, lowX, highX, m_width) &&
        liesWithin(word.yy, word.y, lowY, highY, m_height))
        return word;
    word.xx = word.yy = 0; // numbers too large or too small for a picture: all of it is in the middle
    word.x = float(m_width / 2);
    word.y = float(m_height / 2);
    return word;
}

void BatchPainter::paint(const std::vector<ifs::AffineMap<2>>& maps, std::vector<double> probabilities,
                         std::uint64_t seed, const std::stop_token& stop, std::uint32_t* counts) {
    if (m_samples == 0) return;
    attractor::PreparedSystem system = preparedWithoutBox(maps, std::move(probabilities));
    boxAround(system, seed);
    attractor::PointExtremes all = draw(system, seed, 0);
    for (std::uint64_t first = most; first < m_samples && !stop.stop_requested(); first += most) {
        const attractor::PointExtremes part = draw(system, seed, first);
        all = {std::min(all.lowX, part.lowX), std::max(all.highX, part.highX), std::min(all.lowY, part.lowY),
               std::max(all.highY, part.highY)};
    }
    const attractor::Word word = placed(system, all);
    for (std::uint64_t first = 0; first < m_samples && !stop.stop_requested(); first += most) {
        if (m_samples > most) draw(system, seed, first); // again: they would fill the memory
        attractor::kernels::addInside(word, {m_x.data(), m_y.data(), sizeOf(first)}, {m_width, 0, m_height},
                                      counts);
    }
}

} // namespace python
