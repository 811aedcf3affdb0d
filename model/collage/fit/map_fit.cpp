// SPDX-License-Identifier: MIT
#include "collage/fit/map_fit.h"

#include "ifs/linear/singular_vectors.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace collage {

namespace {

ifs::AffineMap<2> affineFit(const Eigen::Matrix3d& points, const Eigen::Matrix<double, 3, 2>& images) {
    const Eigen::Matrix<double, 3, 2> rows = points.ldlt().solve(images);
    ifs::AffineMap<2> map;
    map.linear = rows.topRows<2>().transpose();
    map.translation = rows.row(2).transpose();
    return map;
}

// [[a, −σb], [b, σa]] with σ = −1 where the map mirrors.
ifs::AffineMap<2> similarityFit(const Eigen::Matrix3d& points, const Eigen::Matrix<double, 3, 2>& images,
                                double sigma) {
    const double square = points(0, 0) + points(1, 1), x = points(0, 2), y = points(1, 2), n = points(2, 2);
    Eigen::Matrix4d normal;
    normal << square, 0, x, sigma * y, 0, square, -sigma * y, x, x, -sigma * y, n, 0, sigma * y, x, 0, n;
    const Eigen::Vector4d right(images(0, 0) + sigma * images(1, 1), images(0, 1) - sigma * images(1, 0),
                                images(2, 0), images(2, 1));
    const Eigen::Vector4d s = normal.ldlt().solve(right);
    return ifs::affineMap(s[0], -sigma * s[1], s[1], sigma * s[0], s[2], s[3]);
}

} // namespace

void PairSums::addFixed(const Eigen::Matrix3d& moments, const ifs::AffineMap<2>& map, double weight) {
    points += weight * moments;
    Eigen::Matrix<double, 3, 2> rows;
    rows << map.linear.transpose(), map.translation.transpose();
    images += weight * (moments.selfadjointView<Eigen::Upper>() * rows);
}

void PairSums::addAcross(const ifs::Vector<2>& vector, const ifs::Matrix<2>& current) {
    const ifs::Vector<2> along = current * ifs::Vector<2>(vector.y(), -vector.x());
    const double sigma = ifs::determinant<2>(current) < 0 ? -1.0 : 1.0;
    const ifs::Vector<2> image(-sigma * along.y(), sigma * along.x());
    const double weight = 4 * points(2, 2);
    points.topLeftCorner<2, 2>() += weight * vector * vector.transpose();
    images.topRows<2>() += weight * vector * image.transpose();
}

ifs::AffineMap<2> leastSquaresMap(const PairSums& sums, MapClass mapClass, const ifs::AffineMap<2>& current) {
    // Holds directions that the pairs do not determine.
    PairSums held = sums;
    held.addFixed(Eigen::Matrix3d::Identity(), current, 1e-12 * sums.points.trace());
    const Eigen::Matrix3d points = held.points.selfadjointView<Eigen::Upper>();
    const ifs::AffineMap<2> map =
        mapClass == MapClass::Affine
            ? affineFit(points, held.images)
            : similarityFit(points, held.images, ifs::determinant<2>(current.linear) < 0 ? -1.0 : 1.0);
    return ifs::isFinite(map) ? map : current;
}

ifs::AffineMap<2> withNormAtMost(double limit, ifs::AffineMap<2> map, const ifs::Vector<2>& centre) {
    if (ifs::spectralNorm<2>(map.linear) <= limit) return map;
    const auto [left, values, right] = ifs::singularVectors<2>(map.linear);
    const ifs::Vector<2> image = map(centre);
    map.linear = left * values.cwiseMin(limit).asDiagonal() * right.transpose();
    map.translation = image - map.linear * centre;
    return map;
}

} // namespace collage
