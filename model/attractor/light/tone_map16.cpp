// SPDX-License-Identifier: MIT
#include "attractor/light/tone_map16.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>

namespace attractor {

namespace {

constexpr std::uint64_t tabulated = 4096;

std::uint16_t code16(double value) {
    return static_cast<std::uint16_t>(std::clamp(value, 0.0, 1.0) * 65535 + 0.5);
}

} // namespace

ToneMap16::ToneMap16(const ToneSettings& settings)
    : m_settings(settings), m_ownColours(coloursSamples(settings.appearance.colourBy)) {
    std::vector<Entry> entries;
    entries.reserve(tabulated);
    for (std::uint64_t samples = 0; samples < tabulated; ++samples)
        entries.push_back(entry(samples));
    m_entries = std::move(entries);
}

ToneMap16::Entry ToneMap16::entry(std::uint64_t samples) const {
    if (samples < m_entries.size()) return m_entries[samples];
    const Appearance& look = m_settings.appearance;
    Entry result;
    if (samples == 0) return result;
    const double v =
        tone(static_cast<double>(samples) * m_settings.densityPerSample, look, m_settings.whitePoint);
    if (look.colourBy == ColourBy::Density) result.colour = linearColourAt(look.palette, v);
    if (look.colourBy == ColourBy::Plain) result.colour = linearColour(look.plain);
    result.alpha = v * result.colour.alpha;
    result.light = linearFromEncoded(result.alpha);
    return result;
}

void ToneMap16::addRow(const CellSums& sums, int row, std::vector<Light>& lights) const {
    const auto side = static_cast<std::size_t>(m_settings.cellsPerPixel);
    const auto add = [&](std::size_t x, const Entry& e, double red, double green, double blue) {
        Light& light = lights[x / side];
        light.weight += e.light;
        light.red += e.light * red;
        light.green += e.light * green;
        light.blue += e.light * blue;
        light.alpha = e.alpha;
    };
    if (m_ownColours) {
        std::vector<CellSums::Sum> cells;
        sums.sumsOfRow(row, cells);
        for (std::size_t x = 0; x < lights.size() * side; ++x) {
            const CellSums::Sum& sum = cells[x];
            if (sum.samples == 0) continue;
            const double share = 1 / (static_cast<double>(sum.samples) * fullColour);
            add(x, entry(sum.samples), share * static_cast<double>(sum.red),
                share * static_cast<double>(sum.green), share * static_cast<double>(sum.blue));
        }
        return;
    }
    std::vector<std::uint64_t> cells;
    sums.samplesOfRow(row, cells);
    for (std::size_t x = 0; x < lights.size() * side; ++x) {
        if (cells[x] == 0) continue;
        const Entry e = entry(cells[x]);
        add(x, e, e.colour.red, e.colour.green, e.colour.blue);
    }
}

// Composited in code values, as every viewer does.
Rgba16 ToneMap16::pixel(const Light& light) const {
    const Rgba& ground = m_settings.appearance.background;
    const double side = m_settings.cellsPerPixel;
    double alpha = 0;
    if (light.weight > 0)
        alpha = side == 1
                    ? light.alpha
                    : encodedFromLinear(std::clamp(m_settings.gain * light.weight / (side * side), 0.0, 1.0));
    const double behind = (1 - alpha) * (ground.alpha / 255.0);
    const double opacity = alpha + behind;
    if (!(opacity > 0)) return {};
    const auto channel = [&](double sum, std::uint8_t back) {
        const double front = alpha > 0 ? vibrant(encodedFromLinear(std::clamp(sum / light.weight, 0.0, 1.0)),
                                                 m_settings.appearance)
                                       : 0;
        return code16((alpha * front + behind * (back / 255.0)) / opacity);
    };
    return {channel(light.red, ground.red), channel(light.green, ground.green),
            channel(light.blue, ground.blue), code16(opacity)};
}

void ToneMap16::apply(const CellSums& sums, int firstRow, int endRow, std::span<Rgba16> pixels) const {
    const int side = m_settings.cellsPerPixel;
    const auto width = static_cast<std::size_t>(sums.window().width / side);
    const Rgba16 nothing = pixel({});
    std::vector<Light> lights;
    auto out = pixels.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(firstRow) * width);
    for (int y = firstRow; y < endRow; ++y) {
        lights.assign(width, {});
        for (int row = y * side; row < (y + 1) * side; ++row)
            addRow(sums, row, lights);
        for (const Light& light : lights)
            *out++ = light.weight > 0 ? pixel(light) : nothing;
    }
}

} // namespace attractor
