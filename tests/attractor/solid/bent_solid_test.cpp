// SPDX-License-Identifier: MIT
#include "attractor/render/cloud_rendering.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/solid/space_view.h"
#include "attractor/space_systems.h"
#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

using namespace attractor;
using ifs::Vector;

namespace {

std::vector<Vector<3>> cubeCorners() {
    std::vector<Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    return corners;
}

// Menger's sponge in its box, of which two corners are pulled.
SpaceRequest pulled(bool isPerspective) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), 200, 160);
    ifs::ControlCage<3> cage = ifs::polygonAtRest<3>(cubeCorners());
    cage.current[7] += Vector<3>(0.5, 0.4, 0.3);
    cage.current[1] += Vector<3>(0.2, -0.3, 0.1);
    request.cage = cage;
    request.camera.target = {0.6, 0.5, 0.5};
    request.camera.height = 2.4;
    if (isPerspective) request.camera.projection = OrbitCamera::Projection::Perspective;
    return request;
}

// The nearest depths that random points of the attractor have, bent one by one.
std::vector<double> bruteForce(const SpaceRequest& request, int points) {
    const RasterSize size = request.camera.size;
    std::vector<double> nearest(std::size_t(size.width) * std::size_t(size.height), HUGE_VAL);
    const ifs::CageDeformation bend(request.cage->rest, request.cage->current);
    std::mt19937 random(3);
    Vector<3> x(0, 0, 0);
    for (int n = 0; n < points; ++n) {
        x = request.system.maps[random() % request.system.maps.size()].map(x);
        const ScreenPoint seen = toScreen(request.camera, bend(x));
        const int column = int(std::floor(seen.pixel.x())), row = int(std::floor(seen.pixel.y()));
        if (column < 0 || column >= size.width || row < 0 || row >= size.height) continue;
        double& known = nearest[std::size_t(row) * std::size_t(size.width) + std::size_t(column)];
        known = std::min(known, seen.depth);
    }
    return nearest;
}

double depthAt(const DepthRaster& raster, int x, int y) {
    const std::uint32_t key = raster.keys[std::size_t(y) * std::size_t(raster.width) + std::size_t(x)];
    return key == emptyKey ? HUGE_VAL : depthOf(raster, key);
}

DepthRaster drawn(const SpaceRequest& request) {
    SolidRendering rendering(request);
    rendering.draw();
    return rendering.takeRaster();
}

} // namespace

class BentSolidTest : public QObject {
    Q_OBJECT

private slots:
    void theSolidIsWhereItsPointsAre_data() {
        QTest::addColumn<bool>("isPerspective");
        QTest::newRow("orthographic") << false;
        QTest::newRow("perspective") << true;
    }
    // No point lies in front of the solid by more than two pixels, and no pixel of it is far from points.
    void theSolidIsWhereItsPointsAre() {
        QFETCH(bool, isPerspective);
        const SpaceRequest request = pulled(isPerspective);
        const DepthRaster raster = drawn(request);
        const auto points = bruteForce(request, 400'000);
        const double pixel = 1 / pixelsPerUnit(request.camera);
        const auto depth = [&](int x, int y) { return depthAt(raster, x, y); };
        std::size_t seen = 0, inFront = 0, alone = 0;
        for (int y = 1; y + 1 < raster.height; ++y)
            for (int x = 1; x + 1 < raster.width; ++x) {
                double point = HUGE_VAL, solid = HUGE_VAL;
                for (int v = y - 1; v <= y + 1; ++v)
                    for (int u = x - 1; u <= x + 1; ++u) {
                        point = std::min(point,
                                         points[std::size_t(v) * std::size_t(raster.width) + std::size_t(u)]);
                        solid = std::min(solid, depth(u, v));
                    }
                const double here = points[std::size_t(y) * std::size_t(raster.width) + std::size_t(x)];
                if (here < HUGE_VAL && !(solid <= here + 2 * pixel)) ++inFront;
                if (depth(x, y) == HUGE_VAL) continue;
                ++seen;
                if (point == HUGE_VAL) ++alone;
            }
        QVERIFY(seen > 3000);
        QCOMPARE(inFront, std::size_t(0));
        QVERIFY2(alone * 100 < seen, qPrintable(QString::number(alone)));
    }

    // The affine image of a box is that of its tetrahedron, but for the last bits of the map.
    void whatDoesNotBendIsDrawnAsBefore() {
        SpaceRequest request = pulled(false);
        request.cage->current = request.cage->rest;
        for (Vector<3>& corner : request.cage->current)
            corner += Vector<3>(0.25, 0, 0.5);
        const DepthRaster box = drawn(request);
        const auto& rest = request.cage->rest;
        const auto& current = request.cage->current;
        request.cage = ifs::ControlCage<3>{{rest[0], rest[1], rest[2], rest[4]},
                                           {current[0], current[1], current[2], current[4]}};
        const DepthRaster simplex = drawn(request);
        std::size_t others = 0, all = 0;
        for (int y = 0; y < box.height; ++y)
            for (int x = 0; x < box.width; ++x) {
                const double a = depthAt(box, x, y), b = depthAt(simplex, x, y);
                all += a < HUGE_VAL || b < HUGE_VAL;
                others += a != b && !(std::abs(a - b) < 1e-5);
            }
        QVERIFY(all > 3000 && others * 500 < all);
    }

    void aBentPictureIsTheSameForAnyThreads() {
        SpaceRequest request = pulled(true);
        const DepthRaster one = drawn(request);
        request.threads = 3;
        QVERIFY(drawn(request).keys == one.keys);
    }

    void aWordIsStraightWithinItsMiss() {
        const SpaceRequest request = pulled(false);
        const SpaceView view = spaceView(request, {});
        QVERIFY(view.bend);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> side(-1, 1);
        for (const double half : {0.1, 0.02, 0.004}) {
            const ifs::AffineMap<3> word{half * ifs::Matrix<3>::Identity(), Vector<3>(0.4, 0.55, 0.3)};
            const StraightWord straight = straightened(word, view);
            for (int n = 0; n < 200; ++n) {
                const Vector<3> at(side(random), side(random), side(random));
                const Vector<3> exact = view.afterBend((*view.bend)(word(at)));
                const Vector<3> off = (straight.word(at) - exact).cwiseAbs();
                QVERIFY((off.array() <= straight.miss.array() + 1e-6).all());
            }
        }
    }

    // What is known of a word tells where the words in it are, as well as looking at the cage does.
    void wordsInAWordFollowFromIt() {
        for (const bool isPerspective : {false, true}) {
            const SpaceRequest request = pulled(isPerspective);
            const SpaceView view = spaceView(request, {});
            std::mt19937 random(6);
            std::uniform_real_distribution<double> side(-1, 1);
            std::size_t followed = 0;
            for (int start = 0; start < 40; ++start) {
                const Vector<3> middle(0.5 + 0.4 * side(random), 0.5 + 0.4 * side(random),
                                       0.5 + 0.4 * side(random));
                WalkedWord word{{0.02 * ifs::Matrix<3>::Identity(), middle}};
                for (int depth = 0; depth < 4; ++depth) {
                    const StraightWord straight = straightened(word, view);
                    if (depth > 0 && word.follows && word.within.linear != ifs::Matrix<3>::Identity())
                        ++followed;
                    for (int n = 0; n < 20; ++n) {
                        const Vector<3> at(side(random), side(random), side(random));
                        const Vector<3> exact = view.afterBend((*view.bend)(word.word(at)));
                        const Vector<3> off = (straight.word(at) - exact).cwiseAbs();
                        QVERIFY((off.array() <= straight.miss.array() + 1e-6).all());
                    }
                    QVERIFY(depth < 3 || straight.miss.maxCoeff() < 0.25); // straight enough to be drawn
                    word = word.inside({ifs::Matrix<3>::Identity() / 3,
                                        Vector<3>(side(random), side(random), side(random)) * (2.0 / 3)});
                }
            }
            QVERIFY(followed > 60);
        }
    }

    // Of a word whose bend is not known well, the words in it are where it says, in larger boxes.
    void aGlimpseHoldsWhatTheWordShows() {
        const SpaceRequest request = pulled(false);
        const SpaceView view = spaceView(request, {});
        const Vector<3> corner(view.size.width / 2.0, view.size.height / 2.0, 0);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> side(-1, 1);
        std::size_t rough = 0;
        for (int start = 0; start < 60; ++start) {
            const Vector<3> middle(0.5 + 0.3 * side(random), 0.5 + 0.3 * side(random),
                                   0.5 + 0.3 * side(random));
            WalkedWord outer{{0.2 * ifs::Matrix<3>::Identity(), middle}};
            straightened(outer, view);
            WalkedWord word = outer.inside({ifs::Matrix<3>::Identity() / 3,
                                            Vector<3>(side(random), side(random), side(random)) * (2.0 / 3)});
            rough += !word.follows;
            const SeenWord glimpse = glimpsed(word, view);
            QVERIFY(word.bent == outer.bent);
            for (int n = 0; n < 50; ++n) {
                const Vector<3> at(side(random), side(random), side(random));
                const Vector<3> exact = view.afterBend((*view.bend)(word.word(at))) + corner;
                QVERIFY((glimpse.onScreen(at) - exact).cwiseAbs().maxCoeff() <= glimpse.miss + 1e-6);
                QVERIFY((glimpse.half.array() - (glimpse.onScreen.translation - exact).cwiseAbs().array() >=
                         -1e-6)
                            .all());
            }
        }
        QVERIFY(rough > 30);
    }

    void aFoldedAndAFlatCageAreDrawn() {
        SpaceRequest request = pulled(false);
        std::swap(request.cage->current[0], request.cage->current[7]);
        std::swap(request.cage->current[1], request.cage->current[2]);
        QVERIFY(std::ranges::any_of(drawn(request).keys, [](std::uint32_t key) { return key != emptyKey; }));
        for (Vector<3>& corner : request.cage->current)
            corner.z() = 0.5;
        request.cage->current[3] += Vector<3>(0.5, 0.25, 0);
        QVERIFY(std::ranges::any_of(drawn(request).keys, [](std::uint32_t key) { return key != emptyKey; }));
        for (Vector<3>& corner : request.cage->current)
            corner *= 1e100;
        drawn(request); // nothing to see, in bounded time
    }

    void aCloudIsBentLikeTheSolid() {
        SpaceRequest request = pulled(true);
        request.samples = 300'000;
        const DepthRaster solid = drawn(request);
        CloudRendering cloud(request);
        QVERIFY(cloud.refine());
        std::vector<std::uint32_t> pixels(solid.keys.size());
        QVERIFY(cloud.tone(std::span(pixels)));
        std::size_t lit = 0, outside = 0;
        for (int y = 2; y + 2 < solid.height; ++y)
            for (int x = 2; x + 2 < solid.width; ++x) {
                const std::size_t at = std::size_t(y) * std::size_t(solid.width) + std::size_t(x);
                if (std::max({pixels[at] >> 16 & 0xFF, pixels[at] >> 8 & 0xFF, pixels[at] & 0xFF}) < 60)
                    continue;
                ++lit;
                bool isThere = false;
                for (int v = -2; v <= 2; ++v)
                    for (int u = -2; u <= 2; ++u)
                        isThere = isThere || depthAt(solid, x + u, y + v) < HUGE_VAL;
                if (!isThere) ++outside;
            }
        QVERIFY(lit > 1000);
        QVERIFY2(outside * 200 < lit, qPrintable(QString::number(outside)));
    }
};

BARYCAGE_TEST(BentSolidTest);
#include "bent_solid_test.moc"
