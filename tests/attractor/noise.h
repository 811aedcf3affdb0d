// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/density_fold.h"
#include "attractor/folds/drawing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

// The noise of density pictures beside that of independent samples; docs/testing.md, "Noise".
namespace noise {

constexpr int seeds = 24;
constexpr double bright = 4; // samples that a cell has in the mean at least

struct Excess {
    double median = 0; // over all bright cells, of variance / expected variance; 0.97 for independent samples
    double mean = 0;   // of the same; 1 for independent samples
    double worst = 0;  // the largest mean over a group of neighbouring bright cells; 0 where they are too few
};

struct Report {
    Excess pixels; // in groups of 200
    Excess tiles;  // of 10 × 10 pixels, in groups of 50
};

// Sums over seeds of the counts of square cells, and of their squares.
class Spread {
public:
    Spread(int width, int height, int side)
        : m_side(side),
          m_columns(width / side),
          m_rows(height / side),
          m_sum(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows)),
          m_squares(m_sum.size()) {}

    void add(const std::vector<std::uint64_t>& pixels, int width) {
        for (int row = 0; row < m_rows; ++row)
            for (int column = 0; column < m_columns; ++column) {
                double count = 0;
                for (int y = row * m_side; y < (row + 1) * m_side; ++y)
                    for (int x = column * m_side; x < (column + 1) * m_side; ++x)
                        count += static_cast<double>(
                            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x)]);
                m_sum[at(row, column)] += count;
                m_squares[at(row, column)] += count * count;
            }
    }

    // A group is so many bright cells that lie together.
    Excess excess(double samples, std::size_t group) const {
        const std::vector<double> ratios = ratiosAlongCurve(samples);
        Excess result;
        if (ratios.empty()) return result;
        result.mean = meanOf(ratios.begin(), ratios.end());
        for (auto first = ratios.begin(); ratios.end() - first >= static_cast<std::ptrdiff_t>(group);
             first += static_cast<std::ptrdiff_t>(group))
            result.worst = std::max(result.worst, meanOf(first, first + static_cast<std::ptrdiff_t>(group)));
        std::vector<double> sorted = ratios;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        result.median = *middle;
        return result;
    }

private:
    std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(column);
    }
    template <class Iterator> static double meanOf(Iterator first, Iterator end) {
        return std::accumulate(first, end, 0.0) / static_cast<double>(end - first);
    }
    // Bits of column and row in turn: the place on a curve through all cells that keeps neighbours together.
    static std::uint64_t alongCurve(int row, int column) {
        std::uint64_t place = 0;
        for (int bit = 0; bit < 16; ++bit)
            place |= static_cast<std::uint64_t>(column >> bit & 1) << 2 * bit |
                     static_cast<std::uint64_t>(row >> bit & 1) << (2 * bit + 1);
        return place;
    }
    // Of the bright cells. The counts of independent samples are binomial.
    std::vector<double> ratiosAlongCurve(double samples) const {
        std::vector<std::pair<std::uint64_t, double>> placed;
        for (int row = 0; row < m_rows; ++row)
            for (int column = 0; column < m_columns; ++column) {
                const double mean = m_sum[at(row, column)] / seeds;
                const double expected = mean * (1 - mean / samples);
                if (mean < bright || !(expected > 0.05 * mean)) continue;
                const double variance = (m_squares[at(row, column)] - seeds * mean * mean) / (seeds - 1);
                placed.emplace_back(alongCurve(row, column), std::max(variance, 0.0) / expected);
            }
        std::sort(placed.begin(), placed.end());
        std::vector<double> result;
        for (const auto& [place, ratio] : placed)
            result.push_back(ratio);
        return result;
    }

    int m_side;
    int m_columns;
    int m_rows;
    std::vector<double> m_sum;
    std::vector<double> m_squares;
};

// Of 24 seeds of the request, one pass each.
inline Report measured(attractor::RenderRequest request) {
    const int width = request.camera.width;
    const int height = request.camera.height;
    Spread pixels(width, height, 1);
    Spread tiles(width, height, 10);
    folds::Drawing<attractor::DensityFold> drawing(request);
    for (int seed = 1; seed <= seeds; ++seed) {
        request.seed = static_cast<std::uint64_t>(seed);
        drawing.prepared.set(request);
        drawing.fold.start(drawing.workers);
        drawing.rewind();
        drawing.pass(request.samples);
        const std::vector<std::uint64_t> counts = folds::countsOf(drawing.sums());
        pixels.add(counts, width);
        tiles.add(counts, width);
    }
    const auto samples = static_cast<double>(request.samples);
    return {pixels.excess(samples, 200), tiles.excess(samples, 50)};
}

} // namespace noise
