// SPDX-License-Identifier: MIT
#include "attractor/samples/space_samples.h"
#include "attractor/solid/covers.h"
#include "attractor/solid/facing_cover.h"
#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace attractor;

namespace {

// The largest distance, along an axis of the box, from a sample to the nearest point of the cover.
double farthest(const SpaceSamples& samples, const kernels::Cover& cover) {
    const kernels::CoverPoints& points = cover.nearestFirst[0];
    double result = 0;
    for (std::size_t k = 0; k < SampleSet::size; k += 37) {
        float nearest = HUGE_VALF;
        for (std::size_t i = 0; i < cover.size; ++i)
            nearest = std::min(
                nearest, std::max({std::abs(samples.x[k] - points.x[i]), std::abs(samples.y[k] - points.y[i]),
                                   std::abs(samples.z[k] - points.z[i])}));
        result = std::max(result, double(nearest));
    }
    return result;
}

ifs::Vector<3> point(const kernels::Cover& cover, const ifs::Matrix<3>& linear, std::size_t k) {
    const kernels::CoverPoints& points = cover.nearestFirst[0];
    return linear * ifs::Vector<3>(points.x[k], points.y[k], points.z[k]);
}

// Above and to the left of all points.
ifs::Vector<2> corner(const kernels::Cover& cover, const ifs::Matrix<3>& linear) {
    ifs::Vector<2> low = point(cover, linear, 0).head<2>();
    for (std::size_t k = 1; k < cover.size; ++k)
        low = low.cwiseMin(point(cover, linear, k).head<2>());
    return low;
}

// Of every pixel that a point falls into.
std::map<std::pair<int, int>, double> nearestDepths(const kernels::Cover& cover, const ifs::Matrix<3>& linear,
                                                    const ifs::Vector<2>& shift,
                                                    const ifs::Vector<2>& corner) {
    std::map<std::pair<int, int>, double> result;
    for (std::size_t k = 0; k < cover.size; ++k) {
        const ifs::Vector<3> at = point(cover, linear, k);
        const std::pair pixel(int(at.x() - (corner.x() - shift.x())), int(at.y() - (corner.y() - shift.y())));
        const auto [nearest, isFirst] = result.try_emplace(pixel, at.z());
        if (!isFirst) nearest->second = std::min(nearest->second, at.z());
    }
    return result;
}

} // namespace

class TestCovers : public QObject {
    Q_OBJECT

private slots:
    // Every point of the attractor shares a cell with a point of the cover; the box is 2 wide.
    void everyPointIsCovered() {
        for (const auto& system : {systems::menger(), systems::tetrahedron(), systems::fern3()}) {
            const PreparedSpace prepared = preparedSpace(system);
            SpaceSamples samples;
            drawSamples(prepared, 1, 0, samples);
            const Covers covers(prepared);
            float spacing = 2;
            for (const kernels::Cover& cover : covers.ofAtMost(2000)) {
                QVERIFY(cover.spacing < spacing);
                spacing = cover.spacing;
                QVERIFY(cover.size % kernels::solidLanes == 0);
                const double found = farthest(samples, cover);
                QVERIFY2(found <= 2 * cover.spacing * 1.001, qPrintable(QString::number(found)));
            }
            QVERIFY(spacing < 0.2F);
        }
    }

    // A cut of a body whose pieces lie on each other has every cell many times. Its covers have it once, or
    // only the coarsest would be small enough.
    void heavyOverlapsHaveFineCovers() {
        const PreparedSpace prepared = preparedSpace(systems::heavyOverlaps());
        SpaceSamples samples;
        drawSamples(prepared, 1, 0, samples);
        const Covers covers(prepared);
        const auto known = covers.ofAtMost(Covers::maxPoints);
        for (const kernels::Cover& cover : known)
            QVERIFY(farthest(samples, cover) <= 2 * cover.spacing * 1.001);
        QVERIFY(known.back().spacing <= 1.0F / 16);
    }

    // The counts of cells: 20ⁿ of the sponge, 4ⁿ of the tetrahedron.
    void cellsAreCounted() {
        const auto sizes = [](const systems::System3& system) {
            std::vector<std::size_t> result;
            for (const kernels::Cover& cover : Covers(preparedSpace(system)).ofAtMost(5000))
                result.push_back(cover.size);
            return result;
        };
        QVERIFY(std::ranges::count(sizes(systems::menger()), 400U) == 1);
        for (const std::size_t size : {64U, 256U, 1024U, 4096U})
            QVERIFY(std::ranges::count(sizes(systems::tetrahedron()), size) == 1);
    }

    // In every order the same points.
    void ordersHoldTheSamePoints() {
        const Covers covers(preparedSpace(systems::fern3()));
        for (const kernels::Cover& cover : covers.ofAtMost(500)) {
            std::vector<float> wanted(cover.nearestFirst[0].x, cover.nearestFirst[0].x + cover.size);
            std::ranges::sort(wanted);
            wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
            for (const kernels::CoverPoints& order : cover.nearestFirst) {
                std::vector<float> found(order.x, order.x + cover.size);
                std::ranges::sort(found);
                found.erase(std::unique(found.begin(), found.end()), found.end());
                QVERIFY(found == wanted);
            }
        }
    }

    // Only where all words look alike.
    void facingCoversAreForHomotheties() {
        const auto facing = [](const systems::System3& system, OrbitCamera::Projection projection) {
            const PreparedSpace prepared = preparedSpace(system);
            const Covers covers(prepared);
            SpaceRequest request = systems::spaceRequest(system, 800, 600);
            request.camera.projection = projection;
            return FacingCover(prepared, spaceView(request.camera, {}), covers.ofAtMost(8192));
        };
        using enum OrbitCamera::Projection;
        const FacingCover menger = facing(systems::menger(), Orthographic);
        QVERIFY(!menger.isEmpty());
        QVERIFY(menger.cover().onlyFor > 0);
        QVERIFY(menger.cover().size < 8000 / 2);
        QVERIFY(facing(systems::menger(), Perspective).isEmpty());
        QVERIFY(facing(systems::fern3(), Orthographic).isEmpty());
    }

    // Wherever the word lies between the pixels, to an eighth of one.
    void facingCoversKeepWhatIsNearest() {
        for (const systems::System3& system : {systems::menger(), systems::tetrahedron()}) {
            const PreparedSpace prepared = preparedSpace(system);
            const Covers covers(prepared);
            const SpaceView view = spaceView(systems::spaceRequest(system, 800, 600).camera, {});
            const auto known = covers.ofAtMost(8192);
            const FacingCover facing(prepared, view, known);
            const kernels::Cover kept = facing.cover();
            const SeenWord box = seen(view.toPixels * prepared.fromBox(), view);
            const ifs::Matrix<3> linear = box.onScreen.linear * (double(kept.onlyFor) / box.size());
            const auto all = std::ranges::find(known, kept.spacing, &kernels::Cover::spacing);
            QVERIFY(all != known.end() && all->size > kept.size);
            for (int place = 0; place < 64; ++place) {
                const ifs::Vector<2> shift(place % 8 / 8.0, place / 8 / 8.0);
                const auto wanted = nearestDepths(*all, linear, shift, corner(*all, linear));
                const auto found = nearestDepths(kept, linear, shift, corner(*all, linear));
                QVERIFY(found == wanted);
            }
        }
    }
};

BARYCAGE_TEST(TestCovers);
#include "covers_test.moc"
