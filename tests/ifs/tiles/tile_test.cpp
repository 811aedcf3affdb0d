// SPDX-License-Identifier: MIT
#include "ifs/tiles/tile.h"

#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <cmath>

using namespace ifs;
using support::near;

namespace {

using Maps = std::vector<AffineMap<2>>;

std::optional<Tile> tileOf(const Maps& maps) {
    const auto support = SupportFunction<2>::of(maps);
    if (!support) return std::nullopt;
    const BoundingBox<2> box = boundingBox(*support);
    const auto neighbours = neighbourGraph<2>(maps, box);
    return tile(maps, box, neighbours ? &*neighbours : nullptr);
}

Maps squares(int side) {
    Maps maps;
    const double scale = 1.0 / side;
    for (int k = 0; k < side * side; ++k)
        maps.push_back(affineMap(scale, 0, 0, scale, scale * (k % side), scale * (k / side)));
    return maps;
}

} // namespace

class TestTile : public QObject {
    Q_OBJECT

private slots:
    void twindragon() {
        const auto found = tileOf(canonical::twin());
        QVERIFY(found && found->isExact);
        QVERIFY(near(found->area, 1));
        QVERIFY(near(found->boundaryDimension, 1.523627086202492));
    }

    void squaresAreSquare() {
        const auto quarters = tileOf(squares(2));
        QVERIFY(quarters && quarters->isExact);
        QVERIFY(near(quarters->area, 1) && near(quarters->boundaryDimension, 1));
        const auto ninths = tileOf(squares(3));
        QVERIFY(ninths && !ninths->isExact); // 1/3 is no double
        QVERIFY(near(ninths->area, 1) && near(ninths->boundaryDimension, 1));
    }

    void largeOnesAreLeft() {
        QVERIFY(tileOf(squares(8)) && near(tileOf(squares(8))->area, 1));
        QVERIFY(!tileOf(squares(9)));
    }

    // Gaps that other pieces fill: digits 0, 1, 8, 9 in base 4 make two intervals of length 1.
    void tilesMayBeInPieces() {
        Maps maps;
        for (const int x : {0, 1, 8, 9})
            for (const int y : {0, 1, 2, 3})
                maps.push_back(affineMap(.25, 0, 0, .25, x / 4.0, y / 4.0));
        const auto found = tileOf(maps);
        QVERIFY(found && near(found->boundaryDimension, 1));
    }

    // Digits 0, 1, 3 of base 3, twice: the classes modulo 3 are not all there.
    void incompleteDigitsAreNoTile() {
        Maps maps;
        for (const int x : {0, 1, 3})
            for (const int y : {0, 1, 2})
                maps.push_back(affineMap(1 / 3., 0, 0, 1 / 3., x / 3.0, y / 3.0));
        const auto found = tileOf(maps);
        QVERIFY(!found || !found->area);
    }

    void boxesOfDifferentSides() { // no similarity, but the area is known
        Maps maps;
        for (int k = 0; k < 8; ++k)
            maps.push_back(affineMap(.5, 0, 0, .25, .5 * (k % 2), .25 * (k / 2)));
        const auto found = tileOf(maps);
        QVERIFY(found && near(found->area, 1) && !found->boundaryDimension);
    }

    // Turned and mirrored pieces: Duvall and Keesling's number for Lévy's curve, that of the twindragon for
    // Heighway's, and Koch's for the terdragon.
    void dragons() {
        const auto levy = tileOf(canonical::levy());
        QVERIFY(levy && levy->isExact && near(levy->area, .25));
        QVERIFY(near(levy->boundaryDimension, 1.934007182988291, 1e-8));
        const auto heighway = tileOf(canonical::heighway());
        QVERIFY(heighway && near(heighway->boundaryDimension, 1.523627086202492));
        QVERIFY(heighway->isExact && near(heighway->area, .5));
        const double third = 0.5, rise = std::sqrt(3.0) / 6;
        const auto turned = [](double a, double b, double e, double f) {
            return affineMap(a, -b, b, a, e, f);
        };
        const auto terdragon = tileOf({turned(third, rise, 0, 0), turned(0, -2 * rise, third, rise),
                                       turned(third, rise, third, -rise)});
        QVERIFY(terdragon && !terdragon->isExact);
        QVERIFY(near(terdragon->boundaryDimension, std::log(4) / std::log(3)));
        QVERIFY(near(terdragon->area, std::sqrt(3.0) / 6));
    }

    // β³ − β² − 2 = 0, and Koch's curve.
    // Copies of an L of three squares cover the plane without a lattice of translations.
    void chair() {
        const auto found = tileOf({affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, .5, .5),
                                   affineMap(0, -.5, .5, 0, 2, 0), affineMap(0, .5, -.5, 0, 0, 2)});
        QVERIFY(found && found->isExact && near(found->area, 3) && near(found->boundaryDimension, 1));
        // Four right triangles of one half, one of them turned.
        const auto triangle = tileOf({affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, .5, 0),
                                      affineMap(.5, 0, 0, .5, 0, .5), affineMap(-.5, 0, 0, -.5, .5, .5)});
        QVERIFY(triangle && triangle->isExact && near(triangle->area, .5));
    }

    void boundaryDimensionsHaveAnError() {
        for (const Maps& maps : {canonical::twin(), canonical::heighway()}) {
            const auto found = tileOf(maps);
            QVERIFY(std::abs(*found->boundaryDimension - 1.523627086202492) <=
                    found->boundaryDimensionError + 4e-16);
            QVERIFY(found->boundaryDimensionError > 0 && found->boundaryDimensionError < 1e-13);
        }
        const auto square = tileOf(squares(3));
        QVERIFY(std::abs(*square->boundaryDimension - 1) <= square->boundaryDimensionError);
        const auto levy = tileOf(canonical::levy());
        QVERIFY(levy->boundaryDimensionError > 0 && levy->boundaryDimensionError < 1e-10);
    }

    void othersAreNone() {
        QVERIFY(!tileOf(canonical::maple()));
        QVERIFY(!tileOf(canonical::sierpinskiRight()));
        Maps moved = canonical::twin(); // the sum of determinants is 1, and the pieces overlap
        moved[1].linear = moved[1].linear * Eigen::Rotation2D<double>(0.3).toRotationMatrix();
        QVERIFY(!tileOf(moved));
        Maps twice = squares(2);
        twice[3] = twice[2];
        QVERIFY(!tileOf(twice));
    }

    // Of area 0, or without a lattice, by more than rounding.
    void nearlyTilesAreNone() {
        for (const double ratio : {.4999999999, .5 - 0x1p-40, .5 - 0x1p-46, .5 + 0x1p-46}) {
            Maps maps = squares(2);
            for (auto& map : maps)
                map.linear *= 2 * ratio;
            QVERIFY(!tileOf(maps));
        }
        for (const double off : {1e-8, 1e-10, 1e-12, 0x1p-44}) {
            Maps maps = squares(2); // a dust in one direction, intervals that overlap in the other
            for (auto& map : maps)
                map.linear.diagonal() << .5 * (1 + off), .5 / (1 + off);
            QVERIFY(!tileOf(maps));
            maps = squares(2); // digits that are no lattice
            maps[3].translation.y() += off;
            QVERIFY(!tileOf(maps));
            maps = squares(3);
            maps[4].translation.x() += off;
            QVERIFY(!tileOf(maps));
            maps = canonical::heighway();
            maps[1].linear *= std::sqrt(1 - off);
            QVERIFY(!tileOf(maps));
            maps = canonical::heighway();
            maps[1].linear = maps[1].linear * Eigen::Rotation2D<double>(off).toRotationMatrix();
            QVERIFY(!tileOf(maps));
            maps.clear();
            for (int k = 0; k < 8; ++k)
                maps.push_back(affineMap(.5, 0, 0, .25, .5 * (k % 2), .25 * (k / 2)));
            maps[5].translation.y() += off;
            QVERIFY(!tileOf(maps));
        }
    }

    void movedTilesAreTheSame() {
        const AffineMap<2> there = affineMap(1.25, .5, -.25, 2, 3, -1);
        Maps maps;
        for (const auto& map : canonical::twin())
            maps.push_back(*conjugate(there, map));
        const auto found = tileOf(maps);
        QVERIFY(found && near(found->area, 1.25 * 2 + .125, 1e-8));
        QVERIFY(near(found->boundaryDimension, 1.523627086202492));
    }
};

BARYCAGE_TEST(TestTile);
#include "tile_test.moc"
