// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace document;
using ifs::Vector;

namespace {

// A sponge of which one corner is shown elsewhere, turned, and a part of that corner is larger.
Fractal movedSponge() {
    Fractal fractal;
    Shape<3> shape{systems::menger()};
    const auto& maps = shape.system.maps;
    const ifs::AffineMap<3> out{Eigen::AngleAxisd(0.4, Vector<3>(1, 2, 3).normalized()).toRotationMatrix(),
                                Vector<3>(0.7, 0.4, 0.6)};
    const ifs::AffineMap<3> larger{1.5 * ifs::Matrix<3>::Identity(), Vector<3>(-0.7, 0.1, -0.1)};
    shape.moved = {{{maps[19].id}, out}, {{maps[19].id, maps[3].id}, larger}};
    fractal.shape = shape;
    return fractal;
}

void bendInSpace(Fractal& fractal) {
    ifs::ControlCage<3> cage;
    for (int k = 0; k < 8; ++k)
        cage.rest.emplace_back((k & 1) != 0 ? 1.2 : -0.2, (k & 2) != 0 ? 1.2 : -0.2,
                               (k & 4) != 0 ? 1.2 : -0.2);
    cage.current = cage.rest;
    cage.current[7] += Vector<3>(0.5, 0.3, -0.2);
    space(fractal)->cage = cage;
}

// Where the point whose address repeats the word is displayed.
Vector<3> pointAt(const Fractal& fractal, const ifs::Word& word) {
    const Shape<3>& shape = *space(fractal);
    const auto maps = ifs::mapsOf(shape.system);
    ifs::Word address = word;
    address.insert(address.end(), word.begin(), word.end());
    const auto pieces = ifs::pieces<3>(movedBranches(shape), maps.size());
    const Vector<3> x = ifs::pieceOf<3>(pieces, address).change(*ifs::addressPoint<3>(maps, {}, word));
    if (shape.cage && ifs::bends(*shape.cage))
        return ifs::CageDeformation(shape.cage->rest, shape.cage->current)(x);
    return shape.cage ? ifs::displayMap(*shape.cage)(x) : x;
}

bool beginsWith(const ifs::Word& address, const ifs::Word& word) {
    return address.size() >= word.size() && std::equal(word.begin(), word.end(), address.begin());
}

} // namespace

// Branches in space that a file shows elsewhere, and cages that bend: what is known of points there.
class MovedInSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreDrawn() {
        const Fractal fractal = movedSponge();
        const attractor::SpaceRequest request = spaceRequest(fractal, {});
        QCOMPARE(request.moved.size(), std::size_t(2));
        QVERIFY(request.moved[1].word == (ifs::Word{19, 3}));
        QVERIFY(request.moved[0].change == space(fractal)->moved[0].change);
    }

    // As far as the farthest point of the branches reaches, and no farther.
    void theViewHoldsThem() {
        Fractal fractal = movedSponge();
        Fractal inPlace = fractal;
        space(inPlace)->moved.clear();
        for (const bool isPlaced : {false, true}) {
            if (isPlaced) {
                auto cage = *spaceCage(inPlace);
                cage.current[1] += Vector<3>(0.3, 0.2, 0);
                space(fractal)->cage = space(inPlace)->cage = cage;
            }
            const auto maps = ifs::mapsOf(systems::menger());
            for (const Vector<3>& u :
                 {Vector<3>(1, 0, 0), Vector<3>(0, 0, -1), Vector<3>(1, 1, 1).normalized().eval()}) {
                double farthest = -HUGE_VAL;
                for (int a = 0; a < 20; ++a)
                    for (int b = 0; b < 20; ++b)
                        for (int c = 0; c < 20; ++c)
                            farthest = std::max(farthest, u.dot(pointAt(fractal, {a, b, c})));
                const Extent extent = extentAlong(fractal, u);
                QVERIFY(farthest <= extent.high + 1e-6);
                QVERIFY(farthest >= extent.high - 0.1);
                QVERIFY(std::abs(extent.high + extentAlong(fractal, -u).low) < 1e-6);
            }
            QVERIFY(extentAlong(fractal, Vector<3>::UnitX()).high >
                    extentAlong(inPlace, Vector<3>::UnitX()).high + 0.2);
        }
        QVERIFY(fittedToPicture(fractal, {}, 0).height > fittedToPicture(inPlace, {}, 0).height * 1.1);
    }

    // The address of what is under the pointer, wherever its branch is shown.
    void pointsHaveTheirAddresses_data() {
        QTest::addColumn<bool>("isBent");
        QTest::newRow("straight") << false;
        QTest::newRow("bent") << true;
    }
    void pointsHaveTheirAddresses() {
        QFETCH(bool, isBent);
        Fractal fractal = movedSponge();
        if (isBent) bendInSpace(fractal);
        for (const ifs::Word& word : {ifs::Word{19, 5, 7}, {19, 3, 2}, {2, 6, 1}, {0, 19, 3}, {12, 12, 4}}) {
            const ifs::Word address = addressInSpace(fractal, pointAt(fractal, word), 1e-4);
            QVERIFY2(beginsWith(address, word), qPrintable(addressText(address, 12)));
        }
        // Where a branch has been, nothing is any more.
        Fractal inPlace = fractal;
        space(inPlace)->moved.clear();
        QVERIFY(addressInSpace(fractal, pointAt(inPlace, {19, 5, 19}), 1e-4).empty());
    }

    // Bent, what is moved out of the cage is still in the view.
    void bentItIsInView() {
        Fractal fractal = movedSponge();
        bendInSpace(fractal);
        for (const ifs::Word& word : {ifs::Word{19, 19, 19}, {19, 3, 19}})
            for (const Vector<3>& u : {Vector<3>(1, 0, 0), Vector<3>(0, 1, 0), Vector<3>(0, 0, 1)})
                QVERIFY(u.dot(pointAt(fractal, word)) <= extentAlong(fractal, u).high);
    }
};

BARYCAGE_TEST(MovedInSpaceTest);
#include "moved_in_space_test.moc"
