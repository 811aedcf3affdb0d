// SPDX-License-Identifier: MIT
#include "attractor/tops/exact_tops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace attractor {

namespace {

constexpr double maxInOnePixel = 0.5;           // pixels; size of a piece inside one pixel
constexpr double maxBetweenPixels = 1.0 / 1024; // pixels; size of a piece in several pixels
constexpr double minBorder = 1e-6;              // pixels
constexpr double relativeBorder = 4e-9;
constexpr int blockColumns = 16;
constexpr std::uint64_t visitsBetween = 1024; // visits between two checks of the stop token
constexpr std::uint64_t maxVisits = std::uint64_t{1} << 31;

// Pixels that are still empty, and their number among every 16 in a row.
class EmptyPixels {
public:
    EmptyPixels(int width, int rows)
        : m_width(width),
          m_blocks((width + blockColumns - 1) / blockColumns),
          m_counts(std::size_t(m_blocks) * std::size_t(rows)) {
        for (std::size_t k = 0; k < m_counts.size(); ++k) {
            const int first = int(k % std::size_t(m_blocks)) * blockColumns;
            m_counts[k] = std::uint8_t(std::min(blockColumns, width - first));
        }
        m_left = std::uint64_t(width) * std::uint64_t(rows);
    }

    std::uint64_t left() const { return m_left; }
    void fill(int column, int row) {
        --m_counts[block(column, row)];
        --m_left;
    }
    // Returns true if any pixel in the columns and rows, both ends included, satisfies `isEmpty(column,
    // row)`.
    template <class IsEmpty>
    bool any(int firstColumn, int lastColumn, int firstRow, int lastRow, IsEmpty isEmpty) const {
        for (int row = firstRow; row <= lastRow; ++row)
            for (int first = firstColumn; first <= lastColumn;) {
                const int end = (first / blockColumns + 1) * blockColumns;
                const int last = std::min(lastColumn, end - 1);
                const int count = m_counts[block(first, row)];
                const bool isWhole = first % blockColumns == 0 && last == std::min(end, m_width) - 1;
                if (count > 0 && isWhole) return true;
                for (int column = first; count > 0 && column <= last; ++column)
                    if (isEmpty(column, row)) return true;
                first = end;
            }
        return false;
    }

private:
    std::size_t block(int column, int row) const {
        return std::size_t(row) * std::size_t(m_blocks) + std::size_t(column / blockColumns);
    }

    int m_width;
    int m_blocks;
    std::uint64_t m_left = 0;
    std::vector<std::uint8_t> m_counts;
};

struct Open {
    ifs::AffineMap<2> shown; // w_word in pixels
    ifs::AffineMap<2> to;    // v_word
    double address = 0, step = 1;
    double areaRatio = 1; // product of the ratios of its maps
};

class BandWalk {
public:
    BandWalk(const CoupledSystem& system, const Camera& camera, int firstRow, std::span<TopPoint> points)
        : m_system(system),
          m_width(camera.width),
          m_firstRow(firstRow),
          m_endRow(firstRow + int(points.size() / std::size_t(camera.width))),
          m_pixelsPerUnit(camera.pixelsPerUnit),
          m_points(points),
          m_empty(camera.width, m_endRow - firstRow) {
        std::ranges::fill(points, TopPoint{});
        m_open.push_back({worldToPixel(camera), {}});
        const PixelBox whole = boxOf(m_open.back().shown, system.around);
        m_border = std::max(minBorder, relativeBorder * whole.size());
    }

    bool run(const std::stop_token& stop) {
        for (std::uint64_t visits = 1; !m_open.empty() && m_empty.left() > 0; ++visits) {
            if (visits % visitsBetween == 0 && (stop.stop_requested() || visits > maxVisits)) return false;
            const Open open = m_open.back();
            m_open.pop_back();
            const PixelBox box = trimmed(boxOf(open.shown, m_system.around));
            if (!isWanted(box)) continue;
            const bool isOnePixel = std::floor(box.left) == std::floor(box.right) &&
                                    std::floor(box.top) == std::floor(box.bottom);
            if (box.size() <= (isOnePixel ? maxInOnePixel : maxBetweenPixels))
                write(open, box);
            else
                divide(open);
        }
        return true;
    }

private:
    // Box without pixels that it only touches, up to the looseness of the polygon. A flat box on the border
    // of two pixels belongs to the second one.
    PixelBox trimmed(const PixelBox& box) const {
        PixelBox result{box.left + m_border, box.right - m_border, box.top + m_border, box.bottom - m_border};
        if (result.left > result.right) result.left = result.right = (box.left + box.right) / 2 + m_border;
        if (result.top > result.bottom) result.top = result.bottom = (box.top + box.bottom) / 2 + m_border;
        return result;
    }

    struct Pixels {
        int firstColumn, lastColumn, firstRow, lastRow; // extent of the band
    };
    Pixels pixelsOf(const PixelBox& box) const {
        const auto within = [](double value, int last) {
            return int(std::clamp(std::floor(value), 0.0, double(last)));
        };
        const int last = m_endRow - m_firstRow - 1;
        return {within(box.left, m_width - 1), within(box.right, m_width - 1),
                within(box.top - m_firstRow, last), within(box.bottom - m_firstRow, last)};
    }
    TopPoint& at(int column, int row) {
        return m_points[std::size_t(row) * std::size_t(m_width) + std::size_t(column)];
    }

    // Returns true if the box reaches an empty pixel of the band.
    bool isWanted(const PixelBox& box) {
        if (!box.meets(m_width, m_firstRow, m_endRow)) return false;
        const Pixels p = pixelsOf(box);
        return m_empty.any(p.firstColumn, p.lastColumn, p.firstRow, p.lastRow,
                           [this](int column, int row) { return at(column, row).isEmpty(); });
    }

    void write(const Open& open, const PixelBox& box) {
        const ifs::Vector<2> image = open.to(m_system.toTop);
        const double stretch = m_system.wholeRatio *
                               stretchOf(open.areaRatio, open.to.linear, open.shown.linear / m_pixelsPerUnit);
        const Pixels p = pixelsOf(box);
        for (int row = p.firstRow; row <= p.lastRow; ++row)
            for (int column = p.firstColumn; column <= p.lastColumn; ++column) {
                TopPoint& point = at(column, row);
                if (!point.isEmpty()) continue;
                point = {image.x(), image.y(), stretch, open.address};
                m_empty.fill(column, row);
            }
    }

    void divide(const Open& open) { // first map last, on top
        const std::size_t maps = m_system.from.size();
        const double step = open.step / double(maps);
        for (std::size_t i = maps; i-- > 0;)
            m_open.push_back({open.shown * m_system.from[i], open.to * m_system.to[i],
                              open.address + double(i) * step, step,
                              open.areaRatio * m_system.areaRatios[i]});
    }

    const CoupledSystem& m_system;
    int m_width, m_firstRow, m_endRow;
    double m_pixelsPerUnit;
    double m_border = 0;
    std::span<TopPoint> m_points;
    EmptyPixels m_empty;
    std::vector<Open> m_open;
};

} // namespace

bool ExactTops::draw(int firstRow, std::span<TopPoint> points, const std::stop_token& stop) const {
    if (points.empty()) return true;
    return BandWalk(m_system, m_camera, firstRow, points).run(stop);
}

} // namespace attractor
