// SPDX-License-Identifier: MIT
#include "document/edits/timeline/animation_edits.h"

#include "document/edits/key_frames.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/named_test.h"

#include <QtTest>

using namespace document;

namespace {

const Track cage{Track::Kind::Cage};
const Track first{Track::Kind::Map, {ifs::MapId(1)}};

// Keys of the cage at 0, 10 and 20, of the first map at 0 and 10; the length is 24.
Fractal animated() {
    Fractal fractal = withTiming(sierpinskiTriangle(), {{24, 1}, 24, animation::Loop::Off});
    for (const int frame : {10, 20})
        fractal = withKey(std::move(fractal), cage, frame, std::nullopt);
    return withKey(std::move(fractal), first, 10, std::nullopt);
}

} // namespace

class AnimationEditsTest : public QObject {
    Q_OBJECT

private slots:
    void rowsAreWhatCanMove();
    void keysHaveTheValueShown();
    void theCageOfAFreshSolidMoves();
    void theCameraInSpaceIsKeyedWithoutTheOrbit();
    void theLastKeyLeavesItsValue();
    void keysMoveWithinTheAnimation();
    void laterKeysComeAlong();
    void copiesLeaveTheirOriginals();
    void keysArePastedWhereTheyFit();
    void easesAreSet();
    void shorterAnimationsLoseKeys();
    void numbersOfMotionsAreChanged();
    void everyEditIsValid();
};

void AnimationEditsTest::numbersOfMotionsAreChanged() {
    using Kind = MotionNumber::Kind;
    const auto kinds = [](const Fractal& fractal, std::size_t motion) {
        std::vector<Kind> result;
        for (const MotionNumber& number : motionNumbers(fractal, motion))
            result.push_back(number.kind);
        return result;
    };
    Fractal entry = *withWind(sierpinskiTriangle(), animation::swayPresets()[0]);
    entry = *withOrbit(*withBreathing(entry));
    entry = *withPaletteCycle(entry);
    QCOMPARE(kinds(entry, 0), (std::vector{Kind::Degrees, Kind::Cycles, Kind::Cycles, Kind::Cycles}));
    QCOMPARE(kinds(entry, 1), (std::vector{Kind::Share, Kind::Cycles}));
    QCOMPARE(kinds(entry, 2), std::vector{Kind::Turns});
    QCOMPARE(kinds(entry, 3), std::vector{Kind::Turns});
    QVERIFY(motionNumbers(entry, 4).empty());
    QVERIFY(motionNumbers(sierpinskiTriangle(), 0).empty());
    for (std::size_t motion = 0; motion < 4; ++motion) {
        auto numbers = motionNumbers(entry, motion);
        QCOMPARE(withMotionNumbers(entry, motion, numbers), entry);
        for (MotionNumber& number : numbers)
            number.value = number.kind == Kind::Share ? -0.25 : 5;
        const Fractal changed = withMotionNumbers(entry, motion, numbers);
        QCOMPARE(motionNumbers(changed, motion), numbers);
        QVERIFY(animation::isValid<2>(*plane(changed)->animation));
        for (std::size_t other = 0; other < 4; ++other)
            if (other != motion) QCOMPARE(motionNumbers(changed, other), motionNumbers(entry, other));
        for (const double wrong : {1e9, numbers[0].kind == Kind::Turns ? 0.0 : -1e9}) {
            numbers[0].value = wrong;
            QCOMPARE(withMotionNumbers(entry, motion, numbers), entry);
        }
        numbers.pop_back();
        QCOMPARE(withMotionNumbers(entry, motion, numbers), entry);
    }
}

void AnimationEditsTest::rowsAreWhatCanMove() {
    const auto rows = tracksOf(sierpinskiTriangle());
    QCOMPARE(rows.size(), std::size_t(6)); // cage, three maps, look, camera
    QVERIFY(rows.front().track == cage && rows.back().track == Track{Track::Kind::Camera});
    for (const TrackKeys& row : rows)
        QVERIFY(row.keys.empty());
    QCOMPARE(timingOf(sierpinskiTriangle()), (Timing{{24, 1}, 48, animation::Loop::Off}));
    QVERIFY(tracksOf(Fractal()).empty()); // could not be read
    Fractal moved = animated();
    system2(moved)->maps[1].map.translation.x() += 1;
    moved.appearance.gamma = 3;
    QVERIFY(areTracksAlike(animated(), moved));
    for (const auto& change :
         {+[](Shape<2>& shape) { shape.animation.reset(); },
          +[](Shape<2>& shape) { shape.animation->length += 1; },
          +[](Shape<2>& shape) { std::swap(shape.system.maps[0], shape.system.maps[1]); },
          +[](Shape<2>& shape) { shape.system.maps.pop_back(); },
          +[](Shape<2>& shape) {
              shape.moved.push_back({{ifs::MapId(1)}, {}});
          },
          +[](Shape<2>& shape) { shape.animation->cage[1].ease.kind = animation::Ease::Kind::Hold; }}) {
        Fractal other = animated();
        change(*plane(other));
        QVERIFY(!areTracksAlike(animated(), other));
    }
    QVERIFY(areTracksAlike(Fractal(), Fractal()) && !areTracksAlike(Fractal(), moved));
    Fractal unread;
    QCOMPARE(withTiming(unread, {{24, 1}, 24, animation::Loop::Off}), unread);
}

// As of one in the plane, though no cage is stored.
void AnimationEditsTest::theCageOfAFreshSolidMoves() {
    Fractal solid;
    System3& system = solid.shape.emplace<Shape<3>>().system;
    for (int i = 0; i < 4; ++i) {
        ifs::AffineMap<3> half;
        half.linear = ifs::Matrix<3>::Identity() / 2;
        if (i > 0) half.translation[i - 1] = 1;
        ifs::append(system, half, 0.25);
    }
    QVERIFY(tracksOf(solid).front().track == cage);
    const auto shown = *spaceCage(solid);
    solid = withTiming(std::move(solid), {{24, 1}, 24, animation::Loop::Off});
    const Fractal keyed = withKey(solid, cage, 10, std::nullopt);
    QVERIFY(space(keyed)->cage && space(keyed)->cage->current == shown.current);
    QVERIFY(!keyFramesIn(keyed, cage).empty());
    QCOMPARE(space(frameAt(keyed, animation::moment(10)).fractal)->cage->current, shown.current);
}

void AnimationEditsTest::keysHaveTheValueShown() {
    const Fractal fractal = animated();
    QCOMPARE(keyFramesIn(fractal, cage), (std::vector<int>{0, 10, 20}));
    QCOMPARE(keyFramesIn(fractal, first), (std::vector<int>{0, 10}));
    const Fractal still = sierpinskiTriangle();
    for (const int frame : {0, 10, 20, 24}) { // at the keys and behind them, bit by bit
        const Fractal shown = frameAt(fractal, animation::moment(frame)).fractal;
        QCOMPARE(system2(shown)->maps, system2(still)->maps);
    }
    const attractor::View view{{1, 2}, 3};
    const Fractal seen = withKey(fractal, {Track::Kind::Camera}, 6, view);
    QCOMPARE(frameAt(seen, animation::moment(3)).view, std::optional(view));
    QCOMPARE(withKey(fractal, {Track::Kind::Camera}, 6, std::nullopt), fractal);
}

void AnimationEditsTest::theCameraInSpaceIsKeyedWithoutTheOrbit() {
    const Track camera{Track::Kind::Camera};
    Fractal entry;
    entry.shape.emplace<Shape<3>>();
    QVERIFY(tracksOf(entry).back().track == camera);
    attractor::OrbitCamera seen;
    seen.target = {1, 2, 3};
    seen.orientation = attractor::orbit(40, 20, 5);
    seen.height = 2.5;
    seen.fieldOfView = 55;
    seen.projection = attractor::OrbitCamera::Projection::Perspective;
    seen.size = {640, 480};
    attractor::OrbitCamera kept = seen;
    kept.size = {}; // of the window
    Fractal keyed = withKey(entry, camera, 12, seen);
    QCOMPARE(keyFramesIn(keyed, camera), (std::vector<int>{0, 12}));
    QVERIFY(frameAt(keyed, animation::moment(12)).camera == kept);
    QCOMPARE(withKey(entry, camera, 12, attractor::View()).shape, // of the plane
             withTiming(entry, timingOf(entry)).shape);
    QCOMPARE(keyFramesIn(withKey(animated(), camera, 12, seen), camera), std::vector<int>());

    space(entry)->animation.emplace().motions = {animation::Orbit<3>{1, {0, 0, 0}}};
    keyed = withKey(entry, camera, 12, seen);
    const AnimatedFrame frame = frameAt(keyed, animation::moment(12));
    QCOMPARE(frame.orbit.size(), std::size_t(1));
    QCOMPARE(frame.orbit.front().degrees, 90.0);
    const attractor::OrbitCamera again = animation::orbited(*frame.camera, frame.orbit);
    QVERIFY(again.orientation.angularDistance(seen.orientation) < 1e-12);
    QVERIFY((again.target - seen.target).norm() < 1e-12 && again.height == seen.height);
    QVERIFY(animation::isValid(*space(keyed)->animation));
}

void AnimationEditsTest::theLastKeyLeavesItsValue() {
    Fractal fractal = animated();
    auto& keys = plane(fractal)->animation->maps.front().keys;
    for (auto& key : keys)
        key.value.map = ifs::affineMap(0.25, 0, 0, 0.25, 1, 1);
    const std::vector<KeyAt> one{{first, 0}}, all{{first, 0}, {first, 10}};
    QCOMPARE(keyFramesIn(withoutKeys(fractal, one), first), std::vector<int>{10});
    const Fractal still = withoutKeys(fractal, all);
    QVERIFY(keyFramesIn(still, first).empty());
    QCOMPARE(system2(still)->maps[0].map, keys.front().value.map);
    for (const int frame : {0, 10})
        QCOMPARE(frameAt(still, animation::moment(frame)).fractal,
                 frameAt(fractal, animation::moment(frame)).fractal);
}

void AnimationEditsTest::keysMoveWithinTheAnimation() {
    const std::vector<KeyAt> keys{{cage, 10}, {first, 10}};
    const Fractal moved = withKeysMoved(animated(), keys, 5, KeyMove::Move);
    QCOMPARE(keyFramesIn(moved, cage), (std::vector<int>{0, 15, 20}));
    QCOMPARE(keyFramesIn(moved, first), (std::vector<int>{0, 15}));
    QCOMPARE(possibleMove(animated(), keys, 100, KeyMove::Move), 14);
    QCOMPARE(possibleMove(animated(), keys, -100, KeyMove::Move), -10);
    // What was at the new frame gives way.
    QCOMPARE(keyFramesIn(withKeysMoved(animated(), keys, 10, KeyMove::Move), cage),
             (std::vector<int>{0, 20}));
    QCOMPARE(withKeysMoved(animated(), {}, 5, KeyMove::Move), animated());
}

void AnimationEditsTest::laterKeysComeAlong() {
    const std::vector<KeyAt> keys{{cage, 10}};
    const Fractal moved = withKeysMoved(animated(), keys, 7, KeyMove::Ripple);
    QCOMPARE(keyFramesIn(moved, cage), (std::vector<int>{0, 17, 27}));
    QCOMPARE(keyFramesIn(moved, first), (std::vector<int>{0, 10})); // not of this track
    QCOMPARE(timingOf(moved).length, 27);
}

void AnimationEditsTest::copiesLeaveTheirOriginals() {
    const std::vector<KeyAt> keys{{cage, 0}, {cage, 10}};
    QCOMPARE(keyFramesIn(withKeysMoved(animated(), keys, 4, KeyMove::Copy), cage),
             (std::vector<int>{0, 4, 10, 14, 20}));
}

void AnimationEditsTest::keysArePastedWhereTheyFit() {
    const std::vector<KeyAt> keys{{cage, 10}, {cage, 20}, {first, 10}};
    const auto copied = copiedKeys(animated(), keys);
    QCOMPARE(copied.size(), std::size_t(3));
    const Pasted pasted = withKeysPasted(animated(), copied, 12);
    QCOMPARE(keyFramesIn(pasted.fractal, cage), (std::vector<int>{0, 10, 12, 20, 22}));
    QCOMPARE(keyFramesIn(pasted.fractal, first), (std::vector<int>{0, 10, 12}));
    QCOMPARE(pasted.keys.size(), std::size_t(3));
    QCOMPARE(withKeysPasted(animated(), copied, 20).keys.size(), std::size_t(2)); // one is behind the end
    Fractal square = sierpinskiTriangle();
    plane(square)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    plane(square)->system.maps.erase(plane(square)->system.maps.begin());
    QVERIFY(withKeysPasted(square, copied, 0).keys.empty()); // neither the cage nor the map
}

void AnimationEditsTest::easesAreSet() {
    const Fractal held = withEase(animated(), std::vector<KeyAt>{{cage, 10}}, {animation::Ease::Kind::Hold});
    const auto& keys = plane(held)->animation->cage;
    QVERIFY(keys[0].ease.kind == animation::Ease::Kind::Both);
    QVERIFY(keys[1].ease.kind == animation::Ease::Kind::Hold);
}

void AnimationEditsTest::shorterAnimationsLoseKeys() {
    const Fractal shorter = withTiming(animated(), {{30, 1}, 15, animation::Loop::Cycle});
    QCOMPARE(keyFramesIn(shorter, cage), (std::vector<int>{0, 10}));
    QCOMPARE(timingOf(shorter), (Timing{{30, 1}, 15, animation::Loop::Cycle}));
}

void AnimationEditsTest::everyEditIsValid() {
    const std::vector<KeyAt> keys{{cage, 0}, {cage, 10}, {first, 10}};
    for (const KeyMove how : {KeyMove::Move, KeyMove::Copy, KeyMove::Ripple})
        for (int by = -30; by <= 30; ++by)
            QVERIFY(animation::isValid(*plane(withKeysMoved(animated(), keys, by, how))->animation));
    QVERIFY(animation::isValid(*plane(withoutKeys(animated(), keys))->animation));
}

BARYCAGE_TEST(AnimationEditsTest);
#include "animation_edits_test.moc"
