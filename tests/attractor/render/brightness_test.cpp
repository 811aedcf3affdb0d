// SPDX-License-Identifier: MIT
#include "attractor/light/tone_map.h"
#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace attractor;

namespace {

double occupiedGrey(const Frame& frame) { // mean over pixels that show something
    double sum = 0;
    double count = 0;
    for (const std::uint32_t pixel : frame.pixels)
        if (systems::grey(pixel) > 0) {
            sum += systems::grey(pixel);
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

} // namespace

class BrightnessTest : public QObject {
    Q_OBJECT

private slots:
    void massIsConserved() {
        const RenderRequest request = systems::request(systems::maple(), 1'000'000);
        const Frame frame = render(request);
        QCOMPARE(frame.samples, std::uint64_t{1'000'000});
        QVERIFY(std::abs(frame.measure - 1) < 1e-12);
    }

    void brightnessDoesNotDependOnTheNumberOfPoints() {
        for (const auto& system :
             {systems::maple(), systems::fern(), systems::flower(), systems::sierpinski()}) {
            const double few = occupiedGrey(render(systems::request(system, 400'000)));
            const double many = occupiedGrey(render(systems::request(system, 6'400'000)));
            // Pixels that only many points reach are dark; what both show must look alike.
            QVERIFY2(std::abs(many / few - 1) < 0.12, qPrintable(QStringLiteral("%1 %2").arg(few).arg(many)));
        }
    }

    void brightnessSurvivesZoomAndSize() {
        for (const auto& system : {systems::sierpinski(), systems::flower(), systems::dragon()}) {
            RenderRequest request = systems::request(system, 2'000'000);
            const double whole = occupiedGrey(render(request));
            request.camera.centre = *ifs::fixedPoint(system.maps[1].map);
            request.camera.pixelsPerUnit *= 64;
            const double zoomed = occupiedGrey(render(request));
            const double small = occupiedGrey(render(systems::request(system, 2'000'000, 96, 60)));
            QVERIFY2(std::abs(zoomed / whole - 1) < 0.12,
                     qPrintable(QStringLiteral("%1 %2").arg(whole).arg(zoomed)));
            QVERIFY2(std::abs(small / whole - 1) < 0.12,
                     qPrintable(QStringLiteral("%1 %2").arg(whole).arg(small)));
        }
    }

    void brightnessOfThinSetsSurvivesZoomPointsAndDrag() {
        for (const auto& [name, system] : {std::pair("Koch curve", systems::koch()),
                                           std::pair("dust of dimension 1.26", systems::cantorDust(1.0 / 3)),
                                           std::pair("dust of dimension 1", systems::cantorDust(0.25)),
                                           std::pair("dust of dimension 0.6", systems::cantorDust(0.1))}) {
            RenderRequest request = systems::request(system, 2'000'000);
            const double whole = occupiedGrey(render(request));
            const auto same = [&, name = name](const char* what, double value) {
                const double grey = occupiedGrey(render(request));
                QVERIFY2(std::abs(grey / whole - 1) < 0.2,
                         qPrintable(QStringLiteral("%1, %2 %3: %4 after %5")
                                        .arg(QLatin1String(name), QLatin1String(what))
                                        .arg(value)
                                        .arg(grey)
                                        .arg(whole)));
            };
            const RenderRequest asWhole = request;
            for (const std::uint64_t samples : {200'000, 8'000'000}) {
                request.samples = samples;
                same("samples", double(samples));
            }
            request = asWhole;
            request.camera.centre = *ifs::fixedPoint(system.maps[1].map);
            for (const double zoom : {2.0, 7.0, 30.0, 1e3, 1e6}) {
                request.camera.pixelsPerUnit = asWhole.camera.pixelsPerUnit * zoom;
                same("zoom", zoom);
            }
            request = asWhole;
            for (const double stretch : {1.5, 0.5, -0.7}) {
                request.cage =
                    ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {0.2, stretch}}};
                same("drag", stretch);
            }
        }
    }

    void brightnessSurvivesFlattening() {
        RenderRequest request = systems::request(systems::maple(), 2'000'000);
        const Frame upright = render(request);
        request.exposure = upright.exposure;
        for (const double height : {0.5, 0.1, 0.02, 0.0, -0.3}) {
            request.cage = systems::squeezed(height);
            const Frame frame = render(request);
            QVERIFY2(std::abs(occupiedGrey(frame) / occupiedGrey(upright) - 1) < 0.2,
                     qPrintable(QStringLiteral("%1: %2").arg(height).arg(occupiedGrey(frame))));
            QCOMPARE(frame.note, height == 0 ? RenderNote::Degenerate : RenderNote::None);
            QCOMPARE(frame.exposure.whitePoint, upright.exposure.whitePoint);
        }
    }

    void brightnessSurvivesSupersampling() {
        for (const auto& system : {systems::flower(), systems::maple(), systems::dragon()}) {
            RenderRequest request = systems::request(system, 4'000'000);
            const double plain = systems::meanGrey(render(request));
            for (const int side : {2, 4}) {
                request.appearance.supersample = side;
                const Frame frame = render(request);
                QCOMPARE(frame.pixels.size(), std::size_t{320 * 200});
                const double fine = systems::meanGrey(frame);
                QVERIFY2(std::abs(fine / plain - 1) < 0.12,
                         qPrintable(QStringLiteral("%1 %2").arg(plain).arg(fine)));
            }
        }
    }

    void toneIsMonotonicAndNormalised() {
        QCOMPARE(tone(0, 20, 5, 2.2), 0.0);
        QVERIFY(std::abs(tone(5, 20, 5, 2.2) - 1) < 1e-12);
        double before = 0;
        for (double density = 0.01; density < 5; density *= 1.2) {
            const double v = tone(density, 20, 5, 2.2);
            QVERIFY(v > before);
            QVERIFY(std::abs(v - std::pow(std::log1p(20 * density) / std::log1p(100), 1 / 2.2)) < 1e-12);
            before = v;
        }
    }
};

BARYCAGE_TEST(BrightnessTest);
#include "brightness_test.moc"
