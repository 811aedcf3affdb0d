// SPDX-License-Identifier: MIT
#include "collage/target/nearest_cells.h"

#include <algorithm>

namespace collage {

namespace {

constexpr std::int16_t farAway = 32'000; // greater than the number of rows in any column

// Distances to the nearest set cell of the column, upwards in `above` and downwards in `below`.
template <typename Cell>
void scanColumns(const std::vector<Cell>& cells, int width, int height, std::vector<std::int16_t>& above,
                 std::vector<std::int16_t>& below) {
    above.resize(cells.size());
    below.resize(cells.size());
    const auto row = [&](std::vector<std::int16_t>& distances, int y) {
        return distances.data() + std::ptrdiff_t(y) * width;
    };
    const auto step = [&](std::vector<std::int16_t>& distances, int y, int before) {
        const Cell* set = cells.data() + std::ptrdiff_t(y) * width;
        const std::int16_t* from = row(distances, before);
        std::int16_t* to = row(distances, y);
        for (int x = 0; x < width; ++x)
            to[x] = set[x] != 0 ? std::int16_t(0) : std::min(std::int16_t(from[x] + 1), farAway);
    };
    const auto start = [&](std::vector<std::int16_t>& distances, int y) {
        const Cell* set = cells.data() + std::ptrdiff_t(y) * width;
        std::transform(set, set + width, row(distances, y),
                       [](Cell cell) { return cell != 0 ? std::int16_t(0) : farAway; });
    };
    start(above, 0);
    for (int y = 1; y < height; ++y)
        step(above, y, y - 1);
    start(below, height - 1);
    for (int y = height - 2; y >= 0; --y)
        step(below, y, y + 1);
}

// The lower envelope of the parabolas (x − c)² + f(c) over the columns c of one row.
class Envelope {
public:
    explicit Envelope(int width) : m_column(std::size_t(width)), m_begin(std::size_t(width) + 1) {}

    // f < 0: empty column.
    void build(const std::vector<std::int64_t>& f) {
        m_size = 0;
        for (int c = 0; c < int(f.size()); ++c) {
            if (f[std::size_t(c)] < 0) continue;
            double begin = -1;
            while (m_size > 0) {
                const int last = m_column[m_size - 1];
                begin = double(f[std::size_t(c)] + std::int64_t(c) * c - f[std::size_t(last)] -
                               std::int64_t(last) * last) /
                        (2.0 * (c - last));
                if (begin > m_begin[m_size - 1]) break;
                --m_size;
                begin = -1;
            }
            m_column[m_size] = c;
            m_begin[m_size++] = begin;
        }
    }

    bool isEmpty() const { return m_size == 0; }

    // Column of the lowest parabola at each x = 0, 1, …: give(x, column).
    template <typename Give> void sweep(int width, const Give& give) const {
        std::size_t piece = 0;
        for (int x = 0; x < width; ++x) {
            while (piece + 1 < m_size && m_begin[piece + 1] < x)
                ++piece;
            give(x, m_column[piece]);
        }
    }

private:
    std::vector<int> m_column;
    std::vector<double> m_begin; // x from which on each parabola is the lowest
    std::size_t m_size = 0;
};

} // namespace

FeatureTransform featureTransform(const Mask& mask) {
    FeatureTransform result{std::vector<std::int32_t>(mask.cells.size(), -1),
                            std::vector<std::int32_t>(mask.cells.size(), maxSquare)};
    if (mask.cells.empty()) return result;
    std::vector<std::int16_t> above, below;
    scanColumns(mask.cells, mask.width, mask.height, above, below);
    Envelope envelope(mask.width);
    std::vector<std::int64_t> f(std::size_t(mask.width));
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const std::int64_t d = std::min(above[mask.index(x, y)], below[mask.index(x, y)]);
            f[std::size_t(x)] = d == farAway ? -1 : d * d;
        }
        envelope.build(f);
        if (envelope.isEmpty()) continue;
        envelope.sweep(mask.width, [&](int x, int column) {
            const std::size_t foot = mask.index(column, y);
            const int row = above[foot] <= below[foot] ? y - above[foot] : y + below[foot];
            result.nearest[mask.index(x, y)] = std::int32_t(mask.index(column, row));
            const std::int64_t square =
                std::int64_t(x - column) * (x - column) + std::int64_t(y - row) * (y - row);
            result.square[mask.index(x, y)] = std::int32_t(std::min<std::int64_t>(square, maxSquare - 1));
        });
    }
    return result;
}

void NearestCells::prepare(const std::vector<std::int32_t>& labels, int width, int height) {
    m_width = width;
    m_height = height;
    scanColumns(labels, width, height, m_above, m_below);
}

NearestCells::Found NearestCells::operator()(int x, int y) const {
    Found found;
    const std::ptrdiff_t row = std::ptrdiff_t(y) * m_width;
    const auto look = [&](int column) {
        const std::int16_t above = m_above[std::size_t(row + column)];
        const std::int16_t below = m_below[std::size_t(row + column)];
        const int d = std::min(above, below);
        if (d == farAway) return;
        const int square = d * d + (column - x) * (column - x);
        if (square >= found.square) return;
        found = {std::int32_t(row + column) + m_width * (above <= below ? -d : d), square};
    };
    look(x);
    const int reach = std::max(x, m_width - 1 - x);
    for (int step = 1; step <= reach && step * step < found.square; ++step) {
        if (step <= x) look(x - step);
        if (x + step < m_width) look(x + step);
    }
    return found;
}

} // namespace collage
