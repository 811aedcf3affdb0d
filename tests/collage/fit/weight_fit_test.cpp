// SPDX-License-Identifier: MIT
#include "collage/fit/weight_fit.h"
#include "collage/measure/transport_bound.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QTest>

#include <Eigen/LU>

#include <cmath>
#include <random>

using namespace collage;

namespace {

using WeightMaps = std::vector<ifs::AffineMap<2>>;

// Each map halves the picture [−½, ½]² into one of its quarters.
const WeightMaps triangle{ifs::affineMap(0.5, 0, 0, 0.5, -0.25, -0.25),
                          ifs::affineMap(0.5, 0, 0, 0.5, 0.25, -0.25),
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

// In pixels from the top left corner.
ifs::Vector<2> meanOf(const Density& density) {
    ifs::Vector<2> sum(0, 0);
    double mass = 0;
    for (int y = 0; y < density.height; ++y)
        for (int x = 0; x < density.width; ++x) {
            const double here = density.mass[std::size_t(y * density.width + x)];
            mass += here;
            sum += here * ifs::Vector<2>(x + 0.5, y + 0.5);
        }
    return sum / mass;
}

// The same of the invariant measure: m = Σ p (A m + b).
ifs::Vector<2> meanOf(const WeightMaps& maps, const std::vector<double>& weights, const Density& picture) {
    ifs::Matrix<2> a = ifs::Matrix<2>::Identity();
    ifs::Vector<2> b(0, 0);
    for (std::size_t i = 0; i < maps.size(); ++i) {
        a -= weights[i] * maps[i].linear;
        b += weights[i] * maps[i].translation;
    }
    const ifs::Vector<2> mean = a.inverse() * b;
    return {mean.x() * picture.height + picture.width / 2.0, (0.5 - mean.y()) * picture.height};
}

// Random masses, as many on both sides, along a line of cells; and what it costs to move one to the other:
// the area between both sums from the left.
struct Line {
    std::vector<double> supply, demand;
    double cost = 0;
};
Line randomLine(int length, std::mt19937& random) {
    Line line;
    double supply = 0, demand = 0;
    for (int k = 0; k < length; ++k) {
        line.supply.push_back(random() * 0x1p-32);
        line.demand.push_back(random() * 0x1p-32);
        supply += line.supply.back();
        demand += line.demand.back();
    }
    double ahead = 0;
    for (int k = 0; k < length; ++k) {
        line.demand[std::size_t(k)] *= supply / demand;
        ahead += line.supply[std::size_t(k)] - line.demand[std::size_t(k)];
        line.cost += std::abs(ahead);
    }
    return line;
}

double boundOf(const Line& line) {
    TransportBound bound(int(line.supply.size()), 1);
    for (std::size_t k = 0; k < line.supply.size(); ++k) {
        bound.addSupply({line.supply[k], {double(k) + 0.5, 0.5}, 0});
        bound.addDemand({line.demand[k], {double(k) + 0.5, 0.5}, 0});
    }
    return std::move(bound).cost();
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
        WeightMaps maps;
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
        WeightMaps maps = triangle;
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

    void transportAlongALine() {
        std::mt19937 random(9);
        for (const int length : {1, 2, 37, 300}) {
            const Line line = randomLine(length, random);
            QVERIFY(support::near(boundOf(line), line.cost, 1e-9 * (1 + line.cost)));
        }
        const Line line = randomLine(4096, random); // too many cells to be exact
        const double bound = boundOf(line);
        QVERIFY2(bound >= line.cost * (1 - 1e-9) && bound < 1.5 * line.cost,
                 qPrintable(QString::number(bound / line.cost)));
    }

    // Nothing is farther apart than the means are allowed to be.
    void boundOfMeasuresIsNeverViolated() {
        std::mt19937 random(17);
        const auto between = [&](double a, double b) { return a + (b - a) * random() * 0x1p-32; };
        for (int trial = 0; trial < 200; ++trial) {
            Density density{24, 16, std::vector<double>(24 * 16)};
            for (int k = 0; k < 40; ++k)
                density.mass[random() % density.mass.size()] += between(0, 1);
            WeightMaps maps;
            std::vector<double> weights;
            double sum = 0;
            for (int i = 0; i < 3; ++i) {
                auto map = ifs::affineMap(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1),
                                          between(-0.5, 0.5), between(-0.5, 0.5));
                map.linear *= between(0.1, 0.9) / ifs::spectralNorm<2>(map.linear);
                maps.push_back(map);
                weights.push_back(between(0.1, 1));
                sum += weights.back();
            }
            for (double& weight : weights)
                weight /= sum;
            const double apart = (meanOf(maps, weights, density) - meanOf(density)).norm();
            const auto bound = measureBound(density, maps, weights);
            QVERIFY(bound && std::isfinite(*bound));
            QVERIFY2(*bound >= apart - 1e-9, qPrintable(QStringLiteral("%1: %2").arg(*bound).arg(apart)));
        }
    }

    // The invariant measure of one map is its fixed point: everything goes there.
    void boundOfMeasuresIsTight() {
        Density square{64, 64, std::vector<double>(64 * 64)};
        for (int y = 28; y < 36; ++y)
            for (int x = 4; x < 12; ++x)
                square.mass[std::size_t(y * 64 + x)] = 1;
        const double far = 0.9 * 64 - 8; // from its middle to the fixed point (0.4, 0)
        const WeightMaps one{ifs::affineMap(0.5, 0, 0, 0.5, 0.2, 0)};
        const auto bound = measureBound(square, one, std::vector<double>{1});
        QVERIFY(bound.value() >= far && *bound < 1.01 * far);
        const std::vector<double> weights{0.2, 0.3, 0.5};
        QVERIFY(measureBound(sierpinskiMeasure(weights), triangle, weights).value() < 1.5);
        const auto off =
            measureBound(sierpinskiMeasure(weights), triangle, std::vector<double>{0.21, 0.3, 0.49});
        QVERIFY(off.value() > 2.5 && *off < 5); // the means are 2.57 apart
    }

    void onlyTheMeanContractionCounts() {
        const Density density = sierpinskiMeasure({0.2, 0.3, 0.5});
        const WeightMaps maps{ifs::affineMap(0.4, 0, 0, 0.4, 0, 0.2), ifs::affineMap(1.2, 0, 0, 0.5, 0, 0)};
        QVERIFY(measureBound(density, maps, std::vector<double>{0.9, 0.1}).has_value());
        QVERIFY(!measureBound(density, maps, std::vector<double>{0.1, 0.9}).has_value());
        QVERIFY(!measureBound({4, 4, std::vector<double>(16)}, maps, std::vector<double>{0.9, 0.1}));
    }

    void aStopEndsTheFit() {
        std::stop_source source;
        const std::vector<double> weights{0.2, 0.3, 0.5};
        const Density density = sierpinskiMeasure(weights);
        QCOMPARE(fittedWeights(density, triangle, 2, source.get_token()).size(), std::size_t{3});
        QVERIFY(measureBound(density, triangle, weights, source.get_token()));
        source.request_stop();
        QVERIFY(fittedWeights(density, triangle, 2, source.get_token()).empty());
        QVERIFY(!measureBound(density, triangle, weights, source.get_token()));
    }

    void equalImagesShareTheirWeight() {
        const Eigen::MatrixXd q = Eigen::MatrixXd::Ones(3, 3);
        const Eigen::VectorXd p = simplexMinimum(q, Eigen::VectorXd::Ones(3));
        QVERIFY(support::near(p.sum(), 1, 1e-12) && p.minCoeff() >= 0);
    }
};

BARYCAGE_TEST(WeightFitTest);
#include "weight_fit_test.moc"
