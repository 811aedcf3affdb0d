// SPDX-License-Identifier: MIT
#include "ifs/system/decomposition.h"

#include "ifs/linear/decompositions.h"
#include "ifs/linear/singular_vectors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace ifs {

namespace {

// Relative tolerance for a map to be a similarity, and for a rank to be missing.
constexpr double relativeTolerance = 1e-12;
constexpr double rankRounding = 4e-15; // relative to the largest singular value; smaller ones are rounding

Matrix<2> rotationByRadians(double angle) {
    Matrix<2> result;
    result << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return result;
}

} // namespace

RotationScaleShear rotationScaleShear(const Matrix<2>& linear) {
    const double a = linear(0, 0), b = linear(0, 1), c = linear(1, 0), d = linear(1, 1);
    const double scaleX = std::hypot(a, c);
    if (scaleX == 0) // angle from the second column if the first one vanishes
        return {b == 0 && d == 0 ? 0 : std::atan2(-b, d), 0, std::hypot(b, d), 0};
    const double cosine = a / scaleX, sine = c / scaleX;
    // Orthogonal columns have no shear, not one of the size of rounding.
    const double along = cosine * b + sine * d;
    const bool isRight = std::abs(along) <= 4e-16 * (std::abs(cosine * b) + std::abs(sine * d));
    return {std::atan2(c, a), scaleX, cosine * d - sine * b, isRight ? 0 : along / scaleX};
}

Matrix<2> linearPart(const RotationScaleShear& parts) {
    Matrix<2> stretch;
    stretch << parts.scaleX, parts.scaleX * parts.shear, 0, parts.scaleY;
    return rotationByRadians(parts.rotation) * stretch;
}

template <> Polar<2> polar<2>(const Matrix<2>& linear) {
    const double x = linear(0, 0) + linear(1, 1), y = linear(1, 0) - linear(0, 1); // 2α
    const double length = std::hypot(x, y);
    Matrix<2> rotation = Matrix<2>::Identity();
    if (length > 0) rotation << x / length, -y / length, y / length, x / length;
    Matrix<2> stretch = rotation.transpose() * linear;
    stretch(0, 1) = stretch(1, 0) = (stretch(0, 1) + stretch(1, 0)) / 2;
    return {rotation, stretch};
}

template <> Polar<3> polar<3>(const Matrix<3>& linear) {
    if (!linear.allFinite()) return {Matrix<3>::Identity(), linear};
    const auto [u, values, v] = singularVectors<3>(linear);
    const Vector<3> orientation(1, 1, (u * v.transpose()).determinant() < 0 ? -1 : 1);
    const Vector<3> sigma = orientation.cwiseProduct(values);
    return {u * orientation.asDiagonal() * v.transpose(), v * sigma.asDiagonal() * v.transpose()};
}

template <> bool isRotationOpen<2>(const Matrix<2>& linear) {
    return linear.isZero(0);
}

template <> bool isRotationOpen<3>(const Matrix<3>& linear) {
    if (!linear.allFinite()) return false;
    const Vector<3> values = singularValues<3>(linear);
    return values[1] <= rankRounding * values[0];
}

template <> Polar<2> polarNear<2>(const Matrix<2>& linear, const Matrix<2>& rotation) {
    return isRotationOpen<2>(linear) ? Polar<2>{rotation, linear} : polar<2>(linear);
}

template <> Polar<3> polarNear<3>(const Matrix<3>& linear, const Matrix<3>& rotation) {
    if (!isRotationOpen<3>(linear)) return polar<3>(linear);
    const auto [u, values, v] = singularVectors<3>(linear);
    if (values[0] == 0) return {rotation, linear};
    const Vector<3> from = rotation * v.col(0), to = u.col(0);
    return {Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix() * rotation,
            values[0] * v.col(0) * v.col(0).transpose()};
}

template <int Dim> PolarPair<Dim> polarPair(const Matrix<Dim>& from, const Matrix<Dim>& to) {
    const Matrix<Dim> none = Matrix<Dim>::Identity();
    const bool isFromOpen = isRotationOpen<Dim>(from), isToOpen = isRotationOpen<Dim>(to);
    if (!isFromOpen && !isToOpen) return {polar<Dim>(from), polar<Dim>(to)};
    const Polar<Dim> first = polarNear<Dim>(from, isToOpen ? none : polar<Dim>(to).rotation);
    const Polar<Dim> last = polarNear<Dim>(to, first.rotation);
    // Rotation of a point: that of the line from which it shrinks.
    return {polarNear<Dim>(from, last.rotation), last};
}

template PolarPair<2> polarPair<2>(const Matrix<2>&, const Matrix<2>&);
template PolarPair<3> polarPair<3>(const Matrix<3>&, const Matrix<3>&);

namespace {

// A column that depends on the ones before it gives way to one at right angles to both others, so that its
// row of R vanishes altogether and shear stays finite.
Matrix<3> independent(Matrix<3> columns) {
    const auto spans = [&](const Vector<3>& p, const Vector<3>& q) {
        return p.cross(q).norm() > 1e-15 * p.norm() * q.norm();
    };
    const auto orthogonal = [&](const Vector<3>& p, const Vector<3>& q) -> Vector<3> {
        if (spans(p, q)) return p.cross(q).normalized();
        const Vector<3>& longer = p.norm() > q.norm() ? p : q;
        return longer.norm() > 0 ? Vector<3>(longer.unitOrthogonal()) : Vector<3>::Unit(0);
    };
    if (columns.col(0).norm() == 0) columns.col(0) = orthogonal(columns.col(1), columns.col(2));
    if (!spans(columns.col(0), columns.col(1))) columns.col(1) = orthogonal(columns.col(2), columns.col(0));
    return columns;
}

} // namespace

RotationScaleShear3 rotationScaleShear(const Matrix<3>& linear) {
    if (!linear.allFinite()) return {Matrix<3>::Identity(), linear.diagonal(), Matrix<3>::Identity()};
    Matrix<3> q = orthogonalFactor(independent(linear));
    Matrix<3> r = q.transpose() * linear;
    // Moves signs from R to Q, so that Q rotates and only the last scale may reflect.
    for (int k = 0; k < 2; ++k)
        if (r(k, k) < 0) {
            r.row(k) *= -1;
            q.col(k) *= -1;
        }
    if (q.determinant() < 0) {
        r.row(2) *= -1;
        q.col(2) *= -1;
    }
    // Clears entries below the rounding error of their column.
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row <= column; ++row)
            if (std::abs(r(row, column)) <= 4e-15 * linear.col(column).norm()) r(row, column) = 0;
    RotationScaleShear3 result{q, r.diagonal(), Matrix<3>::Identity()};
    const double negligible = 1e-15 * linear.cwiseAbs().maxCoeff();
    for (int row = 0; row < 2; ++row)
        if (result.scale[row] > negligible)
            for (int column = row + 1; column < 3; ++column)
                result.shear(row, column) = r(row, column) / r(row, row);
    return result;
}

Matrix<3> linearPart(const RotationScaleShear3& parts) {
    return parts.rotation * parts.scale.asDiagonal() * parts.shear;
}

AxisAngle axisAngle(const Matrix<3>& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    // Uncertainty of the axis, greater for smaller rotations.
    const double rounding = 8 * std::numeric_limits<double>::epsilon() / std::sin(turn.angle() / 2);
    const auto known = [&](double x) { return std::abs(x) <= rounding && rounding < 1 ? 0 : x; };
    return {turn.axis().unaryExpr(known), turn.angle()};
}

Matrix<3> rotationAbout(const AxisAngle& turn) {
    const double length = turn.axis.stableNorm();
    if (!(length > 0)) return Matrix<3>::Identity();
    return Eigen::AngleAxisd(turn.angle, turn.axis / length).toRotationMatrix();
}

template <int Dim> MapKind kind(const Matrix<Dim>& linear) {
    const Vector<Dim> sigma = singularValues<Dim>(linear);
    if (sigma[0] == 0) return MapKind::Constant;
    if (!(sigma[Dim - 1] > relativeTolerance * relativeTolerance * sigma[0])) return MapKind::Singular;
    if (!(sigma[0] - sigma[Dim - 1] <= 2 * relativeTolerance * sigma[0])) return MapKind::Affine;
    return determinant<Dim>(linear) > 0 ? MapKind::Similarity : MapKind::ReflectedSimilarity;
}

template MapKind kind<2>(const Matrix<2>&);
template MapKind kind<3>(const Matrix<3>&);

} // namespace ifs
