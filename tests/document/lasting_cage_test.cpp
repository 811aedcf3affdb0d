// SPDX-License-Identifier: MIT
#include "document/document.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "support/named_test.h"

#include <QTest>

// A cage that is not stored stays where it is while an animation plays and while numbers are typed.
class LastingCageTest : public QObject {
    Q_OBJECT

private slots:
    void itStaysWhileTimeRuns();
    void itStaysInSpaceToo();
    void itStaysWithoutAnAttractor();
    void itStaysUntilAGestureEnds();
    void aDragAtAMomentStartsFromIt();
    void anotherEntryDoesNotHoldIt();
    void entriesDoNotKeepIt();
};

namespace {

using namespace document;

Fractal swaying() {
    return *withWind(sierpinskiTriangle(), animation::swayPresets()[2]); // Storm
}

Fractal spatial() {
    Shape<3> shape;
    const auto add = [&](double x, double y, double z) {
        ifs::AffineMap<3> map;
        map.linear = 0.5 * ifs::Matrix<3>::Identity();
        map.translation = {x, y, z};
        ifs::append(shape.system, map, 1);
    };
    add(0, 0, 0);
    add(1, 0, 0);
    add(0, 1, 0);
    add(0, 0, 1);
    Fractal fractal;
    fractal.shape = std::move(shape);
    return fractal;
}

Fractal withCorner(Fractal fractal, double x) {
    plane(fractal)->system.maps[1].map.translation.x() = x;
    return fractal;
}

} // namespace

void LastingCageTest::itStaysWhileTimeRuns() {
    Document document;
    document.setFile(fileOf(swaying()));
    const ifs::ControlCage<2> still = effectiveCage(document.fractal());
    QVERIFY(still == canonicalCage(document.entryFractal()));
    int others = 0;
    for (int frame = 0; frame < timingOf(document.entryFractal()).length; ++frame) {
        document.setMoment(animation::moment(frame), Document::Pace::Running);
        QVERIFY(effectiveCage(document.fractal()) == still);
        others += !(canonicalCage(document.fractal()) == still);
    }
    QVERIFY(others > 20); // it would have been another one
}

void LastingCageTest::itStaysInSpaceToo() {
    Document document;
    document.setFile(fileOf(*withWind(spatial(), animation::swayPresets()[2])));
    const auto still = spaceCage(document.fractal());
    QVERIFY(still);
    document.setMoment(animation::moment(7));
    QVERIFY(*spaceCage(document.fractal()) == *still);
    QVERIFY(*knownSpaceCage(document.fractal()) == *still);
    Fractal alone = document.fractal();
    alone.lasting = {};
    QVERIFY(!(*spaceCage(alone) == *still));
}

// There the cage used to be the unit triangle.
void LastingCageTest::itStaysWithoutAnAttractor() {
    Fractal breathing = sierpinskiTriangle();
    plane(breathing)->animation.emplace();
    plane(breathing)->animation->length = 32;
    plane(breathing)->animation->motions = {animation::Breathe<2>{{}, 0.5, 1, {0, 0}}};
    for (auto& map : plane(breathing)->system.maps)
        map.map.linear *= 1.6;
    Document document;
    document.setFile(fileOf(breathing));
    const ifs::ControlCage<2> still = effectiveCage(document.fractal());
    const auto lost = firstWithoutAttractor(document.entryFractal());
    QVERIFY(lost);
    document.setMoment(lost->moment);
    QVERIFY(!supportFunction(document.fractal()));
    QVERIFY(effectiveCage(document.fractal()) == still);
}

void LastingCageTest::itStaysUntilAGestureEnds() {
    Document document;
    const Fractal before = document.fractal();
    const ifs::ControlCage<2> still = effectiveCage(before);
    {
        EditGesture gesture = document.beginGesture(QStringLiteral("Type"));
        for (const double x : {0.7, 0.75, 0.9}) {
            gesture.preview(withCorner(before, x));
            QVERIFY(effectiveCage(document.fractal()) == still);
            QVERIFY(!(canonicalCage(document.fractal()) == still));
        }
        gesture.commit();
    }
    const ifs::ControlCage<2> chosen = canonicalCage(withCorner(before, 0.9));
    QVERIFY(effectiveCage(document.fractal()) == chosen);
    document.undoStack()->undo();
    QVERIFY(effectiveCage(document.fractal()) == still);
    document.undoStack()->redo();
    QVERIFY(effectiveCage(document.fractal()) == chosen);

    EditGesture cancelled = document.beginGesture(QStringLiteral("Type"));
    cancelled.preview(withCorner(before, 3));
    QVERIFY(effectiveCage(document.fractal()) == chosen);
    cancelled.cancel();
    QVERIFY(effectiveCage(document.fractal()) == chosen);
}

void LastingCageTest::aDragAtAMomentStartsFromIt() {
    Document document;
    document.setFile(fileOf(swaying()));
    const ifs::ControlCage<2> still = effectiveCage(document.fractal());
    document.setMoment(animation::moment(9));
    ifs::ControlCage<2> moved = effectiveCage(document.fractal());
    moved.current[0] += ifs::Vector<2>(0.1, 0.2);
    document.edit(QStringLiteral("Move"), withCageMoved(document.fractal(), moved, CageMode::Place));
    QVERIFY(plane(document.entryFractal())->cage);
    QVERIFY(plane(document.entryFractal())->cage->rest == still.rest);
    document.setMoment(animation::moment(3));
    QVERIFY(effectiveCage(document.fractal()).current == moved.current);
}

// Previews that make an entry move begin with its own cage, whatever moved before.
void LastingCageTest::anotherEntryDoesNotHoldIt() {
    Document document;
    FractalFile file = fileOf(swaying());
    file.entries << fileOf(withCorner(sierpinskiTriangle(), 2)).entries;
    file.entries[1].id = EntryId(int(file.entries[0].id) + 1);
    document.setFile(file, file.entries[0].id);
    document.setMoment(animation::moment(5));
    document.setCurrent(file.entries[1].id);
    QCOMPARE(document.currentId(), file.entries[1].id);
    const ifs::ControlCage<2> still = canonicalCage(document.entryFractal());
    EditGesture gesture = document.beginGesture(QStringLiteral("Move"));
    gesture.previewEntry(*withWind(document.entryFractal(), animation::swayPresets()[2]));
    document.setMoment(animation::moment(5));
    QVERIFY(effectiveCage(document.fractal()) == still);
    gesture.cancel();
    QVERIFY(effectiveCage(document.fractal()) == still);
}

// A frame that becomes an entry has a cage of its own.
void LastingCageTest::entriesDoNotKeepIt() {
    Document document;
    document.setFile(fileOf(swaying()));
    document.setMoment(animation::moment(9));
    const Fractal frame = document.fractal();
    QVERIFY(frame.lasting);
    document.editFile(QStringLiteral("Keep the frame"), fileOf(frame));
    QVERIFY(!document.entryFractal().lasting);
    QVERIFY(effectiveCage(document.fractal()) == canonicalCage(frame));
    document.editEntry(QStringLiteral("Again"), withCorner(frame, 0.9));
    QVERIFY(!document.entryFractal().lasting);
    Document other;
    other.setFile(fileOf(frame));
    QVERIFY(!other.entryFractal().lasting);
}

BARYCAGE_TEST(LastingCageTest, QCoreApplication);
#include "lasting_cage_test.moc"
