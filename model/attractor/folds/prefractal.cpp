// SPDX-License-Identifier: MIT
#include "attractor/folds/prefractal.h"

#include "attractor/cut/bend_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace attractor {

namespace {

constexpr double maxImages = 1e6;
constexpr double maxOutlined = 20'000;          // images; keeps the sums of a cell below 2³²
constexpr double minOutlined = 24;              // cells
constexpr std::size_t cellsPerCheck = 1U << 18; // a millisecond's work

class Painter {
public:
    Painter(const Prefractal& job, const Projection& projection, const Prefractal::Colour& colour,
            CellSums& sums)
        : m_job(job), m_projection(projection), m_colour(colour), m_sums(sums) {
        // Box whose image contains everything that an image can become.
        m_low = job.system.centre - job.system.halfExtent;
        m_high = job.system.centre + job.system.halfExtent;
        for (const ifs::Vector<2>& vertex : job.polygon) {
            m_low = m_low.cwiseMin(vertex);
            m_high = m_high.cwiseMax(vertex);
        }
        m_outlined = std::pow(static_cast<double>(job.system.maps.size()), job.iterations) <= maxOutlined;
        if (const ifs::PolygonDeformation* bend = projection.cage.bend())
            m_bend.emplace().follow(*bend, (m_low + m_high) / 2, reach(),
                                    maxBendError * projection.cellsPerPixel / projection.cellsPerUnit());
    }

    bool paint(const std::stop_token& stop) {
        struct Node {
            ifs::AffineMap<2> map;
            int depth = 0;
            std::uint32_t firstMap = 0;
            std::size_t lastMap = 0; // innermost map
            PaletteInterval colours{};
        };
        const ColourCoordinates along =
            m_job.colours.empty() ? ColourCoordinates(m_job.system.maps.size()) : m_job.colours;
        const auto child = [&](const Node& node, std::size_t i) {
            return Node{node.map * m_job.system.maps[i], node.depth + 1,
                        node.depth == 0 ? static_cast<std::uint32_t>(i) : node.firstMap, i,
                        along.child(node.colours, i)};
        };
        const std::vector<double>& links = m_job.system.links;
        const auto isChild = [&](const Node& node, std::size_t i) { // true for admissible words
            return links.empty() || node.depth == 0 || links[i * m_job.system.maps.size() + node.lastMap] > 0;
        };
        std::vector<Node> stack;
        for (const auto& [word, change] : pieces()) {
            Node node{change};
            bool isAdmissible = true;
            for (const int symbol : word) {
                isAdmissible = isAdmissible && isChild(node, static_cast<std::size_t>(symbol));
                node = child(node, static_cast<std::size_t>(symbol));
            }
            if (isAdmissible) stack.push_back(node);
        }
        std::ranges::reverse(stack);
        std::size_t visits = 0;
        while (!stack.empty()) {
            if (++visits % 1024 == 0 || m_filled > cellsPerCheck) {
                m_filled = 0;
                if (stop.stop_requested()) return false;
            }
            const Node node = stack.back();
            stack.pop_back();
            const Reach reach = reachOf(node.map);
            if (!reach.inView) continue;
            if (node.depth == m_job.iterations || reach.size < 0.5) {
                const ColourCell colour = m_colour(node.firstMap, along.middle(node.colours));
                if (fill(node.map, colour) && m_outlined && reach.size >= minOutlined) outline(colour);
                continue;
            }
            for (std::size_t i = m_job.system.maps.size(); i-- > 0;)
                if (isChild(node, i)) stack.push_back(child(node, i));
        }
        return true;
    }

private:
    // Pieces of moved branches. Branches with words longer than those drawn are part of an image and do not
    // move.
    std::vector<ifs::MovedBranch<2>> pieces() const {
        return ifs::pieces<2>(m_job.system.moved, m_job.system.maps.size(),
                              static_cast<std::size_t>(m_job.iterations));
    }

    // Largest distance of a displayed image from the centre of the box.
    double reach() const {
        const ifs::Vector<2> middle = (m_low + m_high) / 2;
        const ifs::Vector<2> half = (m_high - m_low) / 2;
        double farthest = 0;
        for (const ifs::AffineMap<2>& map : ifs::pieceMaps<2>(pieces(), m_job.system.maps)) {
            const ifs::Vector<2> away = (map(middle) - middle).cwiseAbs() + map.linear.cwiseAbs() * half;
            farthest = std::max(farthest, away.maxCoeff());
        }
        return farthest;
    }

    struct Reach {
        bool inView = false;
        double size = 0; // cells
    };

    // Images outside the view are not followed: in an expanding system, the polygon's images may leave the
    // box and return only by chance.
    Reach reachOf(const ifs::AffineMap<2>& map) {
        const ifs::Vector<2> centre = map((m_low + m_high) / 2);
        const ifs::Vector<2> halfBox = (m_high - m_low) / 2;
        ifs::Matrix<2> spread = map.linear;
        spread.col(0) *= halfBox.x();
        spread.col(1) *= halfBox.y();
        ifs::Vector<2> shown = m_projection.cage.affine()(centre);
        ifs::Vector<2> half = (m_projection.cage.affine().linear * spread).cwiseAbs().rowwise().sum();
        if (m_bend) {
            const BendTable::Piece piece = m_bend->piece(centre, spread);
            shown = piece.middle();
            half = piece.linear.cwiseAbs().rowwise().sum() + piece.curvature() + piece.miss;
        }
        half = m_projection.boxAround(half);
        const ifs::Vector<2> middle = m_projection.cell(shown);
        const CellWindow& window = m_sums.window();
        return {middle.x() + half.x() >= 0 && middle.x() - half.x() <= window.width &&
                    middle.y() + half.y() >= window.firstRow && middle.y() - half.y() <= window.endRow,
                2 * half.maxCoeff()};
    }

    // Image of the edge from a to b without b, in straight pieces that are accurate to a quarter of a pixel.
    void addEdge(const ifs::Vector<2>& a, const ifs::Vector<2>& b, int depth) {
        const auto shown = [this](const ifs::Vector<2>& x) {
            return m_projection.cell(m_projection.cage(x));
        };
        if (m_bend && depth < 10) {
            const ifs::Vector<2> middle = (a + b) / 2;
            const ifs::Vector<2> off = shown(middle) - (shown(a) + shown(b)) / 2;
            // At least two divisions: an edge may look straight by chance.
            if (depth < 2 || off.cwiseAbs().maxCoeff() > maxBendError * m_projection.cellsPerPixel) {
                addEdge(a, middle, depth + 1);
                addEdge(middle, b, depth + 1);
                return;
            }
        }
        m_corners.push_back(shown(a));
    }

    void add(int x, int y, const ColourCell& colour, std::uint32_t times = 1) {
        const CellWindow& window = m_sums.window();
        const std::size_t at =
            static_cast<std::size_t>(y - window.firstRow) * static_cast<std::size_t>(window.width) +
            static_cast<std::size_t>(x);
        if (m_sums.kind() == CellKind::Count) {
            m_sums.counts(0)[at] += times;
            return;
        }
        ColourCell& sum = m_sums.colours(0)[at];
        sum.samples += times;
        sum.red += times * colour.red;
        sum.green += times * colour.green;
        sum.blue += times * colour.blue;
    }

    // Adds samples along the sides of the polygon just filled. The points on a side do not depend on the
    // window.
    void outline(const ColourCell& colour) {
        constexpr std::uint32_t times = 3;
        const CellWindow& window = m_sums.window();
        for (std::size_t k = 0; k < m_corners.size(); ++k) {
            const ifs::Vector<2>& a = m_corners[k];
            const ifs::Vector<2> side = m_corners[(k + 1) % m_corners.size()] - a;
            const double steps = std::ceil(side.cwiseAbs().maxCoeff());
            double from = 0; // section of the side, as shares, that crosses the window
            double to = 1;
            const auto clip = [&](double start, double length, double low, double high) {
                if (length == 0) return;
                const double first = (low - start) / length;
                const double second = (high - start) / length;
                from = std::max(from, std::min(first, second));
                to = std::min(to, std::max(first, second));
            };
            clip(a.x(), side.x(), 0, window.width);
            clip(a.y(), side.y(), window.firstRow, window.endRow);
            const double end = std::min(steps, std::ceil(to * steps) + 1);
            for (double i = std::max(0.0, std::floor(from * steps) - 1); i < end; ++i) {
                const ifs::Vector<2> at = a + side * ((i + 0.5) / steps);
                if (at.x() >= 0 && at.x() < window.width && at.y() >= window.firstRow &&
                    at.y() < window.endRow)
                    add(static_cast<int>(at.x()), static_cast<int>(at.y()), colour, times);
            }
        }
    }

    // Even-odd rule at the middles of cells.
    // False where the image is not finite.
    bool fill(const ifs::AffineMap<2>& map, const ColourCell& colour) {
        m_corners.clear();
        for (std::size_t j = 0; j < m_job.polygon.size(); ++j)
            addEdge(map(m_job.polygon[j]), map(m_job.polygon[(j + 1) % m_job.polygon.size()]), 0);
        ifs::Vector<2> middle = ifs::Vector<2>::Zero();
        for (const ifs::Vector<2>& corner : m_corners) {
            if (!corner.allFinite()) return false;
            middle += corner / static_cast<double>(m_corners.size());
        }
        const CellWindow& window = m_sums.window();
        const auto [low, high] = std::minmax_element(
            m_corners.begin(), m_corners.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
        const int first = static_cast<int>(
            std::clamp(std::floor(low->y()), double(window.firstRow), double(window.endRow)));
        const int end = static_cast<int>(
            std::clamp(std::ceil(high->y()) + 1, double(window.firstRow), double(window.endRow)));
        bool any = false;
        for (int y = first; y < end; ++y)
            any = fillRow(y, colour) || any;
        if (!any && middle.x() >= 0 && middle.x() < window.width && middle.y() >= window.firstRow &&
            middle.y() < window.endRow)
            add(static_cast<int>(middle.x()), static_cast<int>(middle.y()), colour);
        return true;
    }

    bool fillRow(int y, const ColourCell& colour) {
        const double height = y + 0.5;
        m_crossings.clear();
        for (std::size_t k = 0; k < m_corners.size(); ++k) {
            const ifs::Vector<2>& a = m_corners[k];
            const ifs::Vector<2>& b = m_corners[(k + 1) % m_corners.size()];
            if ((a.y() <= height) != (b.y() <= height))
                m_crossings.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
        std::sort(m_crossings.begin(), m_crossings.end());
        const double width = m_sums.window().width;
        bool any = false;
        for (std::size_t k = 0; k + 1 < m_crossings.size(); k += 2) {
            const int from = static_cast<int>(std::clamp(std::ceil(m_crossings[k] - 0.5), 0.0, width));
            const int to = static_cast<int>(std::clamp(std::ceil(m_crossings[k + 1] - 0.5), 0.0, width));
            for (int x = from; x < to; ++x)
                add(x, y, colour);
            m_filled += static_cast<std::size_t>(std::max(0, to - from));
            any = any || to > from;
        }
        return any;
    }

    const Prefractal& m_job;
    const Projection& m_projection;
    const Prefractal::Colour& m_colour;
    CellSums& m_sums;
    ifs::Vector<2> m_low;
    ifs::Vector<2> m_high;
    bool m_outlined = false;
    std::optional<BendTable> m_bend;
    std::vector<ifs::Vector<2>> m_corners;
    std::vector<double> m_crossings;
    std::size_t m_filled = 0; // cells filled since the last check of the stop token
};

} // namespace

bool Prefractal::draw(const Projection& projection, const Colour& colour, CellSums& sums,
                      const std::stop_token& stop) const {
    return Painter(*this, projection, colour, sums).paint(stop);
}

int affordableIterations(std::size_t maps, int wanted) {
    if (maps <= 1) return std::min(std::max(wanted, 0), static_cast<int>(maxImages));
    int iterations = 0;
    for (double images = static_cast<double>(maps); iterations < wanted && images <= maxImages;
         images *= static_cast<double>(maps))
        ++iterations;
    return iterations;
}

} // namespace attractor
