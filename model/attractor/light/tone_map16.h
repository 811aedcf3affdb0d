// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/colour/palette.h"
#include "attractor/light/tone_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// sRGB, 16 bits per channel, not premultiplied.
struct Rgba16 {
    std::uint16_t red = 0;
    std::uint16_t green = 0;
    std::uint16_t blue = 0;
    std::uint16_t alpha = 0;

    friend bool operator==(const Rgba16&, const Rgba16&) = default;
};

// Cells → pixels as ToneMap does, with tone and colour computed to all 16 bits. Where cells carry colours, a
// single sample's colour has 12 bits in linear light; sums over samples have more.
class ToneMap16 {
public:
    explicit ToneMap16(const ToneSettings& settings);

    // Rows [firstRow, endRow) of the pixels, counted from the first row of the sums. Different rows may be
    // made by different threads.
    void apply(const CellSums& sums, int firstRow, int endRow, std::span<Rgba16> pixels) const;

private:
    struct Entry { // contribution of a cell with one count
        double alpha = 0;
        double light = 0; // alpha as linear light
        LinearColour colour;
    };
    struct Light { // light of one pixel
        double weight = 0;
        double red = 0;
        double green = 0;
        double blue = 0;
        double alpha = 0; // alpha of the last cell
    };
    Entry entry(std::uint64_t samples) const;
    void addRow(const CellSums& sums, int row, std::vector<Light>& lights) const;
    Rgba16 pixel(const Light& light) const;

    ToneSettings m_settings;
    bool m_ownColours;            // true if the sums carry colours
    std::vector<Entry> m_entries; // entries of the smaller counts
};

} // namespace attractor
