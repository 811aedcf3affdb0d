// SPDX-License-Identifier: MIT
#include "document/edits/timeline/morph_edits.h"

#include "attractor/space_systems.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "ifs/dimension/moments.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace document;

// Morphs of entries as they are shown: with cages, symmetries and looks, in the plane and in space.
class MorphEditsTest : public QObject {
    Q_OBJECT

private slots:
    void endsAreThoseOfTheEntries_data();
    void endsAreThoseOfTheEntries();
    void endsInSpaceAreThoseOfTheEntries();
    void looksAreLedOn();
    void looksInSpaceAreLedOn();
    void whatCannotBeIsSaid();
};

namespace {

constexpr int length = 10;

Fractal maple() {
    return support::fractalOf(canonical::system<2>(canonical::maple(), {0.1, 0.4, 0.3, 0.2}));
}

// Placed somewhere else by its cage, turned, stretched and larger.
Fractal caged() {
    Fractal fractal = sierpinskiTriangle();
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0.5, 0.9}});
    cage.current = {{3, -1}, {3.5, 2}, {1, 1}};
    plane(fractal)->cage = cage;
    return fractal;
}

Fractal symmetric() {
    Fractal fractal = support::fractalOf(canonical::system<2>({ifs::affineMap(.4, .1, -.2, .3, 1, .5)}, {1}));
    ifs::Symmetry<2>& symmetry = plane(fractal)->system.symmetry;
    symmetry.group = ifs::SymmetryGroup::Rotation;
    symmetry.order = 3;
    return fractal;
}

template <int Dim>
void verifySameMeasure(const ifs::IteratedFunctionSystem<Dim>& a, const ifs::IteratedFunctionSystem<Dim>& b) {
    const auto first = ifs::moments<Dim>(ifs::activeMaps(a)), second = ifs::moments<Dim>(ifs::activeMaps(b));
    QVERIFY(first && second);
    QVERIFY((first->mean - second->mean).norm() < 1e-12 * (1 + second->mean.norm()));
    QVERIFY((first->covariance - second->covariance).norm() < 1e-12 * (1 + second->covariance.norm()));
}

} // namespace

void MorphEditsTest::endsAreThoseOfTheEntries_data() {
    QTest::addColumn<Fractal>("from");
    QTest::addColumn<Fractal>("to");
    QTest::newRow("plain") << maple() << sierpinskiTriangle();
    QTest::newRow("from a cage") << caged() << maple();
    QTest::newRow("to a cage") << maple() << caged();
    QTest::newRow("from a symmetry") << symmetric() << maple();
    QTest::newRow("between both") << caged() << symmetric();
}

void MorphEditsTest::endsAreThoseOfTheEntries() {
    QFETCH(Fractal, from);
    QFETCH(Fractal, to);
    const MorphOutcome outcome = morphed(from, to, length, {});
    QVERIFY(outcome.fractal);
    QVERIFY(!plane(*outcome.fractal)->cage);
    QVERIFY(animation::isValid(*plane(*outcome.fractal)->animation));
    QVERIFY(!firstWithoutAttractor(*outcome.fractal));
    const auto at = [&](int frame) {
        return *system2(frameAt(*outcome.fractal, animation::moment(frame)).fractal);
    };
    verifySameMeasure<2>(at(0), *effectiveSystem(from));
    verifySameMeasure<2>(at(length), *effectiveSystem(to));
    double sum = 0;
    for (const animation::Shipment& pair : outcome.pairs) { // of the maps that are listed
        QVERIFY(pair.from < system2(from)->maps.size() && pair.to < system2(to)->maps.size());
        sum += pair.amount;
    }
    QVERIFY(std::abs(sum - 1) < 1e-12);
}

void MorphEditsTest::endsInSpaceAreThoseOfTheEntries() {
    Fractal from, to;
    from.shape = Shape<3>{systems::tetrahedron()};
    to.shape = Shape<3>{canonical::system<3>(canonical::fern3(), {0.1, 0.7, 0.1, 0.1})};
    const MorphOutcome outcome = morphed(from, to, length, {});
    QVERIFY(outcome.fractal);
    QVERIFY(space(*outcome.fractal));
    QVERIFY(animation::isValid(*space(*outcome.fractal)->animation));
    QVERIFY(!firstWithoutAttractor(*outcome.fractal));
    const auto at = [&](int frame) {
        return *system3(frameAt(*outcome.fractal, animation::moment(frame)).fractal);
    };
    verifySameMeasure<3>(at(0), *system3(from));
    verifySameMeasure<3>(at(length), *system3(to));
}

void MorphEditsTest::looksAreLedOn() {
    Fractal from = maple(), to = sierpinskiTriangle();
    from.appearance.brightness = 2;
    from.appearance.plain = {200, 30, 10, 255};
    to.appearance.brightness = 18;
    const MorphOutcome outcome = morphed(from, to, length, {});
    QVERIFY(outcome.fractal);
    const auto lookAt = [&](int frame) {
        return animation::lookOf(frameAt(*outcome.fractal, animation::moment(frame)).fractal.appearance);
    };
    QVERIFY(lookAt(0) == animation::lookOf(from.appearance));
    QVERIFY(lookAt(length) == animation::lookOf(to.appearance));
    QVERIFY(std::abs(lookAt(length / 2).brightness - 6) < 1e-9);
    QVERIFY(plane(*morphed(from, from, length, {}).fractal)->animation->look.empty());
}

void MorphEditsTest::looksInSpaceAreLedOn() {
    Fractal from, to;
    from.shape = Shape<3>{systems::tetrahedron()};
    to.shape = Shape<3>{canonical::system<3>(canonical::fern3(), {0.1, 0.7, 0.1, 0.1})};
    from.inSpace.look = attractor::LookInSpace::Ink;
    from.inSpace.lightAzimuth = 10.1;
    from.inSpace.fog = 1;
    to.inSpace.lightAzimuth = 50.3;
    to.inSpace.clip = attractor::SpaceClip{{0, 0, 1}, 0.1, 0.7};
    const MorphOutcome outcome = morphed(from, to, length, {});
    QVERIFY(outcome.fractal);
    QVERIFY(animation::isValid(*space(*outcome.fractal)->animation));
    const auto inSpaceAt = [&](int frame) {
        return frameAt(*outcome.fractal, animation::moment(frame)).fractal.inSpace;
    };
    QVERIFY(inSpaceAt(0) == from.inSpace);
    QVERIFY(inSpaceAt(length) == to.inSpace);
    QVERIFY(std::abs(inSpaceAt(length / 2).lightAzimuth - 30.2) < 1e-9);
    QVERIFY(std::abs(inSpaceAt(length / 2).fog - 0.5) < 1e-12);
    // Where both look the same, no key is needed for it.
    const Fractal same = *morphed(from, from, length, {}).fractal;
    QVERIFY(space(same)->animation->look.empty());
    QVERIFY(frameAt(same, animation::moment(length / 2)).fractal.inSpace == from.inSpace);
}

void MorphEditsTest::whatCannotBeIsSaid() {
    Fractal solid, bent = sierpinskiTriangle();
    solid.shape = Shape<3>{systems::tetrahedron()};
    plane(bent)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    plane(bent)->cage->current[2] = {2, 2};
    const auto flaw = [](const Fractal& from, const Fractal& to) {
        const MorphOutcome outcome = morphed(from, to, length, {});
        return outcome.fractal ? std::nullopt : std::optional(outcome.flaw);
    };
    QVERIFY(flaw(maple(), solid) == MorphFlaw::Dimensions);
    QVERIFY(flaw(maple(), Fractal()) == MorphFlaw::Dimensions);
    QVERIFY(flaw(maple(), bent) == MorphFlaw::BentCage);
    System2 many;
    for (int i = 0; i < 257; ++i)
        ifs::append(many, ifs::affineMap(.1, 0, 0, .1, i, 0), 1);
    QVERIFY(flaw(support::fractalOf(many), maple()) == MorphFlaw::TooMany);
    many.maps.pop_back();
    QVERIFY(!flaw(maple(), support::fractalOf(many)));
}

BARYCAGE_TEST(MorphEditsTest);
#include "morph_edits_test.moc"
