// SPDX-License-Identifier: MIT
#include "attractor/bend_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace attractor {

namespace {

using ifs::Vector;
using Expansion = ifs::PolygonDeformation::Expansion;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double safety = 2;         // errors are measured in the corners of a square only
constexpr double smallest = 0x1p-40; // of the first square

// F″(a, b)
Vector<2> second(const Expansion& e, const Vector<2>& a, const Vector<2>& b) {
    return e.second[0] * (a.x() * b.x()) + e.second[1] * (a.x() * b.y() + a.y() * b.x()) +
           e.second[2] * (a.y() * b.y());
}

// F‴(a, a, b)
Vector<2> third(const Expansion& e, const Vector<2>& a, const Vector<2>& b) {
    const double xx = a.x() * a.x();
    const double xy = a.x() * a.y();
    const double yy = a.y() * a.y();
    return e.third[0] * (xx * b.x()) + e.third[1] * (xx * b.y() + 2 * xy * b.x()) +
           e.third[2] * (yy * b.x() + 2 * xy * b.y()) + e.third[3] * (yy * b.y());
}

// The same polynomial about another point.
Expansion movedBy(const Expansion& e, const Vector<2>& d) {
    Expansion result = e;
    result.value = e.value + e.linear * d + 0.5 * second(e, d, d) + third(e, d, d) / 6;
    const Vector<2> unitX(1, 0);
    const Vector<2> unitY(0, 1);
    result.linear.col(0) += second(e, d, unitX) + 0.5 * third(e, d, unitX);
    result.linear.col(1) += second(e, d, unitY) + 0.5 * third(e, d, unitY);
    for (std::size_t k = 0; k < 3; ++k)
        result.second[k] += e.third[k] * d.x() + e.third[k + 1] * d.y();
    return result;
}

} // namespace

BendTable::BendTable(const ifs::PolygonDeformation& bend, const Vector<2>& centre, double halfSize,
                     double tolerance)
    : m_bend(bend), m_tolerance(tolerance) {
    const auto corners = bend.from();
    for (std::size_t j = 0; j < corners.size(); ++j) {
        const Vector<2> before = corners[(j + corners.size() - 1) % corners.size()] - corners[j];
        const Vector<2> after = corners[(j + 1) % corners.size()] - corners[j];
        m_cornerSize.push_back(std::min(before.cwiseAbs().maxCoeff(), after.cwiseAbs().maxCoeff()) / 2);
    }
    m_squares.emplace_back(centre, halfSize);
}

// Coordinates vary over the distance from the corners, and near them over the length of the edges: what is
// measured in the corners of a larger square may overlook something.
double BendTable::featureSize(const Vector<2>& x) const {
    double size = infinity;
    for (std::size_t j = 0; j < m_cornerSize.size(); ++j)
        size = std::min(size, (m_bend.from()[j] - x).cwiseAbs().maxCoeff() + m_cornerSize[j]);
    return size;
}

void BendTable::measure(Square& square) const {
    const auto expansion = m_bend.expansion(square.centre);
    if (expansion) {
        square.expansion = *expansion;
    } else {
        square.expansion.value = m_bend(square.centre);
        square.expansion.linear = m_bend.fit().linear;
    }
    square.feature = featureSize(square.centre);
    square.error = expansion && square.half <= square.feature ? 0 : infinity;
    for (int corner = 0; corner < 4 && square.error < infinity; ++corner) {
        const Vector<2> offset = square.half * Vector<2>(corner % 2 == 0 ? -1 : 1, corner / 2 == 0 ? -1 : 1);
        const Vector<2> miss = m_bend(square.centre + offset) - movedBy(square.expansion, offset).value;
        square.error = std::max(square.error, safety * miss.cwiseAbs().maxCoeff());
    }
}

// What the expansion misses at most, in a piece that reaches `radius` beyond x, itself in the square. It is
// of third order: from the middle of the square it grows like the cube of the distance.
double BendTable::error(const Square& square, double distance, double radius) {
    if (square.error == 0) return 0;
    if (!(radius <= square.feature)) return infinity;
    const double reach = std::max(1.0, (distance + radius) / square.half);
    return square.error * (reach * reach) * (reach * reach);
}

// The first square that is good enough for the piece, or one that is small beside it.
BendTable::Found BendTable::find(const Vector<2>& x, double radius) {
    std::size_t at = 0;
    while (true) {
        if (m_squares[at].error < 0) measure(m_squares[at]);
        const double distance = (x - m_squares[at].centre).cwiseAbs().maxCoeff();
        const double missed = error(m_squares[at], distance, radius);
        const double half = m_squares[at].half / 2;
        if (missed <= m_tolerance || half < radius / 4 || half < smallest * m_squares[0].half)
            return {at, missed};
        const Vector<2> centre = m_squares[at].centre;
        if (m_squares[at].children == 0) {
            m_squares[at].children = static_cast<std::uint32_t>(m_squares.size());
            for (int k = 0; k < 4; ++k)
                m_squares.emplace_back(centre + half * Vector<2>(k % 2 == 0 ? -1 : 1, k / 2 == 0 ? -1 : 1),
                                       half);
        }
        at = m_squares[at].children + (x.x() < centre.x() ? 0U : 1U) + (x.y() < centre.y() ? 0U : 2U);
    }
}

BendTable::Piece BendTable::piece(const Vector<2>& x, const ifs::Matrix<2>& spread) {
    const Found found = find(x, spread.cwiseAbs().rowwise().sum().maxCoeff());
    const Square& s = m_squares[found.square];
    const Expansion e = movedBy(s.expansion, x - s.centre);
    const Vector<2> a = spread.col(0);
    const Vector<2> b = spread.col(1);
    // Of the cubic terms, a³ is nearest to ¾a, a²b to ½b; a quarter and a half are missed.
    const Vector<2> aaa = third(e, a, a) / 6;
    const Vector<2> aab = third(e, a, b) / 2;
    const Vector<2> abb = third(e, b, a) / 2;
    const Vector<2> bbb = third(e, b, b) / 6;
    Piece result;
    result.value = e.value;
    result.linear.col(0) = e.linear * a + 0.75 * aaa + 0.5 * abb;
    result.linear.col(1) = e.linear * b + 0.75 * bbb + 0.5 * aab;
    result.aa = 0.5 * second(e, a, a);
    result.ab = second(e, a, b);
    result.bb = 0.5 * second(e, b, b);
    result.miss = 0.25 * (aaa.cwiseAbs() + bbb.cwiseAbs()) + 0.5 * (aab.cwiseAbs() + abb.cwiseAbs()) +
                  Vector<2>::Constant(found.miss);
    return result;
}

} // namespace attractor
