// SPDX-License-Identifier: MIT
#include "collage/fit/attractor_fit.h"

#include "collage/measure/agreement.h"
#include "collage/measure/attractor_points.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace collage {

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t maxPoints = 5000;
constexpr double outlier = 2; // cells; farther residuals count by their distance, not its square

// The directions in which a map may change, of its numbers a b c d e f, one in each column.
Eigen::MatrixXd directions(const ifs::AffineMap<2>& map, MapClass mapClass) {
    if (mapClass == MapClass::Affine) return Eigen::MatrixXd::Identity(6, 6);
    const double sigma = ifs::determinant<2>(map.linear) < 0 ? -1.0 : 1.0;
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(6, 4);
    basis.col(0) << 1, 0, 0, sigma, 0, 0;
    basis.col(1) << 0, -sigma, 1, 0, 0, 0;
    basis(4, 2) = 1;
    basis(5, 3) = 1;
    return basis;
}

// The free parameters of all maps: columns are directions, rows the 6 N numbers.
Eigen::MatrixXd freedom(const Maps& maps, MapClass mapClass, std::span<const std::uint8_t> locked) {
    const Eigen::Index each = mapClass == MapClass::Affine ? 6 : 4;
    Eigen::MatrixXd basis =
        Eigen::MatrixXd::Zero(6 * Eigen::Index(maps.size()), each * Eigen::Index(maps.size()));
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!locked.empty() && locked[i] != 0) continue;
        basis.block(6 * Eigen::Index(i), column, 6, each) = directions(maps[i], mapClass);
        column += each;
    }
    return basis.leftCols(column);
}

// How the points move with the 6 N numbers: two rows for each point.
Rows derivatives(const Maps& maps, const std::vector<AttractorPoint>& points) {
    Rows rows = Rows::Zero(2 * Eigen::Index(points.size()), 6 * Eigen::Index(maps.size()));
    for (std::size_t k = 0; k < points.size(); ++k) {
        const AttractorPoint& point = points[k];
        const AttractorPoint& from = points[std::size_t(point.parent)];
        auto here = rows.middleRows<2>(2 * Eigen::Index(k));
        const ifs::Matrix<2>& a = maps[std::size_t(point.map)].linear;
        if (k > 0) here = a * rows.middleRows<2>(2 * Eigen::Index(point.parent));
        auto own = here.middleCols<6>(6 * Eigen::Index(point.map));
        own.row(0) += Eigen::Matrix<double, 1, 6>(from.x, from.y, 0, 0, 1, 0);
        own.row(1) += Eigen::Matrix<double, 1, 6>(0, 0, from.x, from.y, 0, 1);
        if (k == 0) own = ((ifs::Matrix<2>::Identity() - a).inverse() * own).eval();
    }
    return rows;
}

// Where points of the attractor should go: r = goal − x, with weights.
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
    Eigen::MatrixXd pull; // of the residuals
    Eigen::MatrixXd hold; // of all points
    Eigen::VectorXd right;
};

Linearised linearised(const Target& target, const Maps& maps, const Eigen::MatrixXd& basis) {
    // Few enough points for the derivatives, at most one in a cell of the target.
    double step = 1;
    std::vector<AttractorPoint> points = attractorPoints(maps, target.grid, step, 16 * maxPoints);
    while (points.size() > maxPoints) {
        step *= std::max(1.1, std::sqrt(double(points.size()) / double(maxPoints)));
        points = attractorPoints(maps, target.grid, step, 16 * maxPoints);
    }
    const Residuals residual = residuals(target, points);
    const Rows rows = derivatives(maps, points) * basis;
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

Maps moved(const Maps& maps, const Eigen::VectorXd& step, double largestNorm, const ifs::Vector<2>& centre) {
    Maps result = maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto d = step.segment<6>(6 * Eigen::Index(i));
        if (d.isZero(0)) continue;
        result[i].linear += (ifs::Matrix<2>() << d[0], d[1], d[2], d[3]).finished();
        result[i].translation += ifs::Vector<2>(d[4], d[5]);
        result[i] = withNormAtMost(largestNorm, result[i], centre);
    }
    return result;
}

bool areFinite(const Maps& maps) {
    return std::ranges::all_of(maps, [](const auto& map) { return ifs::isFinite(map); });
}

// Levenberg and Marquardt: steps that do not help are shortened.
class Descent {
public:
    Descent(const Target& target, Maps maps, double largestNorm)
        : m_target(target), m_maps(std::move(maps)), m_largestNorm(largestNorm) {
        m_error = errorOf(m_maps);
    }

    bool step(const Eigen::MatrixXd& basis) {
        Maps inside;
        for (const auto& map : m_maps)
            inside.push_back(inGrid(m_target.grid, map));
        const Linearised at = linearised(m_target, inside, basis);
        for (int attempt = 0; attempt < 4; ++attempt, m_damping *= 4) {
            Eigen::MatrixXd normal = at.pull + m_damping * at.hold;
            normal.diagonal() *= 1 + 1e-9;
            const Eigen::VectorXd free = normal.ldlt().solve(at.right);
            Maps trial = moved(inside, basis * free, m_largestNorm, m_target.mean);
            if (!areFinite(trial)) continue;
            // What did not move keeps its bits.
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
    double m_largestNorm;
    double m_error = 0;
    double m_damping = 0.03;
};

} // namespace

std::vector<ifs::AffineMap<2>> fittedAttractor(const Target& target, std::vector<ifs::AffineMap<2>> maps,
                                               const AttractorSchedule& schedule,
                                               std::span<const std::uint8_t> locked) {
    if (contraction(maps) >= 1) return maps;
    const Eigen::MatrixXd basis = freedom(maps, schedule.mapClass, locked);
    if (basis.cols() == 0) return maps;
    Descent descent(target, std::move(maps), schedule.largestNorm);
    for (int iteration = 0; iteration < schedule.iterations && descent.step(basis); ++iteration) {}
    return descent.maps();
}

} // namespace collage
