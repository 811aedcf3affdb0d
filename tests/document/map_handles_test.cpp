// SPDX-License-Identifier: MIT
#include "document/map_handles.h"
#include "ifs/weaving.h"

#include <QTest>

#include <array>

using namespace document;
using ifs::Vector;

namespace {

Fractal placed(std::vector<Vector<2>> rest, std::vector<Vector<2>> current) {
    Fractal fractal = sierpinskiTriangle();
    fractal.cage = ifs::ControlCage<2>{std::move(rest), std::move(current)};
    return fractal;
}

const std::vector<Vector<2>> triangle{{0, 0}, {1, 0}, {0, 1}};
const std::vector<Vector<2>> square{{-0.2, -0.2}, {1.2, -0.2}, {1.2, 1.2}, {-0.2, 1.2}};

double farthest(const std::vector<Vector<2>>& a, const std::vector<Vector<2>>& b, const Vector<2>& offset) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] + offset - b[i]).norm());
    return most;
}

} // namespace

class MapHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void theChildrenOfTheCageAreTheMapsOnTheScreen() {
        const Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        const MapHandles handles(fractal, *fractal.cage);
        const auto effective = effectiveSystem(fractal);
        for (std::size_t i = 0; i < handles.count(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY((handles.corners(i)[k] - effective->maps[i].map(fractal.cage->current[k])).norm() <
                        1e-13);
        QVERIFY(handles.outline(0) == handles.corners(0));
    }

    // What is asked for in displayed coordinates happens there, whatever the placement.
    void dragsAreThoseOfTheScreen_data() {
        QTest::addColumn<std::vector<Vector<2>>>("rest");
        QTest::addColumn<std::vector<Vector<2>>>("current");
        QTest::addColumn<bool>("bends");
        QTest::newRow("at rest") << triangle << triangle << false;
        QTest::newRow("placed") << triangle << std::vector<Vector<2>>{{1, 1}, {3, 1.5}, {0.5, 4}} << false;
        QTest::newRow("mirrored") << triangle << std::vector<Vector<2>>{{0, 0}, {0, 2}, {1, 0}} << false;
        QTest::newRow("bent") << square
                              << std::vector<Vector<2>>{{-0.2, -0.2}, {1.5, 0}, {1.1, 1.3}, {-0.2, 1.2}}
                              << true;
    }
    void dragsAreThoseOfTheScreen() {
        QFETCH(std::vector<Vector<2>>, rest);
        QFETCH(std::vector<Vector<2>>, current);
        QFETCH(bool, bends);
        const Fractal fractal = placed(rest, current);
        const MapHandles handles(fractal, *fractal.cage);
        QVERIFY(handles.canBeTaken());
        const Vector<2> offset(0.03, -0.02);
        const double exact = 1e-9, firstOrder = bends ? 1e-2 : 1e-9;

        const Fractal dragged = handles.withCornerMoved(1, 2, offset);
        const MapHandles after(dragged, *dragged.cage);
        QVERIFY((after.corners(1)[2] - handles.corners(1)[2] - offset).norm() < exact);
        QVERIFY(farthest(handles.corners(0), after.corners(0), Vector<2>::Zero()) == 0);
        QVERIFY(dragged.cage == fractal.cage);

        const std::array<std::size_t, 2> both{0, 2};
        const Fractal moved = handles.withMapsMoved(both, offset);
        const MapHandles there(moved, *moved.cage);
        QVERIFY(farthest(handles.corners(0), there.corners(0), offset) < firstOrder);
        QVERIFY(farthest(handles.corners(2), there.corners(2), offset) < firstOrder);
        QVERIFY(there.corners(1) == handles.corners(1));
        QVERIFY(system2(moved)->maps[0].map.linear == system2(fractal)->maps[0].map.linear);

        ifs::AffineMap<2> turn = ifs::affineMap(0.99, -0.08, 0.08, 0.99, 0.02, 0.01);
        const Fractal turned = handles.withMapsChanged(both, turn);
        const MapHandles round(turned, *turned.cage);
        for (std::size_t k = 0; k < rest.size(); ++k)
            QVERIFY((round.corners(0)[k] - turn(handles.corners(0)[k])).norm() < (bends ? 3e-2 : 1e-9));
    }

    void noOffsetIsExactlyNoChange() {
        const Fractal fractal = sierpinskiTriangle(); // whose cage follows the code
        const MapHandles handles(fractal, effectiveCage(fractal));
        const std::array<std::size_t, 1> first{0};
        QVERIFY(handles.withCornerMoved(0, 1, Vector<2>::Zero()) == fractal);
        QVERIFY(handles.withMapsMoved(first, Vector<2>::Zero()) == fractal);
        QVERIFY(handles.withMapsChanged(first, {}) == fractal);
        // While the code changes, the cage that was in force stays.
        QVERIFY(handles.withMapsMoved(first, {0.1, 0}).cage == effectiveCage(fractal));
    }

    void aFlatPlacementHoldsTheMaps() {
        const Fractal fractal = placed(triangle, {{0, 0}, {1, 1}, {2, 2}});
        const MapHandles handles(fractal, *fractal.cage);
        QVERIFY(!handles.canBeTaken());
        QVERIFY(handles.withCornerMoved(0, 1, {0.1, 0.1}) == fractal);
    }

    // As a map of its own, a branch is moved alone; its neighbours and the attractor's other points stay.
    void aBranchIsAMapOfItsOwn() {
        Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        system2(fractal)->maps.push_back({ifs::MapId(9), ifs::affineMap(.1, 0, 0, .1, 0, 0), 1.0, false});
        const System2 before = *system2(fractal);
        const ifs::Word branch{2, 0};
        const auto taken = branchHandles(fractal, *fractal.cage, branch, BranchEdit::OwnMap);
        QVERIFY(taken);
        QCOMPARE(taken->handles.count(), std::size_t{6}); // 2·(3 − 1) + 1, and the one that is off
        QVERIFY(!taken->handles.maps().back().enabled);
        const ifs::AffineMap<2> map = before.maps[2].map * before.maps[0].map;
        const ifs::Placement place = placement(fractal);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY((taken->handles.corners(taken->place)[k] - place(map(triangle[k]))).norm() < 1e-13);
        const std::array<std::size_t, 1> first{taken->place};
        const Fractal after = taken->handles.withMapsMoved(first, {0.2, 0.1});
        const MapHandles moved(after, *after.cage);
        QVERIFY(farthest(taken->handles.corners(0), moved.corners(0), {0.2, 0.1}) < 1e-12);
        for (std::size_t i = 1; i < moved.count(); ++i)
            QVERIFY(moved.maps()[i] == taken->handles.maps()[i]);
        // Every map has the colour of the one it begins with.
        QVERIFY(attractor::mapColour(after.appearance, moved.maps()[0].id, 0) ==
                attractor::mapColour(fractal.appearance, before.maps[2].id, 2));
    }

    // Through its last map, the branch follows the hand and the others that this map makes follow it.
    void aBranchChangesItsLastMap() {
        const Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        const auto taken = branchHandles(fractal, *fractal.cage, {2, 2, 0}, BranchEdit::LastMap);
        QVERIFY(taken && taken->place == 0);
        const Vector<2> offset(0.03, -0.04);
        for (const Fractal& after :
             {taken->handles.withCornerMoved(0, 1, offset),
              taken->handles.withMapsChanged(std::array<std::size_t, 1>{0},
                                             ifs::affineMap(1, 0, 0, 1, offset.x(), offset.y()))}) {
            QVERIFY(system2(after)->maps[1] == system2(fractal)->maps[1]);
            const auto there = branchHandles(after, *after.cage, {2, 2, 0}, BranchEdit::LastMap);
            QVERIFY((there->handles.corners(0)[1] - taken->handles.corners(0)[1] - offset).norm() < 1e-12);
        }
        QVERIFY(!branchHandles(fractal, *fractal.cage, {}, BranchEdit::LastMap));
        QVERIFY(!branchHandles(fractal, *fractal.cage, {0, 7}, BranchEdit::LastMap));
    }

    // A branch turns about its own base, seen as a turn whatever the placement.
    void branchesSwingAboutTheirRoots() {
        for (const auto& current : {triangle, std::vector<Vector<2>>{{1, 1}, {3, 1.5}, {0.5, 4}}}) {
            const Fractal fractal = placed(triangle, current);
            const MapHandles handles(fractal, *fractal.cage);
            const auto base = root(fractal);
            QVERIFY(base);
            const ifs::Placement place = placement(fractal);
            for (const Vector<2>& vertex : current)
                QVERIFY(place(*base).y() <= vertex.y() + 1e-6);
            const std::array<std::size_t, 2> both{1, 2};
            const Fractal after = handles.withMapsSwung(both, *base, 0.4);
            for (const std::size_t i : both) {
                const Vector<2> pivot = place(system2(fractal)->maps[i].map(*base));
                QVERIFY((place(system2(after)->maps[i].map(*base)) - pivot).norm() < 1e-12);
                const ifs::AffineMap<2> turn = ifs::swung({}, pivot, 0.4);
                for (const Vector<2>& vertex : triangle)
                    QVERIFY((place(system2(after)->maps[i].map(vertex)) -
                             turn(place(system2(fractal)->maps[i].map(vertex))))
                                .norm() < 1e-12);
            }
            QVERIFY(system2(after)->maps[0] == system2(fractal)->maps[0]);
            QVERIFY(handles.withMapsSwung(both, *base, 0) == fractal);
        }
    }

    void theOutlineBendsWithTheCage() {
        const Fractal fractal = placed(square, {{-0.2, -0.2}, {2, 0}, {1.1, 1.3}, {-0.2, 1.2}});
        const MapHandles handles(fractal, *fractal.cage);
        QVERIFY(handles.outline(1).size() > 3 * handles.corners(1).size());
        QCOMPARE(handles.outline(1).front(), handles.corners(1).front());
    }
};

QTEST_APPLESS_MAIN(MapHandlesTest)
#include "map_handles_test.moc"
