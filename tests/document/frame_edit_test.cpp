// SPDX-License-Identifier: MIT
#include "document/moments/frame_edit.h"

#include "animation/motions/motion_presets.h"
#include "document/document.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/moments/animated_fractal.h"
#include "document/moments/motion_paths.h"
#include "support/named_test.h"

#include <QtTest>

#include <memory>

using namespace document;

namespace {

constexpr int length = 24;

// A triangle with a cage; nothing moves yet.
Fractal still() {
    Fractal fractal = sierpinskiTriangle();
    Shape<2>& shape = *plane(fractal);
    shape.cage = canonicalCage(fractal);
    shape.animation.emplace();
    shape.animation->length = length;
    return fractal;
}

Fractal keyed(Fractal entry, const Track& track, int frame) {
    return withKey(std::move(entry), track, frame, std::nullopt);
}

const animation::Animation<2>& animationOf(const Fractal& fractal) {
    return *plane(fractal)->animation;
}

// What `change` does to what is shown at this frame.
template <class Change> FrameEdit edited(const Fractal& entry, int frame, Change change) {
    const animation::Moment at = animation::moment(frame);
    const Fractal before = frameAt(entry, at).fractal;
    Fractal after = before;
    change(after);
    return withFrameEdited(entry, at, before, after);
}

void moveVertex(Fractal& fractal) {
    plane(fractal)->cage->current[1] += ifs::Vector<2>(0.25, 0.5);
}

void shrinkMap(Fractal& fractal) {
    plane(fractal)->system.maps[1].map = ifs::affineMap(0.25, 0, 0, 0.25, 0.5, 0);
}

} // namespace

class FrameEditTest : public QObject {
    Q_OBJECT

private slots:
    void whatHasNoKeysChangesForAllTimes();
    void whatHasKeysGetsOne();
    void theFirstKeyKeepsTheStart();
    void nothingChangesNothing();
    void motionsAreUndone();
    void orbitsAreUndone();
    void weightsAloneLeaveTheMap();
    void mapsThatGoTakeTheirTracks();
    void anotherCageLosesItsKeys();
    void branchesAreKeyed();
    void branchesThatChangeInsideThemselvesAreKeyed();
    void looksAreKeyed();
    void inSpaceAsInThePlane();
    void looksInSpaceAreKeyed();
    void theCameraInSpaceIsThatOfTheFrame();
    void dragsBecomeKeys();
    void dragsGoOnWhileTimeRuns();
    void stepsNameTheFrame();
    void timeIsNoStepOfTheHistory();
    void pathsGoThroughTheKeys();
    void smoothPathsBend();
};

void FrameEditTest::whatHasNoKeysChangesForAllTimes() {
    const Fractal entry = keyed(still(), {Track::Kind::Look}, 0);
    const FrameEdit edit = edited(entry, 7, moveVertex);
    QVERIFY(!edit.isKeyed);
    Fractal expected = entry;
    moveVertex(expected);
    QCOMPARE(edit.fractal, expected);
}

void FrameEditTest::whatHasKeysGetsOne() {
    const Fractal entry = keyed(still(), {Track::Kind::Cage}, 0);
    const FrameEdit edit = edited(entry, 7, moveVertex);
    QVERIFY(edit.isKeyed);
    QCOMPARE(edit.frame, 7);
    QCOMPARE(animationOf(edit.fractal).cage.size(), std::size_t(2));
    QCOMPARE(plane(edit.fractal)->cage, plane(entry)->cage); // what is still stays
    Fractal wanted = frameAt(entry, animation::moment(7)).fractal;
    moveVertex(wanted);
    QCOMPARE(frameAt(edit.fractal, animation::moment(7)).fractal, wanted); // exactly as it was dropped
    QCOMPARE(frameAt(edit.fractal, animation::moment(0)).fractal,
             frameAt(entry, animation::moment(0)).fractal);
}

void FrameEditTest::theFirstKeyKeepsTheStart() {
    const Track map{Track::Kind::Map, {ifs::MapId(2)}};
    const Fractal entry = keyed(still(), map, 12);
    QCOMPARE(animationOf(entry).maps.front().keys.size(), std::size_t(2));
    const FrameEdit edit = edited(entry, 12, shrinkMap);
    QCOMPARE(animationOf(edit.fractal).maps.front().keys.size(), std::size_t(2));
    QCOMPARE(frameAt(edit.fractal, animation::moment(0)).fractal,
             frameAt(entry, animation::moment(0)).fractal);
    const double middle =
        system2(frameAt(edit.fractal, animation::moment(6)).fractal)->maps[1].map.linear(0, 0);
    QVERIFY(middle > 0.25 && middle < 0.5);
}

void FrameEditTest::nothingChangesNothing() {
    Fractal entry = keyed(keyed(still(), {Track::Kind::Cage}, 9), {Track::Kind::Map, {ifs::MapId(1)}}, 3);
    plane(entry)->animation->motions = {animation::swayOf<2>(animation::swayPresets()[1], {}, {0, 0}),
                                        animation::Orbit<2>{}, animation::PaletteCycle{}};
    for (int frame = 0; frame <= length; ++frame) {
        const FrameEdit edit = edited(entry, frame, [](Fractal&) {});
        QVERIFY(!edit.isKeyed);
        QCOMPARE(edit.fractal, entry); // bit by bit
    }
}

void FrameEditTest::motionsAreUndone() {
    Fractal entry = still();
    plane(entry)->animation->motions = {animation::swayOf<2>(animation::swayPresets()[2], {}, {0.1, 0.2}),
                                        animation::Breathe<2>{{}, 0.2}};
    const FrameEdit edit = edited(entry, 5, shrinkMap);
    QVERIFY(!edit.isKeyed);
    Fractal wanted = frameAt(entry, animation::moment(5)).fractal;
    shrinkMap(wanted);
    const auto shown = system2(frameAt(edit.fractal, animation::moment(5)).fractal)->maps;
    QVERIFY((shown[1].map.linear - system2(wanted)->maps[1].map.linear).norm() < 1e-14);
    QVERIFY((shown[1].map.translation - system2(wanted)->maps[1].map.translation).norm() < 1e-14);
    QCOMPARE(shown[0], system2(wanted)->maps[0]);
    QCOMPARE(system2(edit.fractal)->maps[2], system2(entry)->maps[2]);
}

void FrameEditTest::orbitsAreUndone() {
    Fractal entry = still();
    plane(entry)->cage.reset(); // the canonical one, until something is moved
    plane(entry)->animation->motions = {animation::Orbit<2>{1, {1, 1}}};
    QCOMPARE(edited(entry, 6, shrinkMap).fractal.shape.index(), std::size_t(1));
    QVERIFY(!plane(edited(entry, 6, shrinkMap).fractal)->cage);
    const FrameEdit edit = edited(entry, 6, moveVertex);
    const auto frame = frameAt(edit.fractal, animation::moment(6)).fractal;
    Fractal wanted = frameAt(entry, animation::moment(6)).fractal;
    moveVertex(wanted);
    for (int i = 0; i < 3; ++i)
        QVERIFY((cage2(frame)->current[i] - cage2(wanted)->current[i]).norm() < 1e-12);
}

void FrameEditTest::weightsAloneLeaveTheMap() {
    Fractal entry = keyed(still(), {Track::Kind::Map, {ifs::MapId(1)}}, 0);
    plane(entry)->animation->motions = {animation::Turn<2>{{}, 1, {0, 0}}};
    const FrameEdit edit =
        edited(entry, 5, [](Fractal& shown) { plane(shown)->system.maps[0].weight = 0.125; });
    const auto& keys = animationOf(edit.fractal).maps.front().keys;
    QCOMPARE(keys.size(), std::size_t(2));
    QCOMPARE(keys[1].value.weight, std::optional(0.125));
    QCOMPARE(keys[1].value.map, keys[0].value.map); // not turned
}

void FrameEditTest::mapsThatGoTakeTheirTracks() {
    Fractal entry = keyed(still(), {Track::Kind::Map, {ifs::MapId(2)}}, 4);
    entry = keyed(entry, {Track::Kind::Map, {ifs::MapId(1)}}, 4);
    plane(entry)->animation->motions = {animation::Turn<2>{{ifs::MapId(2)}, 1, {0, 0}}};
    const FrameEdit edit = edited(entry, 4, [](Fractal& shown) {
        plane(shown)->system.maps.erase(plane(shown)->system.maps.begin() + 1);
    });
    QCOMPARE(animationOf(edit.fractal).maps.size(), std::size_t(1));
    QCOMPARE(animationOf(edit.fractal).maps.front().map, ifs::MapId(1));
    QVERIFY(animationOf(edit.fractal).motions.empty()); // it does not fall upon all other maps
}

void FrameEditTest::anotherCageLosesItsKeys() {
    const Fractal entry = keyed(still(), {Track::Kind::Cage}, 4);
    const FrameEdit edit = edited(entry, 4, [](Fractal& shown) {
        plane(shown)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    });
    QVERIFY(animationOf(edit.fractal).cage.empty());
    QCOMPARE(cage2(edit.fractal)->rest.size(), std::size_t(4));
}

void FrameEditTest::branchesAreKeyed() {
    Fractal entry = still();
    const std::vector<ifs::MapId> word{ifs::MapId(1), ifs::MapId(3)};
    plane(entry)->moved = {{word, ifs::affineMap(1, 0, 0, 1, 0.125, 0)}};
    entry = keyed(entry, {Track::Kind::Branch, word}, 8);
    QCOMPARE(animationOf(entry).branches.front().keys.size(), std::size_t(2));
    const FrameEdit edit =
        edited(entry, 8, [](Fractal& shown) { plane(shown)->moved[0].change.translation.x() = 0.5; });
    QCOMPARE(animationOf(edit.fractal).branches.front().keys[1].value.translation.x(), 0.5);
    QCOMPARE(plane(edit.fractal)->moved, plane(entry)->moved);
    const FrameEdit put = edited(entry, 8, [](Fractal& shown) { plane(shown)->moved.clear(); });
    QVERIFY(animationOf(put.fractal).branches.empty() && plane(put.fractal)->moved.empty());
}

void FrameEditTest::branchesThatChangeInsideThemselvesAreKeyed() {
    Fractal entry = still();
    const std::vector<ifs::MapId> address{ifs::MapId(1)}, word = recurringWord(address);
    plane(entry)->moved = {{address, ifs::affineMap(1, 0, 0, 1, 0.125, 0)},
                           {word, ifs::affineMap(1, 0, 0, 1, 0.25, 0)}};
    entry = keyed(entry, {Track::Kind::Branch, word}, 8);
    const FrameEdit edit =
        edited(entry, 8, [](Fractal& shown) { plane(shown)->moved[1].change.translation.x() = 0.5; });
    QCOMPARE(animationOf(edit.fractal).branches.size(), std::size_t(1));
    QCOMPARE(animationOf(edit.fractal).branches.front().word, word);
    QCOMPARE(animationOf(edit.fractal).branches.front().keys[1].value.translation.x(), 0.5);
    const auto without = [&](std::ptrdiff_t map) {
        return edited(entry, 8,
                      [map](Fractal& shown) {
                          auto& maps = plane(shown)->system.maps;
                          maps.erase(maps.begin() + map);
                      })
            .fractal;
    };
    QCOMPARE(animationOf(without(1)).branches.size(), std::size_t(1));
    QVERIFY(animationOf(without(0)).branches.empty());
}

void FrameEditTest::looksAreKeyed() {
    Fractal entry = keyed(still(), {Track::Kind::Look}, 0);
    plane(entry)->animation->motions = {animation::PaletteCycle{}};
    const FrameEdit edit = edited(entry, 6, [](Fractal& shown) {
        shown.appearance.gamma = 3;
        shown.appearance.mapColours[ifs::MapId(1)] = {1, 2, 3, 255};
    });
    const auto& keys = animationOf(edit.fractal).look;
    QCOMPARE(keys.size(), std::size_t(2));
    QCOMPARE(keys[1].value.gamma, 3.0);
    QVERIFY(keys[1].value.palette == keys[0].value.palette); // not gone round
    QCOMPARE(edit.fractal.appearance.gamma, entry.appearance.gamma);
    QVERIFY(!(edit.fractal.appearance.mapColours == entry.appearance.mapColours)); // these have no keys
}

void FrameEditTest::inSpaceAsInThePlane() {
    Shape<3> shape;
    ifs::AffineMap<3> half{0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>::Zero()};
    ifs::append(shape.system, half, 0.5);
    half.translation.x() = 1;
    ifs::append(shape.system, half, 0.5);
    shape.animation.emplace();
    Fractal entry;
    entry.shape = shape;
    entry = withKey(entry, {Track::Kind::Map, {ifs::MapId(2)}}, 10, std::nullopt);
    const FrameEdit edit =
        edited(entry, 10, [](Fractal& shown) { space(shown)->system.maps[1].map.translation.z() = 2; });
    QVERIFY(edit.isKeyed);
    QCOMPARE(system3(frameAt(edit.fractal, animation::moment(10)).fractal)->maps[1].map.translation.z(), 2.0);
    QCOMPARE(system3(frameAt(edit.fractal, animation::moment(0)).fractal)->maps[1].map.translation.z(), 0.0);
}

void FrameEditTest::looksInSpaceAreKeyed() {
    Shape<3> shape;
    ifs::append<3>(shape.system, {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(1, 0, 0)}, 1);
    shape.animation.emplace().length = length;
    Fractal entry;
    entry.shape = shape;
    const auto dim = [](Fractal& shown) { shown.inSpace.fog = 3; };
    const auto fogAt = [](const Fractal& fractal, int frame) {
        return frameAt(fractal, animation::moment(frame)).fractal.inSpace.fog;
    };
    const FrameEdit forAll = edited(entry, 10, dim); // no keys: for all times
    QVERIFY(!forAll.isKeyed);
    QCOMPARE(fogAt(forAll.fractal, 0), 3.0);
    const Fractal track = withKey(entry, {Track::Kind::Look}, 0, std::nullopt);
    const FrameEdit later = edited(track, 10, dim);
    QVERIFY(later.isKeyed);
    QCOMPARE(fogAt(later.fractal, 0), 0.0);
    QVERIFY(fogAt(later.fractal, 5) > 0 && fogAt(later.fractal, 5) < 3);
    QCOMPARE(fogAt(later.fractal, 10), 3.0);
    QCOMPARE(later.fractal.inSpace, entry.inSpace);
    // The last keys leave what the first of them had.
    const Fractal without =
        withoutKeys(later.fractal, std::vector<KeyAt>{{{Track::Kind::Look}, 0}, {{Track::Kind::Look}, 10}});
    QCOMPARE(without.inSpace.fog, 0.0);
    // What is copied in space has no place in the plane.
    const auto copied = copiedKeys(later.fractal, std::vector<KeyAt>{{{Track::Kind::Look}, 10}});
    const Pasted pasted = withKeysPasted(still(), copied, 3);
    QCOMPARE(pasted.keys.size(), std::size_t(1));
    QVERIFY(animation::isValid(animationOf(pasted.fractal)));
}

void FrameEditTest::theCameraInSpaceIsThatOfTheFrame() {
    Shape<3> shape;
    ifs::append<3>(shape.system, {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(1, 0, 0)}, 1);
    animation::Animation<3>& moving = shape.animation.emplace();
    moving.length = length;
    attractor::OrbitCamera near, far;
    near.target = {1, 0, 0};
    far.height = 8;
    far.orientation = attractor::orbit(70, 10);
    moving.camera = {{0, near, {}}, {length, far, {}}};
    moving.motions = {animation::Orbit<3>{1, {0, 0, 0}}};
    const animation::Animation<3> stored = moving;
    Fractal entry;
    entry.shape = shape;
    Document document;
    QVERIFY(!document.camera());
    document.editEntry(QStringLiteral("start"), entry);
    for (const int frame : {0, 7, length}) {
        document.setMoment(animation::moment(frame));
        const animation::Pose<3> pose = stored.at(animation::moment(frame), {shape.system});
        QVERIFY(document.camera() == pose.camera);
        QCOMPARE(document.orbit(), pose.orbit);
        QVERIFY(!document.view());
    }
    QVERIFY(document.camera() == far);
    document.undoStack()->undo();
    QVERIFY(!document.camera());
}

void FrameEditTest::dragsBecomeKeys() {
    Document document;
    document.editEntry(QStringLiteral("start"), keyed(still(), {Track::Kind::Cage}, 0));
    const Fractal stored = document.entryFractal();
    document.setMoment(animation::moment(12));
    EditGesture gesture = document.beginGesture(QStringLiteral("Move vertex 2"));
    for (int i = 0; i < 3; ++i) {
        Fractal after = gesture.before();
        moveVertex(after);
        plane(after)->cage->current[2].x() += i;
        gesture.preview(after);
        QCOMPARE(document.fractal(), after); // what is dragged is seen
    }
    gesture.commit();
    QCOMPARE(document.undoStack()->count(), 2);
    QCOMPARE(animationOf(document.entryFractal()).cage.size(), std::size_t(2));
    document.undoStack()->undo();
    QCOMPARE(document.entryFractal(), stored);
    QCOMPARE(document.moment(), animation::moment(12)); // time is not undone

    EditGesture given = document.beginGesture(QStringLiteral("given up"));
    Fractal after = given.before();
    moveVertex(after);
    given.preview(after);
    QVERIFY(document.isModified());
    given.cancel();
    QCOMPARE(document.entryFractal(), stored);
}

void FrameEditTest::dragsGoOnWhileTimeRuns() {
    Document document;
    document.editEntry(QStringLiteral("start"), keyed(still(), {Track::Kind::Cage}, 0));
    document.setMoment(animation::moment(4), Document::Pace::Running);
    EditGesture gesture = document.beginGesture(QStringLiteral("Move vertex 2"));
    Fractal after = gesture.before();
    moveVertex(after);
    gesture.preview(after);
    document.setMoment(animation::moment(9), Document::Pace::Running);
    gesture.preview(after);
    gesture.commit();
    const auto& keys = animationOf(document.entryFractal()).cage;
    QCOMPARE(keys.size(), std::size_t(2));
    QCOMPARE(keys[1].frame, 4); // where it was pressed
    document.setMoment(animation::moment(4));
    QCOMPARE(cage2(document.fractal())->current, plane(after)->cage->current);
}

void FrameEditTest::stepsNameTheFrame() {
    Document document;
    document.editEntry(QStringLiteral("start"), keyed(still(), {Track::Kind::Cage}, 0));
    document.setMoment(animation::moment(5));
    Fractal after = document.fractal();
    moveVertex(after);
    document.edit(QStringLiteral("Move"), after);
    QCOMPARE(document.undoStack()->undoText(), QStringLiteral("Move (frame 5)"));
    after = document.fractal();
    shrinkMap(after);
    document.edit(QStringLiteral("Shrink"), after); // for all times
    QCOMPARE(document.undoStack()->undoText(), QStringLiteral("Shrink"));
}

void FrameEditTest::timeIsNoStepOfTheHistory() {
    Document document;
    document.editEntry(QStringLiteral("start"), keyed(still(), {Track::Kind::Cage}, 0));
    Fractal after = document.fractal();
    document.setMoment(animation::moment(8));
    moveVertex(after);
    document.edit(QStringLiteral("Move"), after);
    document.undoStack()->setClean();
    const int steps = document.undoStack()->count();

    std::vector<Change> changes;
    connect(&document, &Document::changed, this, [&](const Change& change) { changes.push_back(change); });
    document.setMoment(animation::moment(4), Document::Pace::Running);
    document.setMoment(animation::moment(4), Document::Pace::Running); // already there
    document.setMoment(animation::moment(4));                          // and now it rests
    document.setMoment(animation::moment(4));
    QCOMPARE(changes.size(), std::size_t(2));
    QVERIFY(changes[0].live && changes[0].parts == (Change::Time | Change::Cage));
    QVERIFY(!changes[1].live && changes[1].parts == (Change::Time | Change::Cage));
    QCOMPARE(document.undoStack()->count(), steps);
    QVERIFY(!document.isModified());
    QVERIFY(!plane(document.fractal())->animation);
    QVERIFY(plane(document.entryFractal())->animation);
    document.setFile(fileOf(sierpinskiTriangle()));
    QCOMPARE(document.moment(), animation::Moment());
}

void FrameEditTest::pathsGoThroughTheKeys() {
    QVERIFY(motionPaths(still()).vertices.empty());
    Fractal entry = edited(keyed(still(), {Track::Kind::Cage}, 0), 12, moveVertex).fractal;
    entry = edited(keyed(entry, {Track::Kind::Map, {ifs::MapId(2)}}, 0), 6, shrinkMap).fractal;
    const MotionPaths paths = motionPaths(entry);
    QCOMPARE(paths.vertices.size(), std::size_t(3));
    QCOMPARE(paths.vertices[1].points.size(), std::size_t(length + 1));
    QCOMPARE(paths.vertices[1].keys.size(), std::size_t(2));
    for (const int frame : {0, 12})
        QCOMPARE(paths.vertices[1].points[std::size_t(frame)],
                 cage2(frameAt(entry, animation::moment(frame)).fractal)->current[1]);
    QCOMPARE(paths.maps.size(), std::size_t(1));
    QCOMPARE(paths.maps[0].keys[1], paths.maps[0].points[6]);
    plane(entry)->animation->length = 1000; // not every frame is looked at
    QVERIFY(motionPaths(entry).vertices[0].points.size() <= 245);
    QCOMPARE(motionPaths(entry).vertices[1].keys.size(), std::size_t(2)); // but every key
}

void FrameEditTest::smoothPathsBend() {
    Fractal entry = edited(keyed(still(), {Track::Kind::Cage}, 0), 6, moveVertex).fractal;
    entry = edited(entry, 12, [](Fractal& shown) { plane(shown)->cage->current[1].y() += 2; }).fractal;
    // How far the step after the key is from the one before it, by the longer of the two.
    const auto cornerAt = [&](const animation::Ease& ease) {
        for (auto& key : plane(entry)->animation->cage)
            key.ease = ease;
        const auto points = motionPaths(entry).vertices[1].points;
        const ifs::Vector<2> before = points[6] - points[5], after = points[7] - points[6];
        return (after - before).norm() / std::max(after.norm(), before.norm());
    };
    QVERIFY(cornerAt({animation::Ease::Kind::Linear}) > 0.6);
    QVERIFY(cornerAt({animation::Ease::Kind::Smooth}) < 0.4);
    const FrameEdit later = edited(entry, 9, moveVertex); // a new key leads on as the one before it does
    QVERIFY(plane(later.fractal)->animation->cage[2].ease.kind == animation::Ease::Kind::Smooth);
}

BARYCAGE_TEST(FrameEditTest);
#include "frame_edit_test.moc"
