// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/solid/thinned_covers.h"
#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

using namespace attractor;

namespace {

using Pixels = std::map<std::pair<int, int>, double>;

// The nearest depth in every pixel that a point falls into.
Pixels nearestPixels(const kernels::Cover& cover, const ifs::Matrix<3>& linear,
                     const ifs::Vector<3>& middle) {
    Pixels result;
    const kernels::CoverPoints& points = cover.nearestFirst[0];
    for (std::size_t k = 0; k < cover.size; ++k) {
        const ifs::Vector<3> at = linear * ifs::Vector<3>(points.x[k], points.y[k], points.z[k]) + middle;
        const auto [nearest, isFirst] =
            result.try_emplace({int(std::floor(at.x())), int(std::floor(at.y()))}, at.z());
        if (!isFirst) nearest->second = std::min(nearest->second, at.z());
    }
    return result;
}

// Menger's sponge, `turned`·0.2° on the way around it.
SpaceRequest sponge(int turned, bool isBent) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), 480, 360, 30 + 0.2 * turned);
    request.camera.projection = OrbitCamera::Projection::Perspective;
    if (!isBent) return request;
    std::vector<ifs::Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    request.cage = ifs::polygonAtRest<3>(corners);
    request.cage->current.back() += ifs::Vector<3>(0.3, 0.2, 0.2);
    request.camera.projection = OrbitCamera::Projection::Orthographic;
    return request;
}

} // namespace

class TestThinnedCovers : public QObject {
    Q_OBJECT

private slots:
    // For the map that a cover was thinned for and all that it is said to hold for, wherever the word lies.
    void nothingThatIsSeenIsMissing() {
        const PreparedSpace prepared = preparedSpace(systems::menger());
        const Covers covers(prepared);
        const auto whole = covers.ofAtMost(1024);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (const std::string& simd : simdNames()) {
            const std::string usual = simdName();
            QVERIFY(selectSimd(simd));
            ThinnedCovers thinned;
            thinned.use(covers, 1.0 / 3);
            thinned.missed(100'000'000);
            std::size_t found = 0, points = 0, allPoints = 0;
            for (int k = 0; k < 400; ++k) {
                const SpaceRequest request =
                    systems::spaceRequest(systems::menger(), 800, 600, 20 + 10 * (k / 80), 25);
                const SeenWord box = seen(spaceView(request.camera, {}).toPixels * prepared.fromBox(), {});
                const double size = k / 40 % 2 == 0 ? 6 : 3.5;
                ifs::Matrix<3> linear = size / (2 * box.half.maxCoeff()) * box.onScreen.linear;
                if (k % 40 != 0) { // about as far from the first of 40 as a cover does for
                    ifs::Matrix<3> factor = ifs::Matrix<3>::Identity();
                    for (int row = 0; row < 3; ++row)
                        for (int column = 0; column < 3; ++column)
                            factor(row, column) +=
                                (row < 2 && column < 2 ? 0.059 : 0.039) * (unit(random) < 0 ? -1 : 1);
                    linear = factor * linear;
                }
                const kernels::Cover* cover = thinned.find(linear, 1, whole);
                if (cover == nullptr) continue;
                ++found;
                points += cover->size;
                const auto all = std::ranges::find(whole, cover->spacing, &kernels::Cover::spacing);
                QVERIFY(all != whole.end());
                QCOMPARE(cover->work, all->size);
                allPoints += all->size;
                for (int place = 0; place < 20; ++place) {
                    const ifs::Vector<3> middle(unit(random), unit(random), 0);
                    QVERIFY(nearestPixels(*cover, linear, middle) == nearestPixels(*all, linear, middle));
                }
            }
            QVERIFY(selectSimd(usual));
            QVERIFY(found > 300);
            QVERIFY(3 * points < 2 * allPoints);
        }
    }

    // Of maps near the one before, the cover is known; others have to be paid for.
    void nearMapsShareACover() {
        const Covers covers(preparedSpace(systems::menger()));
        const auto whole = covers.ofAtMost(1024);
        ThinnedCovers thinned;
        thinned.use(covers, 1.0 / 3);
        const ifs::Matrix<3> linear =
            2 * (orbit(30, 20).toRotationMatrix() * ifs::Vector<3>(0.9, 0.7, 0.8).asDiagonal());
        QVERIFY(thinned.find(linear, 1, whole) == nullptr);
        thinned.missed(600 * whole.back().size);
        QVERIFY(thinned.find(linear, 1, whole) != nullptr);
        QVERIFY(thinned.find(1.01 * linear, 1, whole) != nullptr);
        QVERIFY(thinned.find(1.01 * linear / 3, 1, whole) == nullptr); // drawn by fewer points
        QVERIFY(thinned.find(1.2 * linear, 1, whole) == nullptr);
        thinned.use(Covers(preparedSpace(systems::menger())), 1.0 / 3);
        QVERIFY(thinned.find(linear, 1, whole) == nullptr);
    }

    void onlyWhereRoundingIsSmall() {
        QVERIFY(ThinnedCovers::isExact(0.5, 1920, {0, 1000, false}));
        QVERIFY(!ThinnedCovers::isExact(0.95, 1920, {0, 1000, false}));
        QVERIFY(!ThinnedCovers::isExact(0.5, 10'000, {0, 1000, false}));
        QVERIFY(!ThinnedCovers::isExact(0.5, 1920, {0, 100'000, false}));
    }

    void picturesAreTheSameWithLessWork_data() {
        QTest::addColumn<bool>("isBent");
        QTest::newRow("perspective") << false;
        QTest::newRow("bent") << true;
    }
    void picturesAreTheSameWithLessWork() {
        QFETCH(bool, isBent);
        SolidRendering rendering(sponge(0, isBent));
        rendering.draw();
        const std::size_t before = rendering.work().points;
        for (int turned = 1; turned <= 6; ++turned) {
            rendering.restart(sponge(turned, isBent));
            QVERIFY(rendering.draw());
        }
        SolidRendering alone(sponge(6, isBent));
        QVERIFY(alone.draw());
        QVERIFY(rendering.raster().keys == alone.raster().keys);
        QCOMPARE(rendering.work().words, alone.work().words);
        QVERIFY2(4 * rendering.work().points < 3 * before,
                 qPrintable(QStringLiteral("%1 of %2").arg(rendering.work().points).arg(before)));
    }
};

BARYCAGE_TEST(TestThinnedCovers);
#include "thinned_covers_test.moc"
