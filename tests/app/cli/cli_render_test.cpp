// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QFile>
#include <QImage>
#include <QTest>

#include <cmath>

// The pictures that barycage-cli render and gallery draw.
class CliRenderTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void opacityIsTheEndOfAColour();
    void writesToStandardOutput();
    void aPointIsInTheMiddle();
    void thousandsOfMapsFitIntoMemory();
    void sameBytesForAnyThreads();
    void pictureReopens_data();
    void pictureReopens();
    void viewShowsTheWholeAttractor();
    void cageMovesThePicture();
    void restCagesAroundTheAttractor_data();
    void restCagesAroundTheAttractor();
    void cageOfManyCornersBendsThePicture();
    void drawsShapes();
    void drawsAGallery();
    void aGalleryShowsSolids();
    void instructionSetsGiveTheSameBytes_data();
    void instructionSetsGiveTheSameBytes();
    void pictureOptionsCount();
    void theViewIsTurned();
};

// One map has one point: it is the middle of the picture, whatever rounding makes of its box.
void CliRenderTest::aPointIsInTheMiddle() {
    write("point.ifs", "point {\n .5 .1 -.1 .5 1 2 1\n}\n");
    const Result result =
        run("render point.ifs -o point.png --size 81x61 --points 1000 --background transparent");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.isEmpty(), result.err.constData());
    const QImage image(path("point.png"));
    int lit = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() > 0) {
                ++lit;
                QVERIFY(std::abs(x - 40) <= 1 && std::abs(y - 30) <= 1);
            }
    QVERIFY(lit > 0);
}

// Every word has 8,000 children that overlap; all words of one level at once would fill any memory.
void CliRenderTest::thousandsOfMapsFitIntoMemory() {
    QByteArray maps;
    for (int i = 0; i < 8'000; ++i)
        maps += " .9 0 0 .9 " + QByteArray::number(1 + 0.01 * (i % 100)) + " 1 1\n";
    write("many.ifs", "many {\n" + maps + "}\n");
    QCOMPARE(run("render many.ifs -o many.png --size 80x60 --points 20000 --view 15,10,0.05").status, 0);
}

void CliRenderTest::sameBytesForAnyThreads() {
    for (const char* algorithm : {"density", "chaos-game"}) {
        QByteArray first;
        for (const char* threads : {"1", "2", "3"}) {
            const Result result = run(
                QByteArray("render systems.ifs -o threads.png --size 160x120 --seed 7 --points 5000000 ") +
                "--threads " + threads + " --algorithm " + algorithm);
            QCOMPARE(result.status, 0);
            QVERIFY(result.err.isEmpty());
            const QByteArray bytes = read("threads.png");
            QVERIFY(!bytes.isEmpty());
            if (first.isEmpty()) first = bytes;
            QVERIFY(bytes == first);
        }
    }
}

void CliRenderTest::pictureReopens_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("png") << QByteArray("picture.png");
    QTest::newRow("svg") << QByteArray("picture.svg");
}

void CliRenderTest::pictureReopens() {
    QFETCH(QByteArray, file);
    QCOMPARE(run("render systems.ifs --entry fern --size 90x90 -o " + file).status, 0);
    const Result result = run("info --json " + file);
    QCOMPARE(result.status, 0);
    QCOMPARE(result.entry()[QLatin1String("name")].toString(), QStringLiteral("Fern"));
    compare(result.entry()[QLatin1String("mean")], 2659956.0 / 3338159, 20588360.0 / 3338159, 1e-11);
}

void CliRenderTest::viewShowsTheWholeAttractor() {
    QCOMPARE(
        run("render systems.ifs -o fit.png --size 200x200 --colour none --background transparent --dpi 254")
            .status,
        0);
    const QImage picture(path("fit.png"));
    QCOMPARE(picture.dotsPerMeterX(), 10000);
    QRect lit;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qAlpha(picture.pixel(x, y)) > 0) lit |= QRect(x, y, 1, 1);
    // The maple is taller than wide: 5 % above and below, centred.
    QVERIFY(std::abs(lit.top() - 10) <= 2);
    QVERIFY(std::abs(picture.height() - 1 - lit.bottom() - 10) <= 2);
    QVERIFY(std::abs(lit.left() + lit.right() - picture.width()) <= 4);
}

// The picture turned by a quarter, whose open side is found from what is seen.
void CliRenderTest::theViewIsTurned() {
    const QByteArray look = " --colour none --background transparent --margin 0 -o ";
    QCOMPARE(run("render systems.ifs --size 200x" + look + "upright.png").status, 0);
    QCOMPARE(run("render systems.ifs --size x200 --view-rotation 90" + look + "turned.png").status, 0);
    const QImage upright(path("upright.png")), turned(path("turned.png"));
    QCOMPARE(turned.size(), upright.size().transposed());
    int differing = 0;
    for (int y = 0; y < upright.height(); ++y)
        for (int x = 0; x < upright.width(); ++x)
            differing += (qAlpha(upright.pixel(x, y)) > 127) !=
                         (qAlpha(turned.pixel(y, turned.height() - 1 - x)) > 127);
    QVERIFY2(differing < 200, qPrintable(QString::number(differing)));
    QCOMPARE(run("render systems.ifs --view 0,0,1 --view-rotation -30 -o a.png --size 40x30").status, 0);
    QCOMPARE(run("render systems.ifs --view-rotation 15 -o a.svg --size 40x30").status, 0);
    for (const char* wrong : {"x", "361", "nan"})
        QCOMPARE(run(QByteArray("render systems.ifs -o a.png --view-rotation ") + wrong).status, 2);
}

void CliRenderTest::cageMovesThePicture() {
    const QByteArray common = "render systems.ifs --size 120x120 --colour none -o";
    // Mirroring the cage and looking at it mirrored gives the same silhouette upside down.
    QCOMPARE(run(common + " up.png --view 0,1,10").status, 0);
    QCOMPARE(
        run(common + " down.png --view 0,-1,10 --rest-cage \"0,0 1,0 0,1\" --cage \"0,0 1,0 0,-1\"").status,
        0);
    const QImage up = QImage(path("up.png")).mirrored();
    const QImage down(path("down.png"));
    int different = 0;
    for (int y = 0; y < up.height(); ++y)
        for (int x = 0; x < up.width(); ++x)
            different += std::abs(qGray(up.pixel(x, y)) - qGray(down.pixel(x, y))) > 60;
    QVERIFY2(different < 150, qPrintable(QString::number(different)));
    QVERIFY(QImage(path("up.png")) != down);
}

void CliRenderTest::restCagesAroundTheAttractor_data() {
    QTest::addColumn<QByteArray>("rest");
    for (const char* rest : {"canonical", "box", "rectangle", "hull", "hull:4"})
        QTest::newRow(rest) << QByteArray(rest);
}

// A cage at rest leaves the picture as it is, whatever holds it.
void CliRenderTest::restCagesAroundTheAttractor() {
    QFETCH(QByteArray, rest);
    const QByteArray common = "render systems.ifs --size 60x60 -o";
    QCOMPARE(run(common + " plain.png").status, 0);
    QCOMPARE(run(common + " held.png --rest-cage " + rest).status, 0);
    QCOMPARE(QImage(path("held.png")), QImage(path("plain.png")));
}

void CliRenderTest::cageOfManyCornersBendsThePicture() {
    const auto render = [this](const QByteArray& file, const QByteArray& rest, const QByteArray& cage) {
        return run("render systems.ifs --size 150x150 --colour none --view 0,1,14 -o " + file +
                   " --rest-cage \"" + rest + "\" --cage \"" + cage + "\"");
    };
    const QByteArray square = "-6,-6 6,-6 6,7 -6,7";
    const auto difference = [this](const char* a, const char* b) {
        const QImage first(path(a));
        const QImage second(path(b));
        int different = 0;
        for (int y = 0; y < first.height(); ++y)
            for (int x = 0; x < first.width(); ++x)
                different += std::abs(qGray(first.pixel(x, y)) - qGray(second.pixel(x, y))) > 60;
        return different;
    };
    QCOMPARE(render("t.png", "0,0 1,0 0,1", "1,0 2,0.5 1,1").status, 0);
    // The same shear by (1, 0) + (x, y + x/2) of four corners, then one of them pulled away.
    QCOMPARE(render("q.png", square, "-5,-9 7,-3 7,10 -5,4").status, 0);
    QCOMPARE(render("b.png", square, "-5,-9 7,-3 4,5 -5,4").status, 0);
    QVERIFY(difference("t.png", "q.png") < 200);
    QVERIFY(difference("b.png", "q.png") > 800);
    QCOMPARE(render("x.png", "0,0 1,1 1,0 0,1", square).status, 2);
    const auto svg = run("render systems.ifs --rest-cage box --cage \"-3,-3 3,-3 5,5 -3,5\" -o b.svg");
    QCOMPARE(svg.status, 0);
    QVERIFY2(svg.err.contains("affine fit"), svg.err.constData());
}

void CliRenderTest::drawsShapes() {
    const QByteArray render = "render systems.ifs -o";
    QCOMPARE(run(render + " outline.svg --svg outline").status, 0);
    QCOMPARE(read("outline.svg").count("<path"), 1);
    QCOMPARE(run(render + " points.svg --svg points --points 700").status, 0);
    QCOMPARE(read("points.svg").count("h0"), 700);
    QCOMPARE(run(render + " maple.pdf --depth 3").status, 0);
    QVERIFY(read("maple.pdf").startsWith("%PDF-1."));
    // A format may be named where the name of the file does not tell it.
    QCOMPARE(run(render + " thumbnail --to png --size 64x64").status, 0);
    QCOMPARE(QImage(path("thumbnail"), "PNG").size(), QSize(64, 64));
    QCOMPARE(run(render + " a.svg --points 9").status, 2);
    QCOMPARE(run("convert systems.ifs all.pdf").status, 0);
    QVERIFY(read("all.pdf").contains("/Count 2/")); // the third has no attractor
}

// As they are drawn one by one.
void CliRenderTest::aGalleryShowsSolids() {
    QByteArray maps;
    for (int k = 0; k < 4; ++k)
        maps += " .5 0 0 0 .5 0 0 0 .5 " + QByteArray(k == 1 ? "1" : "0") + (k == 2 ? " 1" : " 0") +
                (k == 3 ? " 1" : " 0") + " .25\n";
    write("solid.ifs",
          "stone (3D) {\n" + maps + "}\ncloud (3D) {\n; barycage: space-look cloud\n" + maps + "}\n");
    const Result result = run("gallery solid.ifs -o solid.png --tile 100x80 --columns 2");
    QCOMPARE(result.status, 0);
    QCOMPARE(result.err, QByteArray());
    const QImage sheet = QImage(path("solid.png")).convertToFormat(QImage::Format_RGB32);
    QCOMPARE(run("render solid.ifs -o alone.png --size 100x80 --margin 6").status, 0);
    const QImage alone = QImage(path("alone.png")).convertToFormat(QImage::Format_RGB32);
    constexpr int edge = 12; // around the sheet
    int shown = 0, others = 0;
    for (int y = 10; y < 70; ++y)
        for (int x = 10; x < 90; ++x) {
            const int there = qGray(sheet.pixel(edge + x, edge + y));
            shown += there > 60;
            others += std::abs(there - qGray(alone.pixel(x, y))) > 8;
        }
    QVERIFY2(shown > 500, qPrintable(QString::number(shown)));
    QVERIFY2(others < 48, qPrintable(QString::number(others))); // a hundredth
    int ofCloud = 0;
    for (int y = 10; y < 70; ++y)
        for (int x = 10; x < 90; ++x)
            ofCloud += qGray(sheet.pixel(edge + 100 + 6 + x, edge + y)) > 60;
    QVERIFY2(ofCloud > 100 && ofCloud != shown, qPrintable(QString::number(ofCloud)));
}

void CliRenderTest::drawsAGallery() {
    const QByteArray gallery = "gallery systems.ifs -o sheet.png --tile 100x80 --columns";
    const Result first = run(gallery + " 3");
    QCOMPARE(first.status, 0);
    QVERIFY2(first.err.isEmpty(), first.err.constData());
    const QImage wide(path("sheet.png"));
    QCOMPARE(run(gallery + " 1 --paper light --title Leaves").status, 0);
    const QImage tall(path("sheet.png"));
    QVERIFY(wide.width() > 300 && wide.height() > 80 && wide.height() < 160);
    QVERIFY(tall.width() > 100 && tall.width() < 160 && tall.height() > 300);
    QVERIFY(qGray(wide.pixel(1, 1)) < 30 && qGray(tall.pixel(1, 1)) > 230);
    // The maple is drawn in the first place, and its name under it.
    const auto inkIn = [&tall](const QRect& part) {
        int pixels = 0;
        for (int y = part.top(); y <= part.bottom(); ++y)
            for (int x = part.left(); x <= part.right(); ++x)
                pixels += qGray(tall.pixel(x, y)) < 225;
        return pixels;
    };
    const int ink = inkIn(tall.rect());
    QVERIFY2(ink > 1000 && ink < 3 * 4000, qPrintable(QString::number(ink))); // light tiles
    QCOMPARE(run("gallery systems.ifs -o sheet.svg").status, 2);
    QCOMPARE(run("gallery absent.ifs -o none.png").status, 3);
    QVERIFY(!QFile::exists(path("none.png")));
}

void CliRenderTest::instructionSetsGiveTheSameBytes_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::newRow("usual") << QByteArray();
    QTest::newRow("tones") << QByteArray(" --contrast 3 --vibrancy 0.3");
    QTest::newRow("tones of addresses") << QByteArray(" --colour address --contrast 0.5 --vibrancy 0");
}

void CliRenderTest::instructionSetsGiveTheSameBytes() {
    QFETCH(QByteArray, options);
    const auto drawn = [&](const char* set) {
        const Result result = run("render systems.ifs -o set.png --size 100x80" + options + " --simd " + set);
        if (result.status == 0) return read("set.png");
        if (result.status != 2 || !result.err.contains("scalar")) return QByteArray("wrong message");
        return QByteArray();
    };
    const QByteArray scalar = drawn("scalar");
    QVERIFY(scalar.size() > 100);
    int possible = 0;
    for (const char* set : {"sse4", "avx2", "avx3", "avx512", "neon"}) {
        const QByteArray bytes = drawn(set);
        if (bytes.isEmpty()) continue; // not here, said with the list of what is
        QVERIFY2(bytes == scalar, set);
        ++possible;
    }
    QVERIFY(possible >= 1 && possible <= 4); // avx512 by two names; no machine has both families
}

void CliRenderTest::pictureOptionsCount() {
    write("p.gpl", "GIMP Palette\n0 0 60\n255 0 0\n");
    write("bad.map", "0 60 0\nnonsense\n0 255 0\n");
    QList<QImage> pictures;
    const auto draw = [&](const QByteArray& options) {
        const Result result =
            run(QByteArray("render systems.ifs -o o.png --size 90x80 --background black ") + options);
        pictures << QImage(path("o.png"));
        return result;
    };
    QCOMPARE(run("render systems.ifs -o paper.png --size 90x80 --colour none --background white").status, 0);
    const QImage paper(path("paper.png"));
    int dark = 0;
    for (int y = 0; y < paper.height(); ++y)
        for (int x = 0; x < paper.width(); ++x)
            dark += qGray(paper.pixel(x, y)) < 100;
    QVERIFY(dark > 100);
    for (const char* colour : {"density", "map", "address", "blend", "none"})
        QCOMPARE(draw(QByteArray("--colour ") + colour).status, 0);
    QCOMPARE(draw("--supersample 3").status, 0);
    QCOMPARE(draw("--contrast 3").status, 0);
    QCOMPARE(draw("--vibrancy 0.2").status, 0);
    QCOMPARE(draw("--shadow 0.5").status, 0);
    QCOMPARE(draw("--shadow 0.5 --shadow-lean -1 --shadow-length -0.5").status, 0);
    QCOMPARE(draw("--colour map --contrast 0.5 --vibrancy 0").status, 0);
    QCOMPARE(draw("--palette ink").status, 0);
    QCOMPARE(draw("--palette p.gpl").status, 0);
    const QImage red = pictures.back();
    const Result remarked = draw("--palette bad.map");
    QCOMPARE(remarked.status, 0);
    QVERIFY(remarked.err.contains("bad.map:2:1: warning: "));
    for (qsizetype i = 0; i < pictures.size(); ++i)
        for (qsizetype k = 0; k < i; ++k)
            QVERIFY(pictures[i] != pictures[k]);
    for (int y = 0; y < red.height(); ++y)
        for (int x = 0; x < red.width(); ++x)
            QCOMPARE(qGreen(red.pixel(x, y)), 0);
    QCOMPARE(draw("--bits 16 --dpi 254").status, 0);
    QCOMPARE(pictures.back().depth(), 64);
    QCOMPARE(pictures.back().dotsPerMeterX(), 10000);
}

// #rrggbbaa, the order of our files.
void CliRenderTest::opacityIsTheEndOfAColour() {
    for (const auto& [text, colour] :
         {std::pair("#ff000080", qRgba(255, 0, 0, 128)), std::pair("#00ff00", qRgba(0, 255, 0, 255)),
          std::pair("#00ffff40", qRgba(0, 255, 255, 0x40)), std::pair("transparent", qRgba(0, 0, 0, 0))}) {
        QCOMPARE(
            run(QByteArray("render systems.ifs -o back.png --size 40x30 --view 100,100,1 --background ") +
                text)
                .status,
            0);
        const QRgb found = QImage(path("back.png")).pixel(0, 0);
        QVERIFY2(found == colour, qPrintable(QString::number(found, 16)));
    }
}

void CliRenderTest::writesToStandardOutput() {
    for (const QByteArray format : {"png", "svg", "pdf"}) {
        QCOMPARE(run("render systems.ifs --size 30x20 -o printed." + format).status, 0);
        const Result printed = run("render systems.ifs --size 30x20 -o - --to " + format);
        QCOMPARE(printed.status, 0);
        QCOMPARE(printed.out, read("printed." + format));
        QVERIFY(printed.err.isEmpty());
    }
    QCOMPARE(run("render systems.ifs -o -").status, 2);
    const Result sheet = run("gallery systems.ifs --tile 40x40 -o -");
    QCOMPARE(sheet.status, 0);
    QVERIFY(sheet.out.startsWith("\x89PNG"));
    QVERIFY(!QFile::exists(path("-")));
}

// The first entry in the plane, that is: another draws nothing.
BARYCAGE_TEST(CliRenderTest, QGuiApplication);
#include "cli_render_test.moc"
