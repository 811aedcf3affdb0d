// SPDX-License-Identifier: MIT
#include "attractor/solid/covers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>

namespace attractor {

namespace {

using ifs::Vector;

// Half the width of the image of the box [−1, 1]³, which all coordinates here lie in.
double halfWidth(const ifs::Matrix<3>& linear) {
    return linear.cwiseAbs().rowwise().sum().maxCoeff();
}

// Returns false for points outside a box that is not certified, which must not be drawn.
bool isInBox(const Vector<3>& x) {
    return x.cwiseAbs().maxCoeff() <= 1; // false for NaN
}

// Cubes of a grid, each of which takes one point.
class Grid {
public:
    explicit Grid(double edge) : m_perUnit(1 / edge) {}
    bool take(const Vector<3>& x) { // true for the first point in its cube
        std::uint64_t key = 0;
        for (int k = 0; k < 3; ++k) {
            const double cell = std::clamp((x[k] + 2) * m_perUnit, 0.0, 2097151.0);
            key = key << 21 | static_cast<std::uint64_t>(cell);
        }
        return m_taken.insert(key).second;
    }

private:
    double m_perUnit;
    std::unordered_set<std::uint64_t> m_taken;
};

class CoverBuilder {
public:
    explicit CoverBuilder(const PreparedSpace& system) : m_contracts(system.contracts) {
        double volume = 0;
        for (const ifs::AffineMap<3>& map : system.maps) {
            m_maps.push_back(system.inBox(map));
            volume += std::abs(ifs::determinant<3>(map.linear));
        }
        m_overlaps = volume > 1;
        m_point = ifs::fixedPoint(m_maps.front()).value_or(Vector<3>::Zero());
        if (!isInBox(m_point)) m_point.setZero();
        // Chooses a point near the middle of the box, because it represents cells best there.
        constexpr double few = 1.0 / 8;
        const auto cells = cut(few);
        for (const Vector<3>& x : cells ? cells->points : flood(few))
            if (isInBox(x) && x.norm() < m_point.norm()) m_point = x;
    }

    struct Cells {
        std::vector<Vector<3>> points;
        double width = 0; // width of the widest cell, as a share of the box
    };

    // Returns nullopt for too many cells.
    std::optional<Cells> cut(double width) const {
        constexpr std::size_t maxWords = 4 * Covers::maxPoints;
        if (!m_contracts) return std::nullopt;
        Cells cells;
        std::vector<ifs::AffineMap<3>> open(1);
        std::size_t words = 0;
        while (!open.empty()) {
            const ifs::AffineMap<3> word = open.back();
            open.pop_back();
            const double size = halfWidth(word.linear);
            if (size <= width) {
                cells.points.push_back(word(m_point));
                cells.width = std::max(cells.width, size);
                continue;
            }
            words += m_maps.size();
            if (words > maxWords) return std::nullopt;
            for (const ifs::AffineMap<3>& map : m_maps)
                open.push_back(word * map);
        }
        return cells;
    }

    // Orbit of the point, one image for each cube: approximately a cover, even of a system with too many
    // words to list.
    std::vector<Vector<3>> flood(double width) const {
        constexpr std::size_t maxImages = 1U << 20;
        Grid grid(width);
        std::vector<Vector<3>> points{m_point};
        grid.take(m_point);
        std::size_t images = 0;
        for (std::size_t k = 0; k < points.size() && points.size() <= Covers::maxPoints; ++k)
            for (const ifs::AffineMap<3>& map : m_maps) {
                if (++images > maxImages) return points;
                const Vector<3> x = map(Vector<3>(points[k]));
                if (isInBox(x) && grid.take(x)) points.push_back(x);
            }
        return points;
    }

    // Cover with its spacing. In sets of low dimension, where most words are thinner than the widest, finer
    // cells that are merged where they coincide may be fewer.
    Cells cover(double width) const {
        if (width >= 1) return {{m_point}, 1};
        std::optional<Cells> best = cut(width);
        if (!best) return {flood(width), width};
        *best = thinned(std::move(*best), width);
        constexpr std::size_t worthThinning = Covers::maxPoints / 8;
        for (double finer = width / 2; finer >= width / 4 && best->points.size() <= worthThinning;
             finer /= 2) {
            std::optional<Cells> cells = cut(finer);
            if (!cells) break;
            *cells = thinned(std::move(*cells), width);
            if (cells->points.size() < best->points.size()) best = std::move(cells);
        }
        // Flooding is worthwhile if pieces overlap, because their cells occur many times.
        constexpr std::size_t worthFlooding = 4;
        if (m_overlaps && best->points.size() > worthFlooding) {
            std::vector<Vector<3>> points = flood(width);
            if (worthFlooding * points.size() <= best->points.size()) return {std::move(points), width};
        }
        return *best;
    }

private:
    // Keeps one point for each cube; the width of cubes keeps the spacing below `width`.
    static Cells thinned(Cells cells, double width) {
        constexpr double minEdge = 1.0 / 64; // merges points that differ only by rounding
        Grid grid(2 * std::max(width - cells.width, minEdge * width));
        const std::size_t before = cells.points.size();
        std::erase_if(cells.points, [&](const Vector<3>& x) { return !isInBox(x) || !grid.take(x); });
        if (cells.points.empty()) cells.points.push_back(Vector<3>::Zero());
        if (cells.points.size() < before) cells.width = width;
        return cells;
    }

    bool m_contracts;
    bool m_overlaps = false;               // true if the volumes of the pieces imply overlaps
    std::vector<ifs::AffineMap<3>> m_maps; // maps in box coordinates
    Vector<3> m_point;                     // point of the attractor
};

// Points in the order of kernels::Cover::nearestFirst.
std::vector<Vector<3>> sorted(std::vector<Vector<3>> points, unsigned octant) {
    const Vector<3> deeper((octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1,
                           (octant & 4) != 0 ? -1 : 1);
    std::stable_sort(points.begin(), points.end(),
                     [&](const Vector<3>& a, const Vector<3>& b) { return deeper.dot(a) < deeper.dot(b); });
    return points;
}

void append(std::vector<float>& coordinates, const std::vector<Vector<3>>& points, std::size_t padded) {
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < padded; ++i)
            coordinates.push_back(static_cast<float>(points[i < points.size() ? i : 0][k]));
}

} // namespace

Covers::Covers(const PreparedSpace& system) {
    constexpr double finest = 1.0 / 128;
    const CoverBuilder builder(system);
    std::vector<Points> covers;
    for (double width = 1; width >= finest && (covers.empty() || 4 * covers.back().count <= maxPoints);
         width /= 2) {
        const auto cells = builder.cover(width);
        if (cells.points.size() > maxPoints && !covers.empty()) break;
        Points points;
        points.spacing = static_cast<float>(cells.width);
        points.count = cells.points.size();
        points.padded = (points.count + kernels::solidLanes - 1) / kernels::solidLanes * kernels::solidLanes;
        for (unsigned octant = 0; octant < 8; ++octant)
            append(points.coordinates, sorted(cells.points, octant), points.padded);
        // Replaces covers with at least as many points, which have the same cells or are less dense.
        while (!covers.empty() && covers.back().count >= points.count)
            covers.pop_back();
        covers.push_back(std::move(points));
    }
    m_covers = std::make_shared<const std::vector<Points>>(std::move(covers));
}

std::vector<kernels::Cover> Covers::ofAtMost(std::size_t points) const {
    std::vector<kernels::Cover> result;
    if (!m_covers) return result;
    for (const Points& cover : *m_covers) {
        if (cover.count > points && !result.empty()) continue;
        kernels::Cover& view = result.emplace_back();
        view.spacing = cover.spacing;
        view.size = view.work = cover.padded;
        const float* at = cover.coordinates.data();
        for (kernels::CoverPoints& order : view.nearestFirst) {
            order = {at, at + cover.padded, at + 2 * cover.padded};
            at += 3 * cover.padded;
        }
    }
    return result;
}

} // namespace attractor
