// SPDX-License-Identifier: MIT
#include "collage/fit/weight_fit.h"
#include "support/near.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace collage;

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;

// Each map halves the picture [−½, ½]² into one of its quarters.
const Maps triangle{ifs::affineMap(0.5, 0, 0, 0.5, -0.25, -0.25), ifs::affineMap(0.5, 0, 0, 0.5, 0.25, -0.25),
                    ifs::affineMap(0.5, 0, 0, 0.5, -0.25, 0.25)};

// The exact measure of every pixel of 256²: the pieces with words of length 8 are its pixels.
Density sierpinskiMeasure(const std::vector<double>& weights) {
    Density density{256, 256, std::vector<double>(256 * 256)};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            double mass = 1;
            for (int bit = 0; bit < 8; ++bit) {
                const int right = x >> bit & 1, up = (255 - y) >> bit & 1;
                mass *= right + up == 2 ? 0 : right ? weights[1] : up ? weights[2] : weights[0];
            }
            density.mass[std::size_t(y * 256 + x)] = mass;
        }
    return density;
}

} // namespace

class WeightFitTest : public QObject {
    Q_OBJECT

private slots:
    void weightsOfTheSierpinskiTriangleComeBack() {
        const std::vector<double> weights{0.2, 0.3, 0.5};
        const std::vector<double> found = fittedWeights(sierpinskiMeasure(weights), triangle);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY2(support::near(found[i], weights[i], 1e-3), qPrintable(QString::number(found[i])));
    }

    // Turned, off the pixels, and known from samples only.
    void weightsComeBackFromAPicture() {
        const std::vector<double> weights{0.2, 0.3, 0.5};
        const auto turn = ifs::affineMap(0.8 * std::cos(0.3), -0.8 * std::sin(0.3), 0.8 * std::sin(0.3),
                                         0.8 * std::cos(0.3), 0.013, 0.007);
        Maps maps;
        for (const auto& map : triangle)
            maps.push_back(*ifs::conjugate<2>(turn, map));
        Density density{256, 256, std::vector<double>(256 * 256)};
        std::mt19937 random(5);
        ifs::Vector<2> x(0, 0);
        for (int k = 0; k < 2'000'000; ++k) {
            const double u = random() * 0x1p-32;
            x = maps[u < 0.2 ? 0 : u < 0.5 ? 1 : 2](x);
            if (k > 50)
                density.mass[std::size_t((0.5 - x.y()) * 256) * 256 + std::size_t((x.x() + 0.5) * 256)] += 1;
        }
        const std::vector<double> found = fittedWeights(density, maps);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY2(support::near(found[i], weights[i], 3e-3), qPrintable(QString::number(found[i])));
    }

    void mapsThatCoverNothingGetNoWeight() {
        Maps maps = triangle;
        maps.push_back(ifs::affineMap(0.5, 0, 0, 0.5, 0.25, 0.25)); // the empty quarter
        const std::vector<double> found = fittedWeights(sierpinskiMeasure({0.2, 0.3, 0.5}), maps);
        QVERIFY(support::near(found[3], 0, 1e-3));
        QVERIFY(support::near(found[0] + found[1] + found[2] + found[3], 1, 1e-12));
    }

    void anEmptyPictureGivesEqualWeights() {
        const std::vector<double> found = fittedWeights({4, 4, std::vector<double>(16)}, triangle);
        QCOMPARE(found, std::vector<double>(3, 1.0 / 3));
    }

    // Karush, Kuhn and Tucker: the slope is the same for all that are positive, and not smaller elsewhere.
    void minimaSatisfyTheirConditions() {
        std::mt19937 random(3);
        const auto unit = [&] { return random() * 0x1p-31 - 1; };
        for (int trial = 0; trial < 500; ++trial) {
            const auto n = Eigen::Index(1 + random() % 9);
            const Eigen::MatrixXd root =
                Eigen::MatrixXd::NullaryExpr(n + Eigen::Index(random() % 2), n, unit); // may be tight
            const Eigen::MatrixXd q = root.transpose() * root;
            const Eigen::VectorXd c = Eigen::VectorXd::NullaryExpr(n, unit);
            const Eigen::VectorXd p = simplexMinimum(q, c);
            QVERIFY(support::near(p.sum(), 1, 1e-12) && p.minCoeff() >= 0);
            const Eigen::VectorXd slope = q * p - c;
            for (Eigen::Index i = 0; i < n; ++i)
                if (p[i] > 1e-9) QVERIFY(slope[i] <= slope.minCoeff() + 1e-8);
        }
    }

    void equalImagesShareTheirWeight() {
        const Eigen::MatrixXd q = Eigen::MatrixXd::Ones(3, 3);
        const Eigen::VectorXd p = simplexMinimum(q, Eigen::VectorXd::Ones(3));
        QVERIFY(support::near(p.sum(), 1, 1e-12) && p.minCoeff() >= 0);
    }
};

QTEST_APPLESS_MAIN(WeightFitTest)
#include "weight_fit_test.moc"
