// SPDX-License-Identifier: MIT
#include "collage/target/target.h"

#include <algorithm>
#include <cmath>

namespace collage {

namespace {

// Number of pixels of the shape in every cell; the first cell begins at (left, top) of the picture.
std::vector<int> coverage(const Mask& picture, int left, int top, int factor, const Mask& cells) {
    std::vector<int> count(cells.cells.size());
    const PixelBox box = boxOf(picture);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            if (picture(x, y)) ++count[cells.index((x - left) / factor, (y - top) / factor)];
    return count;
}

Mask reduced(const Mask& shape, const std::vector<int>& count, int factor) {
    const int half = (factor * factor + 1) / 2;
    Mask mask = shape;
    std::ranges::transform(count, mask.cells.begin(), [half](int n) { return std::uint8_t(n >= half); });
    const Mask filled = mask;
    const auto hasNeighbour = [&](int x, int y) {
        for (int v = std::max(0, y - 1); v <= std::min(mask.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(mask.width - 1, x + 1); ++u)
                if (filled(u, v)) return true;
        return false;
    };
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (count[mask.index(x, y)] > 0 && !hasNeighbour(x, y)) mask.cells[mask.index(x, y)] = 1;
    return mask;
}

void list(Target& target) {
    const Mask& mask = target.mask;
    for (std::size_t cell = 0; cell < mask.cells.size(); ++cell) {
        if (mask.cells[cell] == 0) continue;
        target.cells.push_back(std::int32_t(cell));
        target.columns.push_back(float(cell % std::size_t(mask.width)) + 0.5F);
        target.rows.push_back(float(cell / std::size_t(mask.width)) + 0.5F);
    }
    const auto count = double(target.cells.size());
    target.mean.setZero();
    target.spread.setZero();
    for (std::size_t k = 0; k < target.cells.size(); ++k)
        target.mean += ifs::Vector<2>(target.columns[k], target.rows[k]) / count;
    for (std::size_t k = 0; k < target.cells.size(); ++k) {
        const ifs::Vector<2> d = ifs::Vector<2>(target.columns[k], target.rows[k]) - target.mean;
        target.spread += d * d.transpose();
    }
}

} // namespace

ifs::AffineMap<2> Grid::toGrid() const {
    return ifs::affineMap(1 / cell, 0, 0, -1 / cell, -left / cell, top / cell);
}

ifs::AffineMap<2> Grid::fromGrid() const {
    return ifs::affineMap(cell, 0, 0, -cell, left, top);
}

ifs::AffineMap<2> inGrid(const Grid& grid, const ifs::AffineMap<2>& map) {
    return grid.toGrid() * map * grid.fromGrid();
}

ifs::AffineMap<2> fromGrid(const Grid& grid, const ifs::AffineMap<2>& map) {
    return grid.fromGrid() * map * grid.toGrid();
}

Target target(const Mask& picture, int factor, double margin) {
    const PixelBox box = boxOf(picture);
    const int columns = (box.width() + factor - 1) / factor, rows = (box.height() + factor - 1) / factor;
    const int pad = std::max(2, int(std::ceil(margin * std::max(columns, rows))));
    Target result;
    const double pixel = 1.0 / picture.height;
    // Centres the box in its cells, so that a thin line lies in the middle of the cells set for it.
    const int left = box.left - pad * factor - (columns * factor - box.width()) / 2;
    const int top = box.top - pad * factor - (rows * factor - box.height()) / 2;
    result.grid = {(left - picture.width / 2.0) * pixel, (picture.height / 2.0 - top) * pixel, factor * pixel,
                   columns + 2 * pad, rows + 2 * pad};
    const Mask empty = emptyMask(result.grid.width, result.grid.height);
    result.mask = reduced(empty, coverage(picture, left, top, factor, empty), factor);
    result.features = featureTransform(result.mask);
    result.size = std::max(box.width(), box.height()) * pixel;
    list(result);
    return result;
}

int factorFor(const Mask& picture, int side) {
    const PixelBox box = boxOf(picture);
    return std::max(1, (std::max(box.width(), box.height()) + side - 1) / side);
}

} // namespace collage
