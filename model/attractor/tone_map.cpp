// SPDX-License-Identifier: MIT
#include "attractor/tone_map.h"

#include "attractor/arithmetic.h"
#include "attractor/kernels.h"
#include "attractor/linear_light.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace attractor {

namespace {

constexpr double fullColour = 4095;       // 12 bits a channel
constexpr double smallestWhitePoint = 4;  // an even measure is shown below the brightest tone
constexpr double sampledPixels = 200'000; // enough for a mean
constexpr std::size_t rampSize = 512;

// Middle of the counts that share a place in a tone table.
double samplesOf(std::size_t index) {
    if (index < kernels::exactCounts) return static_cast<double>(index);
    const std::size_t step = index - kernels::exactCounts;
    const auto octave = static_cast<double>(std::uint64_t{1} << std::min<std::size_t>(step / 64 + 1, 63));
    return (64.5 + static_cast<double>(step % 64)) * octave;
}

std::size_t tableSize(std::uint64_t mostSamples) {
    return kernels::toneIndex(mostSamples) + 1;
}

// How many pixels would be occupied if only a share q of the samples had been drawn: rarefaction, which makes
// occupancy independent of the number of samples.
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
    std::array<double, 2048> m_seen{};
};

// Calls work(samples per block) for rows of blocks of side × side cells; only those rows that `wanted` picks.
template <class Wanted, class Work>
void forBlockRows(const CellSums& sums, int side, Wanted wanted, Work work) {
    const int height = sums.window().endRow - sums.window().firstRow;
    const auto width = static_cast<std::size_t>(sums.window().width);
    const auto step = static_cast<std::size_t>(side);
    std::vector<std::uint64_t> cells;
    std::vector<std::uint64_t> blocks((width + step - 1) / step);
    for (int row = 0; row * side < height; ++row) {
        if (!wanted(row)) continue;
        std::fill(blocks.begin(), blocks.end(), 0U);
        for (int y = row * side; y < std::min(height, (row + 1) * side); ++y) {
            sums.samplesOfRow(y, cells);
            for (std::size_t block = 0, x = 0; block < blocks.size(); ++block)
                for (const std::size_t end = std::min(width, x + step); x < end; ++x)
                    blocks[block] += cells[x];
        }
        work(blocks);
    }
}

Occupancy occupancyOf(const std::vector<std::uint64_t>& blocks, double share) {
    Occupancy result;
    const Rarefied seen(std::min(1.0, share));
    for (const std::uint64_t samples : blocks) {
        result.samples += static_cast<double>(samples);
        result.occupied += seen(samples);
    }
    return result;
}

double total(const std::vector<std::uint64_t>& values) {
    double sum = 0;
    for (const std::uint64_t value : values)
        sum += static_cast<double>(value);
    return sum;
}

void appendOccupied(std::vector<std::uint64_t>& occupied, const std::vector<std::uint64_t>& values) {
    for (const std::uint64_t value : values)
        if (value > 0) occupied.push_back(value);
}

// Occupied pixels of about one row in `stride`; which ones is fixed, but without a rhythm that a fractal
// could share.
std::vector<std::uint64_t> pixelSamples(const CellSums& sums, int cellsPerPixel, std::uint64_t stride) {
    std::vector<std::uint64_t> result;
    forBlockRows(
        sums, cellsPerPixel,
        [stride](int row) { return mixed(static_cast<std::uint64_t>(row)) % stride == 0; },
        [&](const std::vector<std::uint64_t>& pixels) { appendOccupied(result, pixels); });
    return result;
}

// The 99.5 percentile relative to the mean, over blocks large enough that the noise of few samples is no part
// of it.
double whitePointOf(const CellSums& sums, int cellsPerPixel, double referencePerPixel, double share) {
    int side = 1;
    while (side < 16 && referencePerPixel * side * side < 64)
        side *= 2;
    std::vector<std::uint64_t> blocks;
    forBlockRows(
        sums, side * cellsPerPixel, [](int) { return true; },
        [&](const std::vector<std::uint64_t>& row) { appendOccupied(blocks, row); });
    const Occupancy occupied = occupancyOf(blocks, share);
    const auto rank = std::min(static_cast<std::size_t>(0.005 * occupied.occupied), blocks.size() - 1);
    const auto nth = blocks.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(blocks.begin(), nth, blocks.end(), std::greater<>());
    return std::max(smallestWhitePoint, static_cast<double>(*nth) * occupied.occupied / occupied.samples);
}

std::vector<double> lightTable(const Appearance& look, double whitePoint, double densityPerSample,
                               std::uint64_t mostSamples) {
    std::vector<double> table(tableSize(mostSamples));
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = i == 0 ? 0
                          : linearFromEncoded(tone(samplesOf(i) * densityPerSample, look.brightness,
                                                   whitePoint, look.gamma));
    return table;
}

// Averaging light over the cells of a pixel dims what is thinner than a pixel; the gain restores the mean.
double gainOf(const CellSums& sums, const Appearance& look, int cellsPerPixel, double whitePoint,
              double densityPerSample, const std::vector<std::uint64_t>& pixels, std::uint64_t stride) {
    const std::uint64_t most = *std::max_element(pixels.begin(), pixels.end());
    const double area = cellsPerPixel * cellsPerPixel;
    const auto whole = lightTable(look, whitePoint, densityPerSample, most);
    const auto split = lightTable(look, whitePoint, densityPerSample * area, most);
    double wanted = 0;
    for (const std::uint64_t samples : pixels)
        wanted += whole[kernels::toneIndex(samples)];
    double found = 0;
    std::vector<std::uint64_t> cells;
    for (int row = 0; row < sums.window().endRow - sums.window().firstRow; ++row) {
        if (mixed(static_cast<std::uint64_t>(row / cellsPerPixel)) % stride != 0) continue;
        sums.samplesOfRow(row, cells);
        for (const std::uint64_t samples : cells)
            found += split[kernels::toneIndex(samples)];
    }
    return found > 0 ? std::clamp(wanted * area / found, 1.0, static_cast<double>(cellsPerPixel)) : 1;
}

const std::vector<std::uint8_t>& codes() { // sRGB of 12 bit linear light
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> values(4096);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = encoded(static_cast<double>(i) / fullColour);
        return values;
    }();
    return table;
}

const std::vector<float>& alphas() { // the same as a fraction
    static const std::vector<float> table = [] {
        std::vector<float> values(4096);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(encodedFromLinear(static_cast<double>(i) / fullColour));
        return values;
    }();
    return table;
}

std::size_t twelveBits(double light) {
    return static_cast<std::size_t>(std::clamp(light, 0.0, 1.0) * fullColour + 0.5);
}

} // namespace

double tone(double density, double brightness, double whitePoint, double gamma) {
    const double ratio =
        naturalLogarithm(1 + brightness * density) / naturalLogarithm(1 + brightness * whitePoint);
    return std::clamp(power(ratio, 1 / gamma), 0.0, 1.0);
}

double referenceShare(double pixels, double samples) {
    return samples > 0 ? std::min(1.0, 0.5 * pixels / samples) : 1;
}

Occupancy occupancy(const CellSums& sums, int cellsPerPixel, double share) {
    return occupancyOf(pixelSamples(sums, cellsPerPixel, 1), share);
}

Exposure measuredExposure(const CellSums& sums, const Appearance& appearance, int cellsPerPixel,
                          double samples, const std::optional<Exposure>& kept) {
    const CellWindow& window = sums.window();
    const double pixelCount = static_cast<double>(window.cells()) / (cellsPerPixel * cellsPerPixel);
    auto stride = static_cast<std::uint64_t>(std::max(1.0, pixelCount / sampledPixels));
    std::vector<std::uint64_t> pixels = pixelSamples(sums, cellsPerPixel, stride);
    double found = total(pixels);
    if (!(found > 0) && stride > 1) {
        stride = 1;
        pixels = pixelSamples(sums, cellsPerPixel, stride);
        found = total(pixels);
    }
    Exposure exposure = kept && kept->whitePoint > 0 ? *kept : Exposure{0, 0, 1};
    if (!(found > 0) || !(samples > 0))
        return {1, std::max(smallestWhitePoint, exposure.whitePoint), exposure.gain};
    const double share = referenceShare(pixelCount / static_cast<double>(stride), found);
    const Occupancy occupied = occupancyOf(pixels, share);
    exposure.meanDensity = found / occupied.occupied / samples;
    if (exposure.whitePoint > 0) return exposure;
    const double referencePerPixel = std::min(1.0, share) * found / occupied.occupied;
    exposure.whitePoint = whitePointOf(sums, cellsPerPixel, referencePerPixel, share);
    if (cellsPerPixel > 1)
        exposure.gain = gainOf(sums, appearance, cellsPerPixel, exposure.whitePoint,
                               occupied.occupied / found, pixels, stride);
    return exposure;
}

ToneMap::ToneMap(const ToneSettings& settings, std::uint64_t mostSamples)
    : m_settings(settings),
      m_ownColours(settings.appearance.colourBy == ColourBy::Map ||
                   settings.appearance.colourBy == ColourBy::Address),
      m_mostSamples(mostSamples) {
    const Appearance& look = m_settings.appearance;
    if (look.colourBy == ColourBy::Plain)
        m_ramp.push_back(look.plain);
    else if (look.colourBy == ColourBy::Density)
        for (std::size_t i = 0; i < rampSize; ++i)
            m_ramp.push_back(colourAt(look.palette, static_cast<double>(i) / (rampSize - 1)));
    else
        m_ramp.push_back({});
    m_entries.resize(tableSize(mostSamples));
    m_pixels.resize(m_entries.size());
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const Entry& e = m_entries[i] = entry(samplesOf(i));
        m_pixels[i] = pixel(e.alpha, codes()[twelveBits(e.red)], codes()[twelveBits(e.green)],
                            codes()[twelveBits(e.blue)]);
    }
}

ToneMap::Entry ToneMap::entry(double samples) const {
    const Appearance& look = m_settings.appearance;
    Entry result;
    if (!(samples > 0)) return result;
    const double v =
        tone(samples * m_settings.densityPerSample, look.brightness, m_settings.whitePoint, look.gamma);
    const Rgba& colour = m_ramp[static_cast<std::size_t>(v * static_cast<double>(m_ramp.size() - 1) + 0.5)];
    result.alpha = static_cast<float>(v * (colour.alpha / 255.0));
    result.light = static_cast<float>(linearFromEncoded(result.alpha));
    result.red = static_cast<float>(linearLight(colour.red));
    result.green = static_cast<float>(linearLight(colour.green));
    result.blue = static_cast<float>(linearLight(colour.blue));
    return result;
}

// Composited as every viewer composites: in code values, so that a transparent picture laid over the
// background gives the same pixels as one drawn on it.
std::uint32_t ToneMap::pixel(double alpha, double red, double green, double blue) const {
    const Rgba& ground = m_settings.appearance.background;
    const double behind = (1 - alpha) * (ground.alpha / 255.0);
    const auto channel = [](double value) {
        return static_cast<std::uint32_t>(std::clamp(value + 0.5, 0.0, 255.0));
    };
    const std::uint32_t a = channel(255 * (alpha + behind));
    const auto composed = [&](double front, double back) {
        return std::min(a, channel(alpha * front + behind * back));
    };
    return a << 24 | composed(red, ground.red) << 16 | composed(green, ground.green) << 8 |
           composed(blue, ground.blue);
}

std::uint32_t ToneMap::pixel(const Light& light) const {
    if (!(light.weight > 0)) return m_pixels[0];
    const int side = m_settings.cellsPerPixel;
    const double alpha = side == 1 ? static_cast<double>(light.alpha)
                                   : alphas()[twelveBits(m_settings.gain * light.weight / (side * side))];
    const auto code = [&](double sum) {
        return static_cast<double>(codes()[twelveBits(sum / light.weight)]);
    };
    return pixel(alpha, code(light.red), code(light.green), code(light.blue));
}

void ToneMap::addCounts(const CellSums& sums, int row, std::vector<Light>& lights) const {
    const auto side = static_cast<std::size_t>(m_settings.cellsPerPixel);
    std::vector<std::uint64_t> cells;
    sums.samplesOfRow(row, cells);
    for (std::size_t x = 0; x < lights.size() * side; ++x) {
        if (cells[x] == 0) continue;
        const Entry& e = m_entries[kernels::toneIndex(cells[x])];
        Light& light = lights[x / side];
        light.weight += e.light;
        light.red += e.light * e.red;
        light.green += e.light * e.green;
        light.blue += e.light * e.blue;
        light.alpha = e.alpha;
    }
}

void ToneMap::addColours(const CellSums& sums, int row, std::vector<Light>& lights) const {
    const auto side = static_cast<std::size_t>(m_settings.cellsPerPixel);
    std::vector<CellSums::Sum> cells;
    sums.sumsOfRow(row, cells);
    for (std::size_t x = 0; x < lights.size() * side; ++x) {
        const CellSums::Sum& sum = cells[x];
        if (sum.samples == 0) continue;
        const Entry& e = m_entries[kernels::toneIndex(sum.samples)];
        const double share = e.light / (static_cast<double>(sum.samples) * fullColour);
        Light& light = lights[x / side];
        light.weight += e.light;
        light.red += share * static_cast<double>(sum.red);
        light.green += share * static_cast<double>(sum.green);
        light.blue += share * static_cast<double>(sum.blue);
        light.alpha = e.alpha;
    }
}

void ToneMap::apply(const CellSums& sums, int firstRow, int endRow, std::span<std::uint32_t> pixels) const {
    const int side = m_settings.cellsPerPixel;
    const auto width = static_cast<std::size_t>(sums.window().width / side);
    const std::size_t begin = static_cast<std::size_t>(firstRow) * width;
    const std::size_t end = static_cast<std::size_t>(endRow) * width;
    const bool small = m_mostSamples < std::uint64_t{1} << 31;
    if (side == 1 && !m_ownColours && !sums.carried() && small && begin < end) {
        std::vector<const std::uint32_t*> counts = sums.counters();
        for (const std::uint32_t*& pointer : counts)
            pointer += begin;
        kernels::mapTones(counts, end - begin, m_pixels.data(), pixels.data() + begin);
        return;
    }
    std::vector<Light> lights;
    auto out = pixels.begin() + static_cast<std::ptrdiff_t>(begin);
    for (int y = firstRow; y < endRow; ++y) {
        lights.assign(width, {});
        for (int row = y * side; row < (y + 1) * side; ++row)
            m_ownColours ? addColours(sums, row, lights) : addCounts(sums, row, lights);
        for (const Light& light : lights)
            *out++ = pixel(light);
    }
}

} // namespace attractor
