// SPDX-License-Identifier: MIT
#include "attractor/tone_map.h"

#include "attractor/arithmetic.h"
#include "attractor/kernels.h"
#include "attractor/linear_light.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

using kernels::exactCounts;
constexpr double fullColour = 4095; // 12 bits a channel

// How many of the pixels would be occupied if only a share q of the samples had been drawn: rarefaction,
// which makes occupancy independent of the number of samples.
class Rarefied {
public:
    explicit Rarefied(double q) {
        double missed = 1;
        for (double& value : m_seen) {
            value = 1 - missed;
            missed *= 1 - q;
        }
    }
    double operator()(std::uint64_t samples) const {
        return m_seen[std::min<std::uint64_t>(samples, m_seen.size() - 1)];
    }

private:
    std::array<double, 4096> m_seen{};
};

// Samples per block of `side` × `side` cells, rows of blocks from the top.
struct Blocks {
    std::vector<std::uint64_t> samples;
};

Blocks blocks(const CellSums& sums, int side) {
    const CellWindow& window = sums.window();
    const int columns = (window.width + side - 1) / side;
    const int rows = (window.endRow - window.firstRow + side - 1) / side;
    Blocks result;
    result.samples.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    std::size_t cell = 0;
    for (int y = 0; y < window.endRow - window.firstRow; ++y) {
        std::uint64_t* row =
            result.samples.data() + static_cast<std::size_t>(y / side) * static_cast<std::size_t>(columns);
        for (int x = 0; x < window.width; ++x)
            row[x / side] += sums.samples(cell++);
    }
    return result;
}

struct Occupancy {
    double total = 0;  // samples in the picture
    double blocks = 0; // occupied, at the reference number of samples
};

Occupancy occupancy(const Blocks& blocks, double referenceSamples) {
    Occupancy result;
    for (const std::uint64_t samples : blocks.samples)
        result.total += static_cast<double>(samples);
    if (!(result.total > 0)) return result;
    const Rarefied seen(std::min(1.0, referenceSamples / result.total));
    for (const std::uint64_t samples : blocks.samples)
        if (samples > 0) result.blocks += seen(samples);
    return result;
}

// The 99.5 percentile relative to the mean, over blocks large enough that the noise of few samples is no part
// of it.
double whitePointOf(const CellSums& sums, int cellsPerPixel, double pixels, const Occupancy& perPixel,
                    double referenceSamples) {
    int side = 1;
    while (side < 16 && referenceSamples * side * side / perPixel.blocks < 64)
        side *= 2;
    Blocks large = blocks(sums, side * cellsPerPixel);
    const Occupancy occupied = occupancy(large, std::min(referenceSamples, pixels));
    const auto rank = static_cast<std::size_t>(0.005 * occupied.blocks);
    const auto nth =
        large.samples.begin() + static_cast<std::ptrdiff_t>(std::min(rank, large.samples.size() - 1));
    std::nth_element(large.samples.begin(), nth, large.samples.end(), std::greater<>());
    return static_cast<double>(*nth) * occupied.blocks / occupied.total;
}

constexpr double smallestWhitePoint = 4; // an even measure is shown below the brightest tone

} // namespace

double tone(double density, double brightness, double whitePoint, double gamma) {
    const double ratio =
        naturalLogarithm(1 + brightness * density) / naturalLogarithm(1 + brightness * whitePoint);
    return std::clamp(power(ratio, 1 / gamma), 0.0, 1.0);
}

Exposure measuredExposure(const CellSums& sums, const Appearance& appearance, int cellsPerPixel,
                          double samples) {
    const Blocks perPixel = blocks(sums, cellsPerPixel);
    const auto pixels = static_cast<double>(perPixel.samples.size());
    const double referenceSamples = pixels / 2;
    const Occupancy occupied = occupancy(perPixel, referenceSamples);
    Exposure exposure;
    if (!(occupied.total > 0) || !(samples > 0)) return {0, smallestWhitePoint, 1};
    exposure.meanDensity = occupied.total / occupied.blocks / samples;
    exposure.whitePoint =
        std::max(smallestWhitePoint, whitePointOf(sums, cellsPerPixel, pixels, occupied, referenceSamples));
    if (cellsPerPixel == 1) return exposure;
    // Averaging light over cells dims what is thinner than a pixel; the gain restores the mean.
    const auto light = [&](double density) {
        return linearFromEncoded(tone(density, appearance.brightness, exposure.whitePoint, appearance.gamma));
    };
    const double perSample = 1 / (samples * exposure.meanDensity);
    const double area = cellsPerPixel * cellsPerPixel;
    double whole = 0;
    for (const std::uint64_t count : perPixel.samples)
        whole += count > 0 ? light(static_cast<double>(count) * perSample) : 0;
    double split = 0;
    for (std::size_t cell = 0; cell < sums.window().cells(); ++cell)
        if (const std::uint64_t count = sums.samples(cell); count > 0)
            split += light(static_cast<double>(count) * perSample * area) / area;
    exposure.gain = split > 0 ? std::clamp(whole / split, 1.0, static_cast<double>(cellsPerPixel)) : 1;
    return exposure;
}

double ToneMap::samplesOf(std::size_t index) {
    if (index < exactCounts) return static_cast<double>(index);
    const std::size_t step = index - exactCounts;
    const auto exponent = static_cast<int>(step / 256) + 9;
    return std::ldexp(256.5 + static_cast<double>(step % 256), exponent - 8);
}

ToneMap::ToneMap(const ToneSettings& settings, std::uint64_t mostSamples)
    : m_settings(settings),
      m_ownColours(settings.appearance.colourBy == ColourBy::Map ||
                   settings.appearance.colourBy == ColourBy::Address),
      m_mostSamples(mostSamples) {
    const Rgba& ground = settings.appearance.background;
    m_background = {static_cast<double>(ground.red), static_cast<double>(ground.green),
                    static_cast<double>(ground.blue)};
    m_codes.resize(4096);
    for (std::size_t i = 0; i < m_codes.size(); ++i)
        m_codes[i] = encoded(static_cast<double>(i) / fullColour);
    m_entries.resize(kernels::toneIndex(mostSamples) + 1);
    m_pixels.resize(m_entries.size());
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        m_entries[i] = entry(samplesOf(i));
        m_pixels[i] = plainPixel(m_entries[i]);
    }
}

ToneMap::Entry ToneMap::entry(double samples) const {
    const Appearance& look = m_settings.appearance;
    Entry result;
    if (!(samples > 0)) return result;
    const double v =
        tone(samples * m_settings.densityPerSample, look.brightness, m_settings.whitePoint, look.gamma);
    const Rgba colour = look.colourBy == ColourBy::Plain ? look.plain : colourAt(look.palette, v);
    result.alpha = static_cast<float>(v * (colour.alpha / 255.0));
    result.light = static_cast<float>(linearFromEncoded(result.alpha));
    result.red = static_cast<float>(linearLight(colour.red));
    result.green = static_cast<float>(linearLight(colour.green));
    result.blue = static_cast<float>(linearLight(colour.blue));
    return result;
}

std::uint32_t ToneMap::plainPixel(const Entry& e) const {
    return pixel(e.alpha, encoded(e.red), encoded(e.green), encoded(e.blue));
}

// Composited as every viewer composites: in code values, so that a transparent picture laid over the
// background gives the same pixels as one drawn on it.
std::uint32_t ToneMap::pixel(double alpha, double red, double green, double blue) const {
    const double behind = (1 - alpha) * (m_settings.appearance.background.alpha / 255.0);
    const auto channel = [](double value) {
        return static_cast<std::uint32_t>(std::clamp(value + 0.5, 0.0, 255.0));
    };
    const std::uint32_t a = channel(255 * (alpha + behind));
    const auto composed = [&](double front, double ground) {
        return std::min(a, channel(alpha * front + behind * ground));
    };
    return a << 24 | composed(red, m_background[0]) << 16 | composed(green, m_background[1]) << 8 |
           composed(blue, m_background[2]);
}

std::uint32_t ToneMap::averagedPixel(const CellSums& sums, int x, int y) const {
    const int side = m_settings.cellsPerPixel;
    double light = 0;
    double red = 0;
    double green = 0;
    double blue = 0;
    for (int j = 0; j < side; ++j) {
        std::size_t cell =
            static_cast<std::size_t>(y * side + j) * static_cast<std::size_t>(sums.window().width) +
            static_cast<std::size_t>(x * side);
        for (int i = 0; i < side; ++i, ++cell) {
            if (m_ownColours) {
                const CellSums::Sum sum = sums.sum(cell);
                if (sum.samples == 0) continue;
                const double weight = m_entries[kernels::toneIndex(sum.samples)].light;
                const double share = weight / (static_cast<double>(sum.samples) * fullColour);
                light += weight;
                red += share * static_cast<double>(sum.red);
                green += share * static_cast<double>(sum.green);
                blue += share * static_cast<double>(sum.blue);
            } else if (const std::uint64_t samples = sums.samples(cell); samples > 0) {
                const Entry& e = m_entries[kernels::toneIndex(samples)];
                light += e.light;
                red += e.light * e.red;
                green += e.light * e.green;
                blue += e.light * e.blue;
            }
        }
    }
    if (!(light > 0)) return m_pixels[0];
    const auto code = [&](double sum) {
        return static_cast<double>(
            m_codes[static_cast<std::size_t>(std::min(1.0, sum / light) * fullColour + 0.5)]);
    };
    const double alpha = side == 1
                             ? encodedFromLinear(light)
                             : encodedFromLinear(std::min(1.0, m_settings.gain * light / (side * side)));
    return pixel(std::min(alpha, 1.0), code(red), code(green), code(blue));
}

void ToneMap::apply(const CellSums& sums, int firstRow, int endRow, std::span<std::uint32_t> pixels) const {
    const int width = sums.window().width / m_settings.cellsPerPixel;
    auto out = pixels.begin() + static_cast<std::ptrdiff_t>(firstRow) * width;
    if (m_settings.cellsPerPixel == 1 && !m_ownColours) {
        const std::size_t begin = static_cast<std::size_t>(firstRow) * static_cast<std::size_t>(width);
        const std::size_t end = static_cast<std::size_t>(endRow) * static_cast<std::size_t>(width);
        if (!sums.carried() && m_mostSamples < std::uint64_t{1} << 31) {
            std::vector<const std::uint32_t*> counts = sums.counters();
            for (const std::uint32_t*& pointer : counts)
                pointer += begin;
            kernels::mapTones(counts, end - begin, m_pixels.data(), &*out);
            return;
        }
        for (std::size_t cell = begin; cell < end; ++cell)
            *out++ = m_pixels[kernels::toneIndex(sums.samples(cell))];
        return;
    }
    for (int y = firstRow; y < endRow; ++y)
        for (int x = 0; x < width; ++x)
            *out++ = averagedPixel(sums, x, y);
}

} // namespace attractor
