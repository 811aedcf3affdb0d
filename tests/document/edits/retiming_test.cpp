// SPDX-License-Identifier: MIT
#include "document/edits/timeline/retiming.h"

#include "document/edits/key_frames.h"
#include "document/edits/timeline/animation_edits.h"
#include "support/named_test.h"

#include <QtTest>

using namespace document;

// A range of frames that lasts longer or shorter.
class RetimingTest : public QObject {
    Q_OBJECT

private slots:
    void keysOfTheRangeSpread();
    void laterKeysKeepTheirDistance();
    void keysNeverMeet();
    void theWayBackIsExact();
    void nothingIsStretchedIntoNothing();
};

namespace {

const Track cageTrack{Track::Kind::Cage};
const Track mapTrack{Track::Kind::Map, {ifs::MapId(1)}};

// Keys of the cage at 0, 10, 20 and 30, of the first map at 0 and 15; the length is 40.
Fractal stretchable() {
    Fractal fractal = withTiming(sierpinskiTriangle(), {{24, 1}, 40, animation::Loop::Off});
    for (const int frame : {10, 20, 30})
        fractal = withKey(std::move(fractal), cageTrack, frame, std::nullopt);
    return withKey(std::move(fractal), mapTrack, 15, std::nullopt);
}

} // namespace

void RetimingTest::keysOfTheRangeSpread() {
    const auto slower = withKeysStretched(stretchable(), {0, 40, 80});
    QVERIFY(slower);
    QCOMPARE(keyFramesIn(*slower, cageTrack), (std::vector{0, 20, 40, 60}));
    QCOMPARE(keyFramesIn(*slower, mapTrack), (std::vector{0, 30}));
    QCOMPARE(timingOf(*slower).length, 80);
}

void RetimingTest::laterKeysKeepTheirDistance() {
    const auto part = withKeysStretched(stretchable(), {10, 20, 25});
    QVERIFY(part);
    QCOMPARE(keyFramesIn(*part, cageTrack), (std::vector{0, 10, 25, 35}));
    QCOMPARE(keyFramesIn(*part, mapTrack), (std::vector{0, 18})); // to whole frames
    QCOMPARE(timingOf(*part).length, 45);
}

void RetimingTest::keysNeverMeet() {
    QVERIFY(withKeysStretched(stretchable(), {0, 30, 3}));
    QVERIFY(!withKeysStretched(stretchable(), {0, 30, 1}));
}

void RetimingTest::theWayBackIsExact() {
    const Fractal before = stretchable();
    const auto slower = withKeysStretched(before, {10, 30, 70});
    QVERIFY(slower);
    QVERIFY(*withKeysStretched(*slower, {10, 70, 30}) == before);
}

void RetimingTest::nothingIsStretchedIntoNothing() {
    for (const Stretch& stretch : {Stretch{10, 10, 20}, Stretch{10, 20, 10}, Stretch{-1, 20, 30},
                                   Stretch{0, 40, animation::maxLength + 1}})
        QVERIFY(!withKeysStretched(stretchable(), stretch));
    QVERIFY(!withKeysStretched(sierpinskiTriangle(), {0, 10, 20}));
}

BARYCAGE_TEST(RetimingTest);
#include "retiming_test.moc"
