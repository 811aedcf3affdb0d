// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/samples/space_samples.h"
#include "attractor/space_systems.h"
#include "ifs/dimension/moments.h"
#include "support/late_stop.h"
#include "support/named_test.h"

#include <QtTest>

#include <chrono>
#include <cmath>
#include <thread>

using namespace attractor;
using ifs::Vector;

namespace {

using Pixels = std::vector<std::uint32_t>;

Pixels drawnCloud(const SpaceRequest& request) {
    CloudRendering rendering(request);
    rendering.refine();
    Pixels pixels(std::size_t(request.camera.size.width) * std::size_t(request.camera.size.height));
    rendering.tone(pixels);
    return pixels;
}

SpaceRequest requestFor(const systems::System3& system, bool perspective, std::uint64_t samples) {
    SpaceRequest request = systems::spaceRequest(system, 160, 120);
    if (perspective) request.camera.projection = OrbitCamera::Projection::Perspective;
    request.appearance.colourBy = ColourBy::Plain;
    request.appearance.background = {0, 0, 0, 255};
    request.samples = samples;
    return request;
}

} // namespace

class TestCloudRendering : public QObject {
    Q_OBJECT

private slots:
    // The samples have the mean that the measure has.
    void samplesFollowTheMeasure() {
        for (const auto& system : {systems::menger(), systems::fern3()}) {
            const PreparedSpace prepared = preparedSpace(system);
            const auto mean = ifs::mean(ifs::activeMaps(system));
            QVERIFY(mean.has_value());
            Vector<3> sum = Vector<3>::Zero();
            SpaceSamples samples;
            constexpr int passes = 32;
            for (std::uint64_t pass = 0; pass < passes; ++pass) {
                drawSamples(prepared, 1, pass, samples);
                for (std::size_t k = 0; k < SampleSet::size; ++k)
                    sum += prepared.fromBox()(Vector<3>(samples.x[k], samples.y[k], samples.z[k]));
            }
            sum /= double(passes * SampleSet::size);
            QVERIFY2((sum - mean->point).cwiseQuotient(prepared.halfExtent).norm() < 0.02,
                     qPrintable(QString::number((sum - mean->point).norm())));
        }
    }

    // What is lit is where points of the chaos game fall under the camera, and nowhere else.
    void isWhereThePointsAre() {
        for (const auto& system : {systems::menger(), systems::tetrahedron(), systems::fern3()})
            for (const bool perspective : {false, true}) {
                const SpaceRequest request = requestFor(system, perspective, 5'000'000);
                const Pixels pixels = drawnCloud(request);
                const PreparedSpace prepared = preparedSpace(system);
                SpaceSamples samples;
                std::vector<bool> hit(pixels.size());
                std::size_t hits = 0;
                std::size_t dark = 0;
                for (std::uint64_t pass = 0; pass < 8; ++pass) {
                    drawSamples(prepared, 99, pass, samples);
                    for (std::size_t k = 0; k < SampleSet::size; ++k) {
                        const Vector<3> x =
                            prepared.fromBox()(Vector<3>(samples.x[k], samples.y[k], samples.z[k]));
                        const Vector<2> at = toScreen(request.camera, x).pixel;
                        if (!(at.x() >= 0 && at.x() < 160 && at.y() >= 0 && at.y() < 120)) continue;
                        const std::size_t pixel = std::size_t(at.y()) * 160 + std::size_t(at.x());
                        ++hits;
                        dark += (pixels[pixel] & 0xFFFFFF) == 0 ? 1 : 0;
                        for (int dy = -1; dy <= 1; ++dy)
                            for (int dx = -1; dx <= 1; ++dx) {
                                const int u = int(at.x()) + dx;
                                const int v = int(at.y()) + dy;
                                if (u >= 0 && u < 160 && v >= 0 && v < 120)
                                    hit[std::size_t(v * 160 + u)] = true;
                            }
                    }
                }
                QVERIFY(hits > 50'000);
                QVERIFY(dark < hits / 100);
                std::size_t lit = 0;
                std::size_t stray = 0;
                for (std::size_t k = 0; k < pixels.size(); ++k) {
                    if ((pixels[k] & 0xFFFFFF) == 0) continue;
                    ++lit;
                    stray += hit[k] ? 0 : 1;
                }
                QVERIFY(lit > 500);
                QVERIFY(stray < lit / 20);
            }
    }

    void sameBytesWhateverThreadsAndInstructions() {
        for (const bool perspective : {false, true})
            for (const ColourBy colourBy : {ColourBy::Density, ColourBy::Map, ColourBy::Address}) {
                SpaceRequest request = requestFor(systems::fern3(), perspective, 300'000);
                request.camera.height /= 1.5;
                request.appearance.colourBy = colourBy;
                const Pixels wanted = drawnCloud(request);
                const std::string usual = simdName();
                for (const std::string& simd : simdNames())
                    for (const int threads : {1, 2, 3}) {
                        QVERIFY(selectSimd(simd));
                        request.threads = threads;
                        const Pixels found = drawnCloud(request);
                        QVERIFY(selectSimd(usual));
                        QVERIFY2(found == wanted, simd.c_str());
                    }
            }
    }

    void passesAddUp() {
        CloudRendering rendering(requestFor(systems::tetrahedron(), false, 100'000));
        QVERIFY(rendering.refine());
        QVERIFY(rendering.refine());
        QVERIFY(rendering.samples() > 199'000 && rendering.samples() <= 200'000);
    }

    void hostileSystemsAreDrawn() {
        systems::System3 expanding;
        for (const double x : {0.0, 1.0})
            ifs::append<3>(expanding, systems::scaled(1.5, x, 0, 0));
        systems::System3 overlapping;
        for (int i = 0; i < 12; ++i)
            ifs::append<3>(overlapping, systems::scaled(0.9, 0.01 * i, 0.01 * (i % 3), 0.01 * (i % 5)));
        systems::System3 constant;
        ifs::append<3>(constant, systems::scaled(0, 1, 2, 3));
        for (const auto& system : {expanding, overlapping, constant, systems::System3{}})
            for (const bool perspective : {false, true}) {
                const SpaceRequest request = requestFor(system, perspective, 200'000);
                QCOMPARE(drawnCloud(request).size(), std::size_t(160 * 120));
            }
        QCOMPARE(CloudRendering(requestFor(expanding, false, 10)).note(), RenderNote::NoAttractor);
        QCOMPARE(CloudRendering(requestFor({}, false, 10)).note(), RenderNote::NoMaps);
    }

    void stopsWithinMilliseconds() {
        CloudRendering rendering(requestFor(systems::menger(), false, 2'000'000'000));
        support::LateStop stop(std::chrono::milliseconds(30));
        QVERIFY(!rendering.refine(stop.token()));
        const auto ended = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> late = ended - stop.asked();
        QVERIFY2(late.count() < 250, qPrintable(QString::number(late.count()))); // on a busy machine
    }
};

BARYCAGE_TEST(TestCloudRendering);
#include "cloud_rendering_test.moc"
