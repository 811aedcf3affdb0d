// SPDX-License-Identifier: MIT
#include "collage/fit/cage_fit.h"

#include "collage/measure/agreement.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace collage {

namespace {

using Points = std::vector<ifs::Vector<2>>;

constexpr int restSide = 256;       // cells along the longer side of the cage at rest
constexpr int iterations = 60;      // rounds of closest points
constexpr double cornerHold = 0.02; // stiffness of the corners, as a share of the mean diagonal
constexpr int neighbours[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

// The cells that can be reached from the edge of the mask without crossing the shape.
Mask surroundings(const Mask& mask) {
    Mask outside = emptyMask(mask.width, mask.height);
    std::vector<std::pair<int, int>> open;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return;
        if (mask(x, y) || outside(x, y)) return;
        outside.cells[outside.index(x, y)] = 1;
        open.emplace_back(x, y);
    };
    for (int x = 0; x < mask.width; ++x) {
        visit(x, 0);
        visit(x, mask.height - 1);
    }
    for (int y = 0; y < mask.height; ++y) {
        visit(0, y);
        visit(mask.width - 1, y);
    }
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (const auto& step : neighbours)
            visit(x + step[0], y + step[1]);
    }
    return outside;
}

struct Box {
    ifs::Vector<2> min = ifs::Vector<2>::Constant(HUGE_VAL);
    ifs::Vector<2> max = ifs::Vector<2>::Constant(-HUGE_VAL);
};

Box boxOf(std::span<const ifs::Vector<2>> points) {
    Box box;
    for (const ifs::Vector<2>& p : points)
        box = {box.min.cwiseMin(p), box.max.cwiseMax(p)};
    return box;
}

Points centresOf(const Grid& grid, const Mask& mask) {
    Points points;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (mask(x, y)) points.push_back(grid.fromGrid()(ifs::Vector<2>(x + 0.5, y + 0.5)));
    return points;
}

// The outline of the attractor, in the plane of the code.
Points outlineOf(std::span<const ifs::AffineMap<2>> maps, std::span<const ifs::Vector<2>> rest) {
    const Box box = boxOf(rest);
    const ifs::Vector<2> size = box.max - box.min;
    Grid grid;
    grid.cell = size.maxCoeff() / restSide;
    if (!(grid.cell > 0) || !std::isfinite(grid.cell)) return {};
    grid.left = box.min.x() - 2 * grid.cell;
    grid.top = box.max.y() + 2 * grid.cell;
    grid.width = int(size.x() / grid.cell) + 5;
    grid.height = int(size.y() / grid.cell) + 5;
    return centresOf(grid, outerOutline(attractorMask(grid, maps)));
}

// Closest points between an outline that a cage deforms and that of the target.
class Closest {
public:
    Closest(const Target& target, const Eigen::MatrixXd& coordinates)
        : m_grid(target.grid),
          m_outline(outerOutline(target.mask)),
          m_features(featureTransform(m_outline)),
          m_coordinates(coordinates),
          m_labels(m_outline.cells.size()) {
        for (std::size_t cell = 0; cell < m_outline.cells.size(); ++cell)
            if (m_outline.cells[cell] != 0) m_cells.push_back(std::int32_t(cell));
    }

    const std::vector<std::int32_t>& cells() const { return m_cells; }
    Points outline() const { return centresOf(m_grid, m_outline); }

    // Pairs the points under the corners, in grid coordinates; returns the mean distance in cells. All points
    // together have the weight of the target.
    double pair(const Eigen::MatrixX2d& corners) {
        m_normal.setZero(corners.rows(), corners.rows());
        m_right.setZero(corners.rows(), 2);
        const Eigen::MatrixX2d points = m_coordinates * corners;
        double sum = 0;
        std::ranges::fill(m_labels, 0);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            const double x = points(k, 0), y = points(k, 1);
            const int column = int(std::clamp(x, 0.0, m_grid.width - 1.0));
            const int row = int(std::clamp(y, 0.0, m_grid.height - 1.0));
            const std::size_t cell = m_outline.index(column, row);
            m_labels[cell] = std::int32_t(k) + 1;
            sum += add(k, m_features.nearest[cell], points, 1 / double(points.rows()));
        }
        m_nearest.prepare(m_labels, m_grid.width, m_grid.height);
        for (const std::int32_t cell : m_cells) {
            const auto found = m_nearest(cell % m_grid.width, cell / m_grid.width);
            sum += add(m_labels[std::size_t(found.cell)] - 1, cell, points, 1 / double(m_cells.size()));
        }
        return sum / 2;
    }

    Eigen::MatrixX2d moved(const Eigen::MatrixX2d& corners) const {
        Eigen::MatrixXd normal = m_normal;
        const double weight = cornerHold * normal.trace() / double(normal.rows());
        normal.diagonal().array() += weight;
        return normal.ldlt().solve(m_right + weight * corners);
    }

private:
    double add(Eigen::Index k, std::int32_t goal, const Eigen::MatrixX2d& points, double weight) {
        const Eigen::RowVector2d to(goal % m_grid.width + 0.5, goal / m_grid.width + 0.5);
        const Eigen::VectorXd row = m_coordinates.row(k).transpose();
        m_normal += weight * row * row.transpose();
        m_right += weight * row * to;
        return weight * std::max(0.0, (to - points.row(k)).norm() - std::sqrt(0.5));
    }

    Grid m_grid;
    Mask m_outline;
    FeatureTransform m_features;
    const Eigen::MatrixXd& m_coordinates; // one row for each point
    std::vector<std::int32_t> m_cells;    // cells of the target's outline
    std::vector<std::int32_t> m_labels;
    NearestCells m_nearest;
    Eigen::MatrixXd m_normal;
    Eigen::MatrixX2d m_right;
};

Eigen::MatrixXd coordinatesOf(const Points& outline, std::span<const ifs::Vector<2>> rest,
                              ifs::Coordinates kind) {
    Eigen::MatrixXd rows(Eigen::Index(outline.size()), Eigen::Index(rest.size()));
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const std::vector<double> own = ifs::generalizedCoordinates(kind, rest, outline[k]);
        rows.row(Eigen::Index(k)) =
            Eigen::Map<const Eigen::RowVectorXd>(own.data(), Eigen::Index(own.size()));
    }
    return rows;
}

// The corners at rest, scaled along the axes so that both outlines have the same box.
Eigen::MatrixX2d startOf(const Grid& grid, const Points& outline, const Points& goal,
                         std::span<const ifs::Vector<2>> rest) {
    const Box from = boxOf(outline), to = boxOf(goal);
    Eigen::MatrixX2d corners(Eigen::Index(rest.size()), 2);
    for (std::size_t j = 0; j < rest.size(); ++j) {
        ifs::Vector<2> corner = to.min;
        for (int i = 0; i < 2; ++i) {
            const double extent = from.max[i] - from.min[i];
            const double scale = extent > 0 ? (to.max[i] - to.min[i]) / extent : 1;
            corner[i] += scale * (rest[j][i] - from.min[i]);
        }
        corners.row(Eigen::Index(j)) = grid.toGrid()(corner).transpose();
    }
    return corners;
}

Points pointsOf(const Grid& grid, const Eigen::MatrixX2d& corners) {
    Points points;
    for (Eigen::Index j = 0; j < corners.rows(); ++j)
        points.push_back(grid.fromGrid()(ifs::Vector<2>(corners.row(j).transpose())));
    return points;
}

} // namespace

Mask outerOutline(const Mask& mask) {
    const Mask outside = surroundings(mask);
    Mask outline = emptyMask(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            if (!mask(x, y)) continue;
            bool isEdge = x == 0 || y == 0 || x == mask.width - 1 || y == mask.height - 1;
            for (const auto& step : neighbours)
                isEdge = isEdge || outside(x + step[0], y + step[1]);
            outline.cells[outline.index(x, y)] = isEdge;
        }
    return outline;
}

std::optional<CageFit> fittedCage(const Target& target, std::span<const ifs::AffineMap<2>> maps,
                                  std::span<const ifs::Vector<2>> rest, ifs::Coordinates coordinates,
                                  const std::stop_token& stop) {
    const Points outline = outlineOf(maps, rest);
    if (outline.empty() || contraction(maps) >= 1) return std::nullopt;
    const Eigen::MatrixXd rows = coordinatesOf(outline, rest, coordinates);
    Closest closest(target, rows);
    Eigen::MatrixX2d corners = startOf(target.grid, outline, closest.outline(), rest);
    std::optional<CageFit> best;
    for (int iteration = 0; iteration <= iterations; ++iteration) {
        if (stop.stop_requested()) return std::nullopt;
        const double error = closest.pair(corners) * target.grid.cell;
        Points vertices = pointsOf(target.grid, corners);
        const bool isSound = corners.allFinite() && ifs::isSimplePolygon(vertices);
        if (isSound && (!best || error < best->error)) best = CageFit{std::move(vertices), error};
        corners = closest.moved(corners);
        if (!corners.allFinite()) break;
    }
    return best;
}

} // namespace collage
