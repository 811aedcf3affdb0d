// SPDX-License-Identifier: MIT
#include "attractor/light/tone_map.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"
#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace attractor {

namespace {

constexpr double minWhitePoint = 4;       // keeps an even measure below the brightest tone
constexpr double sampledPixels = 200'000; // sufficient sample for a mean
constexpr std::size_t rampSize = 512;

// Middle of the counts that share an entry of a tone table.
double samplesOf(std::size_t index) {
    if (index < kernels::exactCounts) return static_cast<double>(index);
    const std::size_t step = index - kernels::exactCounts;
    const auto octave = static_cast<double>(std::uint64_t{1} << std::min<std::size_t>(step / 64 + 1, 63));
    return (64.5 + static_cast<double>(step % 64)) * octave;
}

std::size_t tableSize(std::uint64_t maxSamples) {
    return kernels::toneIndex(maxSamples) + 1;
}

// Calls work(samples per block) for rows of blocks of side × side cells, those rows that `wanted` picks and
// that are not empty.
template <class Wanted, class Work>
void forBlockRows(const CellSums& sums, int side, Wanted wanted, Work work) {
    const int height = sums.window().endRow - sums.window().firstRow;
    const auto width = static_cast<std::size_t>(sums.window().width);
    const auto step = static_cast<std::size_t>(side);
    std::vector<std::uint64_t> columns;
    std::vector<std::uint64_t> blocks((width + step - 1) / step);
    for (int row = 0; row * side < height; ++row) {
        if (!wanted(row) || !sums.samplesOfRows(row * side, std::min(height, (row + 1) * side), columns))
            continue;
        if (side == 1) {
            work(columns);
            continue;
        }
        for (std::size_t block = 0; block < blocks.size(); ++block) {
            const auto first = columns.begin() + static_cast<std::ptrdiff_t>(block * step);
            const auto end =
                columns.begin() + static_cast<std::ptrdiff_t>(std::min(width, (block + 1) * step));
            blocks[block] = std::accumulate(first, end, std::uint64_t{0});
        }
        work(blocks);
    }
}

// Histogram of samples per pixel. Whole numbers, so that the order of counting does not matter.
class Tally {
public:
    void add(const std::vector<std::uint64_t>& pixels) {
        for (const std::uint64_t samples : pixels) {
            if (samples == 0) continue;
            ++m_pixels[std::min<std::uint64_t>(samples, m_pixels.size() - 1)];
            m_samples += samples;
        }
    }
    void add(const Tally& other) {
        for (std::size_t i = 0; i < m_pixels.size(); ++i)
            m_pixels[i] += other.m_pixels[i];
        m_samples += other.m_samples;
    }
    double samples() const { return static_cast<double>(m_samples); }

    // Expected number of occupied pixels if only a share of the samples had been drawn (rarefaction). It
    // makes occupancy independent of the number of samples.
    double occupied(double share) const {
        double result = 0;
        double missed = 1;
        for (const std::uint64_t pixels : m_pixels) {
            result += static_cast<double>(pixels) * (1 - missed);
            missed *= 1 - std::min(1.0, share);
        }
        return result;
    }

private:
    std::array<std::uint64_t, 2048> m_pixels{};
    std::uint64_t m_samples = 0;
};

// About one row in `stride`; which ones is fixed, but without a rhythm that a fractal could share.
bool isSampled(int row, std::uint64_t stride) {
    return stride == 1 || mixed(static_cast<std::uint64_t>(row)) % stride == 0;
}

// Calls work(thread, samples per block) as above on all threads, until it is stopped.
template <class Work>
void forBlockRowsTogether(const CellSums& sums, int side, std::uint64_t stride, Workers& workers,
                          const std::stop_token& stop, Work work) {
    workers.run([&](std::size_t thread) {
        const auto mine = [&](int row) {
            return static_cast<std::size_t>(row) % workers.size() == thread && isSampled(row, stride) &&
                   !stop.stop_requested();
        };
        forBlockRows(sums, side, mine,
                     [&](const std::vector<std::uint64_t>& blocks) { work(thread, blocks); });
    });
}

Tally tally(const CellSums& sums, int cellsPerPixel, std::uint64_t stride, Workers& workers,
            const std::stop_token& stop = {}) {
    std::vector<Tally> parts(workers.size());
    forBlockRowsTogether(
        sums, cellsPerPixel, stride, workers, stop,
        [&](std::size_t thread, const std::vector<std::uint64_t>& pixels) { parts[thread].add(pixels); });
    for (std::size_t thread = 1; thread < parts.size(); ++thread)
        parts[0].add(parts[thread]);
    return parts[0];
}

void appendOccupied(std::vector<std::uint64_t>& occupied, const std::vector<std::uint64_t>& values) {
    for (const std::uint64_t value : values)
        if (value > 0) occupied.push_back(value);
}

std::vector<std::uint64_t> pixelSamples(const CellSums& sums, int cellsPerPixel, std::uint64_t stride) {
    std::vector<std::uint64_t> result;
    forBlockRows(
        sums, cellsPerPixel, [stride](int row) { return isSampled(row, stride); },
        [&](const std::vector<std::uint64_t>& pixels) { appendOccupied(result, pixels); });
    return result;
}

// The 99.5 percentile relative to the mean, over blocks large enough that the noise of few samples is no part
// of it.
double whitePointOf(const CellSums& sums, int cellsPerPixel, double referencePerPixel, double share,
                    Workers& workers, const std::stop_token& stop) {
    int side = 1;
    while (side < 16 && referencePerPixel * side * side < 64)
        side *= 2;
    std::vector<std::vector<std::uint64_t>> parts(workers.size());
    forBlockRowsTogether(sums, side * cellsPerPixel, 1, workers, stop,
                         [&](std::size_t thread, const std::vector<std::uint64_t>& row) {
                             appendOccupied(parts[thread], row);
                         });
    std::vector<std::uint64_t>& blocks = parts.front();
    for (std::size_t thread = 1; thread < parts.size(); ++thread)
        blocks.insert(blocks.end(), parts[thread].begin(), parts[thread].end());
    if (blocks.empty()) return minWhitePoint; // stopped
    Tally found;
    found.add(blocks);
    const double occupied = found.occupied(share);
    const auto rank = std::min(static_cast<std::size_t>(0.005 * occupied), blocks.size() - 1);
    const auto nth = blocks.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(blocks.begin(), nth, blocks.end(), std::greater<>());
    return std::max(minWhitePoint, static_cast<double>(*nth) * occupied / found.samples());
}

std::vector<double> lightTable(const Appearance& look, double whitePoint, double densityPerSample,
                               std::uint64_t maxSamples) {
    std::vector<double> table(tableSize(maxSamples));
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = i == 0 ? 0 : linearFromEncoded(tone(samplesOf(i) * densityPerSample, look, whitePoint));
    return table;
}

// Averaging light over the cells of a pixel dims details thinner than a pixel; the gain restores the mean.
double gainOf(const CellSums& sums, const Appearance& look, int cellsPerPixel, double whitePoint,
              double densityPerSample, std::uint64_t stride) {
    const std::vector<std::uint64_t> pixels = pixelSamples(sums, cellsPerPixel, stride);
    const std::uint64_t max = *std::max_element(pixels.begin(), pixels.end());
    const double area = cellsPerPixel * cellsPerPixel;
    const auto whole = lightTable(look, whitePoint, densityPerSample, max);
    const auto split = lightTable(look, whitePoint, densityPerSample * area, max);
    double wanted = 0;
    for (const std::uint64_t samples : pixels)
        wanted += whole[kernels::toneIndex(samples)];
    double found = 0;
    std::vector<std::uint64_t> cells;
    for (int row = 0; row < sums.window().endRow - sums.window().firstRow; ++row) {
        if (!isSampled(row / cellsPerPixel, stride) || !sums.samplesOfRow(row, cells)) continue;
        for (const std::uint64_t samples : cells)
            found += split[kernels::toneIndex(samples)];
    }
    return found > 0 ? std::clamp(wanted * area / found, 1.0, static_cast<double>(cellsPerPixel)) : 1;
}

const std::vector<std::uint8_t>& codes() { // sRGB codes of 12-bit linear light
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> values(4096);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = encoded(static_cast<double>(i) / fullColour);
        return values;
    }();
    return table;
}

const std::vector<float>& alphas() { // sRGB codes as fractions
    static const std::vector<float> table = [] {
        std::vector<float> values(4096);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(encodedFromLinear(static_cast<double>(i) / fullColour));
        return values;
    }();
    return table;
}

std::uint32_t channel(double value) {
    return static_cast<std::uint32_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

std::size_t twelveBits(double light) {
    return static_cast<std::size_t>(std::clamp(light, 0.0, 1.0) * fullColour + 0.5);
}

} // namespace

double referenceShare(double pixels, double samples) {
    return samples > 0 ? std::min(1.0, 0.5 * pixels / samples) : 1;
}

Occupancy occupancy(const CellSums& sums, int cellsPerPixel, double share, Workers& workers) {
    const Tally pixels = tally(sums, cellsPerPixel, 1, workers);
    return {pixels.samples(), pixels.occupied(share)};
}

Exposure measuredExposure(const CellSums& sums, const Appearance& appearance, double samples,
                          const std::optional<Exposure>& kept, Workers& workers,
                          const std::stop_token& stop) {
    const int cellsPerPixel = appearance.supersample;
    const CellWindow& window = sums.window();
    const double pixelCount = static_cast<double>(window.cells()) / (cellsPerPixel * cellsPerPixel);
    auto stride = static_cast<std::uint64_t>(std::max(1.0, pixelCount / sampledPixels));
    Tally pixels = tally(sums, cellsPerPixel, stride, workers, stop);
    if (!(pixels.samples() > 0) && stride > 1) {
        stride = 1;
        pixels = tally(sums, cellsPerPixel, stride, workers, stop);
    }
    const double found = pixels.samples();
    Exposure exposure = kept && kept->whitePoint > 0 ? *kept : Exposure{0, 0, 1};
    if (!(found > 0) || !(samples > 0))
        return {1, std::max(minWhitePoint, exposure.whitePoint), exposure.gain};
    const double share = referenceShare(pixelCount / static_cast<double>(stride), found);
    const double occupied = pixels.occupied(share);
    exposure.meanDensity = found / occupied / samples;
    if (exposure.whitePoint > 0) return exposure;
    const double referencePerPixel = std::min(1.0, share) * found / occupied;
    exposure.whitePoint = whitePointOf(sums, cellsPerPixel, referencePerPixel, share, workers, stop);
    if (cellsPerPixel > 1 && !stop.stop_requested())
        exposure.gain =
            gainOf(sums, appearance, cellsPerPixel, exposure.whitePoint, occupied / found, stride);
    return exposure;
}

ToneMap::ToneMap(const ToneSettings& settings, std::uint64_t maxSamples)
    : m_settings(settings),
      m_ownColours(coloursSamples(settings.appearance.colourBy)),
      m_maxSamples(maxSamples),
      m_vibrantCodes(settings.appearance) {
    const Appearance& look = m_settings.appearance;
    if (look.colourBy == ColourBy::Plain)
        m_ramp.push_back(look.plain);
    else if (look.colourBy == ColourBy::Density)
        for (std::size_t i = 0; i < rampSize; ++i)
            m_ramp.push_back(colourAt(look.palette, static_cast<double>(i) / (rampSize - 1)));
    else
        m_ramp.push_back({});
    m_entries.resize(tableSize(maxSamples));
    m_pixels.resize(m_entries.size());
    double v = 0;
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        if (v >= 1) { // full brightness from here on
            m_entries[i] = m_entries[i - 1];
            m_pixels[i] = m_pixels[i - 1];
            continue;
        }
        v = toneOf(samplesOf(i));
        m_entries[i] = i == 0 ? Entry{} : entry(v);
        m_pixels[i] = pixel(m_entries[i]);
    }
    if (m_ownColours && m_settings.cellsPerPixel == 1 && !m_vibrantCodes.changesColours())
        for (std::size_t i = 0; i < m_entries.size(); ++i)
            m_fronts.push_back(front(i));
}

double ToneMap::toneOf(double samples) const {
    return tone(samples * m_settings.densityPerSample, m_settings.appearance, m_settings.whitePoint);
}

ToneMap::Entry ToneMap::entry(double v) const {
    const Rgba& colour = m_ramp[static_cast<std::size_t>(v * static_cast<double>(m_ramp.size() - 1) + 0.5)];
    Entry result;
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
    const std::uint32_t a = channel(255 * (alpha + behind));
    const auto composed = [&](double front, double back) {
        return std::min(a, channel(alpha * front + behind * back));
    };
    return a << 24 | composed(red, ground.red) << 16 | composed(green, ground.green) << 8 |
           composed(blue, ground.blue);
}

std::uint32_t ToneMap::pixel(const Light& light) const {
    const int side = m_settings.cellsPerPixel;
    const double alpha = side == 1 ? static_cast<double>(light.alpha)
                                   : alphas()[twelveBits(m_settings.gain * light.weight / (side * side))];
    const double share = 1 / light.weight;
    if (m_vibrantCodes.changesColours())
        return pixel(alpha, m_vibrantCodes(light.red * share), m_vibrantCodes(light.green * share),
                     m_vibrantCodes(light.blue * share));
    const auto code = [&](double sum) { return static_cast<double>(codes()[twelveBits(sum * share)]); };
    return pixel(alpha, code(light.red), code(light.green), code(light.blue));
}

std::uint32_t ToneMap::pixel(const Entry& entry) const {
    const auto code = [this](float light) {
        return m_vibrantCodes.changesColours() ? m_vibrantCodes(static_cast<double>(light))
                                               : static_cast<double>(codes()[twelveBits(light)]);
    };
    return pixel(entry.alpha, code(entry.red), code(entry.green), code(entry.blue));
}

// The same arithmetic as for light that adds up over the cells of a pixel, so that it gives the same bytes.
ToneMap::Front ToneMap::front(std::size_t index) const {
    const Entry& e = m_entries[index];
    const Rgba& ground = m_settings.appearance.background;
    Front result;
    result.light = e.light;
    result.inverseLight = 1 / result.light;
    if (index < kernels::exactCounts) result.share = e.light / (static_cast<double>(index) * fullColour);
    result.alpha = e.alpha;
    const double behind = (1 - result.alpha) * (ground.alpha / 255.0);
    result.red = behind * ground.red;
    result.green = behind * ground.green;
    result.blue = behind * ground.blue;
    result.opacity = channel(255 * (result.alpha + behind));
    return result;
}

std::uint32_t ToneMap::pixel(const CellSums::Sum& sum, const std::uint8_t* codes) const {
    const Front& f = m_fronts[kernels::toneIndex(sum.samples)];
    if (!(f.light > 0)) return m_pixels[0];
    const double share = sum.samples < kernels::exactCounts
                             ? f.share
                             : f.light / (static_cast<double>(sum.samples) * fullColour);
    const auto composed = [&](std::uint64_t colour, double behind) {
        const double light = share * static_cast<double>(static_cast<std::int64_t>(colour));
        const double code = codes[twelveBits(light * f.inverseLight)];
        return std::min(f.opacity, channel(f.alpha * code + behind));
    };
    return f.opacity << 24 | composed(sum.red, f.red) << 16 | composed(sum.green, f.green) << 8 |
           composed(sum.blue, f.blue);
}

void ToneMap::applyFronts(const CellSums& sums, int firstRow, int endRow, std::uint32_t* pixels) const {
    const auto width = static_cast<std::size_t>(sums.window().width);
    const std::uint8_t* const table = codes().data();
    std::vector<CellSums::Sum> cells;
    for (int row = firstRow; row < endRow; ++row) {
        std::uint32_t* const out = pixels + static_cast<std::size_t>(row) * width;
        std::fill_n(out, width, m_pixels[0]);
        if (!sums.sumsOfRow(row, cells)) continue;
        for (std::size_t x = 0; x < width; ++x)
            if (cells[x].samples > 0) out[x] = pixel(cells[x], table);
    }
}

bool ToneMap::addCounts(const CellSums& sums, int row, std::vector<Light>& lights) const {
    const auto side = static_cast<std::size_t>(m_settings.cellsPerPixel);
    std::vector<std::uint64_t> cells;
    if (!sums.samplesOfRow(row, cells)) return false;
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
    return true;
}

bool ToneMap::addColours(const CellSums& sums, int row, std::vector<Light>& lights) const {
    const auto side = static_cast<std::size_t>(m_settings.cellsPerPixel);
    std::vector<CellSums::Sum> cells;
    if (!sums.sumsOfRow(row, cells)) return false;
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
    return true;
}

void ToneMap::applyTable(const CellSums& sums, int firstRow, int endRow, std::uint32_t* pixels) const {
    const auto width = static_cast<std::size_t>(sums.window().width);
    for (int row = firstRow; row < endRow;) {
        CellSums::Pieces pieces = sums.pieces(row);
        for (const int end = std::min(endRow, pieces.endRow); row < end; ++row)
            for (CellSums::Piece& piece : pieces.pieces) {
                kernels::mapTones(piece.counts, piece.endColumn - piece.firstColumn, m_pixels.data(),
                                  pixels + static_cast<std::size_t>(row) * width + piece.firstColumn);
                for (const std::uint32_t*& counts : piece.counts)
                    counts += width;
            }
    }
}

void ToneMap::apply(const CellSums& sums, int firstRow, int endRow, std::span<std::uint32_t> pixels) const {
    const int side = m_settings.cellsPerPixel;
    const auto width = static_cast<std::size_t>(sums.window().width / side);
    const bool small = m_maxSamples < std::uint64_t{1} << 31;
    if (side == 1 && !m_ownColours && !sums.carried() && small) {
        applyTable(sums, firstRow, endRow, pixels.data());
        return;
    }
    if (!m_fronts.empty()) {
        applyFronts(sums, firstRow, endRow, pixels.data());
        return;
    }
    std::vector<Light> lights(width);
    auto out = pixels.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(firstRow) * width);
    for (int y = firstRow; y < endRow; ++y) {
        bool any = false;
        for (int row = y * side; row < (y + 1) * side; ++row)
            any |= m_ownColours ? addColours(sums, row, lights) : addCounts(sums, row, lights);
        if (!any) {
            out = std::fill_n(out, width, m_pixels[0]);
            continue;
        }
        for (Light& light : lights) {
            *out++ = light.weight > 0 ? pixel(light) : m_pixels[0];
            light = {};
        }
    }
}

} // namespace attractor
