// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

// The minimum fold of one word: its subtree of addresses, nearest words first, as the smallest key in every
// pixel. Compiled for several instruction sets, which all give the same bits. docs/mathematics.md, "Solids".
namespace attractor::kernels {

constexpr std::size_t solidLanes = 16; // padding of arrays: reads go up to a multiple of it

// Maps in coordinates in which the box of the system is [−1, 1]³.
struct SolidMaps {
    std::size_t count = 0;
    std::array<const float*, 9> linear{}; // row by row
    std::array<const float*, 3> shift{};
    const std::uint8_t* colours = nullptr; // colour of each map
};

// Points of the attractor in box coordinates, one in every cell of a cut: every point of the attractor has
// one of them in a cell that is at most `spacing` times as wide as the box.
struct CoverPoints {
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
};
struct Cover {
    float spacing = 1;
    float onlyFor = 0; // > 0: exact size in pixels of the words that it is valid for
    std::size_t size = 0;
    std::size_t work = 0; // cost, in points
    // The points roughly from the nearest to the farthest, for each octant: depth falls along x (bit 0), y
    // (bit 1), z (bit 2) of the box. Later points are hidden by earlier ones.
    std::array<CoverPoints, 8> nearestFirst;
};

// A word as an affine map from box coordinates to (column, row, depth code).
struct SolidWord {
    static constexpr int uncoloured = -1;

    std::array<float, 9> linear{}; // row by row
    std::array<float, 3> middle{};
    int colour = uncoloured; // colour of the first map
};

// The keys of some rows of a picture, and the farthest one of every 8 × 8 of them.
class KeyBand {
public:
    static constexpr int tile = 8;
    static constexpr int maxRows = 128;

    void reset(int width, int rows); // empties all pixels; rows ≤ maxRows

    int width() const { return m_width; }
    int rows() const { return m_rows; }
    int stride() const { return m_stride; }
    std::uint32_t* keys() { return m_keys.data(); }
    const std::uint32_t* row(int y) const {
        return m_keys.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(m_stride);
    }
    // A cell behind the others that nothing is nearer than, for points outside.
    std::size_t overflow() const {
        return static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(m_paddedRows);
    }
    int tilesAcross() const { return m_stride / tile; }
    std::uint32_t* farthest() { return m_farthest.data(); }
    std::uint8_t* stale() { return m_stale.data(); } // not 0: the farthest key of the tile is out of date

private:
    int m_width = 0;
    int m_rows = 0;
    int m_stride = 0;
    int m_paddedRows = 0;
    std::vector<std::uint32_t> m_keys;
    std::vector<std::uint32_t> m_farthest;
    std::vector<std::uint8_t> m_stale;
};

// An open word of the walk, and half of the box around it.
struct OpenWord {
    SolidWord word;
    std::array<float, 3> half{};
};

struct SolidJob {
    SolidMaps maps;
    std::span<const Cover> covers; // coarse to fine; at least one
    float pixelsPerCode = 0;       // pixels across that equal one depth code
    KeyBand* band = nullptr;
    std::size_t budget = 0; // most work; when it is spent, the remaining words are drawn by the finest cover
    // Counted:
    std::size_t words = 0;  // words examined
    std::size_t points = 0; // points drawn
    std::size_t coarse = 0; // visible words in which the finest cover may leave holes
    // Memory kept from word to word:
    std::vector<OpenWord> open;
    std::vector<float> children;
    std::vector<std::uint64_t> order;
};

// Points of a cover that are this far apart at most leave no holes.
constexpr float maxSpacing = 0.9F; // pixels

// Returns true if neither the word nor anything within `around` pixels of it would be visible in the band.
bool isHidden(const SolidWord& word, float around, KeyBand& band);

// False when stopped, within milliseconds. Words and depths must be finite.
bool drawSolid(const SolidWord& word, SolidJob& job, const std::stop_token& stop);

} // namespace attractor::kernels
