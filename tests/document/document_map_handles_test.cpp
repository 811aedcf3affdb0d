// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/branch_handles.h"
#include "ifs/system/map_interpolation.h"
#include "support/named_test.h"

#include <QTest>

#include <array>

using namespace document;
using ifs::Vector;

namespace {

Fractal placed(std::vector<Vector<2>> rest, std::vector<Vector<2>> current) {
    Fractal fractal = sierpinskiTriangle();
    plane(fractal)->cage = ifs::ControlCage<2>{std::move(rest), std::move(current)};
    return fractal;
}

const std::vector<Vector<2>> triangle{{0, 0}, {1, 0}, {0, 1}};
const std::vector<Vector<2>> square{{-0.2, -0.2}, {1.2, -0.2}, {1.2, 1.2}, {-0.2, 1.2}};

std::shared_ptr<const Fractal> held(const Fractal& fractal) {
    return std::make_shared<const Fractal>(fractal);
}

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
        const MapHandles handles(held(fractal), *plane(fractal)->cage);
        const auto effective = effectiveSystem(fractal);
        for (std::size_t i = 0; i < handles.count(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY((handles.corners(i)[k] - effective->maps[i].map(plane(fractal)->cage->current[k]))
                            .norm() < 1e-13);
        QVERIFY(handles.outline(0) == handles.corners(0));
        const std::vector<Box> boxes = handles.boxes();
        QCOMPARE(boxes.size(), handles.count());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Vector<2> size = boxes[i].max - boxes[i].min;
            for (const Vector<2>& corner : handles.corners(i)) {
                QVERIFY(((corner - boxes[i].min).array() > -1e-12).all());
                QVERIFY(((boxes[i].max - corner).array() > -1e-12).all());
            }
            QVERIFY(size.x() < 2 && size.y() < 2); // of triangles of half of 2.5 by 3
        }
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
        const MapHandles handles(held(fractal), *plane(fractal)->cage);
        QVERIFY(handles.canBeMoved());
        const Vector<2> offset(0.03, -0.02);
        const double exact = 1e-9, firstOrder = bends ? 1e-2 : 1e-9;

        const Fractal dragged = handles.withCornerMoved(1, 2, offset);
        const MapHandles after(held(dragged), *plane(dragged)->cage);
        QVERIFY((after.corners(1)[2] - handles.corners(1)[2] - offset).norm() < exact);
        QVERIFY(farthest(handles.corners(0), after.corners(0), Vector<2>::Zero()) == 0);
        QVERIFY(plane(dragged)->cage == plane(fractal)->cage);

        const std::array<std::size_t, 2> both{0, 2};
        const Fractal moved = handles.withMapsMoved(both, offset);
        const MapHandles there(held(moved), *plane(moved)->cage);
        QVERIFY(farthest(handles.corners(0), there.corners(0), offset) < firstOrder);
        QVERIFY(farthest(handles.corners(2), there.corners(2), offset) < firstOrder);
        QVERIFY(there.corners(1) == handles.corners(1));
        QVERIFY(system2(moved)->maps[0].map.linear == system2(fractal)->maps[0].map.linear);

        ifs::AffineMap<2> turn = ifs::affineMap(0.99, -0.08, 0.08, 0.99, 0.02, 0.01);
        const Fractal turned = handles.withMapsChanged(both, turn);
        const MapHandles round(held(turned), *plane(turned)->cage);
        for (std::size_t k = 0; k < rest.size(); ++k)
            QVERIFY((round.corners(0)[k] - turn(handles.corners(0)[k])).norm() < (bends ? 3e-2 : 1e-9));
    }

    void noOffsetIsExactlyNoChange() {
        const Fractal fractal = sierpinskiTriangle(); // whose cage follows the code
        const MapHandles handles(held(fractal), effectiveCage(fractal));
        const std::array<std::size_t, 1> first{0};
        QVERIFY(handles.withCornerMoved(0, 1, Vector<2>::Zero()) == fractal);
        QVERIFY(handles.withMapsMoved(first, Vector<2>::Zero()) == fractal);
        QVERIFY(handles.withMapsChanged(first, {}) == fractal);
        // While the code changes, the cage that was in force stays.
        QVERIFY(plane(handles.withMapsMoved(first, {0.1, 0}))->cage == effectiveCage(fractal));
    }

    void aFlatPlacementHoldsTheMaps() {
        const Fractal fractal = placed(triangle, {{0, 0}, {1, 1}, {2, 2}});
        const MapHandles handles(held(fractal), *plane(fractal)->cage);
        QVERIFY(!handles.canBeMoved());
        QVERIFY(handles.withCornerMoved(0, 1, {0.1, 0.1}) == fractal);
    }

    // As a map of its own, a branch is moved alone; its neighbours and the attractor's other points stay.
    void aBranchIsAMapOfItsOwn() {
        Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        system2(fractal)->maps.push_back({ifs::MapId(9), ifs::affineMap(.1, 0, 0, .1, 0, 0), 1.0, false});
        const System2 before = *system2(fractal);
        const ifs::Word branch{2, 0};
        const auto taken = branchHandles(held(fractal), *plane(fractal)->cage, branch, BranchEdit::OwnMap);
        QVERIFY(taken);
        QCOMPARE(taken->handles.count(), std::size_t{6}); // 2·(3 − 1) + 1, and the one that is off
        QVERIFY(!taken->handles.maps().back().enabled);
        const ifs::AffineMap<2> map = before.maps[2].map * before.maps[0].map;
        const ifs::Placement place = placement(fractal);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY((taken->handles.corners(taken->index)[k] - place(map(triangle[k]))).norm() < 1e-13);
        const std::array<std::size_t, 1> first{taken->index};
        const Fractal after = taken->handles.withMapsMoved(first, {0.2, 0.1});
        const MapHandles moved(held(after), *plane(after)->cage);
        QVERIFY(farthest(taken->handles.corners(0), moved.corners(0), {0.2, 0.1}) < 1e-12);
        for (std::size_t i = 1; i < moved.count(); ++i)
            QVERIFY(moved.maps()[i] == taken->handles.maps()[i]);
        // Every map has the colour of the one it begins with.
        QVERIFY(attractor::mapColour(after.appearance, moved.maps()[0].id, 0) ==
                attractor::mapColour(fractal.appearance, before.maps[2].id, 2));
    }

    // Through its last map, the branch follows the pointer, and the other branches of this map follow it.
    void aBranchChangesItsLastMap() {
        const Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        const auto taken =
            branchHandles(held(fractal), *plane(fractal)->cage, {2, 2, 0}, BranchEdit::LastMap);
        QVERIFY(taken && taken->index == 0);
        const Vector<2> offset(0.03, -0.04);
        for (const Fractal& after :
             {taken->handles.withCornerMoved(0, 1, offset),
              taken->handles.withMapsChanged(std::array<std::size_t, 1>{0},
                                             ifs::affineMap(1, 0, 0, 1, offset.x(), offset.y()))}) {
            QVERIFY(system2(after)->maps[1] == system2(fractal)->maps[1]);
            const auto there =
                branchHandles(held(after), *plane(after)->cage, {2, 2, 0}, BranchEdit::LastMap);
            QVERIFY((there->handles.corners(0)[1] - taken->handles.corners(0)[1] - offset).norm() < 1e-12);
        }
        QVERIFY(!branchHandles(held(fractal), *plane(fractal)->cage, {}, BranchEdit::LastMap));
        QVERIFY(!branchHandles(held(fractal), *plane(fractal)->cage, {0, 7}, BranchEdit::LastMap));
    }

    // A branch turns about its own base, seen as a turn whatever the placement.
    void branchesSwingAboutTheirRoots() {
        for (const auto& current : {triangle, std::vector<Vector<2>>{{1, 1}, {3, 1.5}, {0.5, 4}}}) {
            const Fractal fractal = placed(triangle, current);
            const MapHandles handles(held(fractal), *plane(fractal)->cage);
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
        const MapHandles handles(held(fractal), *plane(fractal)->cage);
        QVERIFY(handles.outline(1).size() > 3 * handles.corners(1).size());
        QCOMPARE(handles.outline(1).front(), handles.corners(1).front());
    }

    // Only what is shown of the branch moves, as it is dragged, inside others that are moved and under any
    // placement; what is asked for is what is stored.
    void aBranchMovesWhereItIsShown_data() { dragsAreThoseOfTheScreen_data(); }
    void aBranchMovesWhereItIsShown() {
        QFETCH(std::vector<Vector<2>>, rest);
        QFETCH(std::vector<Vector<2>>, current);
        QFETCH(bool, bends);
        Fractal fractal = placed(rest, current);
        const System2 code = *system2(fractal);
        const ifs::MapId a = code.maps[0].id, b = code.maps[1].id;
        plane(fractal)->moved = {{{b}, ifs::affineMap(0.9, -0.1, 0.1, 0.9, 0.05, 0.05)},
                                 {{a, b}, ifs::affineMap(1, 0, 0, 1, 0.3, 0)}};
        const double exact = 1e-9, firstOrder = bends ? 2e-2 : 1e-9;
        const Vector<2> offset(0.03, -0.02);
        const ifs::AffineMap<2> turn = ifs::swung({}, {0.4, 0.3}, 0.1);
        for (const ifs::Word& word : {ifs::Word{1, 2}, ifs::Word{0, 1}, ifs::Word{2, 2, 0}, ifs::Word{1}}) {
            const auto handlesOf = [&](const Fractal& of) {
                return branchHandles(held(of), *plane(of)->cage, word, BranchEdit::Display)->handles;
            };
            const MapHandles before = handlesOf(fractal);
            QVERIFY(before.canBeMoved());
            QCOMPARE(before.count(), 1U);
            const std::array<std::size_t, 1> first{0};
            const auto corners = before.corners(0);
            const auto moved = before.withMapsMoved(first, offset);
            QVERIFY(farthest(corners, handlesOf(moved).corners(0), offset) < firstOrder);
            const auto turned = handlesOf(before.withMapsChanged(first, turn)).corners(0);
            for (std::size_t k = 0; k < corners.size(); ++k)
                QVERIFY((turned[k] - turn(corners[k])).norm() < firstOrder);
            const Fractal dragged = before.withCornerMoved(0, 1, offset);
            const auto after = handlesOf(dragged).corners(0);
            QVERIFY((after[1] - corners[1] - offset).norm() < exact);
            QVERIFY((after[0] - corners[0]).norm() < (rest.size() > 3 ? 0.1 : exact));
            for (const Fractal& changed : {moved, dragged}) {
                QVERIFY(*system2(changed) == code && plane(changed)->cage == plane(fractal)->cage);
                QVERIFY(isMoved(changed, word));
                QVERIFY(!isMoved(withBranchPutBack(changed, word), word));
            }
            QCOMPARE(plane(moved)->moved.size(),
                     plane(fractal)->moved.size() + (isMoved(fractal, word) ? 0 : 1));
            QVERIFY(before.withMapsMoved(first, Vector<2>::Zero()) == fractal);
        }
    }

    // A branch that becomes a map of its own, or is baked, stays where it is shown, and others too.
    void movedBranchesStayWhenTheCodeIsRewritten() {
        Fractal fractal = placed(triangle, {{1, 1}, {3, 1.5}, {0.5, 4}});
        const System2 code = *system2(fractal);
        const ifs::MapId a = code.maps[0].id, b = code.maps[1].id, c = code.maps[2].id;
        plane(fractal)->moved = {{{b}, ifs::affineMap(1, 0, 0, 1, 5, 0)},
                                 {{a, b, c}, ifs::affineMap(0, -1, 1, 0, -3, 1)},
                                 {{c, c}, ifs::affineMap(2, 0, 0, 1, 0, 7)}};
        const auto near = [](const Box& x, const Box& y) {
            return (x.min - y.min).norm() < 1e-6 && (x.max - y.max).norm() < 1e-6;
        };
        const Box box = *displayedBox(fractal);
        Fractal unmoved = fractal;
        plane(unmoved)->moved.clear();
        QVERIFY(!near(box, *displayedBox(unmoved)));
        QVERIFY(near(box, *displayedBox(*baked(fractal))));
        for (const ifs::Word& word : {ifs::Word{0, 1}, ifs::Word{1, 2}, ifs::Word{2, 2, 2}, ifs::Word{1}}) {
            const auto branch = branchHandles(held(fractal), *plane(fractal)->cage, word, BranchEdit::OwnMap);
            const std::array<std::size_t, 1> index{branch->index};
            const Fractal own = branch->handles.withMapsChanged(index, ifs::affineMap(1, 0, 0, 1, 1e-14, 0));
            if (word.size() > 1) QVERIFY(*system2(own) != code);
            QVERIFY(near(box, *displayedBox(own)));
            // The branch is seen where it is shown.
            const auto shown =
                branchHandles(held(fractal), *plane(fractal)->cage, word, BranchEdit::Display)->handles;
            QVERIFY(farthest(shown.corners(0), branch->handles.corners(branch->index), {0, 0}) < 1e-9);
            const auto last = branchHandles(held(fractal), *plane(fractal)->cage, word, BranchEdit::LastMap);
            QVERIFY(farthest(shown.corners(0), last->handles.corners(last->index), {0, 0}) < 1e-9);
        }
    }
};

BARYCAGE_TEST(MapHandlesTest);
#include "document_map_handles_test.moc"
