// SPDX-License-Identifier: MIT
#include "ifs/cage/cage_preimage.h"

#include <algorithm>

namespace ifs {

namespace {

double sizeOf(const CageDeformation& bend) {
    const std::span<const Vector<3>> vertices = bend.rest()->vertices();
    double size = 0;
    for (const Vector<3>& vertex : vertices)
        size = std::max(size, (vertex - vertices.front()).norm());
    return size;
}

} // namespace

Matrix<3> derivative(const CageDeformation& bend, const Vector<3>& x) {
    const double step = 1e-5 * sizeOf(bend);
    Matrix<3> result;
    for (int k = 0; k < 3; ++k) {
        const Vector<3> along = step * Vector<3>::Unit(k);
        result.col(k) = (bend(x + along) - bend(x - along)) / (2 * step);
    }
    return result;
}

std::optional<Vector<3>> preimage(const CageDeformation& bend, const Vector<3>& displayed,
                                  const Vector<3>& start) {
    constexpr int maxSteps = 30;
    constexpr int maxHalvings = 8;
    const double enough = 1e-10 * sizeOf(bend); // length of a step at rest
    Vector<3> x = start;
    Vector<3> miss = displayed - bend(x);
    for (int step = 0; step < maxSteps; ++step) {
        const auto back = inverse(AffineMap<3>{derivative(bend, x), Vector<3>::Zero()});
        if (!back) return std::nullopt;
        Vector<3> by = back->linear * miss;
        if (!by.allFinite()) return std::nullopt;
        if (by.norm() <= enough) return x + by;
        bool isNearer = false;
        for (int halving = 0; halving < maxHalvings && !isNearer; ++halving) {
            const Vector<3> left = displayed - bend(x + by);
            isNearer = left.norm() < miss.norm();
            if (isNearer) {
                x += by;
                miss = left;
            } else {
                by /= 2;
            }
        }
        if (!isNearer) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace ifs
