// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cell_sums.h"
#include "attractor/renderer.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// v = [ln(1 + κρ) / ln(1 + κρ_w)]^(1/γ), clamped to [0, 1].
double tone(double density, double brightness, double whitePoint, double gamma);

// Cells → pixels. `cellsPerPixel` cells a side make one pixel.
struct ToneSettings {
    Appearance appearance;
    int cellsPerPixel = 1;
    double densityPerSample = 0; // ρ of a cell that holds one sample
    double whitePoint = 1;
    double gain = 1; // of linear light, for what averaging over the cells of a pixel takes from thin sets
};

// Mean over occupied pixels, white point and gain of what has been counted in the whole picture; `samples` is
// their number over the whole attractor. Depends on that number only through noise.
Exposure measuredExposure(const CellSums& sums, const Appearance& appearance, int cellsPerPixel,
                          double samples);

class ToneMap {
public:
    // No cell may hold more than `mostSamples`.
    ToneMap(const ToneSettings& settings, std::uint64_t mostSamples);

    // Rows [firstRow, endRow) of the pixels, counted from the first row of the sums.
    void apply(const CellSums& sums, int firstRow, int endRow, std::span<std::uint32_t> pixels) const;

private:
    struct Entry {       // what one cell with a certain count contributes
        float alpha = 0; // v
        float light = 0; // the same as linear light
        float red = 0;   // colour, linear
        float green = 0;
        float blue = 0;
    };
    static double samplesOf(std::size_t index);

    Entry entry(double samples) const;
    std::uint32_t plainPixel(const Entry& entry) const;
    std::uint32_t pixel(double alpha, double red, double green, double blue) const;
    std::uint32_t averagedPixel(const CellSums& sums, int x, int y) const;

    ToneSettings m_settings;
    bool m_ownColours; // the sums carry colours
    std::uint64_t m_mostSamples;
    std::vector<Entry> m_entries;
    std::vector<std::uint32_t> m_pixels; // of a cell without colours that fills its pixel
    std::vector<std::uint8_t> m_codes;   // sRGB of 12 bit linear light
    std::array<double, 3> m_background{};
};

} // namespace attractor
