// SPDX-License-Identifier: MIT
#include "ifs/separation/hull_pieces.h"

#include "ifs/canonical_systems.h"
#include "ifs/facts.h"
#include "ifs/separation/determinant_sum.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace ifs;
using namespace canonical;
using support::near;

namespace {

AffineMap<2> scaledBy(double ratio, double x, double y) {
    return affineMap(ratio, 0, 0, ratio, x, y);
}

AffineMap<3> scaledBy(double ratio, double x, double y, double z) {
    return {ratio * Matrix<3>::Identity(), {x, y, z}};
}

Maps3 cubes(double ratio) {
    Maps3 maps;
    for (int k = 0; k < 8; ++k)
        maps.push_back(scaledBy(ratio, k % 2 * (1 - ratio), k / 2 % 2 * (1 - ratio), k / 4 * (1 - ratio)));
    return maps;
}

template <int Dim> OpenSetFacts openSetOf(const std::vector<AffineMap<Dim>>& maps) {
    return *factsOf(canonical::system<Dim>(maps)).invariants.openSet;
}

template <int Dim> void isSimilarityDimension(const std::vector<AffineMap<Dim>>& maps, double dimension) {
    const auto found = openSetOf<Dim>(maps);
    QCOMPARE(found.condition, OpenSetCondition::Holds);
    QCOMPARE(found.certainty, Certainty::Exact);
    QVERIFY(found.dimension && near(found.dimension->value, dimension, 1e-12));
    QCOMPARE(found.dimension->certainty, Certainty::Exact);
}

} // namespace

class HullPiecesTest : public QObject {
    Q_OBJECT

private slots:
    // Segments that touch at most, on lines that lean, in the plane and in space.
    void segments() {
        isSimilarityDimension<2>({scaledBy(.5, 0, 0), scaledBy(.5, .5, 1)}, 1);
        isSimilarityDimension<2>({scaledBy(.5, 0, 0), scaledBy(.25, .5, 0), scaledBy(.25, .75, 0)}, 1);
        isSimilarityDimension<2>({scaledBy(.5, 0, 0), scaledBy(-.25, .75, 2.25)},
                                 std::log2((1 + std::sqrt(5)) / 2));
        isSimilarityDimension<3>({scaledBy(.5, 0, 0, 0), scaledBy(.5, .5, 1, .25)}, 1);
        for (const double ratio : {.9, .75}) {
            const auto facts = factsOf(canonical::system<2>({scaledBy(ratio, 0, 0), scaledBy(-ratio, 1, 3)}));
            QCOMPARE(facts.invariants.contacts->connectedness, Connectedness::Connected);
            QCOMPARE(facts.invariants.openSet->condition, OpenSetCondition::Fails);
            QCOMPARE(facts.invariants.openSet->dimension->value, 1.0);
            QCOMPARE(facts.invariants.openSet->dimension->proof, HausdorffDimension::Proof::Convex);
        }
        QVERIFY(!piecesOfHull<2>(sierpinskiRight())->coverHull);
        QVERIFY(!piecesOfHull<2>(koch()));
    }

    // Boxes that do not even touch, by less than any cover by balls can show.
    void boxesApart() {
        for (const double ratio : {.5 - 0x1p-48, .5 - 0x1p-54, .5, .5 + 0x1p-53}) {
            const auto found = factsOf(canonical::system<2>({affineMap(ratio, 0, 0, .25, 0, 0),
                                                             affineMap(ratio, 0, 0, .25, 1, 0),
                                                             affineMap(ratio, 0, 0, .125, 0, 1)}))
                                   .invariants;
            const bool isApart = ratio < .5;
            QCOMPARE(found.contacts->separation == Separation::Strong, isApart);
            QCOMPARE(found.openSet->condition == OpenSetCondition::Holds, ratio <= .5);
        }
    }

    // Rounding leaves gaps between the squares of a carpet, which mean nothing.
    void carpetsStayInOnePiece() {
        Maps2 carpet;
        for (int k = 0; k < 9; ++k)
            if (k != 4) carpet.push_back(scaledBy(1. / 3, k % 3 / 3., k / 3 / 3.));
        const auto found = factsOf(canonical::system<2>(carpet)).invariants;
        QCOMPARE(found.contacts->connectedness, Connectedness::ConnectedToRounding);
        QCOMPARE(found.contacts->separation, Separation::Unknown);
    }

    // The condition fails where the images fill more than the line or plane that the attractor lies in.
    void tooMuchForTheAffineHull() {
        const auto fails = [](const OpenSetFacts& found) {
            QCOMPARE(found.condition, OpenSetCondition::Fails);
            QCOMPARE(found.certainty, Certainty::Exact);
        };
        fails(openSetOf<2>({scaledBy(.6180339887499, 0, 0), scaledBy(.6180339887499, 1, 0)}));
        fails(openSetOf<2>({scaledBy(-.75, 0, 0), scaledBy(-.5, 1, 1)}));
        fails(openSetOf<3>({scaledBy(.6, 0, 0, 0), scaledBy(.6, .4, 0, 0), scaledBy(.6, 0, .4, 0),
                            scaledBy(.6, .4, .4, 0)}));
        // On a leaning plane of space, x + y + z = 0.
        const Maps3 leaning{scaledBy(.75, 1, -1, 0), scaledBy(.75, 0, 1, -1), scaledBy(.75, -1, 0, 1)};
        const auto excess = excessOnHull<3>(leaning);
        QVERIFY(excess && excess->dimension == 2 && excess->value == 3 * .75 * .75 - 1);
        fails(openSetOf<3>(leaning));
        const Maps3 loose{scaledBy(.5, 1, -1, 0), scaledBy(.5, 0, 1, -1), scaledBy(.5, -1, 0, 1)};
        QVERIFY(excessOnHull<3>(loose)->value == -.25);
        QVERIFY(openSetOf<3>(loose).condition != OpenSetCondition::Fails);
    }

    void tilesOfHulls() {
        Maps2 square{scaledBy(.5, 0, 0), scaledBy(.5, .5, 0), scaledBy(.5, 0, .5)};
        for (int k = 0; k < 4; ++k)
            square.push_back(scaledBy(.25, .5 + k % 2 * .25, .5 + k / 2 * .25));
        Maps2 boxes;
        for (int k = 0; k < 8; ++k)
            boxes.push_back(affineMap(.5, 0, 0, .25, k % 2 * .5, k / 2 * .25));
        // Four triangles, the middle one upside down, three and a quarter of it: no box.
        const Maps2 triangle{scaledBy(.5, 0, 0), scaledBy(.5, .5, 0), scaledBy(.5, 0, .5),
                             scaledBy(-.5, .5, .5)};
        for (const auto& [maps, area] : {std::pair(square, 1.), {boxes, 1.}, {triangle, .5}}) {
            const auto facts = factsOf(canonical::system<2>(maps));
            const Invariants& found = facts.invariants;
            QCOMPARE(found.openSet->condition, OpenSetCondition::Holds);
            QCOMPARE(found.openSet->certainty, Certainty::Exact);
            QVERIFY(found.openSet->dimension && near(found.openSet->dimension->value, 2, 1e-12));
            QVERIFY(found.tile && found.tile->area && near(*found.tile->area, area, 1e-12));
            QVERIFY(found.tile->isExact);
        }
        // A polygon that leans, of pieces of two sizes.
        Maps2 leaning = square;
        for (auto& map : leaning)
            map = *conjugate(affineMap(1, -1, 1, 1, 3, 4), map);
        isSimilarityDimension<2>(leaning, 2);
        // Overlapping squares are one square, but no tile.
        const auto covered = factsOf(canonical::system<2>(
            {scaledBy(.75, 0, 0), scaledBy(.75, 1, 0), scaledBy(.75, 0, 1), scaledBy(.75, 1, 1)}));
        QCOMPARE(covered.invariants.openSet->condition, OpenSetCondition::Fails);
        QCOMPARE(covered.invariants.openSet->dimension->value, 2.0);
        QCOMPARE(covered.invariants.openSet->dimension->proof, HausdorffDimension::Proof::Convex);
        QVERIFY(!covered.invariants.tile);
    }

    void cubesOfSpace() {
        const auto full = factsOf(canonical::system<3>(cubes(.75))).invariants;
        QCOMPARE(full.contacts->connectedness, Connectedness::Connected);
        QCOMPARE(full.openSet->condition, OpenSetCondition::Fails);
        QCOMPARE(full.openSet->dimension->value, 3.0);
        Maps3 cut = cubes(.5);
        const AffineMap<3> last = cut.back();
        cut.pop_back();
        for (const auto& small : cubes(.5))
            cut.push_back(last * small);
        isSimilarityDimension<3>(cut, 3);
        QVERIFY(piecesOfHull<3>(cut)->coverHull);
        cut.pop_back();
        QVERIFY(!piecesOfHull<3>(cut)->coverHull && piecesOfHull<3>(cut)->haveDisjointInsides);
    }

    // Boxes with sides in multiples of 1/32 in the unit square, two of them in opposite corners: cells of
    // 1/32 are in none, one or more of them.
    void againstCells() {
        std::mt19937 random(11);
        int covered = 0, disjoint = 0;
        for (int n = 0; n < 4000; ++n) {
            Maps2 maps;
            std::vector<int> count(32 * 32, 0);
            const int boxes = 4 + int(random() % 3);
            const bool isEven = n % 2 == 0;
            for (int k = 0; k < boxes; ++k) {
                const int w = isEven ? 16 : int(13 + random() % 12),
                          h = isEven ? 16 : int(13 + random() % 12);
                const int x = k % 2 == 0 ? 0 : 32 - w, y = k / 2 % 2 == 0 ? 0 : 32 - h;
                const bool isTurned = random() % 2 == 0;
                maps.push_back(affineMap(isTurned ? -w / 32. : w / 32., 0, 0, h / 32.,
                                         (isTurned ? x + w : x) / 32., y / 32.));
                for (int a = x; a < x + w; ++a)
                    for (int b = y; b < y + h; ++b)
                        ++count[std::size_t(32 * a + b)];
                if (n % 4 == 0 && k == 3) break;
            }
            const auto found = piecesOfHull<2>(maps);
            QVERIFY(found && found->area && near(*found->area, 1, 1e-12));
            QCOMPARE(found->coverHull, std::ranges::none_of(count, [](int c) { return c == 0; }));
            QCOMPARE(found->haveDisjointInsides, std::ranges::all_of(count, [](int c) { return c <= 1; }));
            covered += found->coverHull ? 1 : 0;
            disjoint += found->haveDisjointInsides ? 1 : 0;
        }
        QVERIFY(covered > 100 && covered < 3900 && disjoint > 100 && disjoint < 3900);
    }
};

BARYCAGE_TEST(HullPiecesTest);
#include "hull_pieces_test.moc"
