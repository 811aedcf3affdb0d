// SPDX-License-Identifier: MIT
#include "collage/fit/collage_fit.h"

#include "ifs/linear/symmetric_matrices.h"

#include <algorithm>
#include <cmath>

namespace collage {

namespace {

// Weight by which every image stays where it is, compared with a point that is out of place.
constexpr double hold = 0.1;
// Pairs count by area: an image point stands for |det A| cells, and those of a flat map for so many.
constexpr double minArea = 0.02;
// Cells squared, the variance of two rows of cells: across a thinner line, pairs tell steps between cells and
// not what a map does.
constexpr double thin = 0.25;

double areaOf(const ifs::AffineMap<2>& map) {
    return std::max(std::abs(ifs::determinant<2>(map.linear)), minArea);
}

// The spread across, from the moments of so many points.
ifs::Vector<2> across(const Eigen::Matrix3d& moments, double count) {
    const ifs::Vector<2> mean = moments.topRightCorner<2, 1>() / count;
    const ifs::Matrix<2> covariance = moments.topLeftCorner<2, 2>() / count - mean * mean.transpose();
    const auto [values, axes] = ifs::symmetricEigenvalues<2>(covariance);
    if (values[0] >= thin) return ifs::Vector<2>::Zero();
    return axes.col(0);
}

} // namespace

CollageFit::CollageFit(const Target& target)
    : m_target(target),
      m_moments(Eigen::Matrix3d::Zero()),
      m_labels(target.mask.cells.size()),
      m_distance(target.mask.cells.size()) {
    for (std::size_t k = 0; k < target.cells.size(); ++k) {
        const Eigen::Vector3d p(target.columns[k], target.rows[k], 1);
        m_moments += p * p.transpose();
    }
    m_across = across(m_moments, double(target.cells.size()));
    std::ranges::transform(target.features.square, m_distance.begin(),
                           [](std::int32_t square) { return std::sqrt(float(square)); });
}

// The loop is kept simple enough for the compiler to vectorise it: cell numbers stay below 2²⁴ and are exact.
void CollageFit::placeImages(const ifs::AffineMap<2>& map, std::size_t index) {
    const std::size_t count = m_target.cells.size();
    const auto a = float(map.linear(0, 0)), b = float(map.linear(0, 1)), c = float(map.linear(1, 0)),
               d = float(map.linear(1, 1)), e = float(map.translation.x()), f = float(map.translation.y());
    const auto width = float(m_target.grid.width);
    const float right = width - 1, bottom = float(m_target.grid.height - 1);
    const float* columns = m_target.columns.data();
    const float* rows = m_target.rows.data();
    std::int32_t* images = m_images.data() + index * count;
    for (std::size_t k = 0; k < count; ++k) {
        float x = a * columns[k] + b * rows[k] + e;
        float y = c * columns[k] + d * rows[k] + f;
        x = x < 0 ? 0 : x;
        x = x > right ? right : x;
        y = y < 0 ? 0 : y;
        y = y > bottom ? bottom : y;
        images[k] = std::int32_t(float(std::int32_t(y)) * width + float(std::int32_t(x)));
    }
    const auto first = std::int32_t(index * count) + 1;
    for (std::size_t k = 0; k < count; ++k)
        m_labels[std::size_t(images[k])] = first + std::int32_t(k);
}

void CollageFit::place(std::span<const ifs::AffineMap<2>> maps) {
    std::ranges::fill(m_labels, 0);
    m_images.resize(maps.size() * m_target.cells.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        placeImages(maps[i], i);
    m_nearest.prepare(m_labels, m_target.grid.width, m_target.grid.height);
}

void CollageFit::pullImages(const ifs::AffineMap<2>& map, std::size_t index, PairSums& sums) const {
    const std::size_t count = m_target.cells.size();
    const double weight = areaOf(map);
    const std::int32_t width = m_target.grid.width;
    const std::int32_t* images = m_images.data() + index * count;
    for (std::size_t k = 0; k < count; ++k) {
        if (m_distance[std::size_t(images[k])] == 0) continue;
        const std::int32_t goal = m_target.features.nearest[std::size_t(images[k])];
        sums.add(m_target.columns[k], m_target.rows[k], goal % width + 0.5, goal / width + 0.5, weight);
    }
    sums.addFixed(m_moments, map, hold * weight);
}

void CollageFit::coverTarget(std::vector<PairSums>& sums) const {
    const auto count = std::int32_t(m_target.cells.size());
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t cell = m_target.cells[std::size_t(k)];
        if (m_labels[std::size_t(cell)] != 0) continue;
        const int x = cell % m_target.grid.width, y = cell / m_target.grid.width;
        const std::int32_t label = m_labels[std::size_t(m_nearest(x, y).cell)] - 1;
        const auto point = std::size_t(label % count);
        sums[std::size_t(label / count)].add(m_target.columns[point], m_target.rows[point], x + 0.5, y + 0.5,
                                             1);
    }
}

void CollageFit::improve(std::vector<ifs::AffineMap<2>>& maps, const FitSchedule& schedule,
                         std::span<const std::uint8_t> locked, const std::stop_token& stop) {
    for (int iteration = 0; iteration < schedule.iterations && !stop.stop_requested(); ++iteration) {
        place(maps);
        std::vector<PairSums> sums(maps.size());
        coverTarget(sums);
        const double norm = iteration < schedule.cautious ? schedule.cautiousNorm : schedule.maxNorm;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (!locked.empty() && locked[i] != 0) continue;
            pullImages(maps[i], i, sums[i]);
            if (schedule.constraints.classOf(i) == MapClass::Affine)
                sums[i].addAcross(m_across, maps[i].linear);
            const ifs::AffineMap<2> fitted =
                leastSquaresMap(sums[i], schedule.constraints.classOf(i), maps[i]);
            maps[i] = constrained(schedule.constraints, i, withNormAtMost(norm, fitted, m_target.mean),
                                  m_target.mean);
        }
    }
}

double CollageFit::error(std::span<const ifs::AffineMap<2>> maps) {
    place(maps);
    const std::size_t count = m_target.cells.size();
    double out = 0, area = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k)
            sum += double(m_distance[std::size_t(m_images[i * count + k])]);
        out += areaOf(maps[i]) * sum;
        area += areaOf(maps[i]) * double(count);
    }
    double uncovered = 0;
    for (const std::int32_t cell : m_target.cells)
        if (m_labels[std::size_t(cell)] == 0)
            uncovered +=
                std::sqrt(double(m_nearest(cell % m_target.grid.width, cell / m_target.grid.width).square));
    return (out / area + uncovered / double(count)) / 2;
}

std::vector<double> CollageFit::shares() const {
    const auto count = std::int32_t(m_target.cells.size());
    std::vector<double> shares(m_images.size() / m_target.cells.size());
    for (const std::int32_t cell : m_target.cells) {
        const auto found = m_nearest(cell % m_target.grid.width, cell / m_target.grid.width);
        const std::int32_t label = m_labels[std::size_t(found.cell)] - 1;
        shares[std::size_t(label / count)] += 1.0 / count;
    }
    return shares;
}

} // namespace collage
