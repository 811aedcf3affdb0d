// SPDX-License-Identifier: MIT
#include "collage/fit/attractor_fit.h"

#include "collage/measure/agreement.h"
#include "collage/measure/attractor_points.h"
#include "ifs/linear/singular_vectors.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace collage {

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t maxPoints = 5000;
constexpr double outlier = 2; // cells; beyond it, residuals count linearly instead of squared

ifs::Matrix<2> matrix(double a, double b, double c, double d) {
    return (ifs::Matrix<2>() << a, b, c, d).finished();
}

// The directions in which the linear part of a map may change, to first order.
std::vector<ifs::Matrix<2>> linearDirections(const ifs::Matrix<2>& a, const Constraints& constraints,
                                             std::size_t index) {
    if (constraints.isStem(index)) {
        const auto [u, values, v] = ifs::singularVectors<2>(a);
        return {u.col(0) * v.col(0).transpose(), u.col(0) * v.col(1).transpose(),
                u.col(1) * v.col(0).transpose()};
    }
    const bool isTurnFixed = constraints.angleStep > 0;
    if (constraints.mapClass == MapClass::Similarity) {
        const double sigma = ifs::determinant<2>(a) < 0 ? -1.0 : 1.0;
        if (isTurnFixed) return {turnOf(a)};
        return {matrix(1, 0, 0, sigma), matrix(0, -sigma, 1, 0)};
    }
    if (isTurnFixed) {
        const ifs::Matrix<2> turn = turnOf(a);
        return {turn * matrix(1, 0, 0, 0), turn * matrix(0, 1, 1, 0), turn * matrix(0, 0, 0, 1)};
    }
    return {matrix(1, 0, 0, 0), matrix(0, 1, 0, 0), matrix(0, 0, 1, 0), matrix(0, 0, 0, 1)};
}

// Directions of its numbers a b c d e f, one in each column.
Eigen::MatrixXd directions(const ifs::AffineMap<2>& map, const Constraints& constraints, std::size_t index) {
    const auto linear = linearDirections(map.linear, constraints, index);
    const auto count = Eigen::Index(linear.size());
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(6, count + 2);
    for (Eigen::Index k = 0; k < count; ++k) {
        const ifs::Matrix<2>& d = linear[std::size_t(k)];
        basis.col(k) << d(0, 0), d(0, 1), d(1, 0), d(1, 1), 0, 0;
    }
    basis(4, count) = 1;
    basis(5, count + 1) = 1;
    return basis;
}

// The free parameters of all maps: columns are directions, rows the 6 N numbers.
Eigen::MatrixXd freedom(const Maps& maps, const Constraints& constraints,
                        std::span<const std::uint8_t> locked) {
    const Eigen::Index numbers = 6 * Eigen::Index(maps.size());
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(numbers, numbers);
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!locked.empty() && locked[i] != 0) continue;
        const Eigen::MatrixXd own = directions(maps[i], constraints, i);
        basis.block(6 * Eigen::Index(i), column, 6, own.cols()) = own;
        column += own.cols();
    }
    return basis.leftCols(column);
}

// Goals of the points of the attractor: r = goal − x, with weights.
struct Residuals {
    std::vector<Eigen::Index> point;
    std::vector<double> x, y, weight;

    void add(std::size_t which, double dx, double dy, double share) {
        const double distance = std::hypot(dx, dy);
        point.push_back(Eigen::Index(which));
        x.push_back(dx);
        y.push_back(dy);
        weight.push_back(share * std::min(1.0, outlier / distance));
    }
};

Residuals residuals(const Target& target, const std::vector<AttractorPoint>& points) {
    Residuals result;
    const int width = target.grid.width, height = target.grid.height;
    std::vector<std::int32_t> labels(target.mask.cells.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double x = points[k].x, y = points[k].y;
        const int column = int(std::clamp(x, 0.0, width - 1.0)), row = int(std::clamp(y, 0.0, height - 1.0));
        const std::size_t cell = target.mask.index(column, row);
        if (x >= 0 && y >= 0 && x < width && y < height) labels[cell] = std::int32_t(k) + 1;
        if (target.features.square[cell] == 0) continue;
        const std::int32_t goal = target.features.nearest[cell];
        result.add(k, goal % width + 0.5 - x, goal / width + 0.5 - y, 1 / double(points.size()));
    }
    NearestCells nearest;
    nearest.prepare(labels, width, height);
    for (const std::int32_t cell : target.cells) {
        if (labels[std::size_t(cell)] != 0) continue;
        const auto found = nearest(cell % width, cell / width);
        if (found.cell < 0) break;
        const auto k = std::size_t(labels[std::size_t(found.cell)] - 1);
        result.add(k, cell % width + 0.5 - points[k].x, cell / width + 0.5 - points[k].y,
                   1 / double(target.cells.size()));
    }
    return result;
}

// The normal equations of one linearisation, in the free parameters.
struct Linearised {
    Eigen::MatrixXd pull; // equations of the residuals
    Eigen::MatrixXd hold; // equations of all points
    Eigen::VectorXd right;
};

Linearised linearised(const Target& target, const Maps& maps, const Eigen::MatrixXd& basis) {
    // Coarser derivatives: at most one point in a cell of the target.
    double step = 1;
    std::vector<AttractorPoint> points = attractorPoints(maps, target.grid, step, 16 * maxPoints);
    while (points.size() > maxPoints) {
        step *= std::max(1.1, std::sqrt(double(points.size()) / double(maxPoints)));
        points = attractorPoints(maps, target.grid, step, 16 * maxPoints);
    }
    const Residuals residual = residuals(target, points);
    const Rows rows = pointDerivatives(maps, points) * basis;
    const auto count = Eigen::Index(residual.point.size());
    Rows active(2 * count, basis.cols());
    Eigen::VectorXd goals(2 * count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto index = std::size_t(k);
        const double root = std::sqrt(residual.weight[index]);
        active.middleRows<2>(2 * k) = root * rows.middleRows<2>(2 * residual.point[index]);
        goals[2 * k] = root * residual.x[index];
        goals[2 * k + 1] = root * residual.y[index];
    }
    return {active.transpose() * active, rows.transpose() * rows / double(points.size()),
            active.transpose() * goals};
}

Maps moved(const Maps& maps, const Eigen::VectorXd& step, const AttractorSchedule& schedule,
           const ifs::Vector<2>& centre) {
    Maps result = maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto d = step.segment<6>(6 * Eigen::Index(i));
        if (d.isZero(0)) continue;
        result[i].linear += (ifs::Matrix<2>() << d[0], d[1], d[2], d[3]).finished();
        result[i].translation += ifs::Vector<2>(d[4], d[5]);
        result[i] = withNormAtMost(schedule.maxNorm, result[i], centre);
        result[i] = constrained(schedule.constraints, i, result[i], centre);
    }
    return result;
}

bool areFinite(const Maps& maps) {
    return std::ranges::all_of(maps, [](const auto& map) { return ifs::isFinite(map); });
}

// Levenberg and Marquardt: steps that do not help are shortened.
class Descent {
public:
    Descent(const Target& target, Maps maps, const AttractorSchedule& schedule)
        : m_target(target), m_maps(std::move(maps)), m_schedule(schedule) {
        m_error = errorOf(m_maps);
    }

    bool step(std::span<const std::uint8_t> locked) {
        Maps inside;
        for (const auto& map : m_maps)
            inside.push_back(inGrid(m_target.grid, map));
        const Eigen::MatrixXd basis = freedom(inside, m_schedule.constraints, locked);
        if (basis.cols() == 0) return false;
        const Linearised at = linearised(m_target, inside, basis);
        for (int attempt = 0; attempt < 4; ++attempt, m_damping *= 4) {
            Eigen::MatrixXd normal = at.pull + m_damping * at.hold;
            normal.diagonal() *= 1 + 1e-9;
            const Eigen::VectorXd free = normal.ldlt().solve(at.right);
            Maps trial = moved(inside, basis * free, m_schedule, m_target.mean);
            if (!areFinite(trial)) continue;
            // Copies maps that did not move, bit for bit.
            for (std::size_t i = 0; i < trial.size(); ++i)
                trial[i] = trial[i] == inside[i] ? m_maps[i] : fromGrid(m_target.grid, trial[i]);
            const double error = errorOf(trial);
            if (!(error < m_error)) continue;
            const bool isProgress = error < 0.999 * m_error;
            m_maps = std::move(trial);
            m_error = error;
            m_damping = std::max(1e-3, m_damping / 3);
            return isProgress;
        }
        return false;
    }

    const Maps& maps() const { return m_maps; }

private:
    double errorOf(const Maps& maps) const {
        return visibleError(m_target, attractorAgreement(m_target, maps));
    }

    const Target& m_target;
    Maps m_maps;
    const AttractorSchedule& m_schedule;
    double m_error = 0;
    double m_damping = 0.03;
};

} // namespace

std::vector<ifs::AffineMap<2>> fittedAttractor(const Target& target, std::vector<ifs::AffineMap<2>> maps,
                                               const AttractorSchedule& schedule,
                                               std::span<const std::uint8_t> locked,
                                               const std::stop_token& stop) {
    if (contraction(maps) >= 1) return maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!locked.empty() && locked[i] != 0) continue;
        const ifs::AffineMap<2> inside = inGrid(target.grid, maps[i]);
        const ifs::AffineMap<2> meeting = constrained(schedule.constraints, i, inside, target.mean);
        if (!(meeting == inside)) maps[i] = fromGrid(target.grid, meeting);
    }
    Descent descent(target, std::move(maps), schedule);
    for (int iteration = 0; iteration < schedule.iterations; ++iteration)
        if (stop.stop_requested() || !descent.step(locked)) break;
    return descent.maps();
}

} // namespace collage
