// SPDX-License-Identifier: MIT
#include "attractor/noise.h"

#include "attractor/systems.h"

#include <QtTest>

using namespace attractor;

// How much noisier density pictures are than independent samples would make them; docs/testing.md, "Noise".
class TestNoise : public QObject {
    Q_OBJECT

private slots:
    void doesNotGrow_data() {
        QTest::addColumn<QString>("system");
        for (const char* name : {"fern", "maple", "dragon", "slow"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void doesNotGrow() {
        QFETCH(QString, system);
        RenderRequest request = systems::request(system == u"fern"     ? systems::fern()
                                                 : system == u"maple"  ? systems::maple()
                                                 : system == u"dragon" ? systems::dragon()
                                                                       : slow(),
                                                 1'000'000, 640, 400);
        const noise::Report report = noise::measured(request);
        QVERIFY2(report.pixels.worst > 0.05 && report.pixels.worst <= 1.5,
                 qPrintable(QString::number(report.pixels.worst)));
        QVERIFY2(report.tiles.worst > 0 && report.tiles.worst <= 1.5,
                 qPrintable(QString::number(report.tiles.worst)));
    }

private:
    // Long orbits that stay near where they are: a spiral with a likely map.
    static ifs::IteratedFunctionSystem<2> slow() {
        return systems::system({{{.9, -.25, .25, .9, 0, 0}, .85}, {{.2, 0, 0, .2, 1, 0}, .15}});
    }
};

QTEST_APPLESS_MAIN(TestNoise)
#include "noise_test.moc"
