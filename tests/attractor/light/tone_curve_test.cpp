// SPDX-License-Identifier: MIT
#include "attractor/light/tone_curve.h"

#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

using namespace attractor;

namespace {

Appearance look(double gamma, double contrast, double vibrancy) {
    Appearance result;
    result.gamma = gamma;
    result.contrast = contrast;
    result.vibrancy = vibrancy;
    return result;
}

} // namespace

class ToneCurveTest : public QObject {
    Q_OBJECT

private slots:
    void withoutContrastAndVibrancyNothingChanges() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> share(0, 1);
        for (int n = 0; n < 10'000; ++n) {
            const double v = share(random);
            QCOMPARE(std::bit_cast<std::uint64_t>(contrasted(v, 1)), std::bit_cast<std::uint64_t>(v));
            const Appearance plain = look(0.2 + 5 * share(random), 1, 1);
            QCOMPARE(std::bit_cast<std::uint64_t>(vibrant(v, plain)), std::bit_cast<std::uint64_t>(v));
            const double density = 20 * share(random);
            QCOMPARE(std::bit_cast<std::uint64_t>(tone(density, plain, 7)),
                     std::bit_cast<std::uint64_t>(tone(density, plain.brightness, 7, plain.gamma)));
        }
        QVERIFY(!VibrantCodes(look(2.2, 3, 1)).changesColours());
    }

    void contrastMultipliesTheLogit() {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> share(0, 1);
        for (int n = 0; n < 10'000; ++n) {
            const double v = share(random);
            const double c = std::exp(4 * share(random) - 2);
            const double a = std::pow(v, c), b = std::pow(1 - v, c);
            QVERIFY(std::abs(contrasted(v, c) - a / (a + b)) < 1e-13);
            if (c < 2 && v > 0.05 && v < 0.95) // elsewhere, 1 − v has lost its digits
                QVERIFY(std::abs(contrasted(contrasted(v, c), 1 / c) - v) < 1e-11);
            if (c > 1 && v > 0.001 && v < 0.999 && std::abs(v - 0.5) > 0.001)
                QVERIFY(std::abs(contrasted(v, c) - 0.5) > std::abs(v - 0.5)); // away from the middle
        }
        for (const double c : {0.2, 0.9, 2.0, 5.0}) {
            QCOMPARE(contrasted(0.5, c), 0.5);
            QVERIFY(std::abs((contrasted(0.5 + 1e-5, c) - contrasted(0.5 - 1e-5, c)) / 2e-5 - c) < 1e-6);
        }
    }

    // Also for numbers that only a file can hold.
    void contrastRisesBetweenZeroAndOne() {
        for (const double c : {1e-320, 1e-9, 0.2, 0.999, 1.001, 3.0, 77.0, 1e9, 1.7e308}) {
            QCOMPARE(contrasted(0, c), 0.0);
            QCOMPARE(contrasted(1, c), 1.0);
            double last = 0;
            for (int i = 1; i <= 4096; ++i) {
                const double v = contrasted(i / 4096.0, c);
                QVERIFY(v >= last - 1e-15 && v <= 1);
                last = v;
            }
        }
        QVERIFY(contrasted(0.51, 1.7e308) > 0.999 && contrasted(0.49, 1.7e308) < 0.001);
    }

    // With L the tone before its gamma, flam3's channels are ν α f + (1 − ν)(L f)^(1/γ), α = L^(1/γ).
    void vibrancyIsThatOfFlames() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(0, 1);
        for (int n = 0; n < 10'000; ++n) {
            const double gamma = 0.3 + 7 * share(random), vibrancy = share(random), f = share(random);
            const Appearance flame = look(gamma, 1, vibrancy);
            const double density = 7 * share(random);
            const double light =
                std::log(1 + flame.brightness * density) / std::log(1 + flame.brightness * 7);
            const double alpha = std::pow(light, 1 / gamma);
            const double channel = vibrancy * alpha * f + (1 - vibrancy) * std::pow(light * f, 1 / gamma);
            QVERIFY(std::abs(tone(density, flame, 7) * vibrant(f, flame) - channel) < 1e-11);
        }
        for (const double gamma : {1e-320, 0.5, 2.2, 1e300})
            for (const double vibrancy : {0.0, 0.4}) {
                QCOMPARE(vibrant(0, look(gamma, 1, vibrancy)), 0.0);
                QCOMPARE(vibrant(1, look(gamma, 1, vibrancy)), 1.0);
            }
    }

    void theTableIsRightToHalfALevel() {
        for (const double gamma : {0.5, 1.0, 2.2, 8.0})
            for (const double vibrancy : {0.0, 0.5, 0.999}) {
                const Appearance appearance = look(gamma, 1, vibrancy);
                const VibrantCodes codes(appearance);
                QVERIFY(codes.changesColours());
                double last = 0;
                for (int i = 0; i <= 50'000; ++i) {
                    const double light = std::pow(i / 50'000.0, 3);
                    const double code = codes(light);
                    QVERIFY(code >= last);
                    last = code;
                    if (light == 0 || light >= 0x1p-20)
                        QVERIFY(std::abs(code - 255 * vibrant(encodedFromLinear(light), appearance)) < 0.5);
                }
                QCOMPARE(codes(0), 0.0);
                QCOMPARE(codes(-1), 0.0);
                QCOMPARE(codes(1), 255.0);
                QCOMPARE(codes(1.001), 255.0);
            }
    }
};

BARYCAGE_TEST(ToneCurveTest);
#include "tone_curve_test.moc"
