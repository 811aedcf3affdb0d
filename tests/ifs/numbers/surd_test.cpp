// SPDX-License-Identifier: MIT
#include "ifs/numbers/surd.h"

#include "support/named_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using ifs::Surd;

class SurdTest : public QObject {
    Q_OBJECT

private slots:
    void fractionsAddUp() {
        const Surd third = Surd(1) / Surd(3);
        QVERIFY(third + third + third == Surd(1));
        QVERIFY((third + third + third - Surd(1)).isZero());
        QVERIFY(!(third == Surd::stored(1.0 / 3)));
        QCOMPARE(third.rounded(), 1.0 / 3);
        QVERIFY(Surd(2) / Surd(-4) == Surd(-1) / Surd(2));
    }
    void rootsAreExact() {
        const Surd three = Surd::root(3), golden = (Surd(1) + Surd::root(5)) / Surd(2);
        QVERIFY(three * three == Surd(3));
        QVERIFY(golden * golden == golden + Surd(1));
        QVERIFY(Surd(1) / golden == golden - Surd(1));
        QVERIFY(Surd::root(Surd(3) / Surd(4)) == three / Surd(2));
        QVERIFY(Surd::root(8) == Surd(2) * Surd::root(2));
        QVERIFY(Surd::root(9) == Surd(3));
        QVERIFY(Surd::root(2) * three == Surd::root(6));
        QVERIFY(Surd::root(0) == Surd());
        QVERIFY(!Surd::root(-1).hasValue());
        QCOMPARE(golden.rounded(), (1 + std::sqrt(5.0)) / 2);
    }
    // Random numbers of two fields, against long doubles.
    void signsAreThoseOfTheValues() {
        std::mt19937 random(7);
        std::uniform_int_distribution<std::int64_t> digits(-1'000'000, 1'000'000);
        for (int k = 0; k < 2000; ++k) {
            const std::int64_t p = digits(random), q = digits(random), under = k % 2 == 0 ? 2 : 7;
            const Surd number = Surd(p) + Surd(q) * Surd::root(under);
            const long double value = (long double)p + (long double)q * std::sqrt((long double)under);
            QCOMPARE(number.sign(), value < 0 ? -1 : value > 0 ? 1 : 0);
        }
        // 99² = 9801 = 2·70² + 1
        QCOMPARE((Surd(99) - Surd(70) * Surd::root(2)).sign(), 1);
        QCOMPARE((Surd(70) * Surd::root(2) - Surd(99)).sign(), -1);
    }
    void storedNumbersAreTheirBits() {
        QVERIFY(Surd::stored(0.375) == Surd(3) / Surd(8));
        QVERIFY(Surd::stored(-0.0) == Surd());
        QVERIFY(Surd::stored(0.1).hasValue());
        QVERIFY(!(Surd::stored(0.1) == Surd(1) / Surd(10)));
        for (const double number : {1e300, 1e-300, std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN()})
            QVERIFY2(!Surd::stored(number).hasValue(), qPrintable(QString::number(number)));
    }
    void decimalsAreAsWritten() {
        QVERIFY(Surd::decimal("0.1") == Surd(1) / Surd(10));
        QVERIFY(Surd::decimal(".25") == Surd(1) / Surd(4));
        QVERIFY(Surd::decimal("12e-2") == Surd(3) / Surd(25));
        QVERIFY(Surd::decimal("1.5E+2") == Surd(150));
        QVERIFY(!Surd::decimal("0.12345678901234567890123").hasValue());
        QVERIFY(!Surd::decimal("1e99").hasValue());
        QVERIFY(!Surd::decimal("1e999999999999").hasValue());
    }
    // Never a wrong number: none.
    void whatIsTooLongHasNoValue() {
        const Surd large(std::int64_t(1) << 60);
        QVERIFY(!(large * large).hasValue());
        QVERIFY(!(large * Surd::root(2) * (large * Surd::root(2))).hasValue());
        QVERIFY(!(Surd(1) / large / large).hasValue());
        QVERIFY(!(Surd::root(2) + Surd::root(3)).hasValue());
        QVERIFY(!((Surd::root(2) + Surd(1)) * Surd::root(3)).hasValue());
        QVERIFY(!(Surd(1) / Surd()).hasValue());
        QVERIFY(!(Surd::none() + Surd(1)).hasValue());
        QVERIFY(!(Surd::none() == Surd::none()));
        QVERIFY(!Surd::none().isZero());
    }
};

BARYCAGE_TEST(SurdTest, QCoreApplication);
#include "surd_test.moc"
