// SPDX-License-Identifier: MIT
#include "ifs/system/affine_map.h"

#include "ifs/linear/decompositions.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace ifs {

namespace {

// The largest coefficient in absolute value, infinity when one is no finite number. Dividing by it first
// keeps products of coefficients within the range of double.
template <int Dim> double magnitude(const Matrix<Dim>& linear) {
    return linear.allFinite() ? linear.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
}

// √(x² + y²) from correctly rounded operations only (std::hypot differs between libraries).
double norm(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// Turns columns p and q so that they become orthogonal; returns whether they were not yet.
bool orthogonaliseColumns(Matrix<3>& m, int p, int q) {
    const double product = m.col(p).dot(m.col(q));
    const double pp = m.col(p).squaredNorm(), qq = m.col(q).squaredNorm();
    if (std::abs(product) <= 1e-16 * std::sqrt(pp * qq)) return false;
    const double zeta = (qq - pp) / (2 * product);
    const double tangent = (zeta >= 0 ? 1 : -1) / (std::abs(zeta) + norm(1, zeta));
    const double cosine = 1 / norm(1, tangent);
    const double sine = cosine * tangent;
    const Vector<3> turned = cosine * m.col(p) - sine * m.col(q);
    m.col(q) = sine * m.col(p) + cosine * m.col(q);
    m.col(p) = turned;
    return true;
}

} // namespace

AffineMap<2> affineMap(double a, double b, double c, double d, double e, double f) {
    AffineMap<2> map;
    map.linear << a, b, c, d;
    map.translation << e, f;
    return map;
}

template <int Dim> AffineMap<Dim> operator*(const AffineMap<Dim>& outer, const AffineMap<Dim>& inner) {
    return {outer.linear * inner.linear, outer.linear * inner.translation + outer.translation};
}

template <int Dim> bool isFinite(const AffineMap<Dim>& map) {
    return map.linear.allFinite() && map.translation.allFinite();
}

// Coefficients of a code in decimals are off by half an ulp each; that and the rounding of the products may
// account for all of a determinant.
template <int Dim> double determinant(const Matrix<Dim>& linear) {
    constexpr double unit = 0x1p-53;
    const double result = linear.determinant();
    const Matrix<Dim> m = linear.cwiseAbs();
    double terms = 0, rounding = 0; // errors from the coefficients of a product, and from its arithmetic
    if constexpr (Dim == 2) {
        terms = m(0, 0) * m(1, 1) + m(0, 1) * m(1, 0);
        rounding = (2 + 2) * unit * terms;
    } else {
        for (int k = 0; k < 3; ++k)
            terms +=
                m(0, k) * (m(1, (k + 1) % 3) * m(2, (k + 2) % 3) + m(1, (k + 2) % 3) * m(2, (k + 1) % 3));
        rounding = (3 + 5) * unit * terms;
    }
    return std::isfinite(rounding) && std::abs(result) <= rounding ? 0 : result;
}

template <> Vector<2> singularValues<2>(const Matrix<2>& linear) {
    const double size = magnitude<2>(linear);
    if (size == 0 || !std::isfinite(size)) return Vector<2>::Constant(size);
    // A z = αz + βz̄: the singular values are |α| + |β| and ||α| − |β||; the smaller one is accurate only
    // when computed from det.
    const Matrix<2> m = linear / size;
    const double alpha = norm(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1)) / 2;
    const double beta = norm(m(0, 0) - m(1, 1), m(1, 0) + m(0, 1)) / 2;
    const double largest = alpha + beta;
    const double smallest = std::min(std::abs(m.determinant()) / largest, largest);
    return {size * largest, size * smallest};
}

template <> Vector<3> singularValues<3>(const Matrix<3>& linear) {
    const double size = magnitude<3>(linear);
    if (size == 0 || !std::isfinite(size)) return Vector<3>::Constant(size);
    // One-sided Jacobi: rotates pairs of columns until all are orthogonal; their lengths are the singular
    // values.
    Matrix<3> m = linear / size;
    constexpr int maxSweeps = 12;
    for (int sweep = 0; sweep < maxSweeps; ++sweep) {
        bool orthogonal = true;
        for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}})
            orthogonal = !orthogonaliseColumns(m, p, q) && orthogonal;
        if (orthogonal) break;
    }
    Vector<3> lengths = size * m.colwise().norm().transpose();
    std::sort(lengths.begin(), lengths.end(), std::greater{});
    return lengths;
}

template <int Dim> double spectralNorm(const Matrix<Dim>& linear) {
    return singularValues<Dim>(linear)[0];
}

template <> double spectralRadius<2>(const Matrix<2>& linear) {
    const double size = magnitude<2>(linear);
    if (size == 0 || !std::isfinite(size)) return size;
    const Matrix<2> m = linear / size;
    const double half = (m(0, 0) + m(1, 1)) / 2;
    const double difference = (m(0, 0) - m(1, 1)) / 2;
    const double discriminant = difference * difference + m(0, 1) * m(1, 0);
    return size * (discriminant >= 0 ? std::abs(half) + std::sqrt(discriminant)
                                     : std::sqrt(std::max(m.determinant(), 0.0)));
}

template <> double spectralRadius<3>(const Matrix<3>& linear) {
    const double size = magnitude<3>(linear);
    if (size == 0 || !std::isfinite(size)) return size;
    return size * largestEigenvalueModulus(linear / size);
}

template <int Dim> std::optional<AffineMap<Dim>> inverse(const AffineMap<Dim>& map) {
    const double det = map.linear.determinant();
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    const Matrix<Dim> linear = map.linear.inverse();
    const AffineMap<Dim> result{linear, -(linear * map.translation)};
    return isFinite(result) ? std::optional(result) : std::nullopt;
}

template <int Dim> std::optional<Vector<Dim>> fixedPoint(const AffineMap<Dim>& map) {
    const Matrix<Dim> complement = Matrix<Dim>::Identity() - map.linear;
    const double det = complement.determinant();
    if (!(std::abs(det) >= 1e-12) || !std::isfinite(det)) return std::nullopt;
    const Vector<Dim> point = complement.inverse() * map.translation;
    return point.allFinite() ? std::optional(point) : std::nullopt;
}

template <int Dim>
std::optional<AffineMap<Dim>> conjugate(const AffineMap<Dim>& transformation, const AffineMap<Dim>& map) {
    const auto back = inverse(transformation);
    if (!back) return std::nullopt;
    // A' = M A M⁻¹, b' = M b + t − A' t
    const Matrix<Dim> linear = transformation.linear * map.linear * back->linear;
    const AffineMap<Dim> result{linear, transformation.linear * map.translation + transformation.translation -
                                            linear * transformation.translation};
    return isFinite(result) ? std::optional(result) : std::nullopt;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template AffineMap<Dim> operator*(const AffineMap<Dim>&, const AffineMap<Dim>&);                         \
    template bool isFinite(const AffineMap<Dim>&);                                                           \
    template double determinant<Dim>(const Matrix<Dim>&);                                                    \
    template double spectralNorm<Dim>(const Matrix<Dim>&);                                                   \
    template std::optional<AffineMap<Dim>> inverse(const AffineMap<Dim>&);                                   \
    template std::optional<Vector<Dim>> fixedPoint(const AffineMap<Dim>&);                                   \
    template std::optional<AffineMap<Dim>> conjugate(const AffineMap<Dim>&, const AffineMap<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

AffineMap<2> flipped(AffineMap<2> map) {
    map.linear(0, 1) = -map.linear(0, 1);
    map.linear(1, 0) = -map.linear(1, 0);
    map.translation.y() = -map.translation.y();
    return map;
}

} // namespace ifs
