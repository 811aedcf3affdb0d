// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "io/overlay/overlay_marks.h"
#include "io/picture/plane_export.h"
#include "io/picture/vector/pdf_writer.h"
#include "io/picture/vector/svg_shapes.h"
#include "support/named_test.h"

#include <QFile>
#include <QPainter>
#include <QPainterPath>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace {
constexpr int side = 200;
}

// Scalable pictures as other programs draw them (librsvg, poppler, Inkscape, Chromium), against each other
// and against the points.
class ShapesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void librsvgDrawsTheAttractor_data() { pictures(); }
    void librsvgDrawsTheAttractor();
    void outlineEnclosesWhatTheCopiesFill_data() { pictures(); }
    void outlineEnclosesWhatTheCopiesFill();
    void inkscapeAndChromiumDrawTheSame_data();
    void inkscapeAndChromiumDrawTheSame();
    void pdfLooksLikeSvg_data() { pictures(); }
    void pdfLooksLikeSvg();
    void pdfShadowLooksLikeSvg_data();
    void pdfShadowLooksLikeSvg();
    void pdfGrowsLinearly();
    void pdfTableIsRight();
    void outlineIsOnePath();
    void pointsAreDots();
    void unionStopsOnRequest();

private:
    void pictures();
    QImage drawnBy(const QString& program, const QStringList& arguments, const QString& suffix,
                   const QByteArray& bytes);
    QImage svgImage(const QByteArray& svg) {
        return drawnBy(QStringLiteral("rsvg-convert"),
                       {QStringLiteral("IN"), QStringLiteral("-o"), QStringLiteral("OUT")},
                       QStringLiteral("svg"), svg);
    }
    QImage inkscapeImage(const QByteArray& bytes, const QString& suffix) {
        return drawnBy(QStringLiteral("inkscape"),
                       {QStringLiteral("--export-type=png"), QStringLiteral("--export-area-page"),
                        QStringLiteral("--export-dpi=96"), QStringLiteral("--export-filename=OUT"),
                        QStringLiteral("IN")},
                       suffix, bytes);
    }
    QImage chromiumImage(const QByteArray& svg) {
        const QImage window = drawnBy(
            QStringLiteral("chromium"),
            {QStringLiteral("--headless"), QStringLiteral("--no-sandbox"), QStringLiteral("--disable-gpu"),
             QStringLiteral("--hide-scrollbars"), QStringLiteral("--window-size=600,600"),
             QStringLiteral("--user-data-dir=") + m_folder.filePath(QStringLiteral("chromium")),
             QStringLiteral("--screenshot=OUT"), QStringLiteral("file://IN")},
            QStringLiteral("svg"), svg);
        return window.isNull() ? window : window.copy(0, 0, side, side);
    }
    QImage pdfImage(const QByteArray& pdf) {
        return drawnBy(QStringLiteral("pdftocairo"),
                       {QStringLiteral("-png"), QStringLiteral("-singlefile"), QStringLiteral("-r"),
                        QStringLiteral("96"), QStringLiteral("IN"), QStringLiteral("STEM")},
                       QStringLiteral("pdf"), pdf);
    }

    QTemporaryDir m_folder;
};

namespace {

document::Fractal fractalOf(const canonical::Maps2& maps) {
    document::Fractal fractal;
    fractal.name = QStringLiteral("shapes");
    document::System2 system;
    for (const auto& map : maps)
        ifs::append(system, map);
    fractal.shape = document::Shape<2>{system};
    fractal.appearance.colourBy = attractor::ColourBy::Plain;
    fractal.appearance.plain = {0, 0, 0, 255};
    fractal.appearance.background = {255, 255, 255, 255};
    return fractal;
}

document::Fractal fractalOf(int index) {
    switch (index) {
    case 0:
        return fractalOf(canonical::maple());
    case 1:
        return fractalOf(canonical::flower());
    case 2:
        return fractalOf(canonical::fern());
    default:
        return fractalOf(canonical::sierpinskiRight());
    }
}

attractor::Camera cameraFor(const document::Fractal& fractal) {
    attractor::Camera camera;
    camera.width = camera.height = side;
    const auto box = document::displayedBox(fractal);
    return attractor::fitted(camera, box->min, box->max);
}

// Whether some pixel around (x, y), at most `distance` away, is darker than `grey`.
bool isDarkNear(const QImage& image, int x, int y, int distance, int grey) {
    for (int dy = -distance; dy <= distance; ++dy)
        for (int dx = -distance; dx <= distance; ++dx)
            if (image.valid(x + dx, y + dy) && qGray(image.pixel(x + dx, y + dy)) < grey) return true;
    return false;
}

// Pixels that `a` draws and `b` does not.
int missing(const QImage& a, const QImage& b, int distance) {
    constexpr int drawn = 100; // more than half
    constexpr int traced = 230;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += qGray(a.pixel(x, y)) < drawn && !isDarkNear(b, x, y, distance, traced);
    return count;
}

// White inside the rings at the corners: the digits there are in the letters of the program that draws them.
QImage withoutDigits(QImage picture, const document::Fractal& fractal, const attractor::Camera& camera) {
    QPainter painter(&picture);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    const io::OverlayMarks marks = io::cornerMarks(fractal, camera, fractal.appearance.background);
    for (const io::OverlayMark& mark : marks)
        if (mark.radius > 0) {
            const double inside = mark.radius - mark.width;
            painter.drawEllipse(mark.centre, inside, inside);
        }
    return picture;
}

QImage filled(const std::vector<io::Ring>& rings) {
    QPainterPath path; // filled by the even-odd rule
    for (const auto& ring : rings) {
        QPolygonF polygon;
        for (const auto& point : ring)
            polygon << QPointF(point.x(), point.y());
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(path, Qt::black);
    return image;
}

} // namespace

void ShapesTest::pictures() {
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("less"); // levels fewer than a pixel needs
    const char* names[] = {"maple", "flower", "fern", "sierpinski"};
    for (int index = 0; index < 4; ++index)
        for (const int less : {4, 7})
            QTest::addRow("%s, %d levels fewer", names[index], less) << index << less;
}

QImage ShapesTest::drawnBy(const QString& program, const QStringList& arguments, const QString& suffix,
                           const QByteArray& bytes) {
    if (QStandardPaths::findExecutable(program).isEmpty()) return {};
    const QString in = m_folder.filePath(QStringLiteral("in.") + suffix);
    const QString stem = m_folder.filePath(QStringLiteral("out"));
    QFile::remove(stem + QStringLiteral(".png"));
    QFile file(in);
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(bytes);
    file.close();
    QStringList filledIn = arguments;
    filledIn.replaceInStrings(QStringLiteral("IN"), in)
        .replaceInStrings(QStringLiteral("STEM"), stem)
        .replaceInStrings(QStringLiteral("OUT"), stem + QStringLiteral(".png"));
    QProcess process;
    process.start(program, filledIn);
    process.waitForFinished(120'000);
    const QImage drawn(stem + QStringLiteral(".png"));
    if (drawn.isNull()) return {};
    QImage onWhite(drawn.size(), QImage::Format_RGB32);
    onWhite.fill(Qt::white);
    QPainter(&onWhite).drawImage(0, 0, drawn);
    return onWhite;
}

void ShapesTest::librsvgDrawsTheAttractor() {
    QFETCH(int, index);
    QFETCH(int, less);
    const document::Fractal fractal = fractalOf(index);
    const attractor::Camera camera = cameraFor(fractal);
    const int depth = std::max(0, io::svgPlan(fractal, camera, {}).depth - less);
    const io::SvgPicture picture = io::svgPicture(fractal, camera, {depth});
    const QImage svg = svgImage(picture.bytes);
    if (svg.isNull()) QSKIP("rsvg-convert is not installed");
    io::PlaneExport png{fractal, document::renderRequest(fractal, camera), {}, io::CageVisibility::Hidden};
    png.request.samples = 4'000'000;
    png.fractal.appearance.brightness = 1000;
    png.request.appearance = png.fractal.appearance;
    const QImage points = io::drawPicture(png).image.convertToFormat(QImage::Format_RGB32);
    const int distance = int(std::ceil(picture.plan.errorInPixels)) + 1;
    QCOMPARE(missing(points, svg, distance), 0);
    QCOMPARE(missing(svg, points, distance), 0);
    QVERIFY(missing(points, svg.mirrored(), 1) > 100); // it could fail
}

void ShapesTest::outlineEnclosesWhatTheCopiesFill() {
    QFETCH(int, index);
    QFETCH(int, less);
    const document::Fractal fractal = fractalOf(index);
    const attractor::Camera camera = cameraFor(fractal);
    const int depth = std::max(0, io::svgPlan(fractal, camera, {}).depth - less);
    const QImage svg = svgImage(io::svgPicture(fractal, camera, {depth}).bytes);
    if (svg.isNull()) QSKIP("rsvg-convert is not installed");
    const auto levels = io::shapeLevels(fractal, camera);
    const auto rings = io::leafUnion(*levels.levels, depth);
    QVERIFY(!rings.empty());
    const QImage outline = filled(rings);
    QCOMPARE(missing(outline, svg, 1), 0);
    QCOMPARE(missing(svg, outline, 1), 0);
}

void ShapesTest::inkscapeAndChromiumDrawTheSame_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("style");
    for (const char* program : {"inkscape", "chromium", "inkscape, of the PDF"})
        for (const int index : {0, 3})
            for (const auto style :
                 {io::ShapeStyle::Structured, io::ShapeStyle::Outline, io::ShapeStyle::Points})
                QTest::addRow("%s, %s, style %d", program, index == 0 ? "maple" : "sierpinski", int(style))
                    << QString::fromLatin1(program) << index << int(style);
}

// To the depth that a pixel needs: what one draws, the other draws, both ways.
void ShapesTest::inkscapeAndChromiumDrawTheSame() {
    if (!qEnvironmentVariableIsSet("BARYCAGE_OTHER_PROGRAMS"))
        QSKIP("./dev test --programs asks other programs");
    QFETCH(QString, program);
    QFETCH(int, index);
    QFETCH(int, style);
    const document::Fractal fractal = fractalOf(index);
    const attractor::Camera camera = cameraFor(fractal);
    io::SvgFormat format;
    format.style = io::ShapeStyle(style);
    format.points = 3000;
    // Inkscape takes a PDF apart into all its copies, minutes for as many as a pixel needs.
    if (program != u"inkscape" && program != u"chromium")
        format.depth = std::max(0, io::svgPlan(fractal, camera, format).depth - 6);
    const QByteArray bytes = io::svgPicture(fractal, camera, format).bytes;
    const QImage svg = svgImage(bytes);
    const QImage other =
        program == u"inkscape" ? inkscapeImage(bytes, QStringLiteral("svg"))
        : program == u"chromium"
            ? chromiumImage(bytes)
            : inkscapeImage(io::pdfPicture({{fractal, camera, format}}).bytes, QStringLiteral("pdf"));
    if (svg.isNull() || other.isNull()) QSKIP(qPrintable(program + QStringLiteral(" is not installed")));
    QVERIFY(std::abs(other.width() - side) <= 1 && std::abs(other.height() - side) <= 1);
    QCOMPARE(missing(svg, other, 1), 0);
    QCOMPARE(missing(other, svg, 1), 0);
}

void ShapesTest::pdfLooksLikeSvg() {
    QFETCH(int, index);
    QFETCH(int, less);
    document::Fractal fractal = fractalOf(index);
    const attractor::Camera camera = cameraFor(fractal);
    const int depth = std::max(0, io::svgPlan(fractal, camera, {}).depth - less);
    if (index == 1 || index == 2) return; // two of the four are enough
    for (const auto style : {io::ShapeStyle::Structured, io::ShapeStyle::Outline, io::ShapeStyle::Points}) {
        if (style != io::ShapeStyle::Structured && less == 4) continue;
        const io::SvgFormat format{depth, io::CageVisibility::Shown, style, 3000};
        const QImage svg = svgImage(io::svgPicture(fractal, camera, format).bytes);
        const QImage pdf = pdfImage(io::pdfPicture({{fractal, camera, format}}).bytes);
        if (svg.isNull() || pdf.isNull()) QSKIP("rsvg-convert or pdftocairo is not installed");
        QVERIFY(std::abs(pdf.width() - side) <= 1 && std::abs(pdf.height() - side) <= 1);
        const int distance = style == io::ShapeStyle::Outline ? 2 : 1; // poppler moves thin lines to pixels
        QCOMPARE(missing(withoutDigits(svg, fractal, camera), pdf, distance), 0);
        QCOMPARE(missing(withoutDigits(pdf, fractal, camera), svg, distance), 0);
    }
}

void ShapesTest::pdfShadowLooksLikeSvg_data() {
    QTest::addColumn<int>("style");
    QTest::newRow("structured") << int(io::ShapeStyle::Structured);
    QTest::newRow("points") << int(io::ShapeStyle::Points);
}

// Its copies lie over each other, and are no darker there.
void ShapesTest::pdfShadowLooksLikeSvg() {
    QFETCH(const int, style);
    document::Fractal fractal = fractalOf(0);
    fractal.appearance.plain = {220, 40, 40, 255};
    fractal.appearance.shadow = 0.5;
    attractor::Camera camera;
    camera.width = camera.height = side;
    const auto box = document::boxWithShadow(fractal, camera.yAxis);
    camera = attractor::fitted(camera, box->min, box->max);
    const int depth = std::max(0, io::svgPlan(fractal, camera, {}).depth - 2); // readers take a while
    const io::SvgFormat format{depth, io::CageVisibility::Hidden, io::ShapeStyle(style), 20'000};
    const QImage svg = svgImage(io::svgPicture(fractal, camera, format).bytes);
    const QImage pdf = pdfImage(io::pdfPicture({{fractal, camera, format}}).bytes);
    if (svg.isNull() || pdf.isNull()) QSKIP("rsvg-convert or pdftocairo is not installed");
    int shadow = 0; // half of (88, 16, 16) on white
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            shadow +=
                std::abs(qRed(pdf.pixel(x, y)) - 172) < 8 && std::abs(qGreen(pdf.pixel(x, y)) - 136) < 8;
    // Averages of blocks: programs put the same ink of a dot into different pixels.
    constexpr int blocks = side / 4;
    const auto averaged = [](const QImage& image) {
        return image.convertToFormat(QImage::Format_RGB32)
            .scaled(blocks, blocks, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage one = averaged(svg), other = averaged(pdf);
    double difference = 0;
    for (int y = 0; y < blocks; ++y)
        for (int x = 0; x < blocks; ++x) {
            const QRgb a = one.pixel(x, y), b = other.pixel(x, y);
            difference += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b));
        }
    difference /= blocks * blocks;
    // Dots leave no pixel whole.
    QVERIFY2(shadow > 200 || style == int(io::ShapeStyle::Points), qPrintable(QString::number(shadow)));
    QVERIFY2(difference < 8, qPrintable(QString::number(difference)));
}

void ShapesTest::pdfGrowsLinearly() {
    const document::Fractal fractal = fractalOf(3);
    const attractor::Camera camera = cameraFor(fractal);
    const auto size = [&](int depth) { return io::pdfPicture({{fractal, camera, {depth}}}).bytes.size(); };
    QVERIFY(size(10) < 8000);
    QVERIFY(std::abs((size(10) - size(8)) - (size(8) - size(6))) < 200);
}

void ShapesTest::pdfTableIsRight() {
    const document::Fractal fractal = fractalOf(0);
    const attractor::Camera camera = cameraFor(fractal);
    const QByteArray pdf =
        io::pdfPicture({{fractal, camera, {3}}, {fractal, camera, {2, {}, io::ShapeStyle::Points}}}).bytes;
    QVERIFY(pdf.startsWith("%PDF-1.5\n"));
    const qsizetype begin = pdf.lastIndexOf("startxref\n") + 10;
    const qsizetype table = pdf.mid(begin, pdf.indexOf('\n', begin) - begin).toLongLong();
    QVERIFY(pdf.mid(table).startsWith("xref\n0 "));
    const QByteArrayList lines = pdf.mid(table).split('\n');
    const int count = lines[1].mid(2).toInt();
    QVERIFY(count > 5);
    for (int object = 1; object < count; ++object) {
        QCOMPARE(lines[object + 2].size(), 19); // and the line end: 20 bytes each
        const QByteArray expected = QByteArray::number(object) + " 0 obj\n";
        QVERIFY(pdf.mid(lines[object + 2].left(10).toLongLong()).startsWith(expected));
    }
    QVERIFY(pdf.contains("/Count 2/"));
}

void ShapesTest::outlineIsOnePath() {
    const document::Fractal fractal = fractalOf(3);
    const io::SvgFormat format{4, io::CageVisibility::Hidden, io::ShapeStyle::Outline};
    const QByteArray svg = io::svgPicture(fractal, cameraFor(fractal), format).bytes;
    QCOMPARE(svg.count("<path"), 1);
    QVERIFY(svg.contains("fill=\"none\""));
    QVERIFY(!svg.contains("<use") && !svg.contains("<rect"));
    // The outside and the holes of four levels: 1 + 3 + 9 + 27 triangles are missing.
    QCOMPARE(svg.count('Z'), 1 + 40);
}

void ShapesTest::pointsAreDots() {
    document::Fractal fractal = fractalOf(0);
    fractal.appearance.colourBy = attractor::ColourBy::Map;
    const attractor::Camera camera = cameraFor(fractal);
    const io::SvgFormat format{{}, io::CageVisibility::Hidden, io::ShapeStyle::Points, 400, 3};
    const QByteArray svg = io::svgPicture(fractal, camera, format).bytes;
    QCOMPARE(svg.count("h0"), 400); // the camera sees all
    QCOMPARE(svg.count("<path"), 4);
    QVERIFY(io::svgPicture(fractal, camera, format).bytes == svg);
    const QImage image = svgImage(svg);
    if (image.isNull()) QSKIP("rsvg-convert is not installed");
    for (const auto& group : io::shapePoints(fractal, camera, 400, 3))
        for (const auto& point : group.points)
            QVERIFY(isDarkNear(image, int(point.x()), int(point.y()), 1, 250));
}

void ShapesTest::unionStopsOnRequest() {
    const document::Fractal fractal = fractalOf(1);
    const auto levels = io::shapeLevels(fractal, cameraFor(fractal));
    std::stop_source source;
    source.request_stop();
    QVERIFY(io::leafUnion(*levels.levels, 12, source.get_token()).empty());
}

BARYCAGE_TEST(ShapesTest, QGuiApplication);
#include "shapes_test.moc"
