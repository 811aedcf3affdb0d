// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/light/tone_curve.h"
#include "attractor/request/render_request.h"
#include "attractor/threads/workers.h"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// The brightest value of the table of encoded light: 12 bits per channel.
inline constexpr double fullColour = 4095;

// Mean density over the occupied pixels of a picture whose cells have been filled with `samples` samples over
// the whole attractor, and for every value that `kept` does not give, white point and gain. Independent of
// the number of samples but for noise. docs/mathematics.md, "Density to colour".
Exposure measuredExposure(const CellSums& sums, const Appearance& appearance, double samples,
                          const std::optional<Exposure>& kept, Workers& workers,
                          const std::stop_token& stop = {});

// Samples in the pixels of some rows, and how many of these pixels would be occupied if only `share` of the
// samples had been drawn; sums add up over rows.
struct Occupancy {
    double samples = 0;
    double occupied = 0;
};
Occupancy occupancy(const CellSums& sums, int cellsPerPixel, double share, Workers& workers);
// The share of the samples at which occupancy is compared.
double referenceShare(double pixels, double samples);

struct ToneSettings {
    Appearance appearance;
    int cellsPerPixel = 1;       // side of the square of cells of a pixel
    double densityPerSample = 0; // density ρ of a cell with one sample
    double whitePoint = 1;
    double gain = 1;
};

// Cells → pixels.
class ToneMap {
public:
    // `maxSamples` is an upper bound of the samples in a cell.
    ToneMap(const ToneSettings& settings, std::uint64_t maxSamples);

    // Rows [firstRow, endRow) of the pixels, counted from the first row of the sums. Different rows may be
    // made by different threads.
    void apply(const CellSums& sums, int firstRow, int endRow, std::span<std::uint32_t> pixels) const;

private:
    struct Entry {       // contribution of a cell of tone v
        float alpha = 0; // v
        float light = 0; // alpha as linear light
        float red = 0;   // colour in linear light
        float green = 0;
        float blue = 0;
    };
    struct Light { // light of one pixel
        double weight = 0;
        double red = 0;
        double green = 0;
        double blue = 0;
        float alpha = 0; // alpha of the last cell
    };
    struct Front { // coloured cell that fills its pixel, by number of samples
        double light = 0;
        double inverseLight = 0;
        double share = 0; // light per unit of colour, for exact counts
        double alpha = 0;
        double red = 0, green = 0, blue = 0; // light added by the background
        std::uint32_t opacity = 0;
    };
    double toneOf(double samples) const;
    Entry entry(double v) const;
    std::uint32_t pixel(double alpha, double red, double green, double blue) const;
    std::uint32_t pixel(const Light& light) const;
    std::uint32_t pixel(const Entry& entry) const; // cell that fills its pixel
    Front front(std::size_t index) const;
    // Coloured cell that fills its pixel.
    std::uint32_t pixel(const CellSums::Sum& sum, const std::uint8_t* codes) const;
    void applyTable(const CellSums& sums, int firstRow, int endRow, std::uint32_t* pixels) const;
    void applyFronts(const CellSums& sums, int firstRow, int endRow, std::uint32_t* pixels) const;
    // False where the row is empty.
    bool addCounts(const CellSums& sums, int row, std::vector<Light>& lights) const;
    bool addColours(const CellSums& sums, int row, std::vector<Light>& lights) const;

    ToneSettings m_settings;
    bool m_ownColours; // true if the sums carry colours
    std::uint64_t m_maxSamples;
    VibrantCodes m_vibrantCodes;
    std::vector<Rgba> m_ramp; // palette, or the plain colour
    std::vector<Entry> m_entries;
    std::vector<std::uint32_t> m_pixels; // pixels of cells without colours that fill them
    std::vector<Front> m_fronts;         // empty if pixels are computed otherwise
};

} // namespace attractor
