// SPDX-License-Identifier: MIT
#include "ifs/affine_map.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace ifs {

AffineMap<2> affineMap(double a, double b, double c, double d, double e, double f) {
    AffineMap<2> map;
    map.linear << a, b, c, d;
    map.translation << e, f;
    return map;
}

template <int Dim> AffineMap<Dim> operator*(const AffineMap<Dim>& outer, const AffineMap<Dim>& inner) {
    return {outer.linear * inner.linear, outer.linear * inner.translation + outer.translation};
}

template <int Dim> double determinant(const Matrix<Dim>& linear) {
    return linear.determinant();
}

template <> Vector<2> singularValues<2>(const Matrix<2>& m) {
    // A z = αz + βz̄: the singular values are |α| + |β| and ||α| − |β||, the small one from det for its
    // digits.
    const double alpha = std::hypot(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1)) / 2;
    const double beta = std::hypot(m(0, 0) - m(1, 1), m(1, 0) + m(0, 1)) / 2;
    const double largest = alpha + beta;
    const double smallest = largest > 0 ? std::abs(m.determinant()) / largest : 0;
    return {largest, std::min(smallest, largest)};
}

template <> Vector<3> singularValues<3>(const Matrix<3>& linear) {
    return Eigen::JacobiSVD<Matrix<3>>(linear).singularValues();
}

template <int Dim> double spectralNorm(const Matrix<Dim>& linear) {
    return singularValues<Dim>(linear)[0];
}

template <> double spectralRadius<2>(const Matrix<2>& linear) {
    const double half = linear.trace() / 2;
    const double det = linear.determinant();
    const double discriminant = half * half - det;
    return discriminant >= 0 ? std::abs(half) + std::sqrt(discriminant) : std::sqrt(det);
}

template <> double spectralRadius<3>(const Matrix<3>& linear) {
    return Eigen::EigenSolver<Matrix<3>>(linear, false).eigenvalues().cwiseAbs().maxCoeff();
}

template <int Dim> std::optional<AffineMap<Dim>> inverse(const AffineMap<Dim>& map) {
    const double det = map.linear.determinant();
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    const Matrix<Dim> linear = map.linear.inverse();
    if (!linear.allFinite()) return std::nullopt;
    return AffineMap<Dim>{linear, -(linear * map.translation)};
}

template <int Dim> std::optional<Vector<Dim>> fixedPoint(const AffineMap<Dim>& map) {
    const Matrix<Dim> complement = Matrix<Dim>::Identity() - map.linear;
    const double det = complement.determinant();
    if (!(std::abs(det) >= 1e-12) || !std::isfinite(det)) return std::nullopt;
    return Vector<Dim>(complement.inverse() * map.translation);
}

template <int Dim>
std::optional<AffineMap<Dim>> conjugate(const AffineMap<Dim>& transformation, const AffineMap<Dim>& map) {
    const auto back = inverse(transformation);
    if (!back) return std::nullopt;
    // A' = M A M⁻¹, b' = M b + t − A' t
    const Matrix<Dim> linear = transformation.linear * map.linear * back->linear;
    return AffineMap<Dim>{linear, transformation.linear * map.translation + transformation.translation -
                                      linear * transformation.translation};
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template AffineMap<Dim> operator*(const AffineMap<Dim>&, const AffineMap<Dim>&);                         \
    template double determinant<Dim>(const Matrix<Dim>&);                                                    \
    template double spectralNorm<Dim>(const Matrix<Dim>&);                                                   \
    template std::optional<AffineMap<Dim>> inverse(const AffineMap<Dim>&);                                   \
    template std::optional<Vector<Dim>> fixedPoint(const AffineMap<Dim>&);                                   \
    template std::optional<AffineMap<Dim>> conjugate(const AffineMap<Dim>&, const AffineMap<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
