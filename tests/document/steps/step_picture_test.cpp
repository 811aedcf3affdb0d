// SPDX-License-Identifier: MIT
#include "document/steps/step_picture.h"

#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QtTest>

#include <map>
#include <set>

using namespace document;

namespace {

constexpr int side = 300;

StepJob job(const Fractal& fractal, const StartShape& shape, int iterations) {
    StepJob job;
    job.fractal = std::make_shared<const Fractal>(fractal);
    job.shape = std::make_shared<const StartShape>(shape);
    job.iterations = iterations;
    job.camera.width = job.camera.height = side;
    const auto box = displayedBox(fractal);
    job.camera = fitted(job.camera, box->min, box->max, 0.2);
    return job;
}

// How many pixels have each colour.
std::map<std::uint32_t, int> colours(const StepJob& job) {
    const auto frame = stepPicture(job, {});
    std::map<std::uint32_t, int> found;
    if (frame)
        for (const std::uint32_t pixel : frame->pixels)
            ++found[pixel];
    return found;
}

int area(const StepJob& job) {
    const auto frame = stepPicture(job, {});
    int count = 0;
    for (const std::uint32_t pixel : frame->pixels)
        count += pixel != frame->pixels.front() ? 1 : 0; // a corner shows the background
    return count;
}

} // namespace

class StepPictureTest : public QObject {
    Q_OBJECT

private slots:
    void theStartIsGreyAndImagesHaveTheColoursOfTheirMaps() {
        const Fractal fractal = sierpinskiTriangle();
        const auto start = colours(job(fractal, squareShape(), 0));
        const auto most = std::ranges::max_element(start, {}, [&](const auto& entry) {
            const QColor colour(entry.first);
            return colour.saturation() < 40 && colour.lightness() > 90 ? entry.second : 0;
        });
        QVERIFY(most->second > side * side / 8);
        const auto first = colours(job(fractal, squareShape(), 1));
        for (std::size_t i = 0; i < 3; ++i) {
            const attractor::Rgba colour = mapColour(fractal.appearance, system2(fractal)->maps[i].id, i);
            const auto found = first.find(0xff000000u | std::uint32_t(colour.red) << 16 |
                                          std::uint32_t(colour.green) << 8 | colour.blue);
            QVERIFY(found != first.end());
            QVERIFY(found->second > side * side / 40);
        }
    }

    // Three images of half the size.
    void everyStepLeavesThreeQuarters() {
        double before = area(job(sierpinskiTriangle(), squareShape(), 0));
        for (int n = 1; n <= 4; ++n) {
            const double now = area(job(sierpinskiTriangle(), squareShape(), n));
            QVERIFY2(std::abs(now / before - 0.75) < 0.1, qPrintable(QString::number(now / before)));
            before = now;
        }
    }

    // 3³⁰ images are not all drawn, and the attractor is what is left.
    void deepStepsEnd() {
        const int deep = area(job(sierpinskiTriangle(), squareShape(), 30));
        const int less = area(job(sierpinskiTriangle(), squareShape(), 8));
        QVERIFY(deep > 0 && deep <= 1.2 * less);
    }

    void lettersKeepTheirHoles() {
        const auto letter = letterShape(QStringLiteral("O"));
        if (!letter) QSKIP("there is no font");
        QCOMPARE(letter->contours.size(), std::size_t{2});
        double low = 0, high = 0;
        for (const auto& contour : letter->contours)
            for (const ifs::Vector<2>& corner : contour) {
                low = std::min(low, corner.minCoeff());
                high = std::max(high, corner.maxCoeff());
            }
        QVERIFY(std::abs(low + 0.5) < 1e-9 && std::abs(high - 0.5) < 1e-9);
        const StepJob drawn = job(sierpinskiTriangle(), *letter, 0);
        const auto frame = stepPicture(drawn, {});
        const auto box = displayedBox(sierpinskiTriangle());
        const ifs::Vector<2> middle = toPixel(drawn.camera, (box->min + box->max) / 2);
        QCOMPARE(frame->pixels[std::size_t(middle.y()) * side + std::size_t(middle.x())],
                 frame->pixels.front());
        QVERIFY(!letterShape(QStringLiteral("  ")));
    }

    // A map without area leaves a line, not nothing.
    void flatImagesAreLines() {
        Fractal fractal = sierpinskiTriangle();
        auto& maps = plane(fractal)->system.maps;
        maps.resize(2);
        maps[0].map.linear << 0.5, 0, 0, 0;
        maps[1].map.linear << 0.5, 0, 0, 0;
        plane(fractal)->cage.reset();
        Fractal whole = sierpinskiTriangle();
        StepJob flat = job(whole, squareShape(), 1);
        flat.fractal = std::make_shared<const Fractal>(fractal);
        QVERIFY(area(flat) > side / 4);
    }

    void endsWhenStopped() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!stepPicture(job(sierpinskiTriangle(), squareShape(), 12), stop.get_token()));
    }
};

BARYCAGE_TEST(StepPictureTest, QGuiApplication);
#include "step_picture_test.moc"
