// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"

#include "document/fractal/fractal_geometry.h"
#include "io/exports/export_recipe.h"
#include "io/picture/vector/shape_preview.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace io;

namespace {

document::Fractal previewed(const canonical::Maps2& maps) {
    document::System2 system;
    const std::vector<double> weights = ifs::determinantWeights<2>(maps);
    for (std::size_t i = 0; i < maps.size(); ++i)
        ifs::append(system, maps[i], weights[i]);
    return support::fractalOf(system, QStringLiteral("test"));
}

attractor::Camera cameraFor(const document::Fractal& fractal, int width, int height) {
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    const auto box = document::displayedBox(fractal);
    return fitted(camera, box->min, box->max);
}

// As another program shows the file; null where there is none.
QImage shownSvg(const SvgPicture& picture) {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("rsvg-convert"));
    if (program.isEmpty()) return {};
    QProcess process;
    process.start(program, {QStringLiteral("--unlimited")});
    process.write(picture.bytes);
    process.closeWriteChannel();
    process.waitForFinished(120'000);
    return QImage::fromData(process.readAllStandardOutput()).convertToFormat(QImage::Format_ARGB32);
}

double meanDifference(const QImage& a, const QImage& b) { // mean, of 255
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y)));
    return sum / (double(a.width()) * a.height());
}

int drawnPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixel(x, y) != image.pixel(0, 0);
    return count;
}

} // namespace

// What a file of shapes will look like, before it is written.
class ShapePreviewTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatTheFileShows_data();
    void isWhatTheFileShows();
    void theDepthIsSeen();
    void outlinesHaveNoBackground();
    void fewerPixelsShowTheSameShapes();
    void endsWhenStopped();

    // Darker than the picture and behind it, in the preview as in the file, and where the renderer has it.
    void theShadowIsDrawnBehindThePicture_data() {
        QTest::addColumn<int>("style");
        QTest::newRow("structured") << int(ShapeStyle::Structured);
        QTest::newRow("points") << int(ShapeStyle::Points);
    }
    void theShadowIsDrawnBehindThePicture() {
        QFETCH(const int, style);
        document::Fractal fractal = previewed(canonical::maple());
        fractal.appearance.colourBy = attractor::ColourBy::Plain;
        fractal.appearance.plain = {200, 200, 200, 255};
        fractal.appearance.background = {255, 255, 255, 255};
        const auto box = document::displayedBox(fractal);
        fractal.appearance.shadow = 0.8;
        fractal.appearance.shadowLean = 1.5;
        attractor::Camera camera;
        camera.width = 400;
        camera.height = 200;
        const auto both = document::boxWithShadow(fractal, camera.yAxis);
        camera = attractor::fitted(camera, both->min, both->max);
        SvgFormat format;
        format.style = ShapeStyle(style);
        const auto preview = shapePreview(fractal, camera, format);
        QVERIFY(preview);
        document::Fractal plain = fractal;
        plain.appearance.shadow = 0;
        const auto without = shapePreview(plain, camera, format);
        const SvgPicture file = svgPicture(fractal, camera, format);
        const qsizetype at = file.bytes.indexOf("id=\"shadow\" opacity=\"0.8\"");
        QVERIFY(at > 0);
        QVERIFY(at < std::max(file.bytes.indexOf("id=\"attractor\""), file.bytes.indexOf("id=\"points\"")));
        QVERIFY(!svgPicture(plain, camera, format).bytes.contains("id=\"shadow\""));
        int dark = 0, outside = 0;
        const double edge = toPixel(camera, box->max).x();
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const bool isDarker = qGreen(preview->pixel(x, y)) < qGreen(without->pixel(x, y)) - 40;
                dark += isDarker;
                outside += isDarker && x > edge;
            }
        QVERIFY2(dark > 300, qPrintable(QString::number(dark)));
        QVERIFY2(outside > 50, qPrintable(QString::number(outside)));
        const QImage shown = shownSvg(file);
        if (shown.isNull()) return;
        const double difference = meanDifference(shown, *preview);
        QVERIFY2(difference < 6, qPrintable(QString::number(difference)));
        const double otherwise = meanDifference(shown, *without);
        QVERIFY2(otherwise > difference + 0.5, qPrintable(QString::number(otherwise)));
    }
};

void ShapePreviewTest::isWhatTheFileShows_data() {
    QTest::addColumn<bool>("isFern");
    QTest::addColumn<bool>("isOfPoints");
    QTest::newRow("maple, copies") << false << false;
    QTest::newRow("maple, points") << false << true;
    QTest::newRow("fern, copies") << true << false;
}

void ShapePreviewTest::isWhatTheFileShows() {
    QFETCH(const bool, isFern);
    QFETCH(const bool, isOfPoints);
    const document::Fractal fractal = previewed(isFern ? canonical::fern() : canonical::maple());
    const attractor::Camera camera = cameraFor(fractal, 200, 160);
    SvgFormat format;
    format.style = isOfPoints ? ShapeStyle::Points : ShapeStyle::Structured;
    const auto preview = shapePreview(fractal, camera, format);
    QVERIFY(preview);
    QCOMPARE(preview->size(), QSize(200, 160));
    const QImage file = shownSvg(svgPicture(fractal, camera, format));
    if (file.isNull()) QSKIP("rsvg-convert is not installed");
    QCOMPARE(file.size(), preview->size());
    const QImage blank = [&] {
        QImage image(preview->size(), QImage::Format_ARGB32_Premultiplied);
        image.fill(preview->pixel(0, 0));
        return image;
    }();
    const double apart = meanDifference(*preview, file);
    const double most = meanDifference(*preview, blank) / (isOfPoints ? 2 : 4);
    QVERIFY2(apart < most, qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(most)));
}

// A density would show none of it.
void ShapePreviewTest::theDepthIsSeen() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    const attractor::Camera camera = cameraFor(fractal, 200, 160);
    int before = 200 * 160;
    for (const int depth : {0, 1, 2}) {
        SvgFormat format;
        format.depth = depth;
        const int drawn = drawnPixels(*shapePreview(fractal, camera, format));
        QVERIFY2(drawn < before * 9 / 10, qPrintable(QString::number(drawn)));
        before = drawn;
    }
    QVERIFY(before > 1000);
}

void ShapePreviewTest::outlinesHaveNoBackground() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    SvgFormat format;
    format.style = ShapeStyle::Outline;
    const auto outline = shapePreview(fractal, cameraFor(fractal, 200, 160), format);
    QVERIFY(outline);
    QCOMPARE(qAlpha(outline->pixel(0, 0)), 0);
    QVERIFY(drawnPixels(*outline) > 500);
}

void ShapePreviewTest::fewerPixelsShowTheSameShapes() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    ShapeRecipe recipe;
    recipe.camera = cameraFor(fractal, 4000, 3200);
    recipe.depth = 1;
    const auto preview = previewOf(recipe, fractal, {200, 160}, {});
    QVERIFY(preview);
    SvgFormat format;
    format.depth = 1;
    const auto small = shapePreview(fractal, cameraFor(fractal, 200, 160), format);
    const int one = drawnPixels(*preview), other = drawnPixels(*small);
    QVERIFY2(std::abs(one - other) < other / 20, qPrintable(QStringLiteral("%1, %2").arg(one).arg(other)));
}

void ShapePreviewTest::endsWhenStopped() {
    std::stop_source stop;
    stop.request_stop();
    const document::Fractal fractal = document::sierpinskiTriangle();
    QVERIFY(!shapePreview(fractal, cameraFor(fractal, 200, 160), {}, stop.get_token()));
}

BARYCAGE_TEST(ShapePreviewTest, QGuiApplication);
#include "shape_preview_test.moc"
