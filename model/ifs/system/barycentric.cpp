// SPDX-License-Identifier: MIT
#include "ifs/system/barycentric.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

constexpr double flatnessLimit = 1e-9;

// Columns V_k − V_0.
template <int Dim> Matrix<Dim> edges(const Simplex<Dim>& simplex) {
    Matrix<Dim> result;
    for (int k = 0; k < Dim; ++k)
        result.col(k) = simplex[k + 1] - simplex[0];
    return result;
}

template <int Dim> double longestEdge(const Simplex<Dim>& simplex) {
    double longest = 0;
    for (int j = 0; j < Dim; ++j)
        for (int k = j + 1; k <= Dim; ++k)
            longest = std::max(longest, (simplex[k] - simplex[j]).stableNorm());
    return longest;
}

} // namespace

template <int Dim> bool isAffineBasis(const Simplex<Dim>& simplex) {
    const double length = longestEdge<Dim>(simplex);
    if (!(length > 0) || !std::isfinite(length) || !edges<Dim>(simplex).allFinite()) return false;
    return std::abs((edges<Dim>(simplex) / length).determinant()) >= flatnessLimit;
}

template <int Dim> Barycentric<Dim> barycentric(const Simplex<Dim>& simplex, const Vector<Dim>& x) {
    const Matrix<Dim> basis = edges<Dim>(simplex);
    const Vector<Dim> offset = x - simplex[0];
    const double volume = basis.determinant();
    Barycentric<Dim> result;
    for (int k = 0; k < Dim; ++k) {
        Matrix<Dim> replaced = basis;
        replaced.col(k) = offset;
        result[k + 1] = replaced.determinant() / volume;
    }
    result[0] = 1 - result.template tail<Dim>().sum();
    return result;
}

template <int Dim> Vector<Dim> point(const Simplex<Dim>& simplex, const Barycentric<Dim>& coordinates) {
    Vector<Dim> result = Vector<Dim>::Zero();
    for (int j = 0; j <= Dim; ++j)
        result += coordinates[j] * simplex[j];
    return result;
}

template <int Dim> AffineMap<Dim> simplexMap(const Simplex<Dim>& from, const Simplex<Dim>& to) {
    const Matrix<Dim> linear = edges<Dim>(to) * edges<Dim>(from).inverse();
    return {linear, to[0] - linear * from[0]};
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template bool isAffineBasis<Dim>(const Simplex<Dim>&);                                                   \
    template Barycentric<Dim> barycentric<Dim>(const Simplex<Dim>&, const Vector<Dim>&);                     \
    template Vector<Dim> point<Dim>(const Simplex<Dim>&, const Barycentric<Dim>&);                           \
    template AffineMap<Dim> simplexMap<Dim>(const Simplex<Dim>&, const Simplex<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
