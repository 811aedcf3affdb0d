// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

// Affine maps of the plane and of space. Points are columns, y (and z) up, right-handed.
// Formulas: docs/mathematics.md, "Affine maps".
namespace ifs {

template <int Dim> using Vector = Eigen::Matrix<double, Dim, 1>;
template <int Dim> using Matrix = Eigen::Matrix<double, Dim, Dim>;

// x ↦ linear·x + translation. In the plane a code row "a b c d e f" is linear = [[a,b],[c,d]], translation =
// (e,f).
template <int Dim> struct AffineMap {
    Matrix<Dim> linear = Matrix<Dim>::Identity();
    Vector<Dim> translation = Vector<Dim>::Zero();

    Vector<Dim> operator()(const Vector<Dim>& x) const { return linear * x + translation; }

    friend bool operator==(const AffineMap& a, const AffineMap& b) {
        return a.linear == b.linear && a.translation == b.translation;
    }
};

AffineMap<2> affineMap(double a, double b, double c, double d, double e, double f);

// outer∘inner: the inner map acts first. The map of the address σ = σ₁σ₂…σₖ is w_σ₁ * w_σ₂ * … * w_σₖ.
template <int Dim> AffineMap<Dim> operator*(const AffineMap<Dim>& outer, const AffineMap<Dim>& inner);

template <int Dim> bool isFinite(const AffineMap<Dim>& map);

template <int Dim> double determinant(const Matrix<Dim>& linear); // 0 within its own rounding error

// Singular values, largest first. In the plane from |α| ± |β|, where A z = αz + βz̄. All infinite when a
// coefficient is no finite number, so that such a map never counts as a contraction.
template <int Dim> Vector<Dim> singularValues(const Matrix<Dim>& linear);

// ‖A‖, the largest singular value: the factor by which A stretches at most.
template <int Dim> double spectralNorm(const Matrix<Dim>& linear);

// ρ(A), the largest modulus of an eigenvalue; infinite when a coefficient is no finite number.
template <int Dim> double spectralRadius(const Matrix<Dim>& linear);

// nullopt when the linear part is singular (determinant 0, or not finite).
template <int Dim> std::optional<AffineMap<Dim>> inverse(const AffineMap<Dim>& map);

// (I − A)⁻¹ b; nullopt when |det(I − A)| < 1e-12, where no single point is fixed, and when it is not finite.
template <int Dim> std::optional<Vector<Dim>> fixedPoint(const AffineMap<Dim>& map);

// T∘w∘T⁻¹: the same map seen in the coordinates that T leads to; nullopt when T is singular.
template <int Dim>
std::optional<AffineMap<Dim>> conjugate(const AffineMap<Dim>& transformation, const AffineMap<Dim>& map);

// The map seen with y as −y: exact, and its own inverse.
AffineMap<2> flipped(AffineMap<2> map);

} // namespace ifs
