// SPDX-License-Identifier: MIT
#include "ifs/tops/tear.h"

#include "ifs/separation/piece_contacts.h"
#include "ifs/tops/enclosing_polygon.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <vector>

namespace ifs {

namespace {

constexpr std::size_t maxPieces = 1U << 18;
constexpr double slack = 1 + 1e-12; // allowance for rounding

// Both pieces of a word.
struct Piece {
    AffineMap<2> from, to;
    EnclosingPolygon::Heights heights{}; // heights of the piece of F
    double diameter = 0;                 // diameter of that piece
    std::uint32_t children = 0;          // index of the first child; 0: none yet
};

struct Pair {
    double bound; // bound of the diameter of the union in G
    std::uint32_t a, b;

    bool operator<(const Pair& other) const { return bound < other.bound; }
};

// The pair that may be torn farthest is looked at first, until its pieces are small enough.
class TearSearch {
public:
    TearSearch(const SupportFunction<2>& from, const SupportFunction<2>& to, double epsilon,
               std::size_t maxPairs)
        : m_from(from),
          m_to(to),
          m_aroundFrom(from),
          m_aroundTo(to),
          m_epsilon(epsilon),
          m_maxPairs(maxPairs) {
        Piece root;
        root.heights = m_aroundFrom.heights;
        root.diameter = diameterOf(m_aroundFrom.corners);
        m_pieces.push_back(root);
    }

    Tear found() {
        const std::size_t maps = m_from.maps().size();
        const double whole = diameterOf(m_aroundTo.corners);
        if (maps * maps > m_maxPairs || m_pieces.size() + maps > maxPieces)
            return {whole * slack, std::nullopt, true, whole * slack};
        const std::uint32_t first = childrenOf(0);
        for (std::uint32_t i = 0; i < maps; ++i)
            for (std::uint32_t j = i + 1; j < maps; ++j)
                add(first + i, first + j, whole);
        while (!m_open.empty()) {
            const Pair pair = m_open.top();
            const bool isSettled =
                std::max(m_pieces[pair.a].diameter, m_pieces[pair.b].diameter) <= m_epsilon;
            if (isSettled || isFull()) return {pair.bound * slack, placeOf(pair), !isSettled, whole * slack};
            m_open.pop();
            divide(pair);
        }
        return {0, std::nullopt, false, whole * slack};
    }

private:
    bool isFull() const {
        const std::size_t maps = m_from.maps().size();
        return m_open.size() + maps > m_maxPairs || m_pieces.size() + maps > maxPieces;
    }

    std::uint32_t childrenOf(std::uint32_t parent) {
        if (m_pieces[parent].children > 0) return m_pieces[parent].children;
        const auto first = std::uint32_t(m_pieces.size());
        m_pieces[parent].children = first;
        for (std::size_t i = 0; i < m_from.maps().size(); ++i) {
            const Piece& outer = m_pieces[parent];
            Piece piece;
            piece.from = outer.from * m_from.maps()[i];
            piece.to = outer.to * m_to.maps()[i];
            const auto corners = m_aroundFrom.image(piece.from);
            piece.heights = heightsOf(corners);
            for (std::size_t k = 0; k < piece.heights.size(); ++k)
                piece.heights[k] = std::min(piece.heights[k], outer.heights[k]);
            piece.diameter = std::min(diameterOf(corners), outer.diameter);
            m_pieces.push_back(piece);
        }
        return first;
    }

    void divide(const Pair& pair) {
        const bool first = m_pieces[pair.a].diameter >= m_pieces[pair.b].diameter;
        const std::uint32_t larger = first ? pair.a : pair.b;
        const std::uint32_t children = childrenOf(larger);
        for (std::uint32_t i = 0; i < m_from.maps().size(); ++i)
            first ? add(children + i, pair.b, pair.bound) : add(pair.a, children + i, pair.bound);
    }

    void add(std::uint32_t a, std::uint32_t b, double outer) {
        if (areApart(m_pieces[a], m_pieces[b])) return;
        const double bound = diameterOf(m_aroundTo.image(m_pieces[a].to), m_aroundTo.image(m_pieces[b].to));
        m_open.push({std::min(bound, outer), a, b});
    }

    // Returns true if the pieces are more than ε apart in some direction.
    bool areApart(const Piece& a, const Piece& b) const {
        constexpr std::size_t half = EnclosingPolygon::sides / 2;
        const double allowed = m_epsilon + 1e-12 * (m_from.radius() + m_from.centre().norm());
        for (std::size_t k = 0; k < half; ++k)
            if (-a.heights[k + half] - b.heights[k] > allowed ||
                -b.heights[k + half] - a.heights[k] > allowed)
                return true;
        return false;
    }

    std::array<Vector<2>, 2> placeOf(const Pair& pair) const {
        const Vector<2> point = m_from.pointOfAttractor();
        return {m_pieces[pair.a].from(point), m_pieces[pair.b].from(point)};
    }

    const SupportFunction<2>&m_from, &m_to;
    EnclosingPolygon m_aroundFrom, m_aroundTo;
    double m_epsilon;
    std::size_t m_maxPairs;
    std::vector<Piece> m_pieces;
    std::priority_queue<Pair> m_open;
};

// Proved to have two addresses for one point: a word with another map in front, or pieces that meet.
bool hasDoubleAddress(const PieceContacts& contacts) {
    return contacts.connectedness == Connectedness::Connected ||
           std::ranges::any_of(contacts.overlaps, &Overlap::isExact);
}

} // namespace

Tear tear(const SupportFunction<2>& from, const SupportFunction<2>& to, double epsilon,
          std::size_t maxPairs) {
    return TearSearch(from, to, epsilon, maxPairs).found();
}

// The verdict. If all points of one attractor have one address and a point of the other has two, T misses a
// point or takes two to one. docs/mathematics.md, "Fractal tops".
Homeomorphism homeomorphism(const SupportFunction<2>& from, const SupportFunction<2>& to) {
    if (from.maps() == to.maps() || from.maps().size() == 1) return Homeomorphism::Proved;
    const PieceContacts f = pieceContacts(from), g = pieceContacts(to);
    const bool isStrongF = f.separation == Separation::Strong, isStrongG = g.separation == Separation::Strong;
    if (isStrongF && isStrongG) return Homeomorphism::Proved;
    if ((isStrongF && hasDoubleAddress(g)) || (isStrongG && hasDoubleAddress(f)))
        return Homeomorphism::Refuted;
    const auto differ = [](const PieceContacts& a, const PieceContacts& b) {
        return a.connectedness == Connectedness::Connected && b.connectedness == Connectedness::Disconnected;
    };
    return differ(f, g) || differ(g, f) ? Homeomorphism::Refuted : Homeomorphism::Unknown;
}

} // namespace ifs
