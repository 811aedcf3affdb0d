// SPDX-License-Identifier: MIT
#include "io/picture/vector/picture_page.h"

#include "attractor/space_systems.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/space_export.h"
#include "io/picture/vector/svg_system.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace io;

namespace {

PictureFormat formatOf(int width, int height, PictureFormat::Pixels pixels) {
    PictureFormat format;
    format.width = width;
    format.height = height;
    format.pixels = pixels;
    return format;
}

// Every pixel another one, of any opacity.
QImage pattern(int width, int height, PictureFormat::Pixels pixels) {
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int alpha = pixels == PictureFormat::Pixels::Opaque ? 255 : (x + y) % 256;
            image.setPixel(x, y, qPremultiply(qRgba(x % 256, y % 256, (x * 7 + y * 13) % 256, alpha)));
        }
    return image;
}

QByteArray pageOf(const QImage& image, ShapeFile file, PictureFormat::Pixels pixels,
                  const OverlayMarks& marks = {}) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    const auto writer = pageWriter({file, QStringLiteral("one & two"), marks}, buffer,
                                   formatOf(image.width(), image.height(), pixels));
    for (int y = 0; y < image.height(); ++y)
        if (writer->writeRows(std::span(reinterpret_cast<const std::uint32_t*>(image.constScanLine(y)),
                                        std::size_t(image.width()))))
            return {};
    return writer->finish() ? QByteArray() : bytes;
}

struct Strip {
    QImage image;
    int y = 0;
    qsizetype characters = 0;
};

std::vector<Strip> stripsOf(const QByteArray& svg) {
    std::vector<Strip> strips;
    QXmlStreamReader xml(svg);
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"image") {
            const auto attributes = xml.attributes();
            const QByteArray link =
                attributes.value(QStringLiteral("http://www.w3.org/1999/xlink"), QStringLiteral("href"))
                    .toLatin1();
            Strip strip;
            strip.y = attributes.value(QStringLiteral("y")).toInt();
            strip.characters = link.size();
            strip.image = QImage::fromData(
                QByteArray::fromBase64(link.mid(QByteArray("data:image/png;base64,").size())));
            if (strip.image.height() == attributes.value(QStringLiteral("height")).toInt())
                strips.push_back(strip);
        }
    return xml.hasError() ? std::vector<Strip>() : strips;
}

// All strips, each over the one before.
QImage assembled(const QByteArray& svg, const QSize& size) {
    QImage whole(size, QImage::Format_ARGB32_Premultiplied);
    whole.fill(Qt::transparent);
    QPainter painter(&whole);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    for (const Strip& strip : stripsOf(svg))
        painter.drawImage(0, strip.y, strip.image);
    return whole;
}

int difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return 1000;
    int most = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            most = std::max({most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                             std::abs(qBlue(p) - qBlue(q)), std::abs(qAlpha(p) - qAlpha(q))});
        }
    return most;
}

SpaceExport menger(ShapeFile page) {
    SpaceExport picture;
    auto& shape = picture.fractal.shape.emplace<document::Shape<3>>();
    shape.system = systems::menger();
    picture.fractal.name = QStringLiteral("sponge");
    picture.request = systems::spaceRequest(shape.system, 80, 60, 30, 20);
    picture.look = attractor::LookInSpace::Stone;
    picture.solid = attractor::appearanceOf(attractor::Look::Stone);
    picture.page = page;
    return picture;
}

QByteArray drawn(const SpaceExport& picture) {
    QByteArray bytes;
    const ExportOutcome outcome = drawSpaceFile(picture, bytes);
    return outcome.failure || outcome.stopped ? QByteArray() : bytes;
}

// As poppler draws it, a pixel for each; null when it is not installed.
QImage drawnByPoppler(const QByteArray& pdf, bool isTransparent) {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("pdftocairo"));
    const QTemporaryDir folder;
    if (program.isEmpty() || !folder.isValid()) return {};
    QFile file(folder.filePath(QStringLiteral("page.pdf")));
    if (!file.open(QIODevice::WriteOnly) || file.write(pdf) != pdf.size()) return {};
    file.close();
    QStringList arguments{QStringLiteral("-png"), QStringLiteral("-singlefile"), QStringLiteral("-r"),
                          QStringLiteral("96")};
    if (isTransparent) arguments << QStringLiteral("-transp");
    QProcess::execute(program, arguments << file.fileName() << folder.filePath(QStringLiteral("page")));
    return QImage(folder.filePath(QStringLiteral("page.png")));
}

OverlayMarks redSquare() {
    OverlayMark square;
    square.polygon = QPolygonF({{10, 10}, {30, 10}, {30, 30}, {10, 30}});
    square.fill = Qt::red;
    return {square};
}

} // namespace

class PicturePageTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsStayInSvg_data() { kinds(); }
    void pixelsStayInSvg();
    void largePicturesAreInStrips();
    void pixelsStayInPdf_data() { kinds(); }
    void pixelsStayInPdf();
    void marksAreShapes();
    void solidsAreEmbedded();
    void sizeFollowsTheResolution();

private:
    static void kinds() {
        QTest::addColumn<PictureFormat::Pixels>("pixels");
        QTest::newRow("opaque") << PictureFormat::Pixels::Opaque;
        QTest::newRow("transparent") << PictureFormat::Pixels::Transparent;
    }
};

void PicturePageTest::pixelsStayInSvg() {
    QFETCH(const PictureFormat::Pixels, pixels);
    const QImage image = pattern(150, 100, pixels);
    const QByteArray svg = pageOf(image, ShapeFile::Svg, pixels);
    QCOMPARE(int(stripsOf(svg).size()), 1);
    QVERIFY(difference(assembled(svg, image.size()), image) <= 1); // of the premultiplied colours
    QVERIFY(svg.contains("<title>one &amp; two</title>"));
}

// libxml2 refuses an attribute of ten million bytes.
void PicturePageTest::largePicturesAreInStrips() {
    const QImage image = pattern(2000, 2500, PictureFormat::Pixels::Opaque);
    const QByteArray svg = pageOf(image, ShapeFile::Svg, PictureFormat::Pixels::Opaque);
    const std::vector<Strip> strips = stripsOf(svg);
    QCOMPARE(int(strips.size()), 3);
    for (std::size_t i = 0; i < strips.size(); ++i) {
        QVERIFY(strips[i].characters < 10'000'000);
        if (i > 0) QCOMPARE(strips[i].y, strips[i - 1].y + strips[i - 1].image.height() - 1); // they overlap
    }
    QCOMPARE(strips.back().y + strips.back().image.height(), 2500);
    QCOMPARE(difference(assembled(svg, image.size()), image), 0);
}

void PicturePageTest::pixelsStayInPdf() {
    QFETCH(const PictureFormat::Pixels, pixels);
    const QImage image = pattern(150, 100, pixels);
    const bool isTransparent = pixels == PictureFormat::Pixels::Transparent;
    const QImage drawn = drawnByPoppler(pageOf(image, ShapeFile::Pdf, pixels), isTransparent);
    if (drawn.isNull()) QSKIP("pdftocairo is not installed: no independent program to draw the PDF");
    QCOMPARE(drawn.size(), image.size());
    // Poppler multiplies by the opacity again, with rounding.
    QVERIFY(difference(drawn.convertToFormat(QImage::Format_ARGB32_Premultiplied), image) <=
            (isTransparent ? 2 : 0));
}

void PicturePageTest::marksAreShapes() {
    const QImage image = pattern(60, 40, PictureFormat::Pixels::Opaque);
    const QByteArray svg = pageOf(image, ShapeFile::Svg, PictureFormat::Pixels::Opaque, redSquare());
    QVERIFY(svg.contains("<polygon points=\"10,10 30,10 30,30 10,30\" fill=\"#ff0000\"/>"));
    QCOMPARE(difference(assembled(svg, image.size()), image), 0);
    const QImage drawn =
        drawnByPoppler(pageOf(image, ShapeFile::Pdf, PictureFormat::Pixels::Opaque, redSquare()), false);
    if (drawn.isNull()) QSKIP("pdftocairo is not installed: no independent program to draw the PDF");
    QCOMPARE(QColor(drawn.pixel(20, 20)), QColor(Qt::red));
    QCOMPARE(drawn.pixel(40, 20), image.pixel(40, 20));
}

void PicturePageTest::solidsAreEmbedded() {
    const SpaceExport picture = menger(ShapeFile::Svg);
    const QImage expected = drawSpacePicture(picture).image;
    const QByteArray svg = drawn(picture);
    QCOMPARE(difference(assembled(svg, expected.size()), expected), 0);
    QCOMPARE(readSvgSystem(svg).text, writeEntry(picture.fractal));
    const QImage page = drawnByPoppler(drawn(menger(ShapeFile::Pdf)), false);
    if (page.isNull()) QSKIP("pdftocairo is not installed: no independent program to draw the PDF");
    QCOMPARE(difference(page, expected), 0);
}

void PicturePageTest::sizeFollowsTheResolution() {
    SpaceExport picture = menger(ShapeFile::Svg);
    picture.dotsPerInch = 254;
    QVERIFY(drawn(picture).contains("width=\"8mm\" height=\"6mm\""));
    picture.page = ShapeFile::Pdf;
    picture.dotsPerInch = 144;
    QVERIFY(drawn(picture).contains("/MediaBox[0 0 40 30]"));
}

BARYCAGE_TEST(PicturePageTest, QCoreApplication);
#include "picture_page_test.moc"
