// SPDX-License-Identifier: MIT
#include "document/edits/motion_edits.h"

#include "document/animated_fractal.h"
#include "document/fractal_geometry.h"
#include "ifs/canonical_systems.h"

#include <QtTest>

#include <chrono>
#include <stop_token>
#include <thread>

using namespace document;

namespace {

Fractal maple() {
    Fractal fractal;
    fractal.shape = Shape<2>{canonical::system<2>(canonical::maple(), {0.25, 0.25, 0.25, 0.25})};
    return fractal;
}

} // namespace

class MotionEditsTest : public QObject {
    Q_OBJECT

private slots:
    void loopsKeepTheirAttractorAndClose();
    void nothingMovesWithoutMaps();
    void windSwaysAboutTheLowestPoint();
    void endlessZoomsEndWhereTheyBegan();
    void zoomsNeedACopyThatStandsClear();
    void whatTakesLongCanBeStopped();
};

void MotionEditsTest::loopsKeepTheirAttractorAndClose() {
    for (const Fractal& fractal : {sierpinskiTriangle(), maple()}) {
        std::vector<std::optional<Fractal>> all{withTurn(fractal), withOrbit(fractal), withBreathing(fractal),
                                                withPaletteCycle(fractal)};
        for (const auto& preset : animation::swayPresets())
            all.push_back(withWind(fractal, preset));
        for (const auto& moving : all) {
            QVERIFY(moving);
            const auto facts = animationFacts(*moving);
            QVERIFY(facts->loop == animation::Loop::Cycle && facts->motions == 1);
            QVERIFY(animation::isValid(*plane(*moving)->animation));
            QVERIFY(!firstWithoutAttractor(*moving));
            const auto start = frameAt(*moving, animation::moment(0)).fractal;
            QCOMPARE(frameAt(*moving, animation::moment(facts->length)).fractal, start);
            QVERIFY(frameAt(*moving, animation::moment(facts->length / 3)).fractal != start);
        }
    }
}

void MotionEditsTest::nothingMovesWithoutMaps() {
    Fractal empty;
    empty.shape = Shape<2>();
    for (const Fractal& fractal : {Fractal(), empty}) {
        QVERIFY(!withTurn(fractal) && !withOrbit(fractal) && !withBreathing(fractal));
        QVERIFY(!withPaletteCycle(fractal) && !withWind(fractal, animation::swayPresets()[0]));
        QVERIFY(!withEndlessZoom(fractal, 1, attractor::YAxis::Up));
    }
}

void MotionEditsTest::windSwaysAboutTheLowestPoint() {
    const auto moving = withWind(maple(), animation::swayPresets()[0]);
    const auto& sway = std::get<animation::Sway<2>>(plane(*moving)->animation->motions.front());
    const Fractal still = maple();
    for (const auto& map : system2(still)->maps)
        QVERIFY(ifs::fixedPoint<2>(map.map)->y() >= sway.root.y());
}

void MotionEditsTest::endlessZoomsEndWhereTheyBegan() {
    const auto zoom = withEndlessZoom(sierpinskiTriangle(), 1.5, attractor::YAxis::Down);
    QVERIFY(zoom);
    const auto& keys = plane(*zoom)->animation->camera;
    QCOMPARE(keys.size(), std::size_t(2));
    const attractor::View &from = keys[0].value, &to = keys[1].value;
    QCOMPARE(to.height, from.height / 2); // all three maps halve
    QCOMPARE(from.centre, to.centre);
    QVERIFY(from.yAxis == attractor::YAxis::Down);
    // The last view sees one piece only: the corner's, and nothing of the other two, half a side away.
    const double reach = std::hypot(1, 1.5) * to.height / 2;
    QVERIFY(reach < 0.5);
    QVERIFY(reach > 0.45); // and is no smaller than it need be
    const Fractal triangle = sierpinskiTriangle();
    const auto* system = system2(triangle);
    bool isCorner = false;
    for (const auto& map : system->maps)
        isCorner = isCorner || (*ifs::fixedPoint<2>(map.map) - from.centre).norm() < 1e-12;
    QVERIFY(isCorner);
}

void MotionEditsTest::zoomsNeedACopyThatStandsClear() {
    QVERIFY(!withEndlessZoom(maple(), 1, attractor::YAxis::Up)); // every map turns or shears
    Fractal bent = sierpinskiTriangle();
    plane(bent)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    plane(bent)->cage->current[2] = {2, 2};
    QVERIFY(!withEndlessZoom(bent, 1, attractor::YAxis::Up));
    // Two halves that meet in the fixed point of a third map.
    Fractal interval;
    Shape<2> shape;
    ifs::append(shape.system, ifs::affineMap(0.5, 0, 0, 0.5, 0, 0), 0.5);
    ifs::append(shape.system, ifs::affineMap(0.75, 0, 0, 0.75, 0, 0), 0.5);
    interval.shape = shape;
    QVERIFY(!withEndlessZoom(interval, 1, attractor::YAxis::Up)); // both hold the same point
}

// Each of 1600 copies must be clear of all others: minutes, if nobody ends it.
void MotionEditsTest::whatTakesLongCanBeStopped() {
    Fractal grid;
    Shape<2> shape;
    for (int i = 0; i < 1600; ++i)
        ifs::append(shape.system, ifs::affineMap(0.02, 0, 0, 0.02, i % 40 / 40.0, i / 40 / 40.0), 1);
    grid.shape = std::move(shape);
    std::stop_source stop;
    std::jthread impatient([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop.request_stop();
    });
    QElapsedTimer timer;
    timer.start();
    QVERIFY(!withEndlessZoom(grid, 1, attractor::YAxis::Up, stop.get_token()));
    QVERIFY(stop.stop_requested());
    QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
    QVERIFY(!withWind(grid, animation::swayPresets()[2], stop.get_token()));
    QVERIFY(!withTurn(grid, stop.get_token()) && !withBreathing(grid, stop.get_token()));
}

QTEST_APPLESS_MAIN(MotionEditsTest)
#include "motion_edits_test.moc"
