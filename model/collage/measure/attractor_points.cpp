// SPDX-License-Identifier: MIT
#include "collage/measure/attractor_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace collage {

namespace {

// The squares that have a point: a bit each within the grid, a set outside it.
class Squares {
public:
    Squares(const Grid& grid, double step)
        : m_step(step),
          m_columns(std::int64_t(std::ceil(grid.width / step))),
          m_rows(std::int64_t(std::ceil(grid.height / step))),
          m_seen(std::size_t(m_columns) * std::size_t(m_rows)) {}

    // Returns false if the square of this point is occupied, or too far away to matter.
    bool insert(double x, double y) {
        const double column = std::floor(x / m_step), row = std::floor(y / m_step);
        if (!(std::abs(column) < 1e9 && std::abs(row) < 1e9)) return false;
        const auto c = std::int64_t(column), r = std::int64_t(row);
        if (c < 0 || r < 0 || c >= m_columns || r >= m_rows)
            return m_outside.insert(c * (1LL << 32) + r).second;
        std::uint8_t& seen = m_seen[std::size_t(r * m_columns + c)];
        if (seen != 0) return false;
        seen = 1;
        return true;
    }

private:
    double m_step;
    std::int64_t m_columns;
    std::int64_t m_rows;
    std::vector<std::uint8_t> m_seen;
    std::unordered_set<std::int64_t> m_outside;
};

} // namespace

std::vector<AttractorPoint> attractorPoints(std::span<const ifs::AffineMap<2>> maps, const Grid& grid,
                                            double step, std::size_t maxPoints) {
    if (maps.empty()) return {};
    const auto start = ifs::fixedPoint(maps.front());
    if (!start) return {};
    Squares squares(grid, step);
    squares.insert(start->x(), start->y());
    std::vector<AttractorPoint> points{{start->x(), start->y(), 0, 0}};
    for (std::size_t next = 0; next < points.size() && points.size() < maxPoints; ++next)
        for (std::size_t i = 0; i < maps.size() && points.size() < maxPoints; ++i) {
            const ifs::Matrix<2>& a = maps[i].linear;
            const ifs::Vector<2>& b = maps[i].translation;
            const AttractorPoint from = points[next];
            const double x = a(0, 0) * from.x + a(0, 1) * from.y + b.x();
            const double y = a(1, 0) * from.x + a(1, 1) * from.y + b.y();
            if (squares.insert(x, y)) points.push_back({x, y, std::int32_t(next), std::int32_t(i)});
        }
    return points;
}

PointDerivatives pointDerivatives(std::span<const ifs::AffineMap<2>> maps,
                                  std::span<const AttractorPoint> points) {
    PointDerivatives rows =
        PointDerivatives::Zero(2 * Eigen::Index(points.size()), 6 * Eigen::Index(maps.size()));
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

} // namespace collage
