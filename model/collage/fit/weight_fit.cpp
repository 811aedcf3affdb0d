// SPDX-License-Identifier: MIT
#include "collage/fit/weight_fit.h"

#include "collage/measure/transport_bound.h"
#include "collage/target/target.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace collage {

namespace {

using Field = Eigen::MatrixXd; // row y, column x; rows from the top

// Adds mass at a point in pixels; mass outside is lost.
void deposit(Field& field, double x, double y, double mass) {
    if (x >= 0 && y >= 0 && x < double(field.cols()) && y < double(field.rows()))
        field(Eigen::Index(y), Eigen::Index(x)) += mass;
}

// (w)_#ν. Four points stand for each pixel.
Field image(const Field& measure, const ifs::AffineMap<2>& map) {
    Field result = Field::Zero(measure.rows(), measure.cols());
    const auto height = double(measure.rows()), middle = double(measure.cols()) / 2;
    for (Eigen::Index row = 0; row < measure.rows(); ++row)
        for (Eigen::Index column = 0; column < measure.cols(); ++column) {
            if (measure(row, column) == 0) continue;
            for (const double dx : {0.25, 0.75})
                for (const double dy : {0.25, 0.75}) {
                    const ifs::Vector<2> to =
                        map({(double(column) + dx - middle) / height, 0.5 - (double(row) + dy) / height});
                    deposit(result, to.x() * height + middle, (0.5 - to.y()) * height,
                            measure(row, column) / 4);
                }
        }
    return result;
}

Field blurredRows(const Field& field, const std::vector<double>& kernel) {
    Field result = Field::Zero(field.rows(), field.cols());
    const auto reach = Eigen::Index(kernel.size()) - 1;
    for (Eigen::Index shift = -reach; shift <= reach; ++shift) {
        const Eigen::Index length = field.cols() - std::abs(shift);
        if (length <= 0) continue;
        result.middleCols(std::max<Eigen::Index>(0, shift), length) +=
            kernel[std::size_t(std::abs(shift))] *
            field.middleCols(std::max<Eigen::Index>(0, -shift), length);
    }
    return result;
}

Field blurred(const Field& field, double deviation) {
    if (!(deviation > 0)) return field;
    std::vector<double> kernel;
    for (int shift = 0; shift <= int(std::ceil(3 * deviation)); ++shift)
        kernel.push_back(std::exp(-shift * shift / (2 * deviation * deviation)));
    const double sum = 2 * std::accumulate(kernel.begin(), kernel.end(), 0.0) - kernel.front();
    for (double& weight : kernel)
        weight /= sum;
    const Field rows = blurredRows(field, kernel);
    return blurredRows(rows.transpose(), kernel).transpose();
}

// The minimum on the plane Σ p = 1 of those that are free; the others are 0.
Eigen::VectorXd planeMinimum(const Eigen::MatrixXd& q, const Eigen::VectorXd& c,
                             const std::vector<Eigen::Index>& free) {
    const auto n = Eigen::Index(free.size());
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd right(n + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index k = 0; k < n; ++k)
            kkt(i, k) = q(free[std::size_t(i)], free[std::size_t(k)]);
        kkt(i, n) = kkt(n, i) = 1;
        right[i] = c[free[std::size_t(i)]];
    }
    right[n] = 1;
    const Eigen::VectorXd solution = kkt.fullPivLu().solve(right);
    Eigen::VectorXd p = Eigen::VectorXd::Zero(c.size());
    for (Eigen::Index i = 0; i < n; ++i)
        p[free[std::size_t(i)]] = solution[i];
    return p;
}

// Goes from p towards the goal as far as all weights stay positive; the one that becomes 0 is no longer free.
Eigen::VectorXd towards(const Eigen::VectorXd& p, const Eigen::VectorXd& goal,
                        std::vector<Eigen::Index>& free) {
    double share = 1;
    std::size_t blocking = free.size();
    for (std::size_t i = 0; i < free.size(); ++i) {
        const double from = p[free[i]], to = goal[free[i]];
        if (to > 0 || from - to <= 0) continue;
        const double here = from / (from - to);
        if (here >= share && blocking < free.size()) continue;
        share = std::min(share, here);
        blocking = i;
    }
    Eigen::VectorXd next = p + share * (goal - p);
    if (blocking == free.size()) return goal;
    next[free[blocking]] = 0;
    free.erase(free.begin() + std::ptrdiff_t(blocking));
    return next;
}

} // namespace

Eigen::VectorXd simplexMinimum(const Eigen::MatrixXd& q, const Eigen::VectorXd& c) {
    const Eigen::Index n = c.size();
    if (n == 0) return {};
    // Tiny ridge, which decides between equal solutions.
    const double scale = std::max(q.diagonal().maxCoeff(), std::numeric_limits<double>::min());
    const Eigen::MatrixXd hessian = q + 1e-13 * scale * Eigen::MatrixXd::Identity(n, n);
    Eigen::Index best = 0;
    for (Eigen::Index i = 1; i < n; ++i)
        if (q(i, i) - 2 * c[i] < q(best, best) - 2 * c[best]) best = i;
    Eigen::VectorXd p = Eigen::VectorXd::Unit(n, best);
    std::vector<Eigen::Index> free{best};
    for (Eigen::Index turn = 0; turn < 20 * n + 20; ++turn) {
        const Eigen::VectorXd goal = planeMinimum(hessian, c, free);
        if (std::ranges::any_of(free, [&](Eigen::Index i) { return goal[i] <= 0; }) && free.size() > 1) {
            p = towards(p, goal, free);
            continue;
        }
        p = goal;
        const Eigen::VectorXd slope = hessian * p - c; // equal in all free components
        Eigen::Index steepest = free.front();
        for (Eigen::Index i = 0; i < n; ++i)
            if (std::ranges::find(free, i) == free.end() && slope[i] < slope[steepest]) steepest = i;
        if (slope[steepest] >= slope[free.front()] - 1e-12 * scale || steepest == free.front()) break;
        free.push_back(steepest);
    }
    return p.cwiseMax(0) / p.cwiseMax(0).sum();
}

std::vector<double> fittedWeights(const Density& density, std::span<const ifs::AffineMap<2>> maps,
                                  double blur, const std::stop_token& stop) {
    const auto count = Eigen::Index(maps.size());
    Field measure(density.height, density.width);
    for (Eigen::Index i = 0; i < measure.size(); ++i)
        measure(i / density.width, i % density.width) = density.mass[std::size_t(i)];
    if (!(measure.sum() > 0)) return std::vector<double>(maps.size(), 1.0 / double(count));
    measure /= measure.sum();
    std::vector<Field> images;
    for (const ifs::AffineMap<2>& map : maps) {
        if (stop.stop_requested()) return {};
        images.push_back(blurred(image(measure, map), blur));
    }
    const Field goal = blurred(measure, blur);
    Eigen::MatrixXd q(count, count);
    Eigen::VectorXd c(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        if (stop.stop_requested()) return {};
        c[i] = images[std::size_t(i)].cwiseProduct(goal).sum();
        for (Eigen::Index k = 0; k < count; ++k)
            q(i, k) = images[std::size_t(i)].cwiseProduct(images[std::size_t(k)]).sum();
    }
    const Eigen::VectorXd p = simplexMinimum(q, c);
    return {p.begin(), p.end()};
}

std::optional<double> measureBound(const Density& density, std::span<const ifs::AffineMap<2>> maps,
                                   std::span<const double> weights, const std::stop_token& stop) {
    const double mass = std::accumulate(density.mass.begin(), density.mass.end(), 0.0);
    double contraction = 0; // average
    for (std::size_t i = 0; i < maps.size(); ++i)
        contraction += weights[i] * ifs::spectralNorm<2>(maps[i].linear);
    if (!(mass > 0) || !(contraction < 1)) return std::nullopt;
    const double side = 1.0 / density.height;
    const Grid grid{-density.width * side / 2, 0.5, side, density.width, density.height};
    std::vector<ifs::AffineMap<2>> inside;
    for (const ifs::AffineMap<2>& map : maps)
        inside.push_back(inGrid(grid, map));
    TransportBound bound(density.width, density.height);
    for (std::size_t k = 0; k < density.mass.size(); ++k) {
        if (k % std::size_t(density.width) == 0 && stop.stop_requested()) return std::nullopt;
        if (density.mass[k] == 0) continue;
        const double share = density.mass[k] / mass;
        const auto width = std::size_t(density.width);
        const ifs::Vector<2> centre(double(k % width) + 0.5, double(k / width) + 0.5);
        bound.addDemand({share, centre, 1.0 / 6}); // even distribution over the pixel
        for (std::size_t i = 0; i < maps.size(); ++i)
            bound.addSupply({share * weights[i], inside[i](centre), inside[i].linear.squaredNorm() / 12});
    }
    const double cost = std::move(bound).cost(stop);
    return stop.stop_requested() ? std::nullopt : std::optional(cost / (1 - contraction));
}

} // namespace collage
