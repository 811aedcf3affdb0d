// SPDX-License-Identifier: MIT
#include "attractor/arithmetic/arithmetic.h"
#include "attractor/arithmetic/double_double.h"
#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace attractor;

class TestArithmetic : public QObject {
    Q_OBJECT

private slots:
    void agreesWithTheMathLibrary() {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> exponents(-250, 250);
        std::uniform_real_distribution<double> powers(0.1, 4);
        for (int n = 0; n < 20000; ++n) {
            const double x = std::pow(10.0, exponents(random));
            QVERIFY(std::abs(naturalLogarithm(x) - std::log(x)) <= 4e-15 * (1 + std::abs(std::log(x))));
            const double y = exponents(random);
            QVERIFY(std::abs(exponential(y) / std::exp(y) - 1) <= 1e-13);
            const double base = std::exp(y / 100);
            const double exponent = powers(random);
            QVERIFY(std::abs(power(base, exponent) / std::pow(base, exponent) - 1) <= 1e-13);
        }
        QCOMPARE(power(0, 2), 0.0);
        QCOMPARE(naturalLogarithm(1), 0.0);
        QCOMPARE(exponential(0), 1.0);
    }

    void anglesAgreeWithTheMathLibrary() {
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> angles(-1000, 1000);
        for (int n = 0; n < 20000; ++n) {
            const double angle = angles(random);
            QVERIFY(std::abs(sineOfDegrees(angle) - std::sin(angle * (M_PI / 180))) < 4e-15);
            QVERIFY(std::abs(cosineOfDegrees(angle) - std::cos(angle * (M_PI / 180))) < 4e-15);
        }
        for (int quarter = -8; quarter <= 8; ++quarter) {
            QCOMPARE(sineOfDegrees(90.0 * quarter), double((quarter & 1) == 0   ? 0
                                                           : (quarter & 2) == 0 ? 1
                                                                                : -1));
            QCOMPARE(cosineOfDegrees(90.0 * quarter), sineOfDegrees(90.0 * (quarter + 1)));
        }
        QCOMPARE(sineOfDegrees(HUGE_VAL), 0.0);
    }

    void codeValuesSurviveLinearLight() {
        for (int code = 0; code < 256; ++code)
            QCOMPARE(int(encoded(linearLight(static_cast<std::uint8_t>(code)))), code);
        QVERIFY(std::abs(linearLight(188) - 0.5029) < 5e-4);
    }

    void doubleDoubleKeepsWhatDoublesLose() {
        const DoubleDouble third = DoubleDouble(1.0 / 3) + DoubleDouble(0x1.5555555555555p-56);
        const DoubleDouble one = third * DoubleDouble(3.0);
        QVERIFY(std::abs(static_cast<double>(one - DoubleDouble(1.0))) < 1e-31);
        const DoubleDouble sum = (DoubleDouble(1e16) + DoubleDouble(1e-10)) - DoubleDouble(1e16);
        QVERIFY(std::abs(static_cast<double>(sum) - 1e-10) < 1e-22);
    }
};

BARYCAGE_TEST(TestArithmetic);
#include "arithmetic_test.moc"
