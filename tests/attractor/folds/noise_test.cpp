// SPDX-License-Identifier: MIT
#include "attractor/noise.h"

#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace attractor;

// How much noisier density pictures are than independent samples would make them; docs/testing.md, "Noise".
class TestNoise : public QObject {
    Q_OBJECT

private slots:
    void doesNotGrow_data() {
        QTest::addColumn<QString>("system");
        for (const char* name : {"fern", "maple", "dragon", "slow", "repeated"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void doesNotGrow() {
        QFETCH(QString, system);
        RenderRequest request = systems::request(system == u"fern"     ? systems::fern()
                                                 : system == u"maple"  ? systems::maple()
                                                 : system == u"dragon" ? systems::dragon()
                                                 : system == u"slow"   ? slow()
                                                                       : repeated(),
                                                 1'000'000, 640, 400);
        const noise::Report report = noise::measured(request);
        QVERIFY2(report.pixels.worst > 0.05 && report.pixels.worst <= 1.5,
                 qPrintable(QString::number(report.pixels.worst)));
        QVERIFY2(report.tiles.worst > 0 && report.tiles.worst <= 1.5,
                 qPrintable(QString::number(report.tiles.worst)));
    }

private:
    // One map six times, and others twice, as at an end of a morph.
    static ifs::IteratedFunctionSystem<2> repeated() {
        ifs::IteratedFunctionSystem<2> result;
        for (int i = 0; i < 6; ++i) {
            const double along = std::numbers::pi / 3 * i;
            ifs::append<2>(result, ifs::affineMap(.346, -.2, .2, .346, 0, 0), .033);
            for (const double weight : {.09, .043})
                ifs::append<2>(result,
                               ifs::affineMap(.32, 0, 0, .32, .68 * std::cos(along),
                                              .68 * std::cos(along - std::numbers::pi / 2)),
                               weight);
        }
        return result;
    }
    // Long orbits that stay near where they are: a spiral with a likely map.
    static ifs::IteratedFunctionSystem<2> slow() {
        return systems::system({{{.9, -.25, .25, .9, 0, 0}, .85}, {{.2, 0, 0, .2, 1, 0}, .15}});
    }
};

BARYCAGE_TEST(TestNoise);
#include "noise_test.moc"
