// SPDX-License-Identifier: MIT
#include "document/edits/timeline/keyed_maps.h"

#include "document/document.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/maps_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QTest>

using namespace document;

namespace {

constexpr int frame = 24;

// A triangle whose map 2 has keys at frames 0 and 24, and which is displaced, seen at frame 24.
class Keyed {
public:
    explicit Keyed(bool isDisplaced = true) {
        Fractal entry = sierpinskiTriangle();
        m_map = plane(entry)->system.maps[1].id;
        for (auto& map : plane(entry)->system.maps)
            map.weight.reset(); // which would be scaled where maps come and go
        plane(entry)->cage = canonicalCage(entry);
        if (isDisplaced) plane(entry)->cage->current[1] += ifs::Vector<2>(0.25, 0.5);
        entry = withKey(std::move(entry), {Track::Kind::Map, {m_map}}, frame, {});
        document.editEntry(QStringLiteral("Key"), std::move(entry));
        document.setMoment(animation::moment(frame));
        m_before = document.entryFractal();
    }

    const animation::Animation<2>& animation() const { return *plane(document.entryFractal())->animation; }
    bool isAsBefore() const { return document.entryFractal() == m_before; }
    // The keys are those of before, and the map that they move is where it was.
    bool keepsKeys() const {
        return animation() == *plane(m_before)->animation &&
               mapAt(document.entryFractal()) == mapAt(m_before);
    }

    Document document;

private:
    ifs::AffineMap<2> mapAt(const Fractal& entry) const {
        for (const auto& map : plane(entry)->system.maps)
            if (map.id == m_map) return map.map;
        return {};
    }

    ifs::MapId m_map{};
    Fractal m_before;
};

ifs::Symmetry<2> rotation() {
    ifs::Symmetry<2> symmetry;
    symmetry.group = ifs::SymmetryGroup::Rotation;
    symmetry.order = 3;
    return symmetry;
}

bool speaksOfKeys(const std::optional<QString>& failure) {
    return failure && failure->startsWith(QStringLiteral("Map 2 has keys"));
}

} // namespace

// What makes other maps of the maps is refused while keys belong to them; what does not keeps the keys with
// their maps.
class KeyedMapsTest : public QObject {
    Q_OBJECT

private slots:
    void onlyWhatHasKeysIsInTheWay() {
        Keyed keyed;
        QVERIFY(speaksOfKeys(branchAsMapObstacle(keyed.document.entryFractal())));
        QVERIFY(speaksOfKeys(rewriteObstacle(keyed.document.entryFractal())));
        QCOMPARE(branchAsMapObstacle(sierpinskiTriangle()), QString());
        QCOMPARE(rewriteObstacle(sierpinskiTriangle()), QString());
        const Fractal look = withKey(sierpinskiTriangle(), {Track::Kind::Look}, frame, {});
        QCOMPARE(branchAsMapObstacle(look), QString());
        QCOMPARE(rewriteObstacle(look), QString());
    }

    void motionsOfSingleMapsAreInTheWayOfABranch() {
        Fractal entry = sierpinskiTriangle();
        animation::Turn<2> turn;
        plane(entry)->animation.emplace().motions.push_back(turn);
        QCOMPARE(branchAsMapObstacle(entry), QString()); // all maps, whatever they are
        turn.maps = {plane(entry)->system.maps[1].id};
        plane(entry)->animation->motions = {turn};
        QVERIFY(branchAsMapObstacle(entry).startsWith(QStringLiteral("A motion")));
        QCOMPARE(rewriteObstacle(entry), QString());
    }

    void theCodeIsNotRewritten() {
        Keyed keyed;
        QVERIFY(bakeObstacle(keyed.document.fractal()).isEmpty());
        QVERIFY(speaksOfKeys(bakeObstacle(keyed.document)));
        QVERIFY(speaksOfKeys(bakeCage(keyed.document)));
        QVERIFY(keyed.isAsBefore());
        Keyed atRest(false);
        QVERIFY(speaksOfKeys(unbakeCage(atRest.document)));
        QVERIFY(atRest.isAsBefore());
    }

    void theCageMovesThePictureAlone() {
        Keyed keyed;
        keyed.document.setCageMode(CageMode::Rewrite);
        QVERIFY(speaksOfKeys(moveCageObstacle(keyed.document)));
        QVERIFY(speaksOfKeys(moveVertex(keyed.document, 0, {-1, -1})));
        QVERIFY(speaksOfKeys(makeCageRegular(keyed.document)));
        QVERIFY(keyed.isAsBefore());
        keyed.document.setCageMode(CageMode::Place);
        QCOMPARE(moveVertex(keyed.document, 0, {-1, -1}), std::nullopt);
        QVERIFY(!keyed.isAsBefore() && keyed.keepsKeys());
    }

    void aSymmetryIsNotExpanded() {
        Keyed keyed;
        keyed.document.editEntry(QStringLiteral("Symmetry"),
                                 withSymmetry(keyed.document.entryFractal(), rotation()));
        QVERIFY(isSymmetric(keyed.document.entryFractal()) && keyed.keepsKeys());
        QVERIFY(!expandObstacle(keyed.document.entryFractal()).isEmpty());
    }

    void otherMapsComeAndGo() {
        const auto after = [](const auto& edit) {
            Keyed keyed;
            keyed.document.edit(QStringLiteral("Maps"), edit(keyed.document.fractal()).fractal);
            return !keyed.isAsBefore() && keyed.keepsKeys();
        };
        QVERIFY(after([](const Fractal& fractal) { return withoutMaps(fractal, {0}); }));
        QVERIFY(after([](const Fractal& fractal) { return withNewMap(fractal); }));
        QVERIFY(after([](const Fractal& fractal) { return withDuplicates(fractal, {0, 1}); }));
        QVERIFY(after([](const Fractal& fractal) { return withMapsMoved(fractal, {1}, 0); }));
        QVERIFY(after([](const Fractal& fractal) { return withMapsMoved(fractal, {0}, 3); }));
        const MapRows pasted{{ifs::MapId{2}, ifs::affineMap(0.25, 0, 0, 0.25, 0.5, 0), {}, true}};
        QVERIFY(after([&](const Fractal& fractal) { return withMapsPasted(fractal, {}, pasted); }));
        QVERIFY(after([&](const Fractal& fractal) { return withMapsPasted(fractal, {0}, pasted); }));
    }

    // A map that goes takes its keys along, and a new one is not moved by them.
    void keysGoWithTheirMap() {
        Keyed keyed;
        keyed.document.edit(QStringLiteral("Delete"), withoutMaps(keyed.document.fractal(), {1}).fractal);
        QVERIFY(keyed.animation().maps.empty());
        keyed.document.edit(QStringLiteral("Add"), withNewMap(keyed.document.fractal()).fractal);
        QVERIFY(keyed.animation().maps.empty());
        keyed.document.undoStack()->undo();
        keyed.document.undoStack()->undo();
        QVERIFY(keyed.isAsBefore());
    }
};

BARYCAGE_TEST(KeyedMapsTest, QGuiApplication);
#include "keyed_maps_test.moc"
