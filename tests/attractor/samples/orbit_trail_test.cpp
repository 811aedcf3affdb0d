// SPDX-License-Identifier: MIT
#include "attractor/samples/orbit_trail.h"

#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>

using namespace attractor;

class TestOrbitTrail : public QObject {
    Q_OBJECT

private slots:
    void followsTheOrbitThatIsDrawn() {
        auto maple = systems::maple();
        maple.maps[1].enabled = false; // indices in the system, not among the maps that take part
        const PreparedSystem system = prepared(maple);
        Orbit orbit(system, 7);
        std::vector<Orbit::Point> drawn;
        for (int n = 0; n < 200; ++n)
            drawn.push_back(orbit.next());
        OrbitTrail trail(system, 7);
        for (const std::uint64_t plotted : {0, 1, 3, 8, 9, 150, 200, 40}) { // forwards and back
            const auto all = trail.after(Orbit::skipped + plotted);
            QCOMPARE(all.size(), std::size_t(Orbit::skipped + plotted));
            const auto points = all.subspan(Orbit::skipped); // the first jumps are not drawn
            for (std::size_t k = 0; k < points.size(); ++k) {
                const Orbit::Point& there = drawn[k];
                QVERIFY(points[k].x == there.x);
                QCOMPARE(points[k].map, system.index[there.lastMap]);
                QVERIFY(points[k].map != 1);
            }
        }
    }

    void everyJumpIsOneMap() {
        const auto fern = systems::fern();
        OrbitTrail trail(prepared(fern), 1);
        const auto points = trail.after(1000);
        for (std::size_t k = 1; k < points.size(); ++k)
            QVERIFY(fern.maps[points[k].map].map(points[k - 1].x).isApprox(points[k].x, 1e-12));
    }

    void onlySoManyAreKept() {
        const auto maple = systems::maple();
        OrbitTrail trail(prepared(maple), 3), other(prepared(maple), 3);
        QCOMPARE(trail.after(3).size(), std::size_t{3});
        const std::uint64_t many = 3 * OrbitTrail::longest + 17;
        for (std::uint64_t jumps = 1000; jumps < many; jumps += 777)
            trail.after(jumps);
        const auto newest = trail.after(many);
        QCOMPARE(newest.size(), OrbitTrail::longest);
        const auto atOnce = other.after(many);
        for (std::size_t k = 0; k < newest.size(); ++k)
            QVERIFY(newest[k].x == atOnce[k].x);
    }

    void nothingToDrawHasNoTrail() {
        OrbitTrail trail({}, 1);
        QVERIFY(trail.after(10).empty());
    }
};

BARYCAGE_TEST(TestOrbitTrail);
#include "orbit_trail_test.moc"
