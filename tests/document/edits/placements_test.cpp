// SPDX-License-Identifier: MIT
#include "document/edits/cage/placements.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "ifs/canonical_systems.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>
#include <memory>

using namespace document;

namespace {

Fractal maple(const QString& name) {
    return support::fractalOf(canonical::system<2>(canonical::maple(), {0.25, 0.25, 0.25, 0.25}), name);
}

Fractal dragged(Fractal fractal) {
    ifs::ControlCage<2> cage = effectiveCage(fractal);
    cage.current[0] += ifs::Vector<2>(3, 1);
    plane(fractal)->cage = cage;
    return fractal;
}

Fractal flat(Fractal fractal) {
    ifs::ControlCage<2> cage = effectiveCage(fractal);
    cage.current[0] = cage.current[1];
    plane(fractal)->cage = cage;
    return fractal;
}

FractalFile fileWith(const QList<Fractal>& fractals) {
    FractalFile file;
    for (const Fractal& fractal : fractals) {
        Entry entry;
        entry.id = EntryId(file.entries.size() + 1);
        entry.fractal = std::make_shared<const Fractal>(fractal);
        file.entries << entry;
    }
    return file;
}

// Where the code alone shows the picture, which is what another program draws.
Box drawnByOthers(const Fractal& fractal) {
    Fractal bare;
    Shape<2> shape;
    shape.system = *system2(fractal);
    shape.system.symmetry = {};
    bare.shape = shape;
    return *displayedBox(bare);
}

} // namespace

// What other programs, which read the code alone, make of entries with a placement.
class PlacementsTest : public QObject {
    Q_OBJECT

private slots:
    void placedEntriesAreKnown();
    void bakedEntriesLookTheSameToOthers();
    void symmetricMapsAreListed();
    void whatMovesWithItsCageIsLeft();
};

void PlacementsTest::placedEntriesAreKnown() {
    Fractal resting = maple(QStringLiteral("resting"));
    plane(resting)->cage = effectiveCage(resting);
    Fractal solid;
    solid.name = QStringLiteral("solid");
    Shape<3> shape;
    for (const double x : {0.0, 1.0})
        ifs::append<3>(shape.system, {ifs::Matrix<3>::Identity() / 2, ifs::Vector<3>(x, x, x)});
    solid.shape = shape;
    auto cage = *spaceCage(solid);
    QVERIFY(!isPlaced(solid));
    cage.current[1].x() += 1;
    space(solid)->cage = cage;
    const FractalFile file =
        fileWith({maple(QStringLiteral("plain")), dragged(maple(QStringLiteral("dragged"))), resting,
                  flat(maple(QStringLiteral("flat"))), solid, Fractal()});
    QCOMPARE(placedEntries(file),
             (QStringList{QStringLiteral("dragged"), QStringLiteral("flat"), QStringLiteral("solid")}));
}

void PlacementsTest::bakedEntriesLookTheSameToOthers() {
    const Fractal plain = maple(QStringLiteral("plain")), moved = dragged(maple(QStringLiteral("dragged")));
    const FractalFile file = fileWith({plain, moved, flat(maple(QStringLiteral("flat")))});
    const Box wanted = *displayedBox(moved);
    QVERIFY((drawnByOthers(moved).max - wanted.max).norm() > 0.1);
    for (const BakedFile& baked : {withPlacementsBaked(file), forOtherPrograms(file)}) {
        QCOMPARE(baked.left, QStringList{QStringLiteral("flat")}); // no code has this picture
        QVERIFY(baked.file.entries[0].fractal == file.entries[0].fractal);
        QVERIFY(*baked.file.entries[2].fractal == *file.entries[2].fractal);
        const Fractal& after = *baked.file.entries[1].fractal;
        QVERIFY(!isPlaced(after));
        for (const Box& box : {*displayedBox(after), drawnByOthers(after)}) {
            QVERIFY((box.min - wanted.min).norm() < 1e-6);
            QVERIFY((box.max - wanted.max).norm() < 1e-6);
        }
    }
}

void PlacementsTest::symmetricMapsAreListed() {
    Fractal symmetric = maple(QStringLiteral("symmetric"));
    system2(symmetric)->symmetry.group = ifs::SymmetryGroup::Rotation;
    system2(symmetric)->symmetry.order = 3;
    const FractalFile file = fileWith({symmetric});
    QCOMPARE(*withPlacementsBaked(file).file.entries[0].fractal, symmetric);
    const BakedFile copy = forOtherPrograms(file);
    QVERIFY(copy.left.isEmpty());
    const Fractal& listed = *copy.file.entries[0].fractal;
    QCOMPARE(system2(listed)->maps.size(), std::size_t(12));
    const Box box = drawnByOthers(listed), wanted = *displayedBox(symmetric);
    QVERIFY((box.min - wanted.min).norm() < 1e-5 && (box.max - wanted.max).norm() < 1e-5);
}

// Baking one moment would put the others elsewhere.
void PlacementsTest::whatMovesWithItsCageIsLeft() {
    Fractal moving = dragged(maple(QStringLiteral("moving")));
    auto& animation = plane(moving)->animation.emplace();
    animation.cage = {{0, plane(moving)->cage->rest, {}}, {10, plane(moving)->cage->current, {}}};
    QVERIFY(!isPlaced(moving)); // at frame 0
    std::swap(animation.cage[0].value, animation.cage[1].value);
    QVERIFY(isPlaced(moving));
    const BakedFile baked = withPlacementsBaked(fileWith({moving}));
    QCOMPARE(baked.left, QStringList{QStringLiteral("moving")});
    QCOMPARE(*baked.file.entries[0].fractal, moving);
}

BARYCAGE_TEST(PlacementsTest, QGuiApplication);
#include "placements_test.moc"
