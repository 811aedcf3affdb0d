// SPDX-License-Identifier: MIT
#include "ifs/linear/decompositions.h"

#include "ifs/linear/inverse.h"
#include "ifs/linear/singular_vectors.h"
#include "ifs/linear/space_columns.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>
#include <random>

class DecompositionsTest : public QObject {
    Q_OBJECT

private slots:
    void eigenvaluesAreConditioned();
    void eigendirectionsStayInvariant();
    void orthogonalFactorSpansTheSame();
    void shortestSolutionOfManyOrNone();
    void inversesInvert();
    void singularVectorsComposeTheMatrix();
    void columnsHavePrincipalAxes();
    void columnsComeNearest();
};

namespace {

Eigen::MatrixXd randomMatrix(std::mt19937& random, Eigen::Index rows, Eigen::Index columns) {
    std::uniform_real_distribution<double> entry(-1, 1);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return entry(random); });
}

const Eigen::Matrix2d turned = (Eigen::Matrix2d() << 0, -3, 3, 0).finished();

} // namespace

void DecompositionsTest::eigenvaluesAreConditioned() {
    QVERIFY(std::abs(ifs::largestEigenvalueModulus(turned) - 3) < 1e-14);
    const Eigen::Vector3d values(-4, 1, 2);
    const auto diagonal = ifs::largestEigenvalue(values.asDiagonal().toDenseMatrix());
    QVERIFY(std::abs(diagonal.modulus - 4) < 1e-14);
    QVERIFY(std::abs(diagonal.condition - 1) < 1e-14);
    const Eigen::Matrix2d sheared = (Eigen::Matrix2d() << 2, 1000, 0, 1).finished();
    const auto found = ifs::largestEigenvalue(sheared);
    QVERIFY(std::abs(found.modulus - 2) < 1e-12);
    QVERIFY(std::abs(found.condition / std::sqrt(1 + 1e6) - 1) < 1e-9); // |(1,0)|·|(1,1000)|
}

void DecompositionsTest::eigendirectionsStayInvariant() {
    std::mt19937 random(3);
    for (int n = 0; n < 1'000; ++n) {
        const Eigen::Matrix3d space = randomMatrix(random, 3, 3);
        const auto found = ifs::eigendirections<3>(space);
        QVERIFY(found);
        // In their coordinates the matrix has a block of 2×2 at most.
        const Eigen::Matrix3d seen = found->inverse() * space * *found;
        const double rest = seen.row(2).head<2>().norm() + seen.col(2).head<2>().norm();
        const double other = seen.row(0).tail<2>().norm() + seen.col(0).tail<2>().norm();
        const double rounding = 1e-12 * found->norm() * found->inverse().norm();
        QVERIFY(std::min(rest, other) < rounding);
        const Eigen::Matrix2d plane = randomMatrix(random, 2, 2);
        const auto flat = ifs::eigendirections<2>(plane);
        QVERIFY(flat);
        const Eigen::Matrix2d normal = flat->inverse() * plane * *flat;
        const bool isReal = std::abs(normal(0, 1)) + std::abs(normal(1, 0)) < 1e-12 * flat->inverse().norm();
        QVERIFY(isReal || std::abs(normal(0, 0) - normal(1, 1)) < 1e-12 * flat->inverse().norm());
    }
}

void DecompositionsTest::orthogonalFactorSpansTheSame() {
    std::mt19937 random(4);
    for (const int size : {2, 3, 7}) {
        const Eigen::MatrixXd matrix = randomMatrix(random, size, size);
        const Eigen::MatrixXd q = ifs::orthogonalFactor(matrix), r = q.transpose() * matrix;
        QVERIFY((q.transpose() * q).isIdentity(1e-14));
        for (int column = 0; column < size; ++column)
            QVERIFY(r.col(column).tail(size - 1 - column).norm() < 1e-14);
    }
}

void DecompositionsTest::shortestSolutionOfManyOrNone() {
    const Eigen::Matrix2d flat = (Eigen::Matrix2d() << 1, 1, 1, 1).finished();
    QVERIFY(ifs::shortestSolution(flat, Eigen::Vector2d(2, 2)).isApprox(Eigen::Vector2d(1, 1), 1e-14));
    QVERIFY(ifs::shortestSolution(flat, Eigen::Vector2d(4, 0)).isApprox(Eigen::Vector2d(1, 1), 1e-14));
    QVERIFY(ifs::shortestSolution(turned, Eigen::Vector2d(3, 6)).isApprox(Eigen::Vector2d(2, -1), 1e-14));
}

void DecompositionsTest::inversesInvert() {
    std::mt19937 random(5);
    const Eigen::MatrixXd matrix = randomMatrix(random, 9, 9);
    QVERIFY((ifs::inverseOf(matrix) * matrix).isIdentity(1e-11));
    const Eigen::VectorXd b = randomMatrix(random, 9, 1);
    QVERIFY((matrix * ifs::solution(matrix, b) - b).norm() < 1e-12);
    const Eigen::Matrix<long double, 6, 6> wide = randomMatrix(random, 6, 6).cast<long double>();
    QVERIFY((ifs::inverseOf(wide) * wide).isIdentity(1e-16L));
}

void DecompositionsTest::singularVectorsComposeTheMatrix() {
    std::mt19937 random(6);
    for (int n = 0; n < 1'000; ++n) {
        const Eigen::Matrix3d matrix = randomMatrix(random, 3, 3);
        const auto [left, values, right] = ifs::singularVectors<3>(matrix);
        QVERIFY(values[0] >= values[1] && values[1] >= values[2] && values[2] >= 0);
        QVERIFY((left.transpose() * left).isIdentity(1e-14) && (right.transpose() * right).isIdentity(1e-14));
        QVERIFY((left * values.asDiagonal() * right.transpose()).isApprox(matrix, 1e-14));
    }
    const auto flat = ifs::singularVectors<2>((Eigen::Matrix2d() << 3, 4, 0, 0).finished());
    QVERIFY(flat.values.isApprox(Eigen::Vector2d(5, 0), 1e-15));
    QVERIFY(std::abs(flat.right.col(0).dot(Eigen::Vector2d(0.6, 0.8))) > 1 - 1e-15);
}

void DecompositionsTest::columnsHavePrincipalAxes() {
    Eigen::Matrix3Xd columns(3, 6);
    columns << 0, 0, 1, -1, 0, 0, 5, -5, 0, 0, 0, 0, 0, 0, 0, 0, 2, -2;
    const auto [directions, lengths] = ifs::principalAxes(columns);
    QVERIFY(
        directions.cwiseAbs().isApprox((Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished(), 1e-15));
    QVERIFY(lengths.isApprox(std::sqrt(2) * Eigen::Vector3d(5, 2, 1), 1e-15));
    const auto one = ifs::principalAxes(Eigen::Vector3d(0, 0, -7));
    QVERIFY(one.lengths == Eigen::Vector3d(7, 0, 0));
    QVERIFY(std::abs(one.directions(2, 0)) > 1 - 1e-15);
    QVERIFY((one.directions.transpose() * one.directions).isIdentity(1e-15));
}

void DecompositionsTest::columnsComeNearest() {
    Eigen::Matrix3Xd columns(3, 2);
    columns << 1, 1, 0, 1, 0, 0;
    QVERIFY(ifs::leastSquares(columns, {3, 2, 9}).isApprox(Eigen::Vector2d(1, 2), 1e-14));
}

BARYCAGE_TEST(DecompositionsTest);
#include "decompositions_test.moc"
