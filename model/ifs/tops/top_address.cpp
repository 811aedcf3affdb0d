// SPDX-License-Identifier: MIT
#include "ifs/tops/top_address.h"

#include "ifs/extent/address_search.h"
#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

constexpr int maxVisits = 4'000'000;
constexpr std::size_t longest = 4096;
constexpr double leafSize = 0.25;  // tolerances; radius of a piece that counts as a point
constexpr double settledSize = 64; // tolerances; size of pieces between which rounding cannot choose
constexpr std::size_t maxPeriod = 64;

// Distance by which rounding may move a point of a composed map, including the error of the coefficients.
double roundingOf(const SupportFunction<2>& attractor) {
    const double scale = attractor.centre().norm() + attractor.radius();
    double longestShift = 0;
    for (const AffineMap<2>& map : attractor.maps())
        longestShift = std::max(longestShift, map.translation.norm());
    const double steps = attractor.normEquivalence() / (1 - attractor.contractivity());
    return 0x1p-51 * (scale + longestShift) * (2 + std::min(steps, 1e6));
}

} // namespace

Word symbols(const TopAddress& top, std::size_t count) {
    Word result(top.word.begin(), top.word.begin() + std::ptrdiff_t(std::min(count, top.word.size())));
    while (result.size() < count)
        result.push_back(top.period > 0 ? result[result.size() - top.period] : 0);
    return result;
}

std::optional<Vector<2>> pointOf(const TopAddress& top, std::span<const AffineMap<2>> maps) {
    const auto begin = top.word.end() - std::ptrdiff_t(top.period);
    return addressPoint<2>(maps, Word(top.word.begin(), begin),
                           top.period > 0 ? Word(begin, top.word.end()) : Word{0});
}

TopSearch::TopSearch(SupportFunction<2> attractor)
    : m_attractor(std::move(attractor)), m_polygon(m_attractor), m_tolerance(roundingOf(m_attractor)) {
    const auto& h = m_polygon.heights;
    m_size = std::hypot(h[0] + h[8], h[4] + h[12]);
}

TopSearch::Answer TopSearch::at(const Vector<2>& x) const {
    if (!x.allFinite()) return {};
    Vector<2> nearest = x;
    Found found = firstWithin(x);
    if (!found.isFound && !found.isCutShort) {
        const AddressQuery query{x};
        const auto match = addressNear(m_attractor, std::span(&query, 1), reach(), m_tolerance);
        if (!match) return {};
        nearest = composed<2>(m_attractor.maps(), match->address)(m_attractor.pointOfAttractor());
        found = firstWithin(nearest);
    }
    if (found.isCutShort || !found.isFound) return {std::nullopt, true};
    return {completed(settled(found.word), nearest), false};
}

// Searches depth first, in the order of the addresses: the first find is the top.
TopSearch::Found TopSearch::firstWithin(const Vector<2>& x) const {
    struct Level {
        AffineMap<2> map;
        std::size_t next = 0;
    };
    const auto& maps = m_attractor.maps();
    std::vector<Level> levels(1);
    Word word;
    for (int visits = 0; !levels.empty();) {
        Level& level = levels.back();
        if (level.next == maps.size()) {
            levels.pop_back();
            if (!word.empty()) word.pop_back();
            continue;
        }
        if (++visits > maxVisits) return {{}, false, true};
        const int symbol = int(level.next++);
        const AffineMap<2> map = level.map * maps[std::size_t(symbol)];
        if (!isNear(map, x)) continue;
        word.push_back(symbol);
        const double radius = spectralNorm<2>(map.linear) * m_attractor.radius();
        if (radius <= leafSize * m_tolerance || word.size() == longest) return {word, true, false};
        levels.push_back({map});
    }
    return {};
}

// Returns true if the piece may reach x, to the tolerance.
bool TopSearch::isNear(const AffineMap<2>& map, const Vector<2>& x) const {
    const double stretch = spectralNorm<2>(map.linear);
    const double distance = (map(m_attractor.centre()) - x).norm();
    return distance <= stretch * m_attractor.radius() + m_tolerance && !isOutside(map, x);
}

// Returns true if x is outside the polygon around the piece, which may be much thinner than the ball: beyond
// one of its edges, by more than the tolerance and the rotation of the edge by rounding.
bool TopSearch::isOutside(const AffineMap<2>& map, const Vector<2>& x) const {
    const auto corners = m_polygon.image(map);
    const double orientation = determinant<2>(map.linear) < 0 ? -1 : 1;
    Vector<2> from = corners.back();
    for (const Vector<2>& to : corners) {
        const Vector<2> edge = to - from, seen = x - from;
        const double length = edge.norm();
        const double slack = m_tolerance * (length + seen.norm() / 4);
        if (length > 0 && orientation * cross(edge, seen) < -slack) return true;
        from = to;
    }
    return false;
}

// The word without its last symbols, which the upper end of the tolerance has chosen.
Word TopSearch::settled(const Word& word) const {
    AffineMap<2> map;
    Word result;
    for (const int symbol : word) {
        map = map * m_attractor.maps()[std::size_t(symbol)];
        if (spectralNorm<2>(map.linear) * m_attractor.radius() < settledSize * m_tolerance) break;
        result.push_back(symbol);
    }
    return result;
}

// The symbols after the settled ones are those of the nearest point, unless x is as near to a point whose
// address repeats early.
TopAddress TopSearch::completed(const Word& settled, const Vector<2>& x) const {
    const AddressQuery query{x, 1, settled};
    const auto match =
        addressNear(m_attractor, std::span(&query, 1), settledSize * m_tolerance, leafSize * m_tolerance);
    TopAddress result{match && match->address.size() >= settled.size() ? match->address : settled, 0, x};
    if (auto found = repeating(settled, result.word.size(), x)) return *found;
    result.point = pointOf(result, m_attractor.maps()).value_or(x);
    return result;
}

// The shortest beginning and period that together are at most half as long as what doubles carry.
std::optional<TopAddress> TopSearch::repeating(const Word& settled, std::size_t carried,
                                               const Vector<2>& x) const {
    const std::size_t most = std::min({carried / 2, settled.size(), maxPeriod});
    for (std::size_t length = 1; length <= most; ++length)
        for (std::size_t period = 1; period <= length; ++period) {
            std::size_t k = length;
            while (k < settled.size() && settled[k] == settled[k - period])
                ++k;
            if (k < settled.size()) continue;
            TopAddress top{Word(settled.begin(), settled.begin() + std::ptrdiff_t(length)), period, x};
            const auto point = pointOf(top, m_attractor.maps());
            if (!point || !((*point - x).norm() <= m_tolerance)) continue;
            top.point = *point;
            top.word = symbols(top, length + (carried - length + period - 1) / period * period);
            return top;
        }
    return std::nullopt;
}

} // namespace ifs
