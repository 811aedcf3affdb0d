// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

// Box-counting dimension. docs/mathematics.md, "Box counting".
namespace ifs {

// A square of side `side` cut into 2^levels × 2^levels half-open cells, row by row from `origin` on.
struct CellGrid {
    Vector<2> origin = Vector<2>::Zero();
    double side = 1;
    int levels = 0;
    std::vector<std::uint8_t> occupied; // 4^levels, each 0 or 1

    bool mark(const Vector<2>& x); // true if the cell was empty; false for points outside
};
CellGrid emptyGrid(const Vector<2>& origin, double side, int levels); // 0 ≤ levels ≤ 14

// N_k, the number of boxes of side·2^−k that hold an occupied cell, for k = 0 … levels.
std::vector<std::uint64_t> boxCounts(CellGrid grid);

// The least of these counts over four places of the boxes, half a box apart in x and y, for k = 0 … levels −
// 1: a count depends on how the boxes happen to lie.
std::vector<std::uint64_t> leastBoxCounts(const CellGrid& grid);

// The least-squares line of ln N_k over k·ln 2 for first ≤ k ≤ last: its slope estimates the dimension.
struct LogLogFit {
    double slope = 0;
    double intercept = 0; // ln N at k = 0
    double deviation = 0; // root mean square of the residuals
};
// nullopt with fewer than two counts or one that is 0.
std::optional<LogLogFit> fitted(const std::vector<std::uint64_t>& counts, int first, int last);

// Cells of a square around the attractor, each of which certainly holds a point of it. In work bounded by the
// number of cells, whatever overlaps: one point per half-cell is followed, so that every point of the
// attractor lies within half a diagonal · C/(1 − γ) of one that marked its cell. nullopt for a single point,
// or when stopped. `image`: of the attractor's image under that invertible map, with C and γ of the image.
// The square is at least `minSide` wide.
std::optional<CellGrid> occupiedCells(const SupportFunction<2>& support, int levels, // levels ≤ 12
                                      const AffineMap<2>& image = {}, const std::stop_token& stop = {},
                                      double minSide = 0);

// N_k over k for an attractor, the least over some places of the boxes, with the line over the range in which
// the counts are the most even: neither the size of the attractor nor that of the cells distorts them there.
// Boxes that are turned are counted, too, for the uncertainty.
struct BoxCounting {
    std::vector<std::uint64_t> counts;
    double side = 0; // side of the box at k = 0
    int first = 0, last = 0;
    LogLogFit fit; // fit over first … last
    // Empirical uncertainty, no proof: the differences between this slope, those of parts of the range, and
    // those of the counts in each direction. Rotating the image changes the slope by no more.
    double uncertainty = 0;
};
std::optional<BoxCounting> boxCounting(const SupportFunction<2>& support, const AffineMap<2>& image = {},
                                       const std::stop_token& stop = {});

} // namespace ifs
