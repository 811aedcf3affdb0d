// SPDX-License-Identifier: MIT
#include "attractor/arithmetic/arithmetic.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/space_systems.h"
#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace attractor;
using ifs::Vector;

namespace {

constexpr int width = 160;
constexpr int height = 120;

// A corner of the sponge is turned and taken out of it, and a part of that corner goes on alone.
SpaceRequest movedSponge() {
    SpaceRequest request = systems::spaceRequest(systems::menger(), width, height);
    request.camera.height *= 1.6;
    const ifs::AffineMap<3> out{Eigen::AngleAxisd(0.4, Vector<3>(1, 2, 3).normalized()).toRotationMatrix(),
                                Vector<3>(0.3, 0.45, -0.2)};
    const ifs::AffineMap<3> aside{1.5 * ifs::Matrix<3>::Identity(), Vector<3>(-0.7, 0.1, -0.1)};
    request.moved = {{{19}, out}, {{19, 3}, aside}};
    return request;
}

ifs::ControlCage<3> bentBox() {
    ifs::ControlCage<3> cage;
    for (int k = 0; k < 8; ++k)
        cage.rest.push_back(
            {(k & 1) != 0 ? 1.6 : -0.6, (k & 2) != 0 ? 1.6 : -0.6, (k & 4) != 0 ? 1.6 : -0.6});
    cage.current = cage.rest;
    cage.current[7] += Vector<3>(0.4, 0.3, -0.1);
    return cage;
}

struct Seen {
    Vector<2> pixel;
    double depth = 0;        // of the plane of the target, in pixels
    ifs::Word address = {0}; // as much as branches ask for
};

// Points of the chaos game, each moved as the branch is that it lies in.
template <class Show> void eachPoint(const SpaceRequest& request, std::size_t points, Show show) {
    const ifs::ActiveMaps<3> active = ifs::activeMaps(request.system);
    const auto pieces = ifs::pieces<3>(request.moved, active.maps.size());
    const bool bends = request.cage && ifs::bends(*request.cage);
    const auto bend =
        bends ? std::make_optional<ifs::CageDeformation>(request.cage->rest, request.cage->current)
              : std::nullopt;
    const AliasTable table(active.probabilities);
    Vector<3> x = *ifs::fixedPoint(active.maps.front());
    Seen seen;
    seen.address = {0, 0};
    for (std::size_t n = 0; n < points; ++n) {
        const auto map = table.draw(std::uint32_t(mixed(n) >> 32));
        x = active.maps[std::size_t(map)](x);
        seen.address = {int(map), seen.address.front()};
        Vector<3> at = ifs::pieceOf<3>(pieces, seen.address).change(x);
        if (bend) at = (*bend)(at);
        const ScreenPoint screen = toScreen(request.camera, at);
        seen.pixel = screen.pixel;
        seen.depth = screen.depth * pixelsPerUnit(request.camera);
        const bool isIn =
            seen.pixel.x() >= 0 && seen.pixel.x() < width && seen.pixel.y() >= 0 && seen.pixel.y() < height;
        if (isIn && n > 100) show(seen);
    }
}

std::size_t at(const Vector<2>& pixel) {
    return std::size_t(pixel.y()) * width + std::size_t(pixel.x());
}

// Whether it holds of a pixel or of one of its neighbours.
template <class Match> bool around(std::size_t pixel, const Match& isMatch) {
    const int x = int(pixel % width), y = int(pixel / width);
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
            if (isMatch(std::size_t(v * width + u))) return true;
    return false;
}

} // namespace

// What a file in space shows elsewhere is drawn there.
class MovedSolidsTest : public QObject {
    Q_OBJECT

private slots:
    void solidsAgreeWithBruteForce_data() {
        QTest::addColumn<bool>("isPerspective");
        QTest::addColumn<bool>("isBent");
        QTest::newRow("orthographic") << false << false;
        QTest::newRow("perspective") << true << false;
        QTest::newRow("bent") << true << true;
    }
    void solidsAgreeWithBruteForce() {
        QFETCH(bool, isPerspective);
        QFETCH(bool, isBent);
        SpaceRequest request = movedSponge();
        if (isPerspective) request.camera.projection = OrbitCamera::Projection::Perspective;
        if (isBent) request.cage = bentBox();
        std::vector<double> wanted(width * height, HUGE_VAL);
        eachPoint(request, 5'000'000, [&](const Seen& seen) {
            wanted[at(seen.pixel)] = std::min(wanted[at(seen.pixel)], seen.depth);
        });
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        const DepthRaster& raster = rendering.raster();
        const double scale = pixelsPerUnit(request.camera);
        const auto found = [&](std::size_t k) {
            return raster.keys[k] == emptyKey ? HUGE_VAL : depthOf(raster, raster.keys[k]) * scale;
        };
        std::size_t filled = 0, missed = 0, drawn = 0, invented = 0;
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const double depth = found(k);
            filled += std::isfinite(wanted[k]);
            missed += std::isfinite(wanted[k]) &&
                      !around(k, [&](std::size_t near) { return found(near) <= wanted[k] + 1; });
            drawn += std::isfinite(depth);
            invented += std::isfinite(depth) &&
                        !around(k, [&](std::size_t near) { return wanted[near] <= depth + 1; });
        }
        qInfo("filled %zu missed %zu, drawn %zu invented %zu", filled, missed, drawn, invented);
        QVERIFY(filled > 2000);
        QVERIFY(missed <= filled / 1000);
        QVERIFY(invented <= drawn / 500);
        // It is seen that branches are elsewhere.
        SpaceRequest inPlace = request;
        inPlace.moved.clear();
        rendering.restart(inPlace);
        QVERIFY(rendering.draw());
        std::size_t others = 0;
        for (std::size_t k = 0; k < wanted.size(); ++k)
            others += std::isfinite(found(k)) != std::isfinite(wanted[k]);
        qInfo("others %zu", others);
        QVERIFY(others > 150);
    }

    // A branch keeps the colour of its address.
    void branchesKeepTheirColours() {
        for (const SolidKey key : {SolidKey::Map, SolidKey::Address}) {
            SpaceRequest request = movedSponge();
            request.key = key;
            std::vector<Seen> nearest(width * height);
            for (Seen& seen : nearest)
                seen.depth = HUGE_VAL;
            eachPoint(request, 2'000'000, [&](const Seen& seen) {
                if (seen.depth < nearest[at(seen.pixel)].depth) nearest[at(seen.pixel)] = seen;
            });
            SolidRendering rendering(request);
            QVERIFY(rendering.draw());
            const auto& keys = rendering.raster().keys;
            std::size_t moved = 0, others = 0;
            for (std::size_t k = 0; k < nearest.size(); ++k) {
                const Seen& seen = nearest[k];
                if (!std::isfinite(seen.depth) || seen.address.front() != 19) continue;
                const std::uint32_t colour = key == SolidKey::Map ? 19 : 19 * 256 / 20;
                ++moved;
                others += !around(k, [&](std::size_t near) { return (keys[near] & 0xFF) == colour; });
            }
            QVERIFY(moved > 300);
            QVERIFY(others <= moved / 100);
        }
    }

    void cloudsAreWhereThePointsAre() {
        for (const bool isPerspective : {false, true}) {
            SpaceRequest request = movedSponge();
            if (isPerspective) request.camera.projection = OrbitCamera::Projection::Perspective;
            request.appearance.colourBy = ColourBy::Plain;
            request.appearance.background = {0, 0, 0, 255};
            request.samples = 3'000'000;
            CloudRendering rendering(request);
            rendering.refine();
            std::vector<std::uint32_t> pixels(width * height);
            rendering.tone(pixels);
            std::vector<bool> hit(pixels.size());
            eachPoint(request, 3'000'000, [&](const Seen& seen) { hit[at(seen.pixel)] = true; });
            std::size_t hits = 0, dark = 0, lit = 0, stray = 0;
            for (std::size_t k = 0; k < pixels.size(); ++k) {
                const auto isLit = [&](std::size_t pixel) { return (pixels[pixel] & 0xFFFFFF) != 0; };
                hits += hit[k];
                dark += hit[k] && !around(k, isLit);
                lit += isLit(k);
                stray += isLit(k) && !around(k, [&](std::size_t pixel) { return hit[pixel]; });
            }
            qInfo("hits %zu dark %zu, lit %zu stray %zu", hits, dark, lit, stray);
            QVERIFY(hits > 2000);
            QVERIFY(dark <= hits / 500);
            QVERIFY(stray <= lit / 500);
        }
    }

    // Another place of a branch is another picture, from the same object.
    void aDraggedBranchIsDrawnAnew() {
        SpaceRequest request = movedSponge();
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        request.moved.front().change.translation.x() += 0.2;
        rendering.restart(request);
        QVERIFY(rendering.draw());
        const DepthRaster after = rendering.takeRaster();
        SolidRendering alone(request);
        QVERIFY(alone.draw());
        QVERIFY(after.keys == alone.raster().keys);
        SolidRendering before(movedSponge());
        QVERIFY(before.draw());
        QVERIFY(before.raster().keys != after.keys);
    }
};

BARYCAGE_TEST(MovedSolidsTest);
#include "moved_solids_test.moc"
