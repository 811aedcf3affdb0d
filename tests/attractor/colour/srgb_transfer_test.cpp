// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace attractor;

// The transfer function of IEC 61966-2-1.
class TestSrgbTransfer : public QObject {
    Q_OBJECT

private slots:
    void knownValues() {
        QCOMPARE(linearLight(0), 0.0);
        QCOMPARE(linearLight(255), 1.0);
        QVERIFY(std::abs(linearLight(10) - 10 / 255.0 / 12.92) < 1e-15); // on the straight part
        QVERIFY(std::abs(linearLight(128) - 0.2158605001138992) < 1e-12);
        QVERIFY(std::abs(linearFromEncoded(0.5) - 0.21404114048223255) < 1e-12);
        QVERIFY(std::abs(encodedFromLinear(0.5) - 0.7353569830524495) < 1e-12);
        QCOMPARE(encoded(0.5), std::uint8_t{188});
    }

    void asTheStandardHasIt() {
        for (int i = 0; i <= 1000; ++i) {
            const double x = i / 1000.0;
            const double linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
            QVERIFY(std::abs(linearFromEncoded(x) - linear) < 1e-12);
            const double code = x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            QVERIFY(std::abs(encodedFromLinear(x) - code) < 1e-12);
        }
    }

    void everyCodeComesBack() {
        for (int code = 0; code < 256; ++code) {
            QCOMPARE(encoded(linearLight(std::uint8_t(code))), std::uint8_t(code));
            QCOMPARE(linearLight(std::uint8_t(code)), linearFromEncoded(code / 255.0));
            if (code > 0) QVERIFY(linearLight(std::uint8_t(code)) > linearLight(std::uint8_t(code - 1)));
        }
    }

    // Half way between two codes in the encoded scale.
    void theNearestCodeIsTaken() {
        for (int code = 0; code < 255; ++code) {
            QCOMPARE(encoded(linearFromEncoded((code + 0.499) / 255)), std::uint8_t(code));
            QCOMPARE(encoded(linearFromEncoded((code + 0.501) / 255)), std::uint8_t(code + 1));
        }
    }

    void lightOutOfRangeIsClipped() {
        QCOMPARE(encoded(-1), std::uint8_t{0});
        QCOMPARE(encoded(7), std::uint8_t{255});
        QCOMPARE(encoded(HUGE_VAL), std::uint8_t{255});
    }
};

BARYCAGE_TEST(TestSrgbTransfer);
#include "srgb_transfer_test.moc"
