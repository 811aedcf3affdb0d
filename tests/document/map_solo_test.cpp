// SPDX-License-Identifier: MIT
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/map_points.h"
#include "document/maps/map_solo.h"
#include "ifs/system/links.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

using namespace document;

namespace {

Fractal triangleOfMaps() {
    return sierpinskiTriangle();
}

ifs::MapId idOf(const Fractal& fractal, std::size_t index) {
    return system2(fractal) ? system2(fractal)->maps[index].id : system3(fractal)->maps[index].id;
}

// What is drawn of an entry in the plane, as points of the code.
std::vector<ifs::Vector<2>> drawn(const Fractal& fractal) {
    const attractor::RenderRequest request = renderRequest(fractal, {});
    const attractor::PreparedSystem system = attractor::prepared(request.system, request.moved);
    attractor::Orbit orbit(system, 1);
    std::vector<ifs::Vector<2>> points;
    for (int k = 0; k < 2000; ++k)
        points.push_back(orbit.next().x);
    return points;
}

Fractal spaceFractal() {
    System3 system;
    for (const ifs::Vector<3>& corner :
         {ifs::Vector<3>(0, 0, 0), ifs::Vector<3>(1, 0, 0), ifs::Vector<3>(0, 1, 0), ifs::Vector<3>(0, 0, 1)})
        ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 2, corner / 2}, 1.0);
    return support::fractalOf(system);
}

int coloured(const QImage& picture, const QRect& area) {
    int count = 0;
    for (int y = area.top(); y <= area.bottom(); ++y)
        for (int x = area.left(); x <= area.right(); ++x)
            if (const QRgb pixel = picture.pixel(x, y);
                qAlpha(pixel) > 60 && (qRed(pixel) != qGreen(pixel) || qGreen(pixel) != qBlue(pixel)))
                ++count;
    return count;
}

} // namespace

class MapSoloTest : public QObject {
    Q_OBJECT

private slots:
    // The image of all of the attractor under the map, and nothing else.
    void drawsTheImageOfTheMap() {
        const Fractal whole = triangleOfMaps();
        for (std::size_t index = 0; index < 3; ++index) {
            const ifs::AffineMap<2> map = system2(whole)->maps[index].map;
            const Fractal alone = soloed(whole, idOf(whole, index));
            QVERIFY(isSameSystem(alone, whole)); // the same code, drawn elsewhere
            const auto all = drawn(whole), some = drawn(alone);
            for (std::size_t k = 0; k < all.size(); ++k)
                QVERIFY((some[k] - map(all[k])).norm() < 1e-12);
        }
    }

    // A map that takes all to a line, and branches that are moved, inside and elsewhere.
    void singularMapsAndMovedBranches() {
        Fractal fractal = triangleOfMaps();
        system2(fractal)->maps[0].map.linear(1, 1) = 0;
        for (const ifs::Vector<2>& point : drawn(soloed(fractal, idOf(fractal, 0))))
            QVERIFY(std::abs(point.y() - system2(fractal)->maps[0].map.translation.y()) < 1e-12);
        Fractal moved = triangleOfMaps();
        const auto a = idOf(moved, 0), b = idOf(moved, 1);
        const ifs::AffineMap<2> aside{ifs::Matrix<2>::Identity(), {10, 0}};
        plane(moved)->moved = {{{a}, aside}, {{b}, {ifs::Matrix<2>::Identity(), {0, 50}}}};
        for (const ifs::Vector<2>& point : drawn(soloed(moved, a)))
            QVERIFY(point.x() >= 9 && point.y() < 20);
        plane(moved)->moved = {{{a, b}, aside}};
        int far = 0;
        for (const ifs::Vector<2>& point : drawn(soloed(moved, a)))
            far += point.x() > 9 ? 1 : 0;
        QVERIFY(far > 300 && far < 1200); // a third of it
    }

    void coloursAreThoseOfTheWhole() {
        Fractal fractal = triangleOfMaps();
        fractal.appearance.colourBy = attractor::ColourBy::Map;
        fractal.appearance.mapColours[idOf(fractal, 1)] = {9, 8, 7, 255};
        const Fractal alone = soloed(fractal, idOf(fractal, 1));
        for (std::size_t index = 0; index < 3; ++index)
            QVERIFY((attractor::mapColour(alone.appearance, idOf(alone, index), index) ==
                     attractor::Rgba{9, 8, 7, 255}));
        fractal.appearance.colourBy = attractor::ColourBy::Address;
        const Fractal second = soloed(fractal, idOf(fractal, 1));
        for (int k = 0; k <= 20; ++k) {
            const auto got = attractor::colourAt(second.appearance.palette, k / 20.0);
            const auto wanted = attractor::colourAt(fractal.appearance.palette, (1 + k / 20.0) / 3);
            QVERIFY(std::abs(got.red - wanted.red) <= 1 && std::abs(got.green - wanted.green) <= 1 &&
                    std::abs(got.blue - wanted.blue) <= 1);
        }
    }

    void linkedMapsAreNotShownAlone() {
        Fractal fractal = triangleOfMaps();
        ifs::setLinks(*system2(fractal), std::vector<double>{1, 0, 1, 1, 1, 1, 1, 1, 1});
        QVERIFY(!soloObstacle(fractal, idOf(fractal, 0)).isEmpty());
        QVERIFY(soloed(fractal, idOf(fractal, 0)) == fractal);
        QVERIFY(!soloObstacle(fractal, ifs::MapId::None).isEmpty());
        QVERIFY(soloObstacle(triangleOfMaps(), idOf(fractal, 0)).isEmpty());
    }

    // By its cage, which is that of the whole after the map.
    void inSpaceTheCageHoldsTheImage() {
        Fractal fractal = spaceFractal();
        system3(fractal)->maps[1].map.linear(2, 2) = 0; // flat
        for (const bool hasCage : {false, true}) {
            ifs::AffineMap<3> display;
            if (hasCage) {
                space(fractal)->cage = ifs::polygonAtRest<3>({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
                space(fractal)->cage->current[1] = {2, 1, 0};
                display = ifs::displayMap(*space(fractal)->cage);
            }
            for (std::size_t index = 0; index < 4; ++index) {
                const Fractal alone = soloed(fractal, idOf(fractal, index));
                const ifs::AffineMap<3> shown = ifs::displayMap(*space(alone)->cage);
                const ifs::AffineMap<3> map = system3(fractal)->maps[index].map;
                QVERIFY(ifs::isValid(*space(alone)->cage));
                for (const ifs::Vector<3>& x : {ifs::Vector<3>(0, 0, 0), ifs::Vector<3>(.3, .2, .4)})
                    QVERIFY((shown(x) - display(map(x))).norm() < 1e-3);
                QVERIFY(spaceRequest(alone, {}).system == *system3(fractal));
            }
        }
        system3(fractal)->maps[0].map.linear.setZero();
        QVERIFY(!soloObstacle(fractal, idOf(fractal, 0)).isEmpty());
    }

    // Its branches are where they are in the whole.
    void inSpaceBranchesStayMoved() {
        Fractal fractal = spaceFractal();
        const auto maps = ifs::mapsOf(*system3(fractal));
        ifs::AffineMap<3> up;
        up.translation = {0.1, 0.7, 0.2};
        ifs::AffineMap<3> large;
        large.linear *= 2;
        space(fractal)->moved = {{{idOf(fractal, 1)}, up},
                                 {{idOf(fractal, 1), idOf(fractal, 2)}, large},
                                 {{idOf(fractal, 3), idOf(fractal, 2)}, up}};
        const auto shownAt = [&](const Fractal& of, const ifs::Word& word) {
            const auto pieces = ifs::pieces<3>(movedBranches(*space(of)), maps.size());
            const ifs::Vector<3> x = ifs::composed<3>(maps, word)(ifs::Vector<3>(0.3, 0.2, 0.1));
            const auto& cage = space(of)->cage;
            const ifs::AffineMap<3> display = cage ? ifs::displayMap(*cage) : ifs::AffineMap<3>();
            return ifs::Vector<3>(display(ifs::pieceOf<3>(pieces, word).change(x)));
        };
        for (const std::size_t index : {1U, 3U, 0U}) {
            const Fractal alone = soloed(fractal, idOf(fractal, index));
            for (int letter = 0; letter < 4; ++letter)
                QVERIFY(
                    (shownAt(alone, {letter, 0, 0}) - shownAt(fractal, {int(index), letter, 0, 0})).norm() <
                    1e-12);
        }
    }

    // The part that the map makes, in its colour and in its place; y points upwards.
    void thumbnailsShowTheImage() {
        const Fractal fractal = triangleOfMaps();
        const MapPoints points(fractal, 40, 40);
        const attractor::Rgba faint{128, 128, 128, 80};
        const QImage first = points.picture(0, faint), last = points.picture(2, faint);
        QCOMPARE(first.size(), QSize(40, 40));
        const QRect below(0, 20, 20, 20), above(0, 0, 40, 20);
        QVERIFY(coloured(first, below) > 40 && coloured(first, above) < 6);
        QVERIFY(coloured(last, above) > 40 && coloured(last, QRect(0, 22, 40, 18)) < 6);
        int faintPixels = 0; // of the whole
        for (int y = 20; y < 40; ++y)
            for (int x = 20; x < 40; ++x)
                faintPixels += qAlpha(first.pixel(x, y)) > 10;
        QVERIFY(faintPixels > 20);
        QVERIFY(points.picture(3, faint).isNull());
        const MapPoints solid(spaceFractal(), 40, 30);
        QVERIFY(coloured(solid.picture(0, faint), QRect(0, 0, 40, 30)) > 20);
        QVERIFY(MapPoints(Fractal(), 40, 30).picture(0, faint).isNull());
        Fractal noMaps;
        noMaps.shape = Shape<2>{};
        QVERIFY(MapPoints(noMaps, 40, 30).picture(0, faint).isNull());
        Fractal expanding = triangleOfMaps();
        for (auto& map : system2(expanding)->maps)
            map.map.linear *= 5;
        MapPoints(expanding, 40, 30).picture(0, faint);
    }
};

BARYCAGE_TEST(MapSoloTest, QCoreApplication);
#include "map_solo_test.moc"
