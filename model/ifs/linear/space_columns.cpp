// SPDX-License-Identifier: MIT
#include "ifs/linear/space_columns.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace ifs {

PrincipalAxes principalAxes(const Eigen::Matrix3Xd& columns) {
    const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(columns, Eigen::ComputeFullU);
    PrincipalAxes result{svd.matrixU(), Eigen::Vector3d::Zero()};
    for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k)
        result.lengths[k] = svd.singularValues()[k];
    return result;
}

Eigen::VectorXd leastSquares(const Eigen::Matrix3Xd& columns, const Eigen::Vector3d& b) {
    return columns.colPivHouseholderQr().solve(b);
}

} // namespace ifs
