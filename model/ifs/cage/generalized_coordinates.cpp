// SPDX-License-Identifier: MIT
#include "ifs/cage/generalized_coordinates.h"

#include "ifs/cage/jet.h"
#include "ifs/extent/polygon.h"
#include "ifs/linear/symmetric_matrices.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

using std::sqrt;

constexpr double minTurn = 1e-6;   // sine of the angle
constexpr double atCorner = 1e-14; // relative to the size
constexpr double flat = 1e-8;      // condition beyond which points count as collinear

template <class Number> struct Point { Number x, y; };
template <class Number> using Weights = std::array<Number, maxCorners>;

template <class Number> Number crossProduct(const Point<Number>& p, const Point<Number>& q) {
    return p.x * q.y - p.y * q.x;
}

double sizeOf(std::span<const Vector<2>> points) {
    double size = 0;
    for (const Vector<2>& p : points)
        size = std::max(size, (p - points[0]).cwiseAbs().maxCoeff());
    return size;
}

// Corners as seen from x.
template <class Number>
std::array<Point<Number>, maxCorners> seenFrom(const Point<Number>& x, std::span<const Vector<2>> polygon) {
    std::array<Point<Number>, maxCorners> s;
    for (std::size_t j = 0; j < polygon.size(); ++j)
        s[j] = {Number(polygon[j].x()) - x.x, Number(polygon[j].y()) - x.y};
    return s;
}

// Corners in turn; a division would take longer than all the rest.
std::size_t after(std::size_t corner, std::size_t corners) {
    return corner + 1 < corners ? corner + 1 : 0;
}
std::size_t before(std::size_t corner, std::size_t corners) {
    return (corner > 0 ? corner : corners) - 1;
}

// w_j = C_j ∏_{k ≠ j−1, j} A_k with A_k the area at x over edge k: no division, so edges need no care.
template <class Number>
bool wachspressWeights(std::span<const Vector<2>> polygon, const Point<Number>& x, Weights<Number>& w) {
    const std::size_t n = polygon.size();
    const auto s = seenFrom(x, polygon);
    Weights<Number> area, behind; // behind[k] = A_k ⋯ A_{n−1}
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) {
        area[k] = crossProduct(s[k], s[after(k, n)]);
        largest = std::max(largest, std::abs(valueOf(area[k])));
    }
    if (!(largest > 0)) return false;
    for (std::size_t k = 0; k < n; ++k)
        area[k] = area[k] * (1 / largest);
    behind[n - 1] = area[n - 1];
    for (std::size_t k = n - 1; k-- > 0;)
        behind[k] = area[k] * behind[k + 1];
    // Corner 0 omits the last edge and the first, corner j edges j − 1 and j.
    Number ahead = 1;
    for (std::size_t k = 1; k + 1 < n; ++k)
        ahead = ahead * area[k];
    w[0] = ahead;
    ahead = 1;
    for (std::size_t j = 1; j < n; ++j) {
        w[j] = j + 1 < n ? ahead * behind[j + 1] : ahead;
        ahead = ahead * area[j - 1];
    }
    for (std::size_t j = 0; j < n; ++j)
        w[j] =
            w[j] * (cross(polygon[j] - polygon[before(j, n)], polygon[after(j, n)] - polygon[j]) / largest);
    return true;
}

// w_j = (t_{j−1} + t_j)/r_j with t_k = tan(α_k/2), α_k the angle at x over edge k. The tangent of the widest
// angle may be infinite (x on an edge), so all are multiplied by its denominator.
template <class Number>
bool meanValueWeights(std::span<const Vector<2>> polygon, const Point<Number>& x, Weights<Number>& w) {
    const std::size_t n = polygon.size();
    const auto s = seenFrom(x, polygon);
    Weights<Number> r, numerator, denominator;
    for (std::size_t j = 0; j < n; ++j) {
        r[j] = sqrt(s[j].x * s[j].x + s[j].y * s[j].y);
        if (!(valueOf(r[j]) > 0)) return false;
    }
    std::size_t widest = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = after(k, n);
        const Number area = crossProduct(s[k], s[next]);
        const Number dot = s[k].x * s[next].x + s[k].y * s[next].y;
        const Number product = r[k] * r[next];
        const bool acute = valueOf(dot) >= 0;
        numerator[k] = acute ? area : product - dot;
        denominator[k] = acute ? product + dot : area;
        const auto wider = [&](std::size_t a, std::size_t b) {
            return std::abs(valueOf(numerator[a]) * valueOf(denominator[b])) >
                   std::abs(valueOf(numerator[b]) * valueOf(denominator[a]));
        };
        if (wider(k, widest)) widest = k;
    }
    const Number common = denominator[widest];
    for (std::size_t k = 0; k < n; ++k)
        numerator[k] = k == widest ? numerator[k] : numerator[k] / denominator[k] * common;
    for (std::size_t j = 0; j < n; ++j)
        w[j] = (numerator[before(j, n)] + numerator[j]) / r[j];
    return true;
}

// Weights up to a factor, and their sum; false where there are none.
template <class Number>
bool weights(Coordinates kind, std::span<const Vector<2>> polygon, const Point<Number>& x, Weights<Number>& w,
             Number& sum) {
    if (!(kind == Coordinates::Wachspress ? wachspressWeights(polygon, x, w)
                                          : meanValueWeights(polygon, x, w)))
        return false;
    sum = w[0];
    double largest = std::abs(valueOf(w[0]));
    for (std::size_t j = 1; j < polygon.size(); ++j) {
        sum = sum + w[j];
        largest = std::max(largest, std::abs(valueOf(w[j])));
    }
    return std::isfinite(largest) && std::abs(valueOf(sum)) > 1e-12 * largest && largest > 1e-280;
}

std::optional<std::size_t> cornerAt(std::span<const Vector<2>> polygon, const Vector<2>& x, double size) {
    for (std::size_t j = 0; j < polygon.size(); ++j)
        if ((polygon[j] - x).cwiseAbs().maxCoeff() <= atCorner * size) return j;
    return std::nullopt;
}

// The pseudo-inverse of a symmetric, positive semidefinite matrix; directions in which it is smaller than
// 1e-8 of its largest eigenvalue count as its kernel.
Matrix<2> pseudoInverse(const Matrix<2>& s) {
    const double trace = s.trace();
    const double determinant = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
    if (!(trace > 0)) return Matrix<2>::Zero();
    if (!(determinant > flat * trace * trace)) return s / (trace * trace);
    Matrix<2> adjugate;
    adjugate << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
    return adjugate / determinant;
}
Matrix<3> pseudoInverse(const Matrix<3>& s) {
    const auto [values, vectors] = symmetricEigenvalues<3>(s);
    Vector<3> inverse = Vector<3>::Zero();
    for (int k = 0; k < 3; ++k)
        if (values[k] > flat * values[2]) inverse[k] = 1 / values[k];
    return vectors * inverse.asDiagonal() * vectors.transpose();
}

// Returns true if two segments have a point in common.
bool meet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d) {
    const auto side = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
        const double value = cross(q - p, r - p);
        return value > 0 ? 1 : value < 0 ? -1 : 0;
    };
    const auto between = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
        return (r.cwiseMin(p).cwiseMin(q) == p.cwiseMin(q)) && (r.cwiseMax(p).cwiseMax(q) == p.cwiseMax(q));
    };
    const int c1 = side(a, b, c), d1 = side(a, b, d), a1 = side(c, d, a), b1 = side(c, d, b);
    if (c1 * d1 < 0 && a1 * b1 < 0) return true;
    return (c1 == 0 && between(a, b, c)) || (d1 == 0 && between(a, b, d)) || (a1 == 0 && between(c, d, a)) ||
           (b1 == 0 && between(c, d, b));
}

} // namespace

bool isSimplePolygon(std::span<const Vector<2>> polygon) {
    const std::size_t n = polygon.size();
    if (n < 3 || !std::ranges::all_of(polygon, [](const Vector<2>& p) { return p.allFinite(); }))
        return false;
    for (std::size_t j = 0; j < n; ++j) {
        const Vector<2>& a = polygon[j];
        const Vector<2>& b = polygon[(j + 1) % n];
        const Vector<2>& c = polygon[(j + 2) % n];
        // Adjacent edges must not fold back.
        if (a == b || (cross(b - a, c - b) == 0 && (b - a).dot(c - b) < 0)) return false;
        for (std::size_t k = j + 2; k < n; ++k)
            if ((k + 1) % n != j && meet(a, b, polygon[k], polygon[(k + 1) % n])) return false;
    }
    return true;
}

bool isStrictlyConvex(std::span<const Vector<2>> polygon) {
    if (!isSimplePolygon(polygon)) return false;
    const std::size_t n = polygon.size();
    const double sign = signedArea(polygon) > 0 ? 1 : -1;
    for (std::size_t j = 0; j < n; ++j) {
        const Vector<2> in = polygon[(j + 1) % n] - polygon[j];
        const Vector<2> out = polygon[(j + 2) % n] - polygon[(j + 1) % n];
        if (!(sign * cross(in, out) > minTurn * in.norm() * out.norm())) return false;
    }
    return true;
}

double signedArea(std::span<const Vector<2>> polygon) {
    double twice = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return twice / 2;
}

std::vector<double> generalizedCoordinates(Coordinates kind, std::span<const Vector<2>> polygon,
                                           const Vector<2>& x) {
    std::vector<double> result(polygon.size(), 0.0);
    if (const auto corner = cornerAt(polygon, x, sizeOf(polygon))) {
        result[*corner] = 1;
        return result;
    }
    Weights<double> w;
    double sum = 0;
    if (!weights<double>(kind, polygon, {x.x(), x.y()}, w, sum))
        return std::vector<double>(polygon.size(), 1.0 / static_cast<double>(polygon.size()));
    for (std::size_t j = 0; j < polygon.size(); ++j)
        result[j] = w[j] / sum;
    return result;
}

std::optional<std::vector<Jet>> coordinateJets(Coordinates kind, std::span<const Vector<2>> polygon,
                                               const Vector<2>& x) {
    Weights<Jet> w;
    Jet sum;
    if (cornerAt(polygon, x, sizeOf(polygon)) ||
        !weights<Jet>(kind, polygon, {Jet(x.x(), 1, 0), Jet(x.y(), 0, 1)}, w, sum))
        return std::nullopt;
    std::vector<Jet> result;
    for (std::size_t j = 0; j < polygon.size(); ++j) {
        result.push_back(w[j] / sum);
        const Jet& c = result.back();
        // Not finite if any term is not.
        const double all = c.value + c.x + c.y + c.xx + c.xy + c.yy + c.xxx + c.xxy + c.xyy + c.yyy;
        if (!std::isfinite(all)) return std::nullopt;
    }
    return result;
}

template <int Dim>
AffineMap<Dim> affineFit(std::span<const Vector<Dim>> from, std::span<const Vector<Dim>> to,
                         const Matrix<Dim>& previous) {
    const double share = 1.0 / static_cast<double>(from.size());
    Vector<Dim> fromMean = Vector<Dim>::Zero();
    Vector<Dim> toMean = Vector<Dim>::Zero();
    for (std::size_t j = 0; j < from.size(); ++j) {
        fromMean += share * from[j];
        toMean += share * to[j];
    }
    double size = 0;
    for (const Vector<Dim>& p : from)
        size = std::max(size, (p - fromMean).cwiseAbs().maxCoeff());
    Matrix<Dim> moments = Matrix<Dim>::Zero();
    Matrix<Dim> mixedMoments = Matrix<Dim>::Zero();
    for (std::size_t j = 0; j < from.size() && size > 0; ++j) {
        const Vector<Dim> offset = (from[j] - fromMean) / size;
        moments += offset * offset.transpose();
        mixedMoments += ((to[j] - toMean) / size - previous * offset) * offset.transpose();
    }
    const Matrix<Dim> linear = previous + mixedMoments * pseudoInverse(moments);
    return {linear, toMean - linear * fromMean};
}

PolygonDeformation::PolygonDeformation(Coordinates kind, std::span<const Vector<2>> from,
                                       std::span<const Vector<2>> to)
    : m_kind(kind), m_from(from.begin(), from.end()), m_fit(affineFit<2>(from, to)) {
    for (std::size_t j = 0; j < m_from.size(); ++j)
        m_residuals.push_back(to[j] - m_fit(m_from[j]));
    m_size = sizeOf(m_from);
}

Vector<2> PolygonDeformation::operator()(const Vector<2>& x) const {
    const Vector<2> fitted = m_fit(x);
    if (const auto corner = cornerAt(m_from, x, m_size)) return fitted + m_residuals[*corner];
    Weights<double> w;
    double sum = 0;
    if (!weights<double>(m_kind, m_from, {x.x(), x.y()}, w, sum)) return fitted;
    Vector<2> shift = Vector<2>::Zero();
    for (std::size_t j = 0; j < m_from.size(); ++j)
        shift += w[j] * m_residuals[j];
    return fitted + shift / sum;
}

std::optional<PolygonDeformation::Expansion> PolygonDeformation::expansion(const Vector<2>& x) const {
    const auto coordinates = coordinateJets(m_kind, m_from, x);
    if (!coordinates) return std::nullopt;
    return expansion(x, *coordinates);
}

PolygonDeformation::Expansion PolygonDeformation::expansion(const Vector<2>& x,
                                                            std::span<const Jet> coordinates) const {
    Jet shiftX, shiftY;
    for (std::size_t j = 0; j < m_from.size(); ++j) {
        shiftX = shiftX + coordinates[j] * m_residuals[j].x();
        shiftY = shiftY + coordinates[j] * m_residuals[j].y();
    }
    Expansion result;
    result.value = m_fit(x) + Vector<2>(shiftX.value, shiftY.value);
    result.linear = m_fit.linear;
    result.linear(0, 0) += shiftX.x;
    result.linear(0, 1) += shiftX.y;
    result.linear(1, 0) += shiftY.x;
    result.linear(1, 1) += shiftY.y;
    result.second = {Vector<2>(shiftX.xx, shiftY.xx), Vector<2>(shiftX.xy, shiftY.xy),
                     Vector<2>(shiftX.yy, shiftY.yy)};
    result.third = {Vector<2>(shiftX.xxx, shiftY.xxx), Vector<2>(shiftX.xxy, shiftY.xxy),
                    Vector<2>(shiftX.xyy, shiftY.xyy), Vector<2>(shiftX.yyy, shiftY.yyy)};
    return result;
}

template AffineMap<2> affineFit<2>(std::span<const Vector<2>>, std::span<const Vector<2>>, const Matrix<2>&);
template AffineMap<3> affineFit<3>(std::span<const Vector<3>>, std::span<const Vector<3>>, const Matrix<3>&);

} // namespace ifs
