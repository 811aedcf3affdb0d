// SPDX-License-Identifier: MIT
#include "collage/random_collages.h"

#include "collage/measure/attractor_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace random_collages {

namespace {

double uniform(std::mt19937& random, double a, double b) {
    return a + (b - a) * random() * 0x1p-32;
}

} // namespace

Collage contracting(std::mt19937& random, int side) {
    Collage collage{collage::emptyMask(side, side), {}};
    const double unit = side / 24.0;
    for (int disc = 0; disc < 3; ++disc) {
        const double x = uniform(random, 4, 20) * unit, y = uniform(random, 4, 20) * unit;
        const double r = uniform(random, 0.8, 5) * unit;
        for (int v = 0; v < side; ++v)
            for (int u = 0; u < side; ++u)
                if (std::hypot(u - x, v - y) < r) collage.mask.cells[collage.mask.index(u, v)] = 1;
    }
    const int count = 2 + int(random() % 3);
    for (int i = 0; i < count; ++i) {
        const double a = uniform(random, -1, 1), b = uniform(random, -1, 1), c = uniform(random, -1, 1),
                     d = uniform(random, -1, 1), e = uniform(random, -0.3, 0.3),
                     f = uniform(random, -0.3, 0.3);
        ifs::AffineMap<2> map = ifs::affineMap(a, b, c, d, e, f);
        map.linear *= uniform(random, 0.1, 0.85) / ifs::spectralNorm<2>(map.linear);
        collage.maps.push_back(map);
    }
    return collage;
}

Collage stretching(std::mt19937& random, int side) {
    for (;;) {
        Collage collage = contracting(random, side);
        // A turn, and then a stretch.
        const double angle = uniform(random, 0, 3), stretch = uniform(random, 2, 5);
        const ifs::Matrix<2> t = (ifs::Matrix<2>() << stretch * std::cos(angle), -stretch * std::sin(angle),
                                  std::sin(angle), std::cos(angle))
                                     .finished();
        double longest = 0;
        for (auto& map : collage.maps) {
            map.linear = (t * map.linear * t.inverse()).eval();
            longest = std::max(longest, ifs::spectralNorm<2>(map.linear));
        }
        if (longest > 1.05) return collage;
    }
}

Truth distanceToAttractor(const collage::Target& target, const std::vector<ifs::AffineMap<2>>& maps,
                          double widening, double step) {
    std::vector<ifs::AffineMap<2>> inside;
    for (const auto& map : maps)
        inside.push_back(inGrid(target.grid, map));
    const auto points = collage::attractorPoints(inside, target.grid, step, 300'000);
    // Of any point of A from those.
    const double gap = step * std::sqrt(2) * widening;
    const std::size_t cells = target.cells.size();
    std::vector<double> nearest(cells, HUGE_VAL); // squares of distances
    double farthest = 0;
    for (const collage::AttractorPoint& point : points) {
        double least = HUGE_VAL;
        for (std::size_t k = 0; k < cells; ++k) {
            const double x = std::abs(point.x - double(target.columns[k]));
            const double y = std::abs(point.y - double(target.rows[k]));
            nearest[k] = std::min(nearest[k], x * x + y * y);
            const double dx = std::max(0.0, x - 0.5), dy = std::max(0.0, y - 0.5);
            least = std::min(least, dx * dx + dy * dy);
        }
        farthest = std::max(farthest, least);
    }
    const double ofCells = std::sqrt(std::ranges::max(nearest)), ofPoints = std::sqrt(farthest);
    return {std::max(ofCells - gap, ofPoints), std::max(ofCells + std::sqrt(0.5), ofPoints + gap)};
}

} // namespace random_collages
