// SPDX-License-Identifier: MIT
#include "document/steps/step_distance.h"

#include "attractor/samples/prepared_system.h"
#include "collage/measure/agreement.h"
#include "document/fractal/fractal_geometry.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace document {

namespace {

constexpr int cells = 512; // cells along a side of the grid
constexpr int coarse = 96; // cells along a side of the grid that finds the extent
using Points = std::vector<ifs::Vector<2>>;

// B where the maps act, which is the displayed plane or that of the code.
StartShape startOf(const Fractal& fractal, const StartShape* shape, const ifs::AffineMap<2>& toPlane) {
    StartShape start = shape ? overAttractor(*shape, fractal) : StartShape{{effectiveCage(fractal).rest}};
    for (auto& contour : start.contours)
        for (ifs::Vector<2>& corner : contour)
            corner = toPlane(corner);
    return start;
}

struct Extent {
    ifs::Vector<2> low, high;
};

Extent united(const attractor::PreparedSystem& system, const StartShape& start) {
    Extent all{system.centre - system.halfExtent, system.centre + system.halfExtent};
    for (const auto& contour : start.contours)
        for (const ifs::Vector<2>& corner : contour) {
            all.low = all.low.cwiseMin(corner);
            all.high = all.high.cwiseMax(corner);
        }
    return all;
}

collage::Grid gridOver(const Extent& extent, double margin, int side) {
    const ifs::Vector<2> middle = (extent.low + extent.high) / 2;
    const double half = 1.02 * ((extent.high - extent.low).maxCoeff() / 2 + margin);
    return {middle.x() - half, middle.y() + half, 2 * half / side, side, side};
}

// Points of B, one in each cell that it meets, in coordinates of the grid.
Points pointsIn(const StartShape& start, const collage::Grid& grid) {
    QImage image(grid.width, grid.height, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const auto& contour : start.contours) {
        QPolygonF polygon;
        for (const ifs::Vector<2>& corner : contour) {
            const ifs::Vector<2> at = grid.toGrid()(corner);
            polygon << QPointF(at.x(), at.y());
        }
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    QPainter painter(&image);
    painter.setPen(QPen(Qt::white, 0)); // keeps thin parts
    painter.setBrush(Qt::white);
    painter.drawPath(path);
    painter.end();
    Points points;
    for (int y = 0; y < grid.height; ++y) {
        const uchar* row = image.constScanLine(y);
        for (int x = 0; x < grid.width; ++x)
            if (row[x] != 0) points.emplace_back(x + 0.5, y + 0.5);
    }
    return points;
}

// The images of the points under all maps, one in each cell.
std::pair<Points, collage::Mask> imagesOf(const Points& points, std::span<const ifs::AffineMap<2>> maps,
                                          const collage::Grid& grid) {
    std::pair<Points, collage::Mask> result{{}, collage::emptyMask(grid.width, grid.height)};
    auto& [images, mask] = result;
    for (const ifs::AffineMap<2>& map : maps)
        for (const ifs::Vector<2>& point : points) {
            const ifs::Vector<2> image = map(point);
            const int x = std::clamp(int(image.x()), 0, grid.width - 1);
            const int y = std::clamp(int(image.y()), 0, grid.height - 1);
            std::uint8_t& cell = mask.cells[mask.index(x, y)];
            if (cell == 0) images.push_back(image);
            cell = 1;
        }
    return result;
}

// The images of B on a grid, step by step, and how far they are from the attractor. In cells.
class Measurement {
public:
    Measurement(std::span<const ifs::AffineMap<2>> maps, const StartShape& start, const collage::Grid& grid)
        : m_grid(grid),
          m_attractor(collage::attractorMask(grid, maps)),
          m_toAttractor(collage::featureTransform(m_attractor)),
          m_points(pointsIn(start, grid)) {
        for (const ifs::AffineMap<2>& map : maps)
            m_maps.push_back(collage::inGrid(grid, map));
        const ifs::AffineMap<2> identity;
        std::tie(m_points, m_mask) = imagesOf(m_points, std::span(&identity, 1), m_grid);
    }

    void apply() { std::tie(m_points, m_mask) = imagesOf(m_points, m_maps, m_grid); }

    double distance() const {
        const collage::FeatureTransform toImages = collage::featureTransform(m_mask);
        std::int32_t worst = 0;
        for (std::size_t k = 0; k < m_mask.cells.size(); ++k) {
            if (m_attractor.cells[k] != 0) worst = std::max(worst, toImages.square[k]);
            if (m_mask.cells[k] != 0) worst = std::max(worst, m_toAttractor.square[k]);
        }
        return std::sqrt(double(worst));
    }

private:
    collage::Grid m_grid;
    std::vector<ifs::AffineMap<2>> m_maps;
    collage::Mask m_attractor;
    collage::FeatureTransform m_toAttractor;
    Points m_points;
    collage::Mask m_mask; // mask of the points
};

} // namespace

std::optional<StepDistance> stepDistance(const Fractal& fractal, const StartShape* shape, int iterations,
                                         const std::stop_token& stop) {
    if (!system2(fractal)) return std::nullopt;
    const auto displayed = effectiveSystem(fractal);
    const attractor::PreparedSystem system = attractor::prepared(displayed ? *displayed : *system2(fractal));
    if (system.maps.empty()) return std::nullopt;
    StepDistance result;
    result.isOfCode = !displayed;
    result.contraction = collage::contraction(system.maps);
    if (system.isLinked() || !(result.contraction < 1)) return result;
    const StartShape start =
        startOf(fractal, shape, displayed ? placement(fractal).affine() : ifs::AffineMap<2>());
    const Extent extent = united(system, start);
    const collage::Grid rough = gridOver(extent, 0, coarse);
    if (!(rough.cell > 0) || !std::isfinite(rough.cell)) return result;
    // Upper bound: no image is farther from the attractor than B is.
    const double farthest = (Measurement(system.maps, start, rough).distance() + 2) * rough.cell;
    const collage::Grid grid = gridOver(extent, farthest, cells);
    Measurement measurement(system.maps, start, grid);
    result.cell = grid.cell;
    const double bound = std::pow(result.contraction, iterations) * measurement.distance();
    for (int n = 0; n < iterations; ++n) {
        if (stop.stop_requested()) return std::nullopt;
        measurement.apply();
    }
    result.distance = std::min(measurement.distance(), bound) * grid.cell;
    result.bound = bound * grid.cell;
    return result;
}

} // namespace document
