// SPDX-License-Identifier: MIT
#include "document/edits/maps/maps_arrange.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_handles.h"
#include "support/named_test.h"

#include <QTest>
#include <QUndoStack>

#include <array>

using namespace document;
using ifs::Vector;
using Arrangement = MapsArrangement;

namespace {

// Three maps at three heights, under a cage that is not at rest.
Fractal threeMapsApart() {
    System2 system;
    ifs::append(system, ifs::affineMap(.4, .1, 0, .3, 0, .05), 1.0);
    ifs::append(system, ifs::affineMap(.3, 0, .1, .4, .3, .4), 1.0);
    ifs::append(system, ifs::affineMap(.2, 0, 0, .2, .7, .1), 1.0);
    Fractal fractal;
    fractal.shape =
        Shape<2>{system, ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {3, 1.5}, {.5, 4}}}};
    return fractal;
}

std::vector<Vector<2>> corners(const Fractal& fractal, std::size_t index) {
    return MapHandles(std::make_shared<const Fractal>(fractal), effectiveCage(fractal)).corners(index);
}

Vector<2> centre(const Fractal& fractal, std::size_t index) {
    Vector<2> sum = Vector<2>::Zero();
    for (const Vector<2>& corner : corners(fractal, index))
        sum += corner / 3;
    return sum;
}

bool isNear(const Vector<2>& a, const Vector<2>& b) {
    return (a - b).norm() < 1e-12;
}

constexpr std::array<std::size_t, 3> all{0, 1, 2};

} // namespace

class MapsArrangeTest : public QObject {
    Q_OBJECT

private slots:
    // About the centre of all of them, as they are displayed.
    void flipsAndTurns() {
        const Fractal before = threeMapsApart();
        const std::array<std::size_t, 2> two{0, 2};
        const Vector<2> middle = (centre(before, 0) + centre(before, 2)) / 2;
        const struct {
            Arrangement arrangement;
            Vector<2> x, y; // where the axes go
        } cases[] = {{Arrangement::FlipLeftRight, {-1, 0}, {0, 1}},
                     {Arrangement::FlipUpDown, {1, 0}, {0, -1}},
                     {Arrangement::RotateLeft, {0, 1}, {-1, 0}},
                     {Arrangement::RotateRight, {0, -1}, {1, 0}}};
        for (const auto& [arrangement, x, y] : cases) {
            const Fractal after = arranged(before, two, arrangement);
            QVERIFY(system2(after)->maps[1] == system2(before)->maps[1]);
            for (const std::size_t index : two)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vector<2> arm = corners(before, index)[k] - middle;
                    QVERIFY(isNear(corners(after, index)[k], middle + arm.x() * x + arm.y() * y));
                }
        }
    }

    void centresAreAligned() {
        const Fractal before = threeMapsApart();
        for (const int axis : {0, 1}) {
            const Fractal after =
                arranged(before, all, axis == 0 ? Arrangement::AlignInColumn : Arrangement::AlignInRow);
            const double mean =
                (centre(before, 0)[axis] + centre(before, 1)[axis] + centre(before, 2)[axis]) / 3;
            for (const std::size_t index : all) {
                QVERIFY(std::abs(centre(after, index)[axis] - mean) < 1e-12);
                QVERIFY(std::abs(centre(after, index)[1 - axis] - centre(before, index)[1 - axis]) < 1e-12);
                QVERIFY((system2(after)->maps[index].map.linear - system2(before)->maps[index].map.linear)
                            .isZero(1e-14));
            }
        }
    }

    void centresAreDistributed() {
        const Fractal before = threeMapsApart();
        for (const int axis : {0, 1}) {
            const Fractal after = arranged(
                before, all, axis == 0 ? Arrangement::DistributeAcross : Arrangement::DistributeUpwards);
            std::array<double, 3> at{}, was{};
            for (const std::size_t index : all) {
                at[index] = centre(after, index)[axis];
                was[index] = centre(before, index)[axis];
            }
            std::ranges::sort(at);
            std::ranges::sort(was);
            QVERIFY(std::abs(at[0] - was[0]) < 1e-12 && std::abs(at[2] - was[2]) < 1e-12);
            QVERIFY(std::abs(at[1] - (at[0] + at[2]) / 2) < 1e-12);
            QVERIFY(std::abs(was[1] - at[1]) > 1e-3);
        }
    }

    // Then that corner is the fixed point of the map.
    void mapsGoToTheirCorners() {
        const Fractal before = threeMapsApart();
        const Fractal after = arranged(before, all, Arrangement::FitToCorners);
        const std::vector<Vector<2>> cage = effectiveCage(before).current;
        for (const std::size_t index : all) {
            std::size_t nearest = 0;
            for (std::size_t k = 0; k < 3; ++k)
                if ((corners(before, index)[k] - cage[k]).norm() <
                    (corners(before, index)[nearest] - cage[nearest]).norm())
                    nearest = k;
            QVERIFY(isNear(corners(after, index)[nearest], cage[nearest]));
            const Vector<2> rest = effectiveCage(before).rest[nearest];
            QVERIFY(isNear(system2(after)->maps[index].map(rest), rest));
        }
    }

    void oneStepOrASentence() {
        Document document;
        document.setFile(fileOf(threeMapsApart()));
        const auto some = [](std::size_t count) { return std::span(all).first(count); };
        QVERIFY(arrangeMaps(document, some(0), Arrangement::FlipUpDown));
        QVERIFY(arrangeMaps(document, some(1), Arrangement::AlignInRow));
        QVERIFY(arrangeMaps(document, some(2), Arrangement::DistributeAcross));
        QCOMPARE(document.undoStack()->count(), 0);
        QVERIFY(!arrangeMaps(document, some(1), Arrangement::RotateLeft));
        QCOMPARE(document.undoStack()->count(), 1);
        for (int k = 0; k < 3; ++k)
            QVERIFY(!arrangeMaps(document, some(1), Arrangement::RotateLeft));
        QVERIFY(isNear(corners(document.fractal(), 0)[1], corners(threeMapsApart(), 0)[1]));
        document.undoStack()->setIndex(0);
        QVERIFY(system2(document.fractal())->maps == system2(threeMapsApart())->maps);
    }
};

BARYCAGE_TEST(MapsArrangeTest, QCoreApplication);
#include "maps_arrange_test.moc"
