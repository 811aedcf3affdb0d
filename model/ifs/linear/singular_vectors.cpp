// SPDX-License-Identifier: MIT
#include "ifs/linear/singular_vectors.h"

#include <Eigen/SVD>

namespace ifs {

template <int Dim> SingularVectors<Dim> singularVectors(const Eigen::Matrix<double, Dim, Dim>& matrix) {
    const Eigen::JacobiSVD<Eigen::Matrix<double, Dim, Dim>> svd(matrix,
                                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

template SingularVectors<2> singularVectors(const Eigen::Matrix2d&);
template SingularVectors<3> singularVectors(const Eigen::Matrix3d&);

} // namespace ifs
