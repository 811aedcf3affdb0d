// SPDX-License-Identifier: MIT
#include "document/edits/timeline/motion_edits.h"

#include "animation/paths/camera_path.h"
#include "attractor/render/renderer.h"
#include "attractor/space_systems.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/edits/timeline/orbit_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "ifs/canonical_systems.h"
#include "support/fractals.h"
#include "support/late_stop.h"
#include "support/named_test.h"
#include "support/processor_timer.h"

#include <QtTest>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stop_token>
#include <thread>

using namespace document;

namespace {

Fractal movingMaple() {
    return support::fractalOf(canonical::system<2>(canonical::maple(), {0.25, 0.25, 0.25, 0.25}));
}

// A turned or mirrored copy in the middle of three pieces that are no similar copies.
Fractal flake(double degrees, bool mirrors) {
    const double turn = degrees * std::numbers::pi / 180, c = 0.4 * std::cos(turn), s = 0.4 * std::sin(turn);
    Shape<2> shape;
    ifs::append(shape.system, mirrors ? ifs::affineMap(c, s, s, -c, 0, 0) : ifs::affineMap(c, -s, s, c, 0, 0),
                0.4);
    for (const double angle : {0.1, 1.0, 3.0})
        ifs::append(shape.system, ifs::affineMap(0.2, 0, 0, 0.14, std::cos(angle), std::sin(angle)), 0.2);
    Fractal fractal;
    fractal.shape = std::move(shape);
    return fractal;
}

std::vector<std::uint32_t> picture(const Fractal& fractal, const attractor::View& view) {
    attractor::RenderRequest request = renderRequest(fractal, attractor::cameraOf(view, {96, 64}));
    request.samples = 1'000'000;
    return attractor::render(request).pixels;
}

// In decibels, of what is seen on white.
double likeness(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int shift = 0; shift < 24; shift += 8) {
            const auto onWhite = [&](std::uint32_t pixel) {
                return double((pixel >> shift) & 255U) + 255.0 - double(pixel >> 24U);
            };
            sum += std::pow(onWhite(a[i]) - onWhite(b[i]), 2);
        }
    return 10 * std::log10(255.0 * 255 * 3 * double(a.size()) / std::max(sum, 1e-9));
}

} // namespace

class MotionEditsTest : public QObject {
    Q_OBJECT

private slots:
    void loopsKeepTheirAttractorAndClose();
    void motionsKeepTheLoopOfKeys();
    void anOrbitTurnsAboutTheMiddle();
    void anOrbitLastsFiveSeconds();
    void axesLean();
    void nothingMovesWithoutMaps();
    void thePaletteIsSeen();
    void windSwaysAboutTheLowestPoint();
    void windIsGentleWhereCopiesHardlyShrink();
    void endlessZoomsEndWhereTheyBegan();
    void endlessZoomsTurnAndMirror_data();
    void endlessZoomsTurnAndMirror();
    void zoomsNeedACopyThatStandsClear();
    void whatTakesLongCanBeStopped();
};

void MotionEditsTest::loopsKeepTheirAttractorAndClose() {
    for (const Fractal& fractal : {sierpinskiTriangle(), movingMaple()}) {
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

// The turn of the main map adds up along a stem of many copies.
void MotionEditsTest::windIsGentleWhereCopiesHardlyShrink() {
    const auto strengthOn = [](double ratio) {
        Fractal fractal = sierpinskiTriangle();
        plane(fractal)->system.maps.front().map = ifs::affineMap(ratio, 0, 0, ratio, 0, 0.01);
        const auto moving = withWind(fractal, animation::swayPresets().front());
        return std::get<animation::Sway<2>>(plane(*moving)->animation->motions.front()).strength;
    };
    QCOMPARE(strengthOn(0.5), animation::swayPresets().front().strength);
    QCOMPARE(strengthOn(0.85), animation::swayPresets().front().strength); // as in a fern
    QVERIFY(strengthOn(0.965) < 0.4 * animation::swayPresets().front().strength);
    QVERIFY(strengthOn(0.965) > 0);
}

void MotionEditsTest::motionsKeepTheLoopOfKeys() {
    Fractal keyed = movingMaple();
    auto& animation = plane(keyed)->animation.emplace();
    animation.loop = animation::Loop::ThereAndBack;
    animation.look = {{0, lookOf(keyed), {}}};
    QVERIFY(animationFacts(*withOrbit(keyed))->loop == animation::Loop::ThereAndBack);
    QVERIFY(animationFacts(*withBreathing(keyed))->loop == animation::Loop::ThereAndBack);
}

void MotionEditsTest::thePaletteIsSeen() {
    Fractal solid = support::fractalOf(systems::menger());
    QVERIFY(solidColour(solid) == attractor::SolidColour::Plain);
    const Fractal cycled = *withPaletteCycle(solid);
    QVERIFY(solidColour(cycled) == attractor::SolidColour::Address);
    const auto paletteAt = [&](int frame) {
        return solidAppearance(frameAt(cycled, animation::moment(frame)).fractal).palette;
    };
    QVERIFY(!(paletteAt(0) == paletteAt(animationFacts(cycled)->length / 3)));
    solid.inSpace.colourBy = attractor::SolidColour::Height;
    QVERIFY(solidColour(*withPaletteCycle(solid)) == attractor::SolidColour::Height);
    Fractal flat = movingMaple();
    for (const auto& [before, after] : {std::pair{attractor::ColourBy::Map, attractor::ColourBy::Density},
                                        {attractor::ColourBy::Plain, attractor::ColourBy::Density},
                                        {attractor::ColourBy::Address, attractor::ColourBy::Address}}) {
        flat.appearance.colourBy = before;
        QVERIFY(withPaletteCycle(flat)->appearance.colourBy == after);
    }
}

// Beside the origin, where the box of the cage has another middle than that of the solid.
void MotionEditsTest::anOrbitTurnsAboutTheMiddle() {
    Fractal solid;
    Shape<3> shape{systems::menger()};
    const ifs::AffineMap<3> away{2 * ifs::Matrix<3>::Identity(), {5, -3, 2}};
    shape.system = *ifs::conjugate(away, shape.system);
    solid.shape = shape;
    const ifs::Vector<3> middle(6, -2, 3);
    const Fractal turning = *withOrbit(solid);
    const auto place = orbitPlace(turning, 0);
    QVERIFY(place && place->pivot == animation::OrbitPivot::Centre);
    QVERIFY((place->centre - middle).norm() < 1e-5);
    QVERIFY(place->axis == ifs::Vector<3>::UnitY());
    QVERIFY(orbitPlace(*withOrbit(solid, ifs::Vector<3>::UnitZ()), 0)->axis == ifs::Vector<3>::UnitZ());
    attractor::OrbitCamera camera;
    camera.size = {640, 480};
    camera.height = 4;
    camera.target = {5.5, -1, 4};
    const auto seen = toScreen(camera, place->centre).pixel;
    for (const int frame : {1, 17, 60, 119}) {
        const auto turns = frameAt(turning, animation::moment(frame)).orbit;
        QVERIFY((toScreen(animation::orbited(camera, turns), place->centre).pixel - seen).norm() < 1e-9);
    }
    // As it is displayed: by a cage that moves it.
    Fractal placed = solid;
    ifs::ControlCage<3> cage = *spaceCage(solid);
    for (auto& vertex : cage.current)
        vertex += ifs::Vector<3>(1, 1, 1);
    space(placed)->cage = cage;
    QVERIFY((orbitPlace(*withOrbit(placed), 0)->centre - middle - ifs::Vector<3>(1, 1, 1)).norm() < 1e-5);
    const OrbitPlace other{ifs::Vector<3>::UnitX(), animation::OrbitPivot::Target, {1, 2, 3}};
    const Fractal changed = withOrbitPlace(turning, 0, other);
    QVERIFY(orbitPlace(changed, 0) == other);
    QVERIFY(!frameAt(changed, animation::moment(7)).orbit.front().pivot);
    QCOMPARE(withOrbitPlace(turning, 0, {ifs::Vector<3>(1, 1, 0), other.pivot, {}}),
             turning); // no length of 1
    QCOMPARE(withOrbitPlace(turning, 1, other), turning);
    const Fractal flat = *withOrbit(sierpinskiTriangle());
    const auto flatPlace = orbitPlace(flat, 0);
    const auto box = displayedBox(flat);
    QVERIFY((flatPlace->centre.head<2>() - (box->min + box->max) / 2).norm() < 1e-12);
    QVERIFY(orbitPlace(withOrbitPlace(flat, 0, {{}, {}, {4, 5, 0}}), 0)->centre == ifs::Vector<3>(4, 5, 0));
}

// Unless the entry has a length already.
void MotionEditsTest::anOrbitLastsFiveSeconds() {
    Fractal solid = support::fractalOf(systems::menger());
    for (const Fractal& fractal : {solid, movingMaple()}) {
        const Timing timing = timingOf(*withOrbit(fractal));
        QCOMPARE(timing.length * timing.rate.seconds, 5 * timing.rate.frames);
        QCOMPARE(timingOf(*withOrbit(*withBreathing(fractal))).length, timingOf(fractal).length);
        QCOMPARE(timingOf(*withOrbit(withTiming(fractal, {{30, 1}, 33, {}}))).length, 33);
    }
}

void MotionEditsTest::axesLean() {
    QVERIFY(directionOf({1, 0, 77}) == ifs::Vector<3>::UnitY());
    QVERIFY((directionOf({1, 90, 0}) - ifs::Vector<3>::UnitZ()).norm() < 1e-15); // y, z, x in turn
    QVERIFY((directionOf({1, 90, 90}) - ifs::Vector<3>::UnitX()).norm() < 1e-15);
    QVERIFY((directionOf({0, 180, 0}) + ifs::Vector<3>::UnitX()).norm() < 1e-15);
    std::mt19937_64 random(3);
    std::normal_distribution<double> number;
    for (int i = 0; i < 200; ++i) {
        const auto direction = ifs::Vector<3>(number(random), number(random), number(random)).normalized();
        const LeaningAxis leaning = leaningAxisOf(direction);
        QVERIFY((directionOf(leaning) - direction).norm() < 1e-12);
        QVERIFY(std::min(leaning.lean, 180 - leaning.lean) < 54.8); // the nearest axis
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
    const auto moving = withWind(movingMaple(), animation::swayPresets()[0]);
    const auto& sway = std::get<animation::Sway<2>>(plane(*moving)->animation->motions.front());
    const Fractal still = movingMaple();
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

void MotionEditsTest::endlessZoomsTurnAndMirror_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<bool>("mirrors");
    QTest::addColumn<bool>("isUp");
    QTest::addColumn<double>("rotation");
    QTest::newRow("turned") << 40.0 << false << true << -40.0;
    QTest::newRow("turned, y down") << 40.0 << false << false << 40.0;
    QTest::newRow("clockwise") << -100.0 << false << true << 100.0;
    QTest::newRow("mirrored") << 40.0 << true << true << 0.0;
}

// The last picture is like the first one, and would not be without the turn.
void MotionEditsTest::endlessZoomsTurnAndMirror() {
    QFETCH(double, degrees);
    QFETCH(bool, mirrors);
    QFETCH(bool, isUp);
    QFETCH(double, rotation);
    const Fractal fractal = flake(degrees, mirrors);
    const auto zoom = withEndlessZoom(fractal, 1.5, isUp ? attractor::YAxis::Up : attractor::YAxis::Down);
    QVERIFY(zoom);
    QVERIFY(animation::isValid(*plane(*zoom)->animation));
    const auto& keys = plane(*zoom)->animation->camera;
    const attractor::View &from = keys[0].value, &to = keys[1].value;
    QVERIFY(to.centre == from.centre && from.centre.norm() < 1e-12);
    QVERIFY(std::abs(to.height / from.height - (mirrors ? 0.16 : 0.4)) < 1e-12);
    QVERIFY(std::abs(attractor::degreesOf(to.rotation) - rotation) < 1e-5);
    const double same = likeness(picture(fractal, from), picture(fractal, to));
    attractor::View wrong = to;
    wrong.rotation = attractor::rotationOf(rotation + 60);
    const double other = likeness(picture(fractal, from), picture(fractal, wrong));
    QVERIFY2(same > other + 6, qPrintable(QStringLiteral("%1 dB, %2 dB").arg(same).arg(other)));
    // In the middle the camera has gone half the way of both.
    const auto half = frameAt(*zoom, animation::moment(animationFacts(*zoom)->length / 2)).view;
    QVERIFY(half);
    QVERIFY(std::abs(attractor::degreesOf(half->rotation) - rotation / 2) < 1e-5);
    QVERIFY(std::abs(half->height - std::sqrt(from.height * to.height)) < 1e-9);
}

void MotionEditsTest::zoomsNeedACopyThatStandsClear() {
    QVERIFY(!withEndlessZoom(movingMaple(), 1, attractor::YAxis::Up)); // no map is a similarity
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
    const support::LateStop stop(std::chrono::milliseconds(300));
    const support::ProcessorTimer timer;
    QVERIFY(!withEndlessZoom(grid, 1, attractor::YAxis::Up, stop.token()));
    QVERIFY(stop.token().stop_requested());
    QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
    QVERIFY(!withWind(grid, animation::swayPresets()[2], stop.token()));
    QVERIFY(!withTurn(grid, stop.token()) && !withBreathing(grid, stop.token()));
}

BARYCAGE_TEST(MotionEditsTest);
#include "motion_edits_test.moc"
