// SPDX-License-Identifier: MIT
#include "ifs/linear/symmetric_matrices.h"
#include "support/named_test.h"

#include <Eigen/Eigenvalues>

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

class SymmetricMatricesTest : public QObject {
    Q_OBJECT

private slots:
    void planeHasTheDigitsOfEigen();
    void spaceIsDecomposed();
    void onlyTheLowerTriangleIsRead();
    void leastEigenvalueInLongNumbers();
    void factorOfADefiniteMatrix();
};

namespace {

// Of any size, with zeros and ties among the entries.
template <int Dim> Eigen::Matrix<double, Dim, Dim> randomSymmetric(std::mt19937& random) {
    std::uniform_real_distribution<double> entry(-1, 1);
    std::uniform_int_distribution<int> half(-2, 2), exponent(-900, 900), kind(0, 2);
    Eigen::Matrix<double, Dim, Dim> result;
    const int which = kind(random), size = which == 2 ? exponent(random) : 0;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j <= i; ++j)
            result(i, j) = result(j, i) = which == 0 ? half(random) / 2.0 : std::ldexp(entry(random), size);
    return result;
}

} // namespace

void SymmetricMatricesTest::planeHasTheDigitsOfEigen() {
    std::mt19937 random(1);
    for (int n = 0; n < 20'000; ++n) {
        const Eigen::Matrix2d matrix = randomSymmetric<2>(random);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(matrix);
        const auto found = ifs::symmetricEigenvalues<2>(matrix);
        QVERIFY(found.values == solver.eigenvalues());
        QVERIFY(found.vectors == solver.eigenvectors());
    }
    const auto none = ifs::symmetricEigenvalues<2>(Eigen::Matrix2d::Zero());
    QVERIFY(none.values.isZero(0));
    QVERIFY(none.vectors == Eigen::Matrix2d::Identity());
}

void SymmetricMatricesTest::spaceIsDecomposed() {
    std::mt19937 random(2);
    for (int n = 0; n < 2'000; ++n) {
        const Eigen::Matrix3d matrix = randomSymmetric<3>(random);
        const auto [values, vectors] = ifs::symmetricEigenvalues<3>(matrix);
        const double size = matrix.cwiseAbs().maxCoeff();
        QVERIFY(values[0] <= values[1] && values[1] <= values[2]);
        QVERIFY((vectors.transpose() * vectors).isIdentity(1e-13));
        const Eigen::Matrix3d again = vectors * values.asDiagonal() * vectors.transpose();
        QVERIFY((again - matrix).cwiseAbs().maxCoeff() <= 1e-14 * size);
    }
}

void SymmetricMatricesTest::onlyTheLowerTriangleIsRead() {
    constexpr double any = std::numeric_limits<double>::infinity();
    const Eigen::Matrix2d plane = (Eigen::Matrix2d() << 2, any, 1, 2).finished();
    QVERIFY(ifs::symmetricEigenvalues<2>(plane).values.isApprox(Eigen::Vector2d(1, 3), 1e-15));
    const Eigen::Matrix3d space = (Eigen::Matrix3d() << 2, any, any, 1, 2, any, 0, 0, 5).finished();
    QVERIFY(ifs::symmetricEigenvalues<3>(space).values.isApprox(Eigen::Vector3d(1, 3, 5), 1e-15));
}

void SymmetricMatricesTest::leastEigenvalueInLongNumbers() {
    using Plane = Eigen::Matrix<long double, 2, 2>;
    using Space = Eigen::Matrix<long double, 3, 3>;
    // 2 ± √2 and 2, 2 ± √2
    const Plane plane = (Plane() << 1, 1, 1, 3).finished();
    const Space space = (Space() << 2, 1, 0, 1, 2, 1, 0, 1, 2).finished();
    const long double least = 2 - std::sqrt(2.0L);
    QVERIFY(std::abs(ifs::leastSymmetricEigenvalue(plane) - least) < 1e-18L);
    QVERIFY(std::abs(ifs::leastSymmetricEigenvalue(space) - least) < 1e-17L);
}

void SymmetricMatricesTest::factorOfADefiniteMatrix() {
    const Eigen::Matrix3d root = (Eigen::Matrix3d() << 2, 1, -1, 0, 3, 0.5, 0, 0, 1).finished();
    const auto found = ifs::choleskyFactor<3>(root.transpose() * root);
    QVERIFY(found);
    QVERIFY(found->isApprox(root, 1e-14));
    QVERIFY(!ifs::choleskyFactor<2>((Eigen::Matrix2d() << 1, 2, 2, 1).finished()));
}

BARYCAGE_TEST(SymmetricMatricesTest);
#include "symmetric_matrices_test.moc"
