// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>

namespace ifs {

// A matrix without rounding, by rows.
template <int Dim> using ExactMatrix = std::array<std::array<Dyadic, Dim>, Dim>;

template <int Dim> ExactMatrix<Dim> exactMatrix(const Matrix<Dim>& finite) {
    ExactMatrix<Dim> result;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            result[std::size_t(i)][std::size_t(j)] = Dyadic(finite(i, j));
    return result;
}

template <std::size_t Size>
std::array<std::array<Dyadic, Size>, Size> operator*(const std::array<std::array<Dyadic, Size>, Size>& a,
                                                     const std::array<std::array<Dyadic, Size>, Size>& b) {
    std::array<std::array<Dyadic, Size>, Size> result;
    for (std::size_t i = 0; i < Size; ++i)
        for (std::size_t j = 0; j < Size; ++j)
            for (std::size_t k = 0; k < Size; ++k)
                result[i][j] = result[i][j] + a[i][k] * b[k][j];
    return result;
}

// Each entry within 2⁻⁵¹ of itself; infinite or 0 where it is too large or too small for a double.
template <int Dim> Matrix<Dim> rounded(const ExactMatrix<Dim>& exact) {
    Matrix<Dim> result;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            result(i, j) = exact[std::size_t(i)][std::size_t(j)].rounded();
    return result;
}

} // namespace ifs
