// SPDX-License-Identifier: MIT
#include "attractor/render/live_step.h"
#include "support/named_test.h"

#include <QTest>

#include <functional>

using attractor::LiveStep;

// The step while a hand moves, for pictures that take so long.
class LiveStepTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheFinestThatIsFluid_data();
    void findsTheFinestThatIsFluid();
    void doesNotStutter();
    void followsTheLoad();

private:
    using Cost = std::function<double(int step)>; // milliseconds
    static int late(LiveStep& step, int pictures, const Cost& cost) {
        int count = 0;
        for (int k = 0; k < pictures; ++k) {
            const double time = cost(step.pixels());
            count += time > LiveStep::fluid ? 1 : 0;
            step.took(time);
        }
        return count;
    }
};

void LiveStepTest::findsTheFinestThatIsFluid_data() {
    QTest::addColumn<double>("whole"); // at the full resolution
    QTest::addColumn<int>("step");
    QTest::newRow("fast") << 10.0 << 1;
    QTest::newRow("usual") << 40.0 << 2;
    QTest::newRow("slow") << 200.0 << 4;
    QTest::newRow("hopeless") << 1e5 << 8;
}

void LiveStepTest::findsTheFinestThatIsFluid() {
    QFETCH(const double, whole);
    QFETCH(const int, step);
    LiveStep live;
    late(live, 100, [&](int pixels) { return whole / (pixels * pixels); });
    QCOMPARE(live.pixels(), step);
}

// As a Menger sponge in a large window.
void LiveStepTest::doesNotStutter() {
    LiveStep live;
    const Cost sponge = [](int step) { return step == 1 ? 60.0 : 2.5; };
    QVERIFY(late(live, 1000, sponge) <= 10);
    QCOMPARE(live.pixels(), 2);
}

void LiveStepTest::followsTheLoad() {
    LiveStep live;
    late(live, 20, [](int step) { return 10.0 / (step * step); });
    QCOMPARE(live.pixels(), 1);
    late(live, 20, [](int step) { return 100.0 / (step * step); });
    QCOMPARE(live.pixels(), 4);
    late(live, 20, [](int step) { return 10.0 / (step * step); });
    QCOMPARE(live.pixels(), 1);
}

BARYCAGE_TEST(LiveStepTest, QCoreApplication);
#include "live_step_test.moc"
