// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

// Symmetric matrices as vectors of their upper triangle (xx, xy, yy; in space xx, xy, xz, yy, yz, zz), and
// the linear operator X ↦ A X Aᵀ on them. docs/mathematics.md, "Invariant measure".
namespace ifs {

template <int Dim> inline constexpr int symmetricSize = Dim*(Dim + 1) / 2;
template <int Dim> using SymmetricVector = Eigen::Matrix<double, symmetricSize<Dim>, 1>;
template <int Dim> using SymmetricOperator = Eigen::Matrix<double, symmetricSize<Dim>, symmetricSize<Dim>>;

template <int Dim> SymmetricVector<Dim> upperTriangle(const Matrix<Dim>& symmetric) {
    SymmetricVector<Dim> result;
    int k = 0;
    for (int i = 0; i < Dim; ++i)
        for (int j = i; j < Dim; ++j)
            result[k++] = symmetric(i, j);
    return result;
}

template <int Dim> Matrix<Dim> symmetricMatrix(const SymmetricVector<Dim>& upper) {
    Matrix<Dim> result;
    int k = 0;
    for (int i = 0; i < Dim; ++i)
        for (int j = i; j < Dim; ++j)
            result(i, j) = result(j, i) = upper[k++];
    return result;
}

template <int Dim> SymmetricOperator<Dim> symmetricSquare(const Matrix<Dim>& linear) {
    SymmetricOperator<Dim> result;
    for (int k = 0; k < symmetricSize<Dim>; ++k) {
        const Matrix<Dim> unit = symmetricMatrix<Dim>(SymmetricVector<Dim>::Unit(k));
        result.col(k) = upperTriangle<Dim>(linear * unit * linear.transpose());
    }
    return result;
}

} // namespace ifs
