// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/dimension/moments.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;
template <int Dim>
Moments<Dim> momentsOf(const std::vector<AffineMap<Dim>>& maps, const std::vector<double>& weights = {}) {
    return *moments(activeMaps(canonical::system<Dim>(maps, weights)));
}
const std::vector<double> equal2{1, 1}, equal3{1, 1, 1}, equal4{1, 1, 1, 1};

void compare(const Moments<2>& found, const Vector<2>& mean, const Vector<3>& covariance) {
    QVERIFY((found.mean - mean).norm() <= 1e-12);
    QVERIFY(near(found.covariance(0, 0), covariance[0], 1e-12));
    QVERIFY(near(found.covariance(0, 1), covariance[1], 1e-12));
    QVERIFY(near(found.covariance(1, 1), covariance[2], 1e-12));
    QVERIFY(found.covariance == found.covariance.transpose());
}
void compareLongRun(const Moments<2>& found, double xx, double yy) {
    QVERIFY(near(found.longRunCovariance(0, 0), xx, 1e-6));
    QVERIFY(near(found.longRunCovariance(1, 1), yy, 1e-6));
}

} // namespace

class MomentsTest : public QObject {
    Q_OBJECT

private slots:
    // Squares of lengths underflow there, lengths do not.
    void tinyUnits() {
        for (const int exponent : {-300, -520, -600, -900}) {
            const auto found =
                momentsOf<2>(canonical::scaled(sierpinskiRight(), std::ldexp(1, exponent)), equal3);
            const Vector<2> mean = Vector<2>::Constant(std::ldexp(1. / 3, exponent));
            QVERIFY(found.meanError < std::ldexp(1e-12, exponent));
            QVERIFY((found.mean - mean).cwiseAbs().maxCoeff() <=
                    found.meanError + std::ldexp(1e-16, exponent));
            const double variance = std::ldexp(2. / 27, 2 * exponent);
            QVERIFY(found.covarianceError > 0);
            QVERIFY(std::abs(found.covariance(0, 0) - variance) <= found.covarianceError + 1e-15 * variance);
        }
    }

    void knownSystems() {
        const auto sierpinski = momentsOf<2>(sierpinskiRight(), equal3);
        compare(sierpinski, {1. / 3, 1. / 3}, {2. / 27, -1. / 27, 2. / 27});
        compareLongRun(sierpinski, 2. / 9, 2. / 9);
        const auto arch = momentsOf<2>(flower(), equal2);
        compare(arch, {332. / 5513, 18321. / 5513},
                {2.331316928710777, -0.063195656056736, 0.264229082939687});
        compareLongRun(arch, 6.546792, 0.744559);
        const auto tree = momentsOf<2>(maple(), equal4);
        compare(tree, {5135. / 70583, 101021. / 70583},
                {1.070887446859971, -0.052426065183732, 3.782835052470806});
        compareLongRun(tree, 2.935123, 5.414467);
        const auto weighted = momentsOf<2>(maple());
        compare(weighted, {0.173497302602363578, 1.889554379976506070},
                {2.129005246374539, -0.386284423904886, 1.849609397423682});
        compareLongRun(weighted, 9.148866, 5.128550);
        const auto leaf = momentsOf<2>(fern(), fernWeights);
        compare(leaf, {2659956. / 3338159, 20588360. / 3338159},
                {1.436308769343536, 1.297831985967738, 6.249627702417141});
        compareLongRun(leaf, 10.425670, 45.059712);
        QVERIFY((momentsOf<2>(koch(), equal4).mean - Vector<2>(.5, std::sqrt(3) / 18)).norm() < 1e-14);
        QVERIFY((momentsOf<2>(levy(), equal2).mean - Vector<2>(.5, .5)).norm() < 1e-14);
        QVERIFY((momentsOf<2>(twin(), equal2).mean - Vector<2>(.5, 0)).norm() < 1e-14);
        const auto triangle = momentsOf<2>(halves({{0, 0}, {0, 1}, {1, 1}}), {.33, .33, .34});
        compare(triangle, {17. / 25, 67. / 50}, {187. / 625, 187. / 1250, 737. / 2500});
    }

    void fernInSpace() {
        const auto found = momentsOf<3>(fern3(), fernWeights);
        QVERIFY((found.mean - Vector<3>(0, 5.287747479916747, -1.908528814407318)).norm() < 1e-12);
        Matrix<3> expected;
        expected << .481030299090, 0, 0, 0, 4.704690336228, -2.701752081778, 0, -2.701752081778,
            2.053916212432;
        QVERIFY((found.covariance - expected).cwiseAbs().maxCoeff() < 1e-11);
    }

    // Not the covariance but the long-run covariance says how far a chaos-game average may be off.
    void chaosGameMean() {
        const auto code = activeMaps(canonical::system<2>(fern(), fernWeights));
        const auto exact = *moments(code);
        constexpr int count = 1'000'000;
        for (unsigned seed = 1; seed <= 5; ++seed) {
            Random random(seed);
            std::discrete_distribution<int> draw(code.probabilities.begin(), code.probabilities.end());
            Vector<2> x = exact.mean, sum(0, 0);
            for (int n = 0; n < count; ++n) {
                x = code.maps[std::size_t(draw(random))](x);
                sum += x;
            }
            for (int k = 0; k < 2; ++k)
                QVERIFY(near(sum[k] / count, exact.mean[k],
                             5 * std::sqrt(exact.longRunCovariance(k, k) / count)));
        }
    }

    void covariantUnderBaking() {
        Random random(1);
        for (int n = 0; n < 1000; ++n) {
            const auto code = canonical::system<2>(randomContractions<2>(random, 3), {1, 2, 3});
            const AffineMap<2> t{randomWellConditioned<2>(random), randomVector<2>(random)};
            const auto here = *moments(activeMaps(code)), there = *moments(activeMaps(*conjugate(t, code)));
            QVERIFY((there.mean - t(here.mean)).norm() <= 1e-10);
            QVERIFY((there.covariance - t.linear * here.covariance * t.linear.transpose()).norm() <= 1e-9);
        }
    }

    void noMoments() {
        QVERIFY(!moments(ActiveMaps<2>{}));
        QVERIFY(!moments(activeMaps(canonical::system<2>({affineMap(1, 0, 0, .5, 1, 1)}))));
        QVERIFY(!moments(activeMaps(canonical::system<2>({affineMap(quietNaN, 0, 0, .5, 1, 1)}))));
        QVERIFY(!moments(activeMaps(canonical::system<2>({affineMap(.5, 0, 0, .5, infinity, 1)}))));
        QVERIFY(!moments(activeMaps(canonical::system<2>({affineMap(1e200, 0, 0, .5, 1, 1)}))));
    }

    // x/4 and 3.2x + 1, 9 to 1: the mean map is 0.545 x + 0.1, but the mean of squares grows.
    void aMeanWithoutCovariance() {
        const auto code = activeMaps(
            canonical::system<2>({affineMap(.25, 0, 0, .5, 0, 0), affineMap(3.2, 0, 0, .5, 1, 4)}, {9, 1}));
        QVERIFY(!moments(code));
        QVERIFY((mean(code)->point - Vector<2>(.1 / .455, .8)).norm() < 1e-15);
        for (const auto& maps : {maple(), flower(), fern()}) {
            const auto active = activeMaps(canonical::system<2>(maps));
            QCOMPARE(mean(active)->point, moments(active)->mean);
        }
    }

    void noMean() {
        QVERIFY(!mean(ActiveMaps<2>{}));
        for (const auto& map : {affineMap(1, 0, 0, .5, 1, 1), affineMap(quietNaN, 0, 0, .5, 1, 1),
                                affineMap(.5, 0, 0, .5, infinity, 1), affineMap(1e200, 0, 0, .5, 1, 1)})
            QVERIFY(!mean(activeMaps(canonical::system<2>({map}))));
    }

    // Seen through an integer shear, whose maps are exact: their moments are the images of those here,
    // although coefficients of 1e8 and more cancel in them.
    void throughShears() {
        Random random(3);
        for (const double shear : {1., 100., 1e4})
            for (int n = 0; n < 25; ++n) {
                const auto dyadic = [&] { return std::round(uniform(random, -180, 180)) / 256; };
                Maps2 here, there;
                for (int i = 0; i < 3; ++i) {
                    here.push_back(
                        affineMap(dyadic(), dyadic() / 2, dyadic() / 2, dyadic(), dyadic(), dyadic()));
                    there.push_back(*conjugate(affineMap(1, shear, 0, 1, 0, 0), here.back()));
                }
                const auto known = moments(activeMaps(canonical::system<2>(here, equal3)));
                const auto found = moments(activeMaps(canonical::system<2>(there, equal3)));
                QCOMPARE(found.has_value(), known.has_value());
                if (!known) continue;
                Matrix<2> lean;
                lean << 1, shear, 0, 1;
                const Matrix<2> covariance = lean * known->covariance * lean.transpose();
                const double size = std::sqrt(covariance.trace());
                QVERIFY2(found->meanError < 1e-8 * size,
                         qPrintable(QStringLiteral("shear %1: %2").arg(shear).arg(found->meanError / size)));
                QVERIFY2(
                    found->covarianceError < (1e-9 + 1e-13 * shear * shear) * size * size,
                    qPrintable(
                        QStringLiteral("shear %1: %2").arg(shear).arg(found->covarianceError / size / size)));
                QVERIFY((found->mean - lean * known->mean).norm() <=
                        found->meanError + 2 * shear * known->meanError + 1e-15 * size);
                QVERIFY((found->covariance - covariance).cwiseAbs().maxCoeff() <=
                        found->covarianceError + 4 * shear * shear * known->covarianceError +
                            1e-15 * size * size);
            }
    }

    void aPointDoesNotSpread() {
        const auto found = momentsOf<2>({affineMap(.5, .1, 0, .3, 1, 2)});
        QVERIFY(found.covariance.norm() < 1e-15);
    }
};

BARYCAGE_TEST(MomentsTest);
#include "moments_test.moc"
