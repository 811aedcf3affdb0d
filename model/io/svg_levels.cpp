// SPDX-License-Identifier: MIT
#include "io/svg_levels.h"

#include "ifs/attractor_existence.h"
#include "ifs/common_lines.h"
#include "ifs/support_function.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

namespace io {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double thinnest = 1.2;     // of a copy by a singular map, in pixels: what is thinner is hardly seen
constexpr double mostThinness = 0.5; // that a map is raised to, however small its copies are
constexpr double hullTolerance = 2e-3;   // of the radius
constexpr double singular = 0.1;         // a larger least singular value is never raised
constexpr double shadowDetail = 0.5;     // of what a singular map shows, in pixels
constexpr double widening = 0.4;         // of the smallest copies on every side, in pixels
constexpr double mostWidening = 0.6;     // as a share of their size
constexpr double faint = 0.15;           // mean thickness of copies, in pixels
constexpr double largestFaint = 3;       // size of copies that are kept larger so as not to fade, in pixels
constexpr std::size_t mostWords = 4000;  // of a picture that is written out word by word
constexpr std::size_t mostBars = 20'000; // of their shadows

double diameterOf(const std::vector<ifs::Vector<2>>& points) {
    double longest = 0;
    for (const auto& a : points)
        for (const auto& b : points)
            longest = std::max(longest, (a - b).norm());
    return longest;
}

double areaOf(const std::vector<ifs::Vector<2>>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
}

ifs::Vector<2> middleOf(const std::vector<ifs::Vector<2>>& points) {
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const auto& p : points)
        sum += p;
    return sum / double(points.size());
}

double turn(const ifs::Vector<2>& a, const ifs::Vector<2>& b, const ifs::Vector<2>& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Strictly convex and counter-clockwise: points found to a tolerance need not be (Andrew's monotone chain).
std::vector<ifs::Vector<2>> strictlyConvex(std::vector<ifs::Vector<2>> points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<ifs::Vector<2>> chain;
    const auto add = [&](const ifs::Vector<2>& point, std::size_t fixed) {
        while (chain.size() >= fixed + 2 && turn(chain[chain.size() - 2], chain.back(), point) <= 0)
            chain.pop_back();
        chain.push_back(point);
    };
    for (const auto& point : points)
        add(point, 0);
    const std::size_t lower = chain.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        add(*point, lower);
    chain.pop_back();
    return chain;
}

// The convex polygon pushed out so that it holds every point within `distance` of it (the corners are cut
// only beyond that). A point or a segment becomes a rectangle.
std::vector<ifs::Vector<2>> pushedOut(const std::vector<ifs::Vector<2>>& polygon, double distance) {
    std::vector<ifs::Vector<2>> result;
    const std::size_t n = polygon.size();
    if (n < 3) {
        const ifs::Vector<2>& a = polygon.front();
        const ifs::Vector<2>& b = polygon.back();
        const ifs::Vector<2> along = n == 2 ? ifs::Vector<2>((b - a).normalized()) : ifs::Vector<2>(1, 0);
        const ifs::Vector<2> u = distance * along;
        const ifs::Vector<2> v(-u.y(), u.x());
        return {a - u - v, b + u - v, b + u + v, a - u + v};
    }
    const auto outward =
        [&](std::size_t i) { // of the edge from vertex i, the polygon being counter-clockwise
            const ifs::Vector<2> edge = polygon[(i + 1) % n] - polygon[i % n];
            return ifs::Vector<2>(ifs::Vector<2>(edge.y(), -edge.x()).normalized());
        };
    for (std::size_t i = 0; i < n; ++i) {
        const ifs::Vector<2> before = outward(i + n - 1);
        const ifs::Vector<2> after = outward(i);
        const double cosine = before.dot(after);
        if (cosine > -0.5) {
            result.push_back(polygon[i] + distance * (before + after) / (1 + cosine));
            continue;
        }
        // A sharp corner would stick out far: two vertices, the square around the corner's end.
        const ifs::Vector<2> tip = (before + after).normalized() * distance;
        result.push_back(polygon[i] + distance * before + tip);
        result.push_back(polygon[i] + distance * after + tip);
    }
    return result;
}

struct Descent {
    std::vector<int> steps; // of each map
    double shrinkage;       // − logarithm of the size that one step stands for
};

// How many steps each map descends: the logarithm of its size in units of the largest map's.
Descent descentOf(const std::vector<ifs::AffineMap<2>>& maps) {
    constexpr double smallestShrinkage = 0.03;
    std::vector<double> costs;
    double least = HUGE_VAL;
    for (const auto& map : maps) {
        const auto sigma = ifs::singularValues<2>(map.linear);
        // The geometric mean, but a thin copy is also long.
        const double size = std::sqrt(sigma[0] * std::max(sigma[1], sigma[0] / 10));
        costs.push_back(-std::log(std::max(size, 1e-9)));
        if (costs.back() > 0) least = std::min(least, costs.back());
    }
    Descent descent{{}, std::isfinite(least) ? std::max(least, smallestShrinkage) : smallestShrinkage};
    for (const double cost : costs)
        descent.steps.push_back(
            std::clamp(int(std::lround(cost / descent.shrinkage)), 1, SvgLevels::mostLevels));
    return descent;
}

// The direction that a map keeps the most of.
ifs::Vector<2> longestDirection(const ifs::Matrix<2>& linear) {
    const ifs::Matrix<2> square = linear.transpose() * linear;
    const double angle = std::atan2(2 * square(0, 1), square(0, 0) - square(1, 1)) / 2;
    return {std::cos(angle), std::sin(angle)};
}

using Interval = std::pair<double, double>;

// Where the attractor of `maps`, inside `hull`, lies along `axis`: intervals that hold all of it and no point
// further than `detail` from it, in order and apart. nullopt when they would be too many.
std::optional<std::vector<Interval>> shadow(const std::vector<ifs::AffineMap<2>>& maps,
                                            const std::vector<ifs::Vector<2>>& hull,
                                            const ifs::Vector<2>& axis, double detail) {
    constexpr std::size_t most = 300'000;
    struct Copy {
        Eigen::RowVector2d row;
        double offset;
    };
    std::vector<Copy> open{{axis.transpose(), 0}};
    std::vector<Interval> found;
    while (!open.empty()) {
        if (open.size() + found.size() > most) return std::nullopt;
        const Copy copy = open.back();
        open.pop_back();
        Interval interval{HUGE_VAL, -HUGE_VAL};
        for (const auto& point : hull) {
            const double place = copy.row.dot(point) + copy.offset;
            interval = {std::min(interval.first, place), std::max(interval.second, place)};
        }
        if (interval.second - interval.first <= detail) {
            found.push_back(interval);
            continue;
        }
        for (const auto& map : maps)
            open.push_back({copy.row * map.linear, copy.offset + copy.row.dot(map.translation)});
    }
    std::sort(found.begin(), found.end());
    std::vector<Interval> joined;
    for (const Interval& interval : found) {
        if (joined.empty() || interval.first > joined.back().second + detail)
            joined.push_back(interval);
        else
            joined.back().second = std::max(joined.back().second, interval.second);
    }
    return joined;
}

} // namespace

ifs::AffineMap<2> thickened(const ifs::AffineMap<2>& map, const ifs::Vector<2>& centre, double least) {
    const auto& m = map.linear;
    // A = R(φ)·diag(s, t)·R(ψ), from A z = αz + βz̄.
    const std::complex<double> alpha((m(0, 0) + m(1, 1)) / 2, (m(1, 0) - m(0, 1)) / 2);
    const std::complex<double> beta((m(0, 0) - m(1, 1)) / 2, (m(1, 0) + m(0, 1)) / 2);
    const double s = std::abs(alpha) + std::abs(beta);
    const double t = std::abs(alpha) - std::abs(beta);
    if (std::abs(t) >= least) return map;
    const Eigen::Rotation2D<double> outer((std::arg(alpha) + std::arg(beta)) / 2);
    const Eigen::Rotation2D<double> inner((std::arg(alpha) - std::arg(beta)) / 2);
    const ifs::Vector<2> thickness(std::max(s, least), std::copysign(least, t));
    ifs::AffineMap<2> thick;
    thick.linear = outer.toRotationMatrix() * thickness.asDiagonal() * inner.toRotationMatrix();
    thick.translation = map(centre) - thick.linear * centre;
    return thick;
}

std::optional<SvgLevels> SvgLevels::of(const document::System2& system, const ifs::AffineMap<2>& display,
                                       std::span<const ifs::MovedBranch<2>> moved) {
    const auto active = ifs::activeMaps(system);
    const auto support = ifs::SupportFunction<2>::of(active.maps);
    if (!support) return std::nullopt;
    SvgLevels levels;
    levels.m_pixel = 1 / std::max(ifs::spectralNorm<2>(display.linear), 1e-300);
    const double tolerance = std::max(hullTolerance * support->radius(), 1e-3 * levels.m_pixel);
    const ifs::ConvexHull hull = ifs::convexHull(*support, tolerance);
    levels.m_hull = strictlyConvex(hull.vertices);
    levels.m_hullError = std::max(hull.error, tolerance);
    levels.m_diameter = diameterOf(levels.m_hull);
    if (!std::isfinite(levels.m_diameter) || levels.m_hull.empty()) return std::nullopt;
    levels.m_index = active.index;
    levels.m_moved = ifs::overMaps<2>(moved, active.index);
    levels.thickenAll(active.maps, display);
    Descent descent = descentOf(levels.m_maps);
    levels.m_steps = std::move(descent.steps);
    levels.m_shrinkage = descent.shrinkage;
    levels.findFibre();
    levels.countReferences();
    levels.findFaintLevel();
    return levels;
}

// A map whose copy of the whole picture would be thinner than can be seen is taken for singular.
void SvgLevels::thickenAll(const std::vector<ifs::AffineMap<2>>& maps, const ifs::AffineMap<2>& display) {
    m_centre = middleOf(m_hull);
    m_thinness = thinnest * m_pixel / std::max(m_diameter, m_pixel);
    m_display = thickened(display, m_centre, thinnest / std::max(m_diameter, m_pixel));
    m_displayShift = shiftBetween(m_display, display);
    m_maps = maps;
    for (const auto& map : maps) {
        const bool isSingular = !(thickened(map, m_centre, std::min(m_thinness, singular)) == map);
        m_shadows.push_back(isSingular ? std::optional(shadowOf(map)) : std::nullopt);
    }
}

// Whether copies fade away unless they are larger than a few pixels: the picture is then written out.
void SvgLevels::findFaintLevel() {
    if (m_diameter < m_pixel) return;
    const int level = levelFor(1, HUGE_VAL);
    if (deviation(level).copy <= largestFaint || references(level + 1) > comfortableReferences) return;
    writeOut();
    if (!m_words.empty()) m_faintLevel = level + 1;
}

bool SvgLevels::isFaint(const Deviation& deviation) {
    return deviation.area < faint * deviation.length;
}

SvgLevels::Shadow SvgLevels::shadowOf(const ifs::AffineMap<2>& map) const {
    const double length = std::max(ifs::spectralNorm<2>(map.linear), m_thinness); // as it is drawn
    return shadowAlong(longestDirection(map.linear), length);
}

// As bars across the direction that a map keeps: thickened, they become bars of the same thickness.
SvgLevels::Shadow SvgLevels::shadowAlong(const ifs::Vector<2>& along, double length) const {
    const ifs::Vector<2> across = ifs::Vector<2>(-along.y(), along.x()) * (std::max(m_diameter, m_pixel) / 2);
    double detail = std::max(shadowDetail * m_pixel / length, 2 * m_hullError);
    auto intervals = shadow(m_maps, m_hull, along, detail);
    while (!intervals)
        intervals = shadow(m_maps, m_hull, along, detail *= 2);
    Shadow result{{}, detail};
    for (const auto& [low, high] : *intervals) {
        const ifs::Vector<2> middle = m_centre - along.dot(m_centre) * along;
        const ifs::Vector<2> from = middle + (low - detail / 2) * along;
        const ifs::Vector<2> to = middle + (high + detail / 2) * along;
        result.bars.push_back({from - across, to - across, to + across, from + across});
    }
    return result;
}

// Every copy by its own matrix, as large as it can be while it is thinner than can be seen: it shows the
// attractor flat along the direction that its word keeps, rounded to what half a pixel tells apart, so that
// words share shadows. Nothing when that would be a large file.
void SvgLevels::writeOut() {
    const std::size_t ofMaps = m_shadows.size();
    std::map<std::pair<int, int>, std::size_t> known; // by size and direction
    std::size_t bars = 0;
    const auto shadowFor = [&](const ifs::Matrix<2>& linear, double length) {
        const int size = int(std::ceil(std::log2(std::max(length / m_thinness, 1.0))));
        const double longest = m_thinness * std::exp2(size);
        const double turns = std::ceil(pi * longest * m_diameter / m_pixel);
        const ifs::Vector<2> along = longestDirection(linear);
        const double turn = std::round(std::atan2(along.y(), along.x()) / pi * turns);
        const auto [place, isNew] =
            known.emplace(std::pair(size, int(std::fmod(turn + turns, turns))), m_shadows.size());
        if (isNew) {
            const double angle = turn * pi / turns;
            m_shadows.push_back(shadowAlong({std::cos(angle), std::sin(angle)}, longest));
            bars += m_shadows.back()->bars.size();
        }
        return place->second;
    };
    std::vector<Word> open;
    const auto add = [&](const ifs::AffineMap<2>& map, std::optional<std::size_t> first) {
        const double length = ifs::spectralNorm<2>(map.linear);
        const bool isDot = length < m_thinness / 2;
        Word word{
            {thickened(map, m_centre, isDot ? std::max(length, m_thinness / 4) : m_thinness), 0, {}, first},
            map};
        const bool isThick = !isDot && word.copy.map == map;
        if (!isDot && !isThick) word.copy.shadow = shadowFor(map.linear, length);
        (isThick ? open : m_words).push_back(word);
    };
    for (const auto& [branch, change] : ifs::pieces<2>(m_moved, m_maps.size())) {
        ifs::AffineMap<2> map = change;
        for (const int symbol : branch)
            map = map * m_maps[std::size_t(symbol)];
        add(map, branch.empty() ? std::nullopt : std::optional(std::size_t(branch.front())));
    }
    while (!open.empty()) {
        if (open.size() + m_words.size() > mostWords || bars > mostBars) {
            m_words.clear();
            m_shadows.resize(ofMaps);
            return;
        }
        const Word outer = open.back();
        open.pop_back();
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            add(outer.map * m_maps[i], outer.copy.first.value_or(i));
    }
    std::stable_sort(m_words.begin(), m_words.end(),
                     [](const Word& a, const Word& b) { return a.copy.first < b.copy.first; });
}

double SvgLevels::shiftBetween(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) const {
    const ifs::AffineMap<2> difference{a.linear - b.linear, a.translation - b.translation};
    double furthest = difference(m_centre).norm();
    for (const auto& point : m_hull) // the hull contains the attractor but for m_hullError
        furthest = std::max(furthest, difference(point).norm());
    return furthest + ifs::spectralNorm<2>(difference.linear) * m_hullError;
}

// The copies that `level` makes are about exp(shrinkage·(depth − level)) times smaller than the picture.
ifs::AffineMap<2> SvgLevels::map(std::size_t i, int level, int depth) const {
    if (!m_shadows[i]) return m_maps[i];
    const double least = m_thinness * std::exp(m_shrinkage * (depth - level));
    return thickened(m_maps[i], m_centre, std::min(least, mostThinness));
}

SvgLevels::Copy SvgLevels::copy(std::size_t i, int level, int depth) const {
    Copy copy{map(i, level, depth), below(level, i), {}, i};
    if (m_shadows[i] && level > 0) copy.shadow = i;
    return copy;
}

std::vector<SvgLevels::Copy> SvgLevels::copies(int level, int depth) const {
    std::vector<Copy> result;
    for (std::size_t i = 0; i < m_maps.size(); ++i)
        result.push_back(copy(i, level, depth));
    return result;
}

std::vector<ifs::MovedBranch<2>> SvgLevels::pieces() const {
    auto pieces = ifs::pieces<2>(m_moved, m_maps.size());
    for (ifs::MovedBranch<2>& piece : pieces)
        piece.change = thickened(piece.change, m_centre, std::min(m_thinness, singular));
    return pieces;
}

std::vector<SvgLevels::Copy> SvgLevels::picture(int depth) const {
    std::vector<Copy> result;
    if (depth >= m_faintLevel) {
        for (const Word& word : m_words)
            result.push_back(word.copy);
        return result;
    }
    for (const auto& [word, change] : pieces()) {
        Copy piece{change, depth, {}, {}};
        for (const int symbol : word) {
            const Copy inner = copy(std::size_t(symbol), piece.level, depth);
            piece = {piece.map * inner.map, inner.level, inner.shadow, piece.first.value_or(symbol)};
        }
        // A shadow shows a branch that ends with its map; of a longer one the copy is as flat, and whole.
        if (!word.empty() || depth == 0) {
            result.push_back(piece);
            continue;
        }
        for (Copy inner : copies(depth, depth)) {
            inner.map = change * inner.map;
            result.push_back(inner);
        }
    }
    return result;
}

void SvgLevels::countReferences() {
    for (int level = 0; level <= mostLevels; ++level) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; level > 0 && i < m_maps.size(); ++i)
            sum += m_shadows[i] ? 1 : 1 + m_references[std::size_t(below(level, i))];
        m_references.push_back(std::min(sum, mostReferences));
    }
}

void SvgLevels::findFibre() {
    for (const ifs::Vector<2>& direction : ifs::commonDirections(m_maps)) {
        constexpr double rounding = 1e-9;
        const ifs::Vector<2> across(-direction.y(), direction.x());
        double shrinkage = HUGE_VAL;
        bool isThin = false; // some copy is, or becomes so by shear
        bool isThick = false;
        for (std::size_t i = 0; i < m_maps.size(); ++i) {
            const ifs::Matrix<2>& linear = m_maps[i].linear;
            const double along = (linear * direction).norm();
            const double area = std::abs(ifs::determinant<2>(linear));
            isThin = isThin || along * along < area * (1 - rounding) ||
                     std::abs(direction.dot(linear * across)) > rounding * linear.norm();
            isThick = isThick || m_shadows[i] || along * along > area * (1 + rounding);
            shrinkage = std::min(shrinkage, -std::log(along) / m_steps[i]);
        }
        if (isThin && !isThick && shrinkage > m_fibreShrinkage) {
            m_fibre = direction;
            m_fibreShrinkage = shrinkage;
        }
    }
}

ifs::Vector<2> SvgLevels::fibre(int depth) const {
    constexpr double longest = 1e6; // of the picture
    if (depth >= m_faintLevel) return ifs::Vector<2>::Zero();
    return m_fibre * std::min(widening * m_pixel * std::exp(m_fibreShrinkage * depth), longest * m_diameter);
}

double SvgLevels::margin(int depth) const {
    if (m_diameter < m_pixel) return m_hullError + thinnest / 2 * m_pixel; // a dot
    if (depth >= m_faintLevel) return m_hullError + mostWidening * m_diameter;
    const double smallest = widening * m_pixel * std::exp(m_shrinkage * depth);
    return m_hullError + std::min(smallest, std::max(mostWidening * m_diameter, widening * m_pixel));
}

std::vector<ifs::Vector<2>> SvgLevels::outline(int depth) const {
    const std::vector<ifs::Vector<2>> wide = pushedOut(m_hull, margin(depth));
    if (m_fibre.isZero()) return wide;
    std::vector<ifs::Vector<2>> ends;
    for (const auto& point : wide)
        for (const double end : {1.0, -1.0})
            ends.push_back(point + end * fibre(depth));
    return strictlyConvex(std::move(ends));
}

int SvgLevels::below(int level, std::size_t map) const {
    return std::max(0, level - m_steps[map]);
}

std::uint64_t SvgLevels::references(int level) const {
    const int depth = std::clamp(level, 0, mostLevels);
    if (depth >= m_faintLevel) return m_words.size();
    if (m_moved.empty()) return m_references[std::size_t(depth)];
    std::uint64_t sum = 0;
    for (const Copy& copy : picture(depth))
        sum += copy.shadow ? 1 : 1 + m_references[std::size_t(copy.level)];
    return std::min(sum, mostReferences);
}

int SvgLevels::deepest() const {
    if (m_faintLevel <= mostLevels) return mostLevels;
    const auto tooMany = std::find(m_references.begin(), m_references.end(), mostReferences);
    return int(tooMany - m_references.begin()) - 1;
}

// Of the bars under `drawn` from the attractor under `map`: along the line that the map keeps by what the
// shadow leaves open, across it by half a bar and half the attractor's thickness.
double SvgLevels::shadowError(const Shadow& shadow, const ifs::AffineMap<2>& drawn,
                              const ifs::AffineMap<2>& map) const {
    const ifs::Vector<2> side = shadow.bars.front()[3] - shadow.bars.front()[0];
    const ifs::Vector<2> across = side.normalized();
    const ifs::Vector<2> along(across.y(), -across.x());
    return ((drawn.linear - map.linear) * along).norm() * m_diameter +
           2 * (drawn.linear * along).norm() * shadow.detail + (drawn.linear * side).norm() / 2 +
           (map.linear * across).norm() * m_diameter;
}

SvgLevels::Deviation SvgLevels::deviation(int depth) const {
    struct Part {
        ifs::Matrix<2> linear;
        int level;
        std::optional<std::size_t> shadow;
        double shift; // of its points, by thickening, in pixels
    };
    Deviation result;
    const double diameter = diameterOf(pushedOut(m_hull, margin(depth)));
    const double area = areaOf(outline(depth));
    const auto step = [&](const Copy& copy, const ifs::AffineMap<2>& map) {
        const double shift =
            copy.shadow ? shadowError(*m_shadows[*copy.shadow], copy.map, map) : shiftBetween(copy.map, map);
        return Part{copy.map.linear, copy.level, copy.shadow, shift};
    };
    const auto inside = [](const Part& outer, const Part& inner) {
        return Part{outer.linear * inner.linear, inner.level, inner.shadow,
                    outer.shift + ifs::spectralNorm<2>(outer.linear) * inner.shift};
    };
    std::vector<Part> open;
    std::vector<std::vector<Part>> steps(1); // by level
    if (depth >= m_faintLevel) {
        for (const Word& word : m_words)
            open.push_back(inside({m_display.linear, 0, {}, m_displayShift}, step(word.copy, word.map)));
    } else {
        for (int level = 1; level <= depth; ++level) {
            steps.emplace_back();
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                steps.back().push_back(step(copy(i, level, depth), m_maps[i]));
        }
        for (const auto& [word, change] : pieces()) {
            Part part{m_display.linear * change.linear, depth, {}, m_displayShift};
            for (const int symbol : word) {
                const auto i = std::size_t(symbol);
                part = inside(part, step(copy(i, part.level, depth), m_maps[i]));
            }
            open.push_back(part);
        }
    }
    for (std::uint64_t parts = 0; !open.empty(); ++parts) {
        if (parts > 2 * mostReferences) {
            result.copy = result.all = HUGE_VAL;
            return result;
        }
        const Part part = open.back();
        open.pop_back();
        if (part.shadow) { // shows all that there is, however deep the picture
            result.all = std::max(result.all, part.shift);
            continue;
        }
        if (part.level == 0) {
            const double size = ifs::spectralNorm<2>(part.linear) * diameter;
            result.copy = std::max(result.copy, size);
            result.area += std::abs(ifs::determinant<2>(part.linear)) * area;
            result.length += size;
            const double longer = (part.linear * fibre(depth)).norm();
            result.all = std::max(result.all, size + longer + part.shift);
            continue;
        }
        for (const Part& inner : steps[std::size_t(part.level)])
            open.push_back(inside(part, inner));
    }
    return result;
}

double SvgLevels::error(int depth) const {
    return deviation(depth).all;
}

int SvgLevels::levelFor(double wanted) const {
    return levelFor(wanted, largestFaint);
}

int SvgLevels::levelFor(double wanted, double largest) const {
    int level = 0;
    if (m_diameter < m_pixel) return level;
    while (level < mostLevels && references(level + 1) <= comfortableReferences &&
           deviation(level).copy > wanted) {
        ++level;
        if (level >= m_faintLevel) return level; // and none below it shows more
    }
    // Copies that have become thin as well fade away: larger ones say less exactly where something is, but
    // that it is.
    while (level > 0 && isFaint(deviation(level)) && deviation(level - 1).copy <= largest)
        --level;
    return level;
}

} // namespace io
