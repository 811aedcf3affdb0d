// SPDX-License-Identifier: MIT
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QTest>

using namespace document;
using ifs::Vector;
using ifs::Word;

class AddressesTest : public QObject {
    Q_OBJECT

private slots:
    // The maps keep their numbers when one of them is off, and the cage takes the points along.
    void numbersAreThoseOfTheTable() {
        Fractal fractal = sierpinskiTriangle();
        System2& system = *system2(fractal);
        system.maps[0].enabled = false;
        plane(fractal)->cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{2, 1}, {4, 2}, {1, 5}}};
        const Addresses addresses(fractal);
        const ifs::Placement placed = placement(fractal);
        const ifs::AffineMap<2>&a = system.maps[1].map, &b = system.maps[2].map;
        const auto fixed = ifs::fixedPoint(a * b);
        const Word word = addresses.at(placed(*fixed), 0.01);
        QVERIFY(word.size() > 5);
        for (std::size_t i = 0; i < word.size(); ++i)
            QCOMPARE(word[i], i % 2 == 0 ? 1 : 2);
        QVERIFY((*addresses.fixedPoint({1, 2}) - placed(*fixed)).norm() < 1e-12);
        QVERIFY(!addresses.fixedPoint({0, 1})); // takes no part
        QVERIFY(!addresses.fixedPoint({}));
        QVERIFY(addresses.at({100, 100}, 0.01).empty());
    }

    // A point of a branch that is moved is found where it is shown, and not where it would be.
    void branchesAreFoundWhereTheyAreShown() {
        Fractal fractal = sierpinskiTriangle();
        const System2& system = *system2(fractal);
        plane(fractal)->moved = {{{system.maps[2].id, system.maps[1].id}, ifs::affineMap(0, -2, 2, 0, 5, 1)}};
        const ifs::AffineMap<2> branch = system.maps[2].map * system.maps[1].map;
        const Vector<2> point = *ifs::fixedPoint(branch);
        const Vector<2> shown = plane(fractal)->moved[0].change(point);
        const Addresses addresses(fractal);
        const Word word = addresses.at(shown, 0.001);
        QVERIFY(word.size() > 6);
        for (std::size_t i = 0; i < word.size(); ++i)
            QCOMPARE(word[i], i % 2 == 0 ? 2 : 1);
        QVERIFY((*addresses.fixedPoint({2, 1}) - shown).norm() < 1e-12);
        QVERIFY((*addresses.fixedPoint({2, 1, 2, 1}) - shown).norm() < 1e-12);
        QVERIFY((*addresses.fixedPoint({2}) - *ifs::fixedPoint(system.maps[2].map)).norm() < 1e-12);
        QVERIFY(addresses.at(branch(Vector<2>(0.2, 0.05)), 0.001).empty());
    }

    void withoutAnAttractorThereIsNone() {
        Fractal fractal = sierpinskiTriangle();
        system2(fractal)->maps[0].map.linear *= 3;
        QVERIFY(Addresses(fractal).at({0.1, 0.1}, 0.01).empty());
        QVERIFY(Addresses(Fractal{}).at({0, 0}, 0.01).empty());
    }

    void addressesAreWrittenAsTheUserCounts() {
        QCOMPARE(addressText({2, 0, 1}, 8), QStringLiteral("3 1 2"));
        QCOMPARE(addressText({2, 0, 1}, 2), QStringLiteral("3 1 …"));
        QCOMPARE(addressText({}, 2), QString());
    }
};

BARYCAGE_TEST(AddressesTest);
#include "addresses_test.moc"
