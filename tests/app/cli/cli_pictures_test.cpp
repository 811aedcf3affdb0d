// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <QtEndian>

#include <cmath>
#include <tuple>

// The kinds of files that barycage-cli render and gallery write, and what explains a picture.
class CliPicturesTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void everyFormatCarriesTheSystem_data();
    void everyFormatCarriesTheSystem();
    void whatAFormatCannotHoldIsRefused_data();
    void whatAFormatCannotHoldIsRefused();
    void qualityChangesTheSize();
    void systemsInSpaceTakeTheSameFormats();
    void overlaysAreDrawn_data();
    void overlaysAreDrawn();
    void overlaysAreShapes();
    void overlaysAreOnPages();
    void theViewHoldsTheCage();
    void theLegendStandsBesideThePicture();
    void theLegendStandsBesideASolid_data();
    void theLegendStandsBesideASolid();
    void sheetsAreWrittenInEveryFormat();
    void largeTilesTakeLittleMemory();
    void pagesOfASheet();
    void sizesOnPaperAreExact();

private:
    QImage picture(const QByteArray& options) const;
};

void CliPicturesTest::everyFormatCarriesTheSystem_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("start");
    QTest::addColumn<QString>("format");
    const auto row = [](const char* name, const QByteArray& start, const char* format) {
        QTest::newRow(name) << QByteArray(name) << start << QString::fromLatin1(format);
    };
    row("a.png", "\x89PNG", "png");
    row("a.JPG", "\xff\xd8\xff", "jpeg");
    row("a.jpeg", "\xff\xd8\xff", "jpeg");
    row("a.webp", "RIFF", "webp");
    row("a.tif", "II*", "tiff");
    row("a.tiff", "II*", "tiff");
    row("a.exr", "\x76\x2f\x31\x01", "exr");
}

void CliPicturesTest::everyFormatCarriesTheSystem() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, start);
    QFETCH(QString, format);
    const QByteArray render = "render systems.ifs --entry fern --size 70x50 --points 50000 -o ";
    QCOMPARE(run(render + name).status, 0);
    const QByteArray bytes = read(name);
    QVERIFY(bytes.startsWith(start));
    QCOMPARE(run(render + name + " --threads 1 --simd scalar").status, 0);
    QCOMPARE(read(name), bytes);
    const Result info = run("info --json " + name);
    QCOMPARE(info.status, 0);
    QCOMPARE(info.entry()[QLatin1String("name")].toString(), QStringLiteral("Fern"));
    QVERIFY(info.out.contains("\"format\": \"" + format.toLatin1() + '"'));
    const QByteArray kind = name.mid(2).toLower();
    const Result piped = run(render + "- --to " + (kind == "jpeg" ? "jpg" : kind == "tif" ? "tiff" : kind));
    QCOMPARE(piped.out, bytes);
}

void CliPicturesTest::whatAFormatCannotHoldIsRefused_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<QByteArray>("sentence");
    const auto row = [](const char* options, const char* sentence) {
        QTest::newRow(options) << QByteArray(options) << QByteArray(sentence);
    };
    row("-o x.jpg --bits 16", "--bits 16 cannot be used here: .jpg and .webp have 8 bits per channel.");
    row("-o x.webp --bits 16", "--bits 16 cannot be used here: .jpg and .webp have 8 bits per channel.");
    row("-o x.exr --bits 8", "--bits 8 cannot be used here: OpenEXR has 16 or 32 bits per channel.");
    row("-o x.png --bits 32", "--bits 32 cannot be used here: only .exr has 32 bits per channel.");
    row("-o x.png --bits 7", "--bits “7” is not valid");
    row("-o x.jpg --background transparent", "A JPEG picture cannot be transparent.");
    row("-o x.jpg --size 2x65501", "A JPEG picture has at most 65500 pixels along a side.");
    row("-o x.webp --size 16384x2", "A WebP picture has at most 16383 pixels along a side.");
    row("-o x.png --quality 50", "--quality cannot be used here: it applies only to .jpg and .webp.");
    row("-o x.jpg --quality 0", "--quality");
    row("-o x.exr --algorithm deterministic --iterations 0-2", "a strip of steps has 8 bits per channel.");
    row("-o x.svg --legend", "--legend cannot be used here: it applies only to pictures made of pixels.");
    row("-o x.sum --overlay maps", "--overlay cannot be used here: a .sum file holds only");
    row("-o x.svg --overlay maps,cag", "--overlay “cag” is not valid");
    row("-o x.pdf --entry broken --overlay hull", "--overlay hull cannot be used here");
    row("-o x.sum --legend", "--legend cannot be used here: a .sum file holds only the numbers of points.");
    row("-o x.png --overlay maps,cag", "--overlay “cag” is not valid");
    row("-o x.png --entry broken --overlay hull", "--overlay hull cannot be used here");
    row("-o x.bmp", "“x.bmp” is none of them.");
}

void CliPicturesTest::whatAFormatCannotHoldIsRefused() {
    QFETCH(QByteArray, options);
    QFETCH(QByteArray, sentence);
    write("growing.ifs", "broken {\n 2 0 0 2 0 0 .5\n 2 0 0 2 1 0 .5\n}\n");
    const bool grows = options.contains("broken");
    const Result result = run(QByteArray("render ") + (grows ? "growing.ifs " : "systems.ifs ") + options);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(sentence), result.err.constData());
    const QByteArray name = options.mid(3).split(' ').first();
    QVERIFY(!QFile::exists(path(name)));
}

void CliPicturesTest::qualityChangesTheSize() {
    const QByteArray render = "render systems.ifs --size 200x200 --points 400000 -o ";
    for (const QByteArray kind : {"jpg", "webp"}) {
        QCOMPARE(run(render + "usual." + kind).status, 0);
        QCOMPARE(run(render + "poor." + kind + " --quality 30").status, 0);
        QVERIFY(read("poor." + kind).size() < read("usual." + kind).size());
    }
}

void CliPicturesTest::systemsInSpaceTakeTheSameFormats() {
    write("space.ifs", "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 1 0 0 .25\n"
                       " .5 0 0 0 .5 0 0 0 .5 0 1 0 .25\n .5 0 0 0 .5 0 0 0 .5 0 0 1 .25\n}\n");
    for (const QByteArray name : {"s.jpg", "s.webp", "s.tiff", "s.exr"}) {
        QCOMPARE(run("render space.ifs --size 60x60 -o " + name).status, 0);
        QCOMPARE(run("info " + name).status, 0);
    }
    QCOMPARE(run("render space.ifs --size 60x60 --look cloud --points 10000 -o c.exr --bits 32").status, 0);
    const Result depth = run("render space.ifs --look depth -o d.tiff");
    QCOMPARE(depth.status, 2);
    QVERIFY2(depth.err.contains("--look depth can be drawn only as .png"), depth.err.constData());
    QCOMPARE(run("render space.ifs -o o.png --look normals --legend").status, 2);
}

QImage CliPicturesTest::picture(const QByteArray& options) const {
    QFile::remove(path("over.png"));
    const Result result = run("render systems.ifs --size 300x240 --points 200000 --view 0.4,2.5,9 "
                              "-o over.png " +
                              options);
    return result.status == 0 && result.err.isEmpty() ? QImage(path("over.png")) : QImage();
}

void CliPicturesTest::overlaysAreDrawn_data() {
    QTest::addColumn<QByteArray>("parts");
    QTest::addColumn<QColor>("colour"); // of something there
    QTest::newRow("maps") << QByteArray("maps") << QColor(0x35, 0xa7, 0xf0);
    QTest::newRow("hull") << QByteArray("hull") << QColor(214, 224, 240);
    QTest::newRow("cage") << QByteArray("cage") << QColor(245, 166, 35);
    QTest::newRow("fixed-points") << QByteArray("fixed-points") << QColor(0x35, 0xa7, 0xf0);
    QTest::newRow("numbers") << QByteArray("numbers") << QColor(0x35, 0xa7, 0xf0);
}

// Only where it should be: few pixels change, some of them to that colour or near it.
void CliPicturesTest::overlaysAreDrawn() {
    QFETCH(QByteArray, parts);
    QFETCH(QColor, colour);
    const QImage plain = picture({}), over = picture("--overlay " + parts);
    QCOMPARE(over.size(), plain.size());
    int changed = 0, coloured = 0;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x) {
            if (plain.pixel(x, y) == over.pixel(x, y)) continue;
            ++changed;
            const QColor here = over.pixelColor(x, y);
            coloured += std::abs(here.red() - colour.red()) + std::abs(here.green() - colour.green()) +
                            std::abs(here.blue() - colour.blue()) <
                        60;
        }
    QVERIFY2(changed > 50, qPrintable(QString::number(changed)));
    QVERIFY2(parts == "maps" || changed < plain.width() * plain.height() / 4,
             qPrintable(QString::number(changed)));
    QVERIFY2(coloured > 10, qPrintable(QString::number(coloured)));
    QCOMPARE(picture("--bits 16 --overlay " + parts).size(), plain.size());
}

// In an SVG picture they are elements of a group of their own, above all others.
void CliPicturesTest::overlaysAreShapes() {
    const Result result = run("render systems.ifs --entry maple --size 300x240 --background white "
                              "--overlay maps,hull,cage,fixed-points,numbers -o over.svg");
    QCOMPARE(result.err, QByteArray());
    QCOMPARE(result.status, 0);
    QXmlStreamReader xml(read("over.svg"));
    const auto isOverlay = [&xml] {
        return xml.isStartElement() &&
               xml.attributes().value(QLatin1String("id")) == QLatin1String("overlay");
    };
    while (!xml.atEnd() && !isOverlay())
        xml.readNext();
    QStringList names, words;
    while (xml.readNextStartElement()) {
        names << xml.name().toString();
        if (xml.name() == QLatin1String("polygon"))
            QVERIFY(xml.attributes().value(QLatin1String("points")).count(u',') >= 3);
        const QString text = xml.readElementText();
        if (!text.isEmpty()) words << text;
    }
    constexpr int maps = 4;
    QCOMPARE(names.count(QStringLiteral("polygon")), 2 * maps + 2 + 1);
    QCOMPARE(names.count(QStringLiteral("circle")), 2 * maps + maps);
    QCOMPARE(words, QStringList({QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3"),
                                 QStringLiteral("4")}));
    xml.readNextStartElement();
    QVERIFY(!xml.isStartElement());
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
}

void CliPicturesTest::overlaysAreOnPages() {
    const auto page = [this](const QByteArray& options) {
        const Result result =
            run("render systems.ifs --entry maple --size 300x240 --view 0,2,12 -o over.pdf " + options);
        return result.status == 0 && result.err.isEmpty() ? read("over.pdf") : QByteArray();
    };
    const QByteArray plain = page({}), cage = page("--overlay cage"), maps = page("--overlay maps");
    const QByteArray numbers = page("--overlay numbers --svg outline");
    QVERIFY(plain.startsWith("%PDF") && cage.startsWith("%PDF"));
    QVERIFY(plain != cage);
    QVERIFY(!cage.contains("/ExtGState") && !cage.contains("/Font"));
    QVERIFY(maps.contains("/ExtGState<</A20<</ca 0.080>>>>")); // an opacity of 8 %
    QVERIFY(numbers.contains("/BaseFont/Helvetica-Bold") && !numbers.contains("/ExtGState"));
}

// The canonical simplex of the maple is larger than the maple.
void CliPicturesTest::theViewHoldsTheCage() {
    const auto cageColour = [](const QImage& image, const QRect& part) {
        int pixels = 0;
        for (int y = part.top(); y <= part.bottom(); ++y)
            for (int x = part.left(); x <= part.right(); ++x) {
                const QColor here = image.pixelColor(x, y);
                pixels += here.red() > 110 && here.green() > here.red() / 2 && here.blue() < here.green() / 2;
            }
        return pixels;
    };
    QCOMPARE(run("render systems.ifs --size 200x200 --colour none --points 1000 --overlay cage -o cage.png")
                 .status,
             0);
    const QImage image(path("cage.png"));
    QVERIFY(cageColour(image, image.rect()) > 300);
    for (const QRect& edge :
         {QRect(0, 0, 200, 4), QRect(0, 196, 200, 4), QRect(0, 0, 4, 200), QRect(196, 0, 4, 200)})
        QCOMPARE(cageColour(image, edge), 0);
}

void CliPicturesTest::theLegendStandsBesideThePicture() {
    const QImage plain = picture({}), wide = picture("--legend");
    QCOMPARE(wide.height(), plain.height());
    QVERIFY(wide.width() > plain.width() + 100);
    QCOMPARE(wide.copy(plain.rect()), plain);
    const QImage legend = wide.copy(plain.width(), 0, wide.width() - plain.width(), wide.height());
    int ink = 0;
    for (int y = 0; y < legend.height(); ++y)
        for (int x = 0; x < legend.width(); ++x)
            ink += legend.pixel(x, y) != legend.pixel(0, 0);
    QVERIFY2(ink > 1000, qPrintable(QString::number(ink)));
    // Of more maps than there is room for, some are shown and the others counted.
    QByteArray many;
    for (int i = 0; i < 300; ++i)
        many += " .1 0 0 .1 " + QByteArray::number(i) + " 0 1\n";
    write("many.ifs", "many {\n" + many + "}\n");
    QCOMPARE(
        run("render many.ifs --size 100x80 --points 1000 --legend --overlay maps,numbers -o many.png").status,
        0);
    QCOMPARE(QImage(path("many.png")).height(), 80);
    QCOMPARE(run("render many.ifs --size 3x2 --points 1000 --legend --overlay numbers -o tiny.png").status,
             0);
}

// The table has twelve numbers for each map, so it is wider than that of the plane.
void CliPicturesTest::theLegendStandsBesideASolid_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::newRow("stone") << QByteArray();
    QTest::newRow("ink, 16 bits") << QByteArray("--look ink --bits 16");
    QTest::newRow("cloud") << QByteArray("--look cloud --points 200000");
    QTest::newRow("maps over it") << QByteArray("--overlay maps");
}

void CliPicturesTest::theLegendStandsBesideASolid() {
    QFETCH(const QByteArray, options);
    const QByteArray render = "render space.ifs --size 300x240 " + options;
    QCOMPARE(run(render + " -o plain.png").status, 0);
    const Result result = run(render + " --legend -o wide.png");
    QVERIFY2(result.status == 0 && result.err.isEmpty(), result.err.constData());
    const QImage plain(path("plain.png")), wide(path("wide.png"));
    QCOMPARE(wide.height(), plain.height());
    QCOMPARE(wide.copy(plain.rect()), plain);
    write("flat.ifs", "flat {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    QCOMPARE(run("render flat.ifs --size 300x240 --points 1000 --legend -o flat.png").status, 0);
    QVERIFY(wide.width() > QImage(path("flat.png")).width() + 30);
    const QImage legend = wide.copy(plain.width(), 0, wide.width() - plain.width(), wide.height());
    int ink = 0;
    for (int y = 0; y < legend.height(); ++y)
        for (int x = 0; x < legend.width(); ++x)
            ink += legend.pixel(x, y) != legend.pixel(0, 0);
    QVERIFY2(ink > 1000, qPrintable(QString::number(ink)));
    QCOMPARE(legend.pixel(0, 0), plain.pixel(0, 0)); // the same paper
}

void CliPicturesTest::sheetsAreWrittenInEveryFormat() {
    const QByteArray gallery = "gallery systems.ifs --tile 60x60 -o ";
    for (const QByteArray name : {"sheet.jpg", "sheet.webp", "sheet.tiff", "sheet.pdf"}) {
        QCOMPARE(run(gallery + name).status, 0);
        const QByteArray bytes = read(name);
        QVERIFY(bytes.size() > 1000);
        QCOMPARE(run(gallery + name).status, 0);
        QCOMPARE(read(name), bytes);
    }
    QCOMPARE(run(gallery + "sheet.exr").status, 2);
    QCOMPARE(run(gallery + "sheet.png --page A4").status, 2);
}

// Row after row: all at once the sheet alone would take 770 MB.
void CliPicturesTest::largeTilesTakeLittleMemory() {
    const QByteArray entry = "a {\n .1 0 0 .1 0 0 .5\n .1 0 0 .1 1 1 .5\n}\n";
    write("four.ifs", entry + entry + entry);
    QProcess shell;
    shell.setWorkingDirectory(path({}));
    shell.start(QStringLiteral("sh"), {QStringLiteral("-c"),
                                       QStringLiteral("ulimit -v 600000; exec \"$0\" gallery four.ifs --tile "
                                                      "4000x4000 --columns 1 --quiet -o large.png"),
                                       support::buildPath(QStringLiteral("barycage-cli"))});
    QVERIFY(shell.waitForFinished(240'000));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
    const QByteArray header = read("large.png").mid(16, 8);
    QVERIFY(qFromBigEndian<quint32>(header.constData()) > 4000);
    QVERIFY(qFromBigEndian<quint32>(header.constData() + 4) > 3 * 4000);
}

void CliPicturesTest::pagesOfASheet() {
    write("forty.ifs", QByteArray("a {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n").repeated(40));
    const auto pages = [this](const QByteArray& options) {
        return run("gallery forty.ifs --tile 60x60 --columns 4 -o pages.pdf " + options).status == 0
                   ? read("pages.pdf").count("/Type /Page\n")
                   : -1;
    };
    QVERIFY(pages("--page A5") > 1);
    QCOMPARE(pages("--page 200x2000"), 1);
    for (const QByteArray page : {"A9", "10x10", "axb", "297", "100x6000"})
        QCOMPARE(pages("--page " + page), -1);
}

// In millimetres, whatever is drawn.
void CliPicturesTest::sizesOnPaperAreExact() {
    const auto draw = [&](const QByteArray& options) {
        return run("render systems.ifs --points 20000 " + options).status;
    };
    for (const auto& [size, width, height] :
         {std::tuple("58mmx40mm", "58mm", "40mm"), std::tuple("101.6MMx76.2mm", "101.6mm", "76.2mm")}) {
        QCOMPARE(run(QByteArray("render systems.ifs -o paper.svg --size ") + size).status, 0);
        QXmlStreamReader xml(read("paper.svg"));
        QVERIFY(xml.readNextStartElement());
        QCOMPARE(xml.attributes().value(QLatin1String("width")).toString(), QLatin1String(width));
        QCOMPARE(xml.attributes().value(QLatin1String("height")).toString(), QLatin1String(height));
    }
    QCOMPARE(run("render systems.ifs -o paper.pdf --size 58mmx40mm").status, 0);
    static const QRegularExpression box(QStringLiteral("/MediaBox ?\\[0 0 ([0-9.]+) ([0-9.]+)\\]"));
    const auto page = box.match(QString::fromLatin1(read("paper.pdf")));
    QVERIFY(page.hasMatch());
    QVERIFY(std::abs(page.captured(1).toDouble() - 58 / 25.4 * 72) < 0.01);
    QVERIFY(std::abs(page.captured(2).toDouble() - 40 / 25.4 * 72) < 0.01);
    QCOMPARE(draw("-o paper.png --size 58mmx40mm --dpi 254"), 0);
    QCOMPARE(QImage(path("paper.png")).size(), QSize(580, 400));
    QCOMPARE(QImage(path("paper.png")).dotsPerMeterX(), 10'000);
    QCOMPARE(draw("-o paper.png --size 25.4mmx12.7mm"), 0);
    QCOMPARE(QImage(path("paper.png")).size(), QSize(300, 150));
    QCOMPARE(QImage(path("paper.png")).dotsPerMeterX(), 11'811);
    QCOMPARE(draw("-o paper.png --size 25.4mmx"), 0);
    QCOMPARE(QImage(path("paper.png")).width(), 300);
    for (const QByteArray wrong :
         {"58mmx40", "58x40mm", "0mmx40mm", "mmxmm", "-1mmx2mm", "58mmx40mmx", "1e3mmx2mm"})
        QCOMPARE(draw("-o wrong.png --size " + wrong), 2);
    QVERIFY(!QFile::exists(path("wrong.png")));
}

BARYCAGE_TEST(CliPicturesTest, QGuiApplication);
#include "cli_pictures_test.moc"
