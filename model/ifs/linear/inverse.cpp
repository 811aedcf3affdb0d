// SPDX-License-Identifier: MIT
#include "ifs/linear/inverse.h"

#include <Eigen/LU>

namespace ifs {

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& square) {
    return square.partialPivLu().inverse();
}

template <int Size>
Eigen::Matrix<long double, Size, Size> inverseOf(const Eigen::Matrix<long double, Size, Size>& square) {
    return square.inverse();
}

template <int Size> using LongMatrix = Eigen::Matrix<long double, Size, Size>;
template LongMatrix<2> inverseOf(const LongMatrix<2>&);
template LongMatrix<3> inverseOf(const LongMatrix<3>&);
template LongMatrix<6> inverseOf(const LongMatrix<6>&);

Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return a.partialPivLu().solve(b);
}

} // namespace ifs
