// SPDX-License-Identifier: MIT
#pragma once

#include "collage/fit/constraints.h"

#include "ifs/system/affine_map.h"

namespace collage {

// Sums over pairs of a point p and where it should go, t, each with a weight: what a least-squares fit of
// one map needs.
struct PairSums {
    Eigen::Matrix3d points = Eigen::Matrix3d::Zero();                         // Σ w (p, 1)(p, 1)ᵀ
    Eigen::Matrix<double, 3, 2> images = Eigen::Matrix<double, 3, 2>::Zero(); // Σ w (p, 1) tᵀ

    void add(double x, double y, double imageX, double imageY, double weight) {
        points(0, 0) += weight * x * x;
        points(0, 1) += weight * x * y;
        points(0, 2) += weight * x;
        points(1, 1) += weight * y * y;
        points(1, 2) += weight * y;
        points(2, 2) += weight;
        images(0, 0) += weight * x * imageX;
        images(0, 1) += weight * x * imageY;
        images(1, 0) += weight * y * imageX;
        images(1, 1) += weight * y * imageY;
        images(2, 0) += weight * imageX;
        images(2, 1) += weight * imageY;
    }
    // Adds pairs (p, map(p)) for the points whose moments are given, each with the weight. Only the upper
    // half of `moments` is read, like that of `points`.
    void addFixed(const Eigen::Matrix3d& moments, const ifs::AffineMap<2>& map, double weight);
    // Adds pairs two units apart along this unit vector, mapped as a similarity would that does the same as
    // `current` at right angles to it. The vector 0 adds nothing.
    void addAcross(const ifs::Vector<2>& vector, const ifs::Matrix<2>& current);
};

// The map of its class that minimises Σ w |map(p) − t|², as near to `current` as the pairs leave a choice. A
// similarity mirrors exactly if `current` does.
ifs::AffineMap<2> leastSquaresMap(const PairSums& sums, MapClass mapClass, const ifs::AffineMap<2>& current);

// The map with its singular values at most `limit`; the image of `centre` stays.
ifs::AffineMap<2> withNormAtMost(double limit, ifs::AffineMap<2> map, const ifs::Vector<2>& centre);

} // namespace collage
