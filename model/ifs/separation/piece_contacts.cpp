// SPDX-License-Identifier: MIT
#include "ifs/separation/piece_contacts.h"

#include "ifs/linear/rounding.h"
#include "ifs/separation/determinant_sum.h"
#include "ifs/separation/exact_map.h"
#include "ifs/separation/stored_rounding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ifs {

namespace {

constexpr std::size_t maxMaps = 64;

// A word with its map.
template <int Dim> struct Composed {
    Word word;
    AffineMap<Dim> map;
    StoredRounding<Dim> rounding;
};

// Words of growing length, about `most` of them altogether.
template <int Dim>
std::vector<Composed<Dim>> shortWords(std::span<const AffineMap<Dim>> maps, std::size_t most,
                                      std::size_t longest) {
    std::vector<StoredRounding<Dim>> roundings;
    for (const auto& map : maps)
        roundings.push_back(StoredRounding<Dim>::of(map));
    std::vector<Composed<Dim>> result{{{}, {}, {}}};
    for (std::size_t first = 0; first < result.size(); ++first) {
        if (result.size() + maps.size() > most || result[first].word.size() == longest) break;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const Composed<Dim>& outer = result[first];
            Composed<Dim> longer{outer.word, outer.map * maps[i],
                                 outer.rounding.after(outer.map, maps[i], roundings[i])};
            longer.word.push_back(int(i));
            result.push_back(std::move(longer));
        }
    }
    return result;
}

template <int Dim> class Contacts {
public:
    Contacts(const SupportFunction<Dim>& support, const NeighbourGraph* neighbours)
        : m_neighbours(neighbours),
          m_maps(support.maps()),
          m_seen(support.conditioning() ? support.conditioning()->support : support),
          m_off(support.conditioning() ? support.conditioning()->error : 0),
          m_telling(1e-6 * support.radius()) {
        double size = support.radius() + support.centre().norm();
        for (const auto& map : m_maps)
            size = std::max(size, map.translation.norm());
        m_near = 1e-12 * size;
    }

    PieceContacts found() {
        PieceContacts result;
        if (m_maps.size() < 2) {
            result.separation = Separation::Strong; // single point or piece
            result.connectedness = Connectedness::Connected;
            return result;
        }
        if (m_maps.size() > maxMaps) return result;
        result.overlaps = overlaps();
        if (result.overlaps.empty() && m_neighbours && m_neighbours->overlap()) {
            const auto& [first, second] = *m_neighbours->overlap();
            result.overlaps.push_back({first, second, m_neighbours->certainty() == Certainty::Exact});
        }
        const auto apart = piecesApart();
        if (!result.overlaps.empty())
            result.separation = Separation::Overlapping;
        else if (std::ranges::all_of(apart, [](bool isApart) { return isApart; }))
            result.separation = Separation::Strong;
        result.connectedness = connectedness(apart);
        return result;
    }

private:
    // Pairs of words with equal maps and different first maps.
    std::vector<Overlap> overlaps() const {
        constexpr std::size_t maxWords = 3'000, longest = 8;
        auto words = shortWords<Dim>(m_maps, maxWords, longest);
        words.erase(words.begin());
        // Sort key: maps that agree up to rounding are adjacent in one of the orders.
        const auto place = [](const Composed<Dim>& word) {
            double result = 0.3137 * word.map.translation.sum();
            for (int k = 0; k < Dim; ++k)
                result += word.map.translation[k] * (0.7 + 0.11 * k) + word.map.linear(k, k) * 0.37;
            return result;
        };
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < words.size(); ++k)
            order.emplace_back(place(words[k]), k);
        std::ranges::sort(order);
        std::vector<std::pair<std::size_t, std::size_t>> near;
        for (std::size_t k = 0; k < order.size(); ++k)
            for (std::size_t n = k + 1;
                 n < order.size() && n < k + 16 && order[n].first - order[k].first <= 16 * m_near; ++n) {
                const auto pair = std::minmax(order[k].second, order[n].second);
                const auto &a = words[pair.first], &b = words[pair.second];
                if (a.word.front() != b.word.front() && agree(a.map, b.map)) near.push_back(pair);
            }
        return shortest(words, near);
    }

    // Shortest pairs; longer ones follow from these or are not worth the room.
    std::vector<Overlap> shortest(const std::vector<Composed<Dim>>& words,
                                  std::vector<std::pair<std::size_t, std::size_t>>& near) const {
        constexpr std::size_t maxListed = 4;
        constexpr int maxAsked = 400;
        const auto length = [&](const auto& pair) {
            return words[pair.first].word.size() + words[pair.second].word.size();
        };
        std::ranges::sort(near, [&](const auto& a, const auto& b) {
            if (length(a) != length(b)) return length(a) < length(b);
            return std::tie(words[a.first].word, words[a.second].word) <
                   std::tie(words[b.first].word, words[b.second].word);
        });
        std::vector<Overlap> result;
        std::size_t least = 0;
        int asked = 0;
        for (const auto& pair : near) {
            if (result.size() == maxListed || (!result.empty() && length(pair) > least)) break;
            if (++asked > maxAsked) break;
            const auto &a = words[pair.first], &b = words[pair.second];
            const auto exactA = exactWord<Dim>(m_maps, a.word), exactB = exactWord<Dim>(m_maps, b.word);
            const bool isExact = exactA == exactB;
            if (!isExact && !agreeToRounding(exactA, exactB, a.rounding, b.rounding)) continue;
            least = length(pair);
            result.push_back({a.word, b.word, isExact});
        }
        return result;
    }

    static bool agreeToRounding(const ExactMap<Dim>& a, const ExactMap<Dim>& b,
                                const StoredRounding<Dim>& ofA, const StoredRounding<Dim>& ofB) {
        for (std::size_t i = 0; i < Dim; ++i) {
            const auto row = Eigen::Index(i);
            const double apart = std::abs((a.translation[i] - b.translation[i]).rounded());
            if (!(apart <= ofA.translation[row] + ofB.translation[row])) return false;
            for (std::size_t j = 0; j < Dim; ++j) {
                const auto column = Eigen::Index(j);
                const double off = std::abs((a.linear[i][j] - b.linear[i][j]).rounded());
                if (!(off <= ofA.linear(row, column) + ofB.linear(row, column))) return false;
            }
        }
        return true;
    }

    // True if they differ by less than a millionth of the size of the piece.
    bool agree(const AffineMap<Dim>& a, const AffineMap<Dim>& b) const {
        const double size = a.linear.cwiseAbs().maxCoeff();
        return (a.linear - b.linear).cwiseAbs().maxCoeff() <= 1e-12 * size &&
               (a.translation - b.translation).cwiseAbs().maxCoeff() <= std::min(m_near, size * m_telling);
    }

    std::size_t pairIndex(std::size_t i, std::size_t j) const { return i * m_maps.size() + j; }

    // Marks the pairs i < j whose pieces are proved to be disjoint.
    std::vector<bool> piecesApart() const {
        constexpr int maxWork = 400'000, maxPairWork = 40'000; // balls in total, and for one pair
        const int maps = int(m_maps.size());
        const int allowed = std::clamp(2 * maxWork / (maps * maps), 4 * maps, maxPairWork);
        std::vector<bool> result(m_maps.size() * m_maps.size(), true);
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            for (std::size_t j = i + 1; j < m_maps.size(); ++j)
                result[pairIndex(i, j)] =
                    areApart(i, j, allowed) || (m_neighbours && m_neighbours->areApart(i, j));
        return result;
    }

    // Ball around a piece.
    struct Cover {
        AffineMap<Dim> map;
        Vector<Dim> centre;
        double radius;
    };

    Cover cover(const AffineMap<Dim>& map) const {
        const double reach = m_seen.radius() + m_seen.centre().norm() + m_off;
        // Rounding error of all products that have led to the map.
        const double rounding = 1024 * roundingUnit * (map.linear.norm() * reach + map.translation.norm());
        return {map, map(m_seen.centre()),
                spectralNorm<Dim>(map.linear) * (m_seen.radius() + m_off) * (1 + 1e-12) + rounding};
    }

    // Divides pairs of pieces of i and j in balls that still meet, until none is left. The maps may be off by
    // rounding, which moves no point of the attractor by more than m_off.
    bool areApart(std::size_t i, std::size_t j, int allowed) const {
        const auto& maps = m_seen.maps();
        std::vector<std::pair<Cover, Cover>> open{{cover(maps[i]), cover(maps[j])}};
        const double smallest = 1e-9 * m_seen.radius() + 4 * m_off;
        while (!open.empty()) {
            auto [a, b] = std::move(open.back());
            open.pop_back();
            const double distance = (a.centre - b.centre).norm(); // infinite if its square overflows
            if (std::isfinite(distance) && distance * (1 - 1e-12) > a.radius + b.radius + 2 * m_off) continue;
            if (allowed <= 0 || std::max(a.radius, b.radius) < smallest) return false;
            if (a.radius < b.radius) std::swap(a, b);
            allowed -= int(maps.size());
            for (const auto& map : maps)
                open.emplace_back(cover(a.map * map), b);
        }
        return true;
    }

    // Returns true if the pairs that satisfy the predicate connect all maps.
    template <class Joined> bool joinsAll(Joined joined) const {
        std::vector<std::size_t> group(m_maps.size());
        std::iota(group.begin(), group.end(), std::size_t(0));
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            for (std::size_t j = i + 1; j < m_maps.size(); ++j)
                if (joined(i, j)) {
                    const std::size_t from = group[j], to = group[i];
                    std::ranges::replace(group, from, to);
                }
        return std::ranges::all_of(group, [&](std::size_t g) { return g == group.front(); });
    }

    Connectedness connectedness(const std::vector<bool>& apart) const {
        if (!joinsAll([&](std::size_t i, std::size_t j) { return !apart[pairIndex(i, j)]; }))
            return Connectedness::Disconnected;
        if (m_neighbours && m_neighbours->certainty() == Certainty::Exact) return byNeighbours();
        // Two pieces cannot be disjoint if all pieces of a neighbourhood meet.
        if (m_maps.size() == 2 && fillSpace<Dim>(m_maps)) return Connectedness::Connected;
        const auto points = knownPoints();
        std::vector<bool> exact(apart.size()), rounded(apart.size());
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            for (std::size_t j = i + 1; j < m_maps.size(); ++j)
                if (!apart[pairIndex(i, j)]) meet(points, i, j, exact, rounded);
        if (joinsAll([&](std::size_t i, std::size_t j) { return exact[pairIndex(i, j)]; }))
            return Connectedness::Connected;
        if (joinsAll([&](std::size_t i, std::size_t j) { return rounded[pairIndex(i, j)]; }))
            return Connectedness::ConnectedToRounding;
        return byNeighbours();
    }

    Connectedness byNeighbours() const {
        if (!m_neighbours) return Connectedness::Unknown;
        const bool isJoined =
            joinsAll([&](std::size_t i, std::size_t j) { return m_neighbours->meet(i, j); });
        if (m_neighbours->certainty() == Certainty::Exact)
            return isJoined ? Connectedness::Connected : Connectedness::Disconnected;
        return isJoined ? Connectedness::ConnectedToRounding : Connectedness::Unknown;
    }

    // w_prefix(fix(w_period))
    struct KnownPoint {
        Word prefix, period;
        Vector<Dim> point;
        Vector<Dim> rounding; // error bounds: see StoredRounding
    };

    std::vector<KnownPoint> knownPoints() const {
        constexpr std::size_t maxPeriods = 24, maxPrefixes = 24;
        std::vector<KnownPoint> result;
        const auto prefixes = shortWords<Dim>(m_maps, maxPrefixes, 2);
        for (const auto& period : shortWords<Dim>(m_maps, std::max(maxPeriods, m_maps.size() + 1), 3))
            if (!period.word.empty())
                if (const auto fixed = fixedPoint(period.map)) {
                    const Matrix<Dim> solving = (Matrix<Dim>::Identity() - period.map.linear).inverse();
                    const Vector<Dim> off =
                        solving.cwiseAbs() * period.rounding.ofImage(period.map, *fixed, Vector<Dim>::Zero());
                    for (const auto& prefix : prefixes)
                        result.push_back({prefix.word, period.word, prefix.map(*fixed),
                                          prefix.rounding.ofImage(prefix.map, *fixed, off)});
                }
        return result;
    }

    // Looks for a common point of two pieces among the images of known points.
    void meet(const std::vector<KnownPoint>& points, std::size_t i, std::size_t j, std::vector<bool>& exact,
              std::vector<bool>& rounded) const {
        constexpr int maxExact = 16;
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < points.size(); ++k)
            order.emplace_back(m_maps[j](points[k].point)[0], k);
        std::ranges::sort(order);
        int asked = 0;
        for (const KnownPoint& known : points) {
            const Vector<Dim> here = m_maps[i](known.point);
            for (auto it = std::ranges::lower_bound(order, std::pair{here[0] - m_near, std::size_t(0)});
                 it != order.end() && it->first <= here[0] + m_near; ++it) {
                const KnownPoint& other = points[it->second];
                const double apart = (m_maps[j](other.point) - here).norm();
                if (!(apart <= m_near)) continue;
                if (++asked > maxExact) return;
                const auto one = exactImage(i, known), two = exactImage(j, other);
                if (isSame(one, two)) {
                    exact[pairIndex(i, j)] = rounded[pairIndex(i, j)] = true;
                    return;
                }
                const Vector<Dim> off = roundingOfImage(i, known) + roundingOfImage(j, other);
                if (apart <= m_telling && areWithin(one, two, off)) rounded[pairIndex(i, j)] = true;
            }
        }
    }

    Vector<Dim> roundingOfImage(std::size_t outer, const KnownPoint& point) const {
        const AffineMap<Dim>& map = m_maps[outer];
        return StoredRounding<Dim>::of(map).ofImage(map, point.point, point.rounding);
    }

    static bool areWithin(const ExactPoint<Dim>& a, const ExactPoint<Dim>& b, const Vector<Dim>& off) {
        if (a.denominator.sign() == 0 || b.denominator.sign() == 0) return false;
        for (std::size_t k = 0; k < Dim; ++k) {
            const Dyadic apart = a.numerator[k] * b.denominator - b.numerator[k] * a.denominator;
            if (!(std::abs(roundedQuotient(apart, a.denominator * b.denominator)) <= off[Eigen::Index(k)]))
                return false;
        }
        return true;
    }

    ExactPoint<Dim> exactImage(std::size_t outer, const KnownPoint& point) const {
        Word way{int(outer)};
        way.insert(way.end(), point.prefix.begin(), point.prefix.end());
        return image(exactWord<Dim>(m_maps, way), exactFixedPoint(exactWord<Dim>(m_maps, point.period)));
    }

    const NeighbourGraph* m_neighbours;
    const std::vector<AffineMap<Dim>>& m_maps;
    const SupportFunction<Dim>& m_seen;
    double m_off;     // error bound of a displayed point of the attractor
    double m_near;    // generous bound of the rounding of a point
    double m_telling; // rounding above this proves nothing about places that agree
};

} // namespace

template <int Dim>
PieceContacts pieceContacts(const SupportFunction<Dim>& support, const NeighbourGraph* neighbours) {
    return Contacts<Dim>(support, neighbours).found();
}

template PieceContacts pieceContacts(const SupportFunction<2>&, const NeighbourGraph*);
template PieceContacts pieceContacts(const SupportFunction<3>&, const NeighbourGraph*);

} // namespace ifs
