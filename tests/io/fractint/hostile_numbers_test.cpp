// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"
#include "document/fractal/fractal_geometry.h"
#include "io/picture/vector/svg_writer.h"
#include "io/report/info_json.h"
#include "io/report/info_text.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QJsonDocument>
#include <QPointF>
#include <QRegularExpression>
#include <QTest>

#include <cfloat>
#include <cmath>

using ifs::affineMap;

// Systems, cages and views that nothing sensible can be made of: there is a picture and a sentence all the
// same, every number that is said is a number, and it is soon over.
class HostileNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void systems_data();
    void systems();
    void cages_data();
    void cages();
    void movedBranches_data();
    void movedBranches();
    void views_data();
    void views();
};

namespace {

constexpr double maxNumber = FLT_MAX; // what readers let in
constexpr double minNumber = 4.9406564584124654e-324;

document::Fractal fractal(const std::vector<ifs::AffineMap<2>>& maps, std::optional<double> weight = {}) {
    document::System2 system;
    for (const auto& map : maps)
        ifs::append(system, map, weight);
    return support::fractalOf(std::move(system), QStringLiteral("hostile"));
}

// What is said about it, and every way of drawing it.
void survive(const document::Fractal& fractal, std::optional<attractor::Camera> view = {}) {
    io::InfoSubject subject;
    subject.entries = document::fileOf(fractal).entries;
    QJsonParseError error;
    const QByteArray json = io::infoJson(subject);
    QJsonDocument::fromJson(json, &error); // which knows no nan and no inf
    QVERIFY2(error.error == QJsonParseError::NoError, json.constData());
    const QString text = io::infoText(subject);
    QVERIFY2(!text.contains(QRegularExpression(QStringLiteral("\\b(nan|inf)\\b"))), qPrintable(text));

    attractor::Camera camera = view.value_or(attractor::Camera());
    camera.width = 64;
    camera.height = 48;
    if (const auto box = document::displayedBox(fractal)) {
        QVERIFY(box->min.allFinite() && box->max.allFinite());
        if (!view) camera = attractor::fitted(camera, box->min, box->max);
    }
    QVERIFY(camera.centre.allFinite() && camera.pixelsPerUnit > 0);
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    for (const auto& vertex : cage.rest)
        QVERIFY(vertex.allFinite());
    for (const auto algorithm : {attractor::Algorithm::Density, attractor::Algorithm::ChaosGame,
                                 attractor::Algorithm::Deterministic})
        for (const auto colourBy : {attractor::ColourBy::Density, attractor::ColourBy::Address}) {
            attractor::RenderRequest request = document::renderRequest(fractal, camera);
            request.algorithm = algorithm;
            request.appearance.colourBy = colourBy;
            request.samples = 20'000;
            request.iterations = 3;
            const attractor::Frame frame = attractor::render(request);
            QCOMPARE(frame.pixels.size(), std::size_t(64 * 48));
            QVERIFY(std::isfinite(frame.exposure.meanDensity) && std::isfinite(frame.exposure.whitePoint) &&
                    std::isfinite(frame.exposure.gain) && std::isfinite(frame.measure));
            for (const std::uint32_t pixel : frame.pixels) // premultiplied over an opaque background
                QCOMPARE(pixel >> 24, 255U);
        }
    for (const auto style : {io::ShapeStyle::Structured, io::ShapeStyle::Outline, io::ShapeStyle::Points}) {
        const io::SvgFormat format{3, io::CageVisibility::Shown, style, 1000, 1};
        const io::SvgPicture svg = io::svgPicture(fractal, camera, format);
        QCOMPARE(svg.bytes.isEmpty(), svg.plan.failure.has_value());
        QVERIFY(!svg.bytes.contains("nan") && !svg.bytes.contains("inf"));
    }
}

} // namespace

void HostileNumbersTest::systems_data() {
    QTest::addColumn<document::Fractal>("fractal");
    const auto row = [](const char* name, const document::Fractal& fractal) {
        QTest::newRow(name) << fractal;
    };
    const auto half = affineMap(.5, 0, 0, .5, 0, 0);
    row("no maps", fractal({}));
    row("one map", fractal({half}));
    row("the identity", fractal({affineMap(1, 0, 0, 1, 0, 0)}));
    row("a shift", fractal({affineMap(1, 0, 0, 1, 1, 0), half}));
    row("a turn", fractal({affineMap(0, -1, 1, 0, 0, 0), half}));
    row("one expands", fractal({affineMap(3, 0, 0, 3, 1, 1), half}));
    row("all expand", fractal({affineMap(2, 0, 0, 2, 0, 0), affineMap(-2, 0, 0, 2, 1, 1)}));
    row("a shear", fractal({affineMap(.5, 1e6, 0, .5, 0, 0), half}));
    row("hardly contracting", fractal({affineMap(1 - 1e-15, 0, 0, 1 - 1e-15, 0, 0), half}));
    row("all zero", fractal({affineMap(0, 0, 0, 0, 0, 0)}));
    row("points", fractal({affineMap(0, 0, 0, 0, 0, 0), affineMap(0, 0, 0, 0, 1, 1)}));
    row("singular", fractal({affineMap(.5, .5, .5, .5, 0, 0), affineMap(.5, 0, 0, 0, 1, 0)}));
    row("the same map twice", fractal({half, half, half}));
    row("weights of zero", fractal({half, affineMap(.5, 0, 0, .5, 1, 0)}, 0));
    row("negative weights", fractal({half, affineMap(.5, 0, 0, .5, 1, 0)}, -1));
    row("the smallest weights", fractal({half, affineMap(.5, 0, 0, .5, 1, 0)}, minNumber));
    row("the largest weights", fractal({half, affineMap(.5, 0, 0, .5, 1, 0)}, maxNumber));
    row("the largest numbers",
        fractal({affineMap(maxNumber, maxNumber, maxNumber, maxNumber, maxNumber, maxNumber), half}));
    row("the largest with both signs",
        fractal({affineMap(maxNumber, -maxNumber, -maxNumber, maxNumber, -maxNumber, maxNumber)}));
    row("far away", fractal({affineMap(.5, 0, 0, .5, maxNumber, maxNumber),
                             affineMap(.5, 0, 0, .5, -maxNumber, maxNumber)}));
    row("the smallest numbers",
        fractal({affineMap(minNumber, minNumber, minNumber, minNumber, minNumber, minNumber),
                 affineMap(minNumber, 0, 0, minNumber, 0, minNumber)}));
    row("tiny", fractal({affineMap(.5, 0, 0, .5, 1e-300, 0), affineMap(.5, 0, 0, .5, 0, 1e-300)}));
    row("huge and tiny", fractal({affineMap(.5, 0, 0, .5, 1e38, 0), affineMap(.5, 0, 0, .5, 0, 1e-38)}));
    row("squashed", fractal({affineMap(.5, 0, 0, 1e-200, 0, 0), affineMap(.5, 0, 0, 1e-200, 1, 0)}));
}

void HostileNumbersTest::systems() {
    QFETCH(document::Fractal, fractal);
    survive(fractal);
}

void HostileNumbersTest::cages_data() {
    QTest::addColumn<QList<QPointF>>("current");
    QTest::newRow("a point") << QList<QPointF>{{1, 1}, {1, 1}, {1, 1}};
    QTest::newRow("a line") << QList<QPointF>{{0, 0}, {1, 1}, {2, 2}};
    QTest::newRow("mirrored") << QList<QPointF>{{0, 0}, {0, 1}, {1, 0}};
    QTest::newRow("the largest") << QList<QPointF>{
        {-maxNumber, -maxNumber}, {maxNumber, -maxNumber}, {0, maxNumber}};
    for (const double size : {1e20, 1e39, 1e100, 1e154, 1e200, 1e300, DBL_MAX}) // as the program might set it
        QTest::addRow("%g", size) << QList<QPointF>{{-size, -size}, {size, -size}, {0, size}};
    QTest::newRow("the smallest") << QList<QPointF>{{0, 0}, {minNumber, 0}, {0, minNumber}};
    QTest::newRow("a bow tie") << QList<QPointF>{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    QTest::newRow("four points in one") << QList<QPointF>{{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    QTest::newRow("huge and folded") << QList<QPointF>{
        {0, 0}, {maxNumber, 0}, {-maxNumber, 1}, {0, maxNumber}};
}

void HostileNumbersTest::cages() {
    QFETCH(QList<QPointF>, current);
    document::Fractal fractal = document::sierpinskiTriangle();
    ifs::ControlCage<2> cage;
    cage.rest = {{0, 0}, {1, 0}, {0, 1}};
    if (current.size() == 4) cage.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const QPointF& point : current)
        cage.current.emplace_back(point.x(), point.y());
    for (const auto deformation : {ifs::Deformation::Bend, ifs::Deformation::AffineFit}) {
        cage.deformation = deformation;
        document::plane(fractal)->cage = cage;
        survive(fractal);
    }
}

void HostileNumbersTest::movedBranches_data() {
    QTest::addColumn<ifs::AffineMap<2>>("change");
    const auto row = [](const char* name, const ifs::AffineMap<2>& change) { QTest::newRow(name) << change; };
    row("to a point", affineMap(0, 0, 0, 0, .5, .5));
    row("to a line", affineMap(1, 1, 1, 1, 0, 0));
    row("mirrored", affineMap(-1, 0, 0, 1, 0, 0));
    row("the smallest", affineMap(minNumber, 0, 0, minNumber, 0, minNumber));
    row("tiny", affineMap(1e-300, 0, 0, 1e-300, 0, 0));
    for (const double size : {1e20, maxNumber, 1e300}) {
        QTest::addRow("wide %g", size) << affineMap(size, 0, 0, size, 0, 0);
        QTest::addRow("far %g", size) << affineMap(1, 0, 0, 1, size, -size);
        QTest::addRow("sheared %g", size) << affineMap(1, size, 0, 1, 0, 0);
    }
}

void HostileNumbersTest::movedBranches() {
    QFETCH(ifs::AffineMap<2>, change);
    document::Fractal fractal = document::sierpinskiTriangle();
    const auto& maps = document::system2(fractal)->maps;
    document::plane(fractal)->moved = {{{maps[0].id}, change}, {{maps[1].id, maps[2].id}, change}};
    survive(fractal);
    ifs::ControlCage<2> bent;
    bent.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    bent.current = {{0, 0}, {1, 0}, {1.5, 1.5}, {0, 1}};
    document::plane(fractal)->cage = bent;
    survive(fractal);
}

void HostileNumbersTest::views_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("pixelsPerUnit");
    QTest::newRow("10^12") << 0.25 << 1e14;
    QTest::newRow("10^300") << 0.25 << 1e300;
    QTest::newRow("10^-12") << 0.25 << 1e-12;
    QTest::newRow("10^-300") << 0.25 << 1e-300;
    QTest::newRow("elsewhere") << 1e300 << 100.0;
    QTest::newRow("everywhere") << -DBL_MAX << minNumber;
}

void HostileNumbersTest::views() {
    QFETCH(double, x);
    QFETCH(double, pixelsPerUnit);
    attractor::Camera camera;
    camera.centre = {x, x / 2};
    camera.pixelsPerUnit = pixelsPerUnit;
    survive(document::sierpinskiTriangle(), camera);
}

BARYCAGE_TEST(HostileNumbersTest, QCoreApplication);
#include "hostile_numbers_test.moc"
