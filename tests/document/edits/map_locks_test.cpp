// SPDX-License-Identifier: MIT
#include "document/edits/collage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/maps_arrange.h"
#include "document/edits/maps/maps_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/maps/branch_handles.h"
#include "document/maps/map_names.h"
#include "support/named_test.h"

#include <QTest>
#include <QUndoStack>

#include <array>

using namespace document;

namespace {

Fractal threeMaps() {
    Fractal fractal = sierpinskiTriangle();
    const auto& maps = system2(fractal)->maps;
    fractal.mapLabels.set(maps[0].id, {QStringLiteral("foot"), false});
    fractal.mapLabels.set(maps[2].id, {QStringLiteral("top"), true});
    return fractal;
}

QString nameAt(const Fractal& fractal, std::size_t index) {
    return fractal.mapLabels.of(system2(fractal)->maps[index].id).name;
}

} // namespace

class MapLocksTest : public QObject {
    Q_OBJECT

private slots:
    void namesAreOneLine() {
        QCOMPARE(mapNameOf(QStringLiteral("  a\n\tb\u202e c ")), QStringLiteral("a b c"));
        QCOMPARE(mapNameOf(QStringLiteral("\u202e\u2066")), QString());
        QCOMPARE(mapNameOf(QString(500, u'x')).size(), maxMapName);
        const QString leaves = mapNameOf(QStringLiteral("x") + QStringLiteral("🌿").repeated(100));
        QVERIFY(leaves.size() <= maxMapName && leaves.back().isLowSurrogate());
    }

    void sentencesNameTheMaps() {
        const Fractal fractal = threeMaps();
        QCOMPARE(lockObstacle(fractal, Rows{0, 1}), QString());
        QCOMPARE(lockObstacle(fractal, Rows{0, 2}),
                 QStringLiteral("Map 3 (top) is locked. Unlock it in the Maps panel first."));
        Fractal two = fractal;
        two.mapLabels.set(system2(two)->maps[1].id, {{}, true});
        QCOMPARE(lockObstacle(two, Rows{1, 2}),
                 QStringLiteral("Maps 2, 3 (top) are locked. Unlock them in the Maps panel first."));
        QVERIFY(isLocked(two, 1) && !isLocked(two, 0) && !isLocked(two, 7));
        QCOMPARE(lockedMaps(two).size(), std::size_t(2));
    }

    void lockingAndNamingAreSteps() {
        Document document;
        document.setFile(fileOf(sierpinskiTriangle()));
        const auto& maps = system2(document.fractal())->maps;
        const std::array ids{maps[0].id, maps[1].id};
        Change seen{};
        connect(&document, &Document::changed, [&](const Change& change) { seen = change; });
        lockMaps(document, ids, true);
        QCOMPARE(document.undoStack()->count(), 1);
        QVERIFY(seen.parts.testFlag(Change::Name) && !seen.parts.testFlag(Change::System));
        QVERIFY(isLocked(document.fractal(), 1));
        lockMaps(document, ids, true); // they are
        QCOMPARE(document.undoStack()->count(), 1);
        renameMap(document, 1, QStringLiteral(" stem\n"));
        QCOMPARE(nameAt(document.fractal(), 1), QStringLiteral("stem"));
        QVERIFY(isLocked(document.fractal(), 1));
        document.undoStack()->undo();
        document.undoStack()->undo();
        QVERIFY(document.fractal().mapLabels.isEmpty());
    }

    void lockedMapsStay() {
        Document document;
        document.setFile(fileOf(threeMaps()));
        const Fractal before = document.fractal();
        QVERIFY(deleteMaps(document, {1, 2}).empty());
        const std::array<std::size_t, 3> all{0, 1, 2};
        const auto why = arrangeMaps(document, all, MapsArrangement::FlipUpDown);
        QVERIFY(why && why->contains(QStringLiteral("top")));
        QVERIFY(document.fractal() == before);
        QCOMPARE(document.undoStack()->count(), 0);
        QCOMPARE(deleteMaps(document, {1}).size(), std::size_t(1));
        QCOMPARE(nameAt(document.fractal(), 1), QStringLiteral("top"));
    }

    void labelsFollowTheirMaps() {
        const Fractal fractal = threeMaps();
        const auto doubled = withDuplicates(fractal, {0, 2});
        QCOMPARE(nameAt(doubled.fractal, 3), QStringLiteral("foot"));
        QCOMPARE(nameAt(doubled.fractal, 4), QStringLiteral("top"));
        QVERIFY(isLocked(doubled.fractal, 2) &&
                !isLocked(doubled.fractal, 4)); // a copy is there to be edited
        QCOMPARE(nameAt(withMapsMoved(fractal, {2}, 0).fractal, 0), QStringLiteral("top"));
        const auto less = withoutMaps(fractal, {2});
        QVERIFY(!less.fractal.mapLabels.isEmpty());
        QVERIFY(nameAt(withNewMap(less.fractal).fractal, 2).isEmpty()); // it may have the id of the old one
        QVERIFY(withoutMaps(fractal, {0, 2}).fractal.mapLabels.isEmpty());
        const auto pasted = withMapsPasted(fractal, {0}, system2(fractal)->maps);
        QCOMPARE(nameAt(pasted.fractal, 0), QStringLiteral("foot"));
        QVERIFY(nameAt(pasted.fractal, 1).isEmpty());
        const Fractal turned =
            expanded(withSymmetry(fractal, ifs::Symmetry<2>{ifs::SymmetryGroup::Rotation, 2}));
        QCOMPARE(system2(turned)->maps.size(), std::size_t(6));
        QCOMPARE(nameAt(turned, 1), QStringLiteral("foot"));
        QVERIFY(isLocked(turned, 4) && isLocked(turned, 5) && !isLocked(turned, 2));
        QVERIFY(withSuggestion(fractal, {}, {}).mapLabels.isEmpty());
    }

    // A branch that becomes a map of its own: the maps that it divides keep the name in their parts.
    void partsHaveTheNameOfTheWhole() {
        const auto fractal = std::make_shared<const Fractal>(threeMaps());
        const auto branch = branchHandles(fractal, effectiveCage(*fractal), {0, 1}, BranchEdit::OwnMap);
        QVERIFY(branch);
        const std::array<std::size_t, 1> first{0};
        const Fractal moved = branch->handles.withMapsMoved(first, ifs::Vector<2>(0.1, 0));
        QCOMPARE(nameAt(moved, 0), QStringLiteral("foot"));
        std::size_t tops = 0;
        for (std::size_t i = 0; i < system2(moved)->maps.size(); ++i)
            tops += nameAt(moved, i) == QStringLiteral("top") ? 1 : 0;
        QCOMPARE(tops, std::size_t(1));
    }

    // Of an entry with keys, too, and they are not keyed.
    void animatedEntriesKeepLabels() {
        Document document;
        Fractal swaying = threeMaps();
        if (auto with = withBreathing(swaying)) swaying = *with;
        QVERIFY(plane(swaying)->animation);
        document.setFile(fileOf(swaying));
        document.setMoment(animation::moment(5));
        QCOMPARE(nameAt(document.fractal(), 2), QStringLiteral("top"));
        renameMap(document, 1, QStringLiteral("leaf"));
        QCOMPARE(nameAt(document.fractal(), 1), QStringLiteral("leaf"));
        QCOMPARE(nameAt(document.entryFractal(), 1), QStringLiteral("leaf"));
        QVERIFY(plane(document.entryFractal())->animation == plane(swaying)->animation);
    }
};

BARYCAGE_TEST(MapLocksTest, QCoreApplication);
#include "map_locks_test.moc"
