// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "bench/orbit_bench.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>

// What the benchmark of an orbit measures.
class SpaceOrbitTest : public QObject {
    Q_OBJECT

private slots:
    void everyMoveIsPainted();
};

void SpaceOrbitTest::everyMoveIsPainted() {
    constexpr int moves = 40;
    const orbit_bench::Orbit orbit = orbit_bench::measure(systems::menger(), moves, {480, 270});
    QCOMPARE(orbit.milliseconds.size(), std::size_t(moves));
    QCOMPARE(orbit.steps.size(), std::size_t(moves));
    QVERIFY(*std::ranges::min_element(orbit.milliseconds) > 0.1); // none is taken for painted before it is
    QCOMPARE(orbit.steps.front(), 2);                             // of a drag that begins
}

BARYCAGE_TEST(SpaceOrbitTest, QApplication);
#include "space_orbit_test.moc"
