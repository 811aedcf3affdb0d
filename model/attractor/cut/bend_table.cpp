// SPDX-License-Identifier: MIT
#include "attractor/cut/bend_table.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace attractor {

namespace {

using ifs::Vector;
using Expansion = ifs::PolygonDeformation::Expansion;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double safety = 2;              // factor, because errors are measured at a few points only
constexpr double minHalf = 0x1p-40;       // half side of the first square
constexpr std::size_t maxKept = 1U << 15; // coordinates of all squares together
constexpr std::size_t maxKeptOfPieces = 1U << 20;

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

Vector<2> valueAt(const Expansion& e, const Vector<2>& d) {
    return e.value + e.linear * d + 0.5 * second(e, d, d) + third(e, d, d) / 6;
}

// The same polynomial about another point.
Expansion movedBy(const Expansion& e, const Vector<2>& d) {
    Expansion result = e;
    result.value = valueAt(e, d);
    const Vector<2> unitX(1, 0);
    const Vector<2> unitY(0, 1);
    result.linear.col(0) += second(e, d, unitX) + 0.5 * third(e, d, unitX);
    result.linear.col(1) += second(e, d, unitY) + 0.5 * third(e, d, unitY);
    for (std::size_t k = 0; k < 3; ++k)
        result.second[k] += e.third[k] * d.x() + e.third[k + 1] * d.y();
    return result;
}

double valueAt(const ifs::Jet& jet, const Vector<2>& d) {
    const double xx = d.x() * d.x();
    const double xy = d.x() * d.y();
    const double yy = d.y() * d.y();
    const double cubic = jet.xxx * (xx * d.x()) + 3 * (jet.xxy * (xx * d.y()) + jet.xyy * (yy * d.x())) +
                         jet.yyy * (yy * d.y());
    return jet.value + (jet.x * d.x() + jet.y * d.y()) + (0.5 * (jet.xx * xx + jet.yy * yy) + jet.xy * xy) +
           cubic / 6;
}

// Places where errors are measured: the four corners of [−1, 1]², and the middles of its edges.
constexpr std::size_t corners = 4;
Vector<2> onEdge(std::size_t point) {
    constexpr std::array<std::array<int, 2>, 8> points{
        {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    return {points[point][0], points[point][1]};
}

BendTable::Piece nowhere() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    BendTable::Piece piece;
    for (Vector<2>* part : {&piece.value, &piece.aa, &piece.ab, &piece.bb, &piece.miss})
        part->setConstant(none);
    piece.linear.setConstant(none);
    return piece;
}

} // namespace

std::size_t BendTable::Hash::operator()(const Parallelogram& piece) const {
    std::uint64_t result = 0;
    for (const double part : {piece.x.x(), piece.x.y(), piece.spread(0, 0), piece.spread(0, 1),
                              piece.spread(1, 0), piece.spread(1, 1)})
        result = mixed(result ^ std::bit_cast<std::uint64_t>(part));
    return result;
}

void BendTable::follow(const ifs::PolygonDeformation& bend, const Vector<2>& centre, double halfSize,
                       double tolerance, bool samePieces) {
    // Depends only on the corners, so that the square stays while the system is edited.
    Vector<2> low = bend.from()[0];
    Vector<2> high = low;
    for (const Vector<2>& corner : bend.from()) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    const Vector<2> middle = (low + high) / 2;
    const double reach = (centre - middle).cwiseAbs().maxCoeff() + halfSize;
    double half = (high - low).maxCoeff() / 2;
    m_farthest = farthest * 2 * half;
    while (half < reach)
        half *= 2;
    if (m_squares.empty() || m_squares[0].centre != middle || m_squares[0].half != half ||
        m_kind != bend.coordinates() || !std::ranges::equal(m_rest, bend.from()) ||
        m_expanded * m_rest.size() > maxKept)
        restart(bend, middle, half);
    m_bend = &bend;
    m_tolerance = tolerance;
    m_keepsPieces = samePieces;
    if (!samePieces) forgetPieces();
    ++m_number;
}

void BendTable::restart(const ifs::PolygonDeformation& bend, const Vector<2>& centre, double half) {
    m_kind = bend.coordinates();
    m_rest.assign(bend.from().begin(), bend.from().end());
    m_cornerSize.clear();
    for (std::size_t j = 0; j < m_rest.size(); ++j) {
        const Vector<2> before = m_rest[(j + m_rest.size() - 1) % m_rest.size()] - m_rest[j];
        const Vector<2> after = m_rest[(j + 1) % m_rest.size()] - m_rest[j];
        m_cornerSize.push_back(std::min(before.cwiseAbs().maxCoeff(), after.cwiseAbs().maxCoeff()) / 2);
    }
    m_squares.clear();
    m_squares.emplace_back(centre, half);
    m_expanded = 0;
    forgetPieces();
}

// Length over which coordinates vary: the distance from the corners, and near them the length of the edges.
// Measurements in the corners of a larger square may miss something.
double BendTable::featureSize(const Vector<2>& x) const {
    double size = infinity;
    for (std::size_t j = 0; j < m_cornerSize.size(); ++j)
        size = std::min(size, (m_rest[j] - x).cwiseAbs().maxCoeff() + m_cornerSize[j]);
    return size;
}

// The coordinates around the centre of the square, whatever the bend.
void BendTable::expand(Square& square) {
    square.feature = featureSize(square.centre);
    auto jets = ifs::coordinateJets(m_kind, m_rest, square.centre);
    if (!jets) return;
    square.coordinates = std::move(*jets);
    square.misses.resize(m_rest.size());
    for (std::size_t point = 0; point < square.misses[0].size(); ++point) {
        const Vector<2> offset = square.half * onEdge(point);
        const auto there = ifs::generalizedCoordinates(m_kind, m_rest, square.centre + offset);
        for (std::size_t j = 0; j < m_rest.size(); ++j)
            square.misses[j][point] = there[j] - valueAt(square.coordinates[j], offset);
    }
    ++m_expanded;
}

void BendTable::measure(Square& square) {
    if (square.feature < 0) expand(square);
    square.bend = m_number;
    square.error = infinity;
    if (square.coordinates.empty()) {
        square.expansion = {};
        square.expansion.value = (*m_bend)(square.centre);
        square.expansion.linear = m_bend->fit().linear;
        return;
    }
    square.expansion = m_bend->expansion(square.centre, square.coordinates);
    if (square.half > square.feature) return;
    square.error = 0;
    for (std::size_t point = 0; point < square.misses[0].size(); ++point) {
        Vector<2> miss = Vector<2>::Zero();
        for (std::size_t j = 0; j < m_rest.size(); ++j)
            miss += square.misses[j][point] * m_bend->residuals()[j];
        square.error = std::max(square.error, safety * miss.cwiseAbs().maxCoeff());
    }
}

// Coordinates of the corners of a piece, one after the other.
std::span<const double> BendTable::cornerCoordinates(const Vector<2>& x, const ifs::Matrix<2>& spread) {
    const std::size_t number = corners * m_rest.size();
    if (!m_keepsPieces)
        m_cornerCoordinates.clear();
    else if (m_cornerCoordinates.size() > maxKeptOfPieces)
        forgetPieces();
    const std::size_t first = m_cornerCoordinates.size();
    if (m_keepsPieces) {
        const auto [found, isNew] = m_pieces.try_emplace({x, spread}, first);
        if (!isNew) return std::span(m_cornerCoordinates).subspan(found->second, number);
    }
    for (std::size_t corner = 0; corner < corners; ++corner) {
        const auto there = ifs::generalizedCoordinates(m_kind, m_rest, x + spread * onEdge(corner));
        m_cornerCoordinates.insert(m_cornerCoordinates.end(), there.begin(), there.end());
    }
    return std::span(m_cornerCoordinates).subspan(first, number);
}

void BendTable::forgetPieces() {
    m_pieces.clear();
    m_cornerCoordinates.clear();
}

// Error bound of the expansion in a piece, as measured in its corners.
double BendTable::missOf(const Square& square, const Vector<2>& x, const ifs::Matrix<2>& spread) {
    auto coordinate = cornerCoordinates(x, spread).begin();
    double result = 0;
    for (std::size_t corner = 0; corner < corners; ++corner) {
        const Vector<2> at = x + spread * onEdge(corner);
        Vector<2> shown = m_bend->fit()(at);
        for (const Vector<2>& residual : m_bend->residuals())
            shown += *coordinate++ * residual;
        const Vector<2> miss = shown - valueAt(square.expansion, at - square.centre);
        result = std::max(result, safety * miss.cwiseAbs().maxCoeff());
    }
    return result;
}

// Error bound of the expansion in a piece that reaches `radius` beyond x, itself in the square. The error is
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
        if (m_squares[at].bend != m_number) measure(m_squares[at]);
        const double distance = (x - m_squares[at].centre).cwiseAbs().maxCoeff();
        const double missed = error(m_squares[at], distance, radius);
        const double half = m_squares[at].half / 2;
        if (missed <= m_tolerance || half < radius / 4 || half < minHalf * m_squares[0].half)
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
    const double radius = spread.cwiseAbs().rowwise().sum().maxCoeff();
    if ((x - m_squares[0].centre).cwiseAbs().maxCoeff() - radius > m_farthest) return nowhere();
    const Found found = find(x, radius);
    const Square& s = m_squares[found.square];
    const Expansion e = movedBy(s.expansion, x - s.centre);
    const Vector<2> a = spread.col(0);
    const Vector<2> b = spread.col(1);
    // Best approximation of cubic terms: a³ by ¾a, a²b by ½b; a quarter and a half remain as errors.
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
    result.miss = 0.25 * (aaa.cwiseAbs() + bbb.cwiseAbs()) + 0.5 * (aab.cwiseAbs() + abb.cwiseAbs());
    // Measures if only the estimate is too large, since it grows with the fourth power of the size.
    const bool doubtful = found.miss > m_tolerance && found.miss < infinity;
    const bool matters = result.miss.maxCoeff() < 2 * m_tolerance;
    result.miss.array() += doubtful && matters ? std::min(found.miss, missOf(s, x, spread)) : found.miss;
    return result;
}

} // namespace attractor
