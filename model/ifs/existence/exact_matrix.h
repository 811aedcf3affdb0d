// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <bit>
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

template <std::size_t Size>
std::array<std::array<Dyadic, Size>, Size> transposed(const std::array<std::array<Dyadic, Size>, Size>& m) {
    std::array<std::array<Dyadic, Size>, Size> result;
    for (std::size_t i = 0; i < Size; ++i)
        for (std::size_t j = 0; j < Size; ++j)
            result[i][j] = m[j][i];
    return result;
}

// The matrix a − factor·b.
template <std::size_t Size>
std::array<std::array<Dyadic, Size>, Size> difference(const std::array<std::array<Dyadic, Size>, Size>& a,
                                                      const Dyadic& factor,
                                                      const std::array<std::array<Dyadic, Size>, Size>& b) {
    std::array<std::array<Dyadic, Size>, Size> result;
    for (std::size_t i = 0; i < Size; ++i)
        for (std::size_t j = 0; j < Size; ++j)
            result[i][j] = a[i][j] - factor * b[i][j];
    return result;
}

// Row by row, from the minors of the rows before in every set of columns: without a division.
template <std::size_t Size> Dyadic determinant(const std::array<std::array<Dyadic, Size>, Size>& m) {
    std::array<Dyadic, (1u << Size)> minors;
    minors[0] = Dyadic(1);
    for (unsigned columns = 1; columns < minors.size(); ++columns) {
        const auto row = std::size_t(std::popcount(columns)) - 1;
        for (std::size_t k = 0; k < Size; ++k) {
            if ((columns >> k & 1u) == 0) continue;
            const Dyadic term = m[row][k] * minors[columns & ~(1u << k)];
            const bool isOdd = std::popcount(columns >> (k + 1)) % 2 == 1;
            minors[columns] = isOdd ? minors[columns] - term : minors[columns] + term;
        }
    }
    return minors.back();
}

// Returns true if a symmetric matrix of two or three rows is positive definite, by its leading minors.
template <std::size_t Size> bool isPositiveDefinite(const std::array<std::array<Dyadic, Size>, Size>& m) {
    static_assert(Size == 2 || Size == 3);
    const Dyadic second = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return m[0][0].sign() > 0 && second.sign() > 0 && (Size == 2 || determinant(m).sign() > 0);
}

// The matrix in doubles, each entry within a relative 2⁻⁵¹; infinite or 0 where it is too large or too small
// for a double.
template <int Dim> Matrix<Dim> rounded(const ExactMatrix<Dim>& exact) {
    Matrix<Dim> result;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            result(i, j) = exact[std::size_t(i)][std::size_t(j)].rounded();
    return result;
}

} // namespace ifs
