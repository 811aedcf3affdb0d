// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QColor>
#include <QFile>
#include <QImage>
#include <QRgba64>
#include <QSet>
#include <QTest>

#include <cmath>

// barycage-cli render with the looks of a solid.
class CliSolidTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void stoneIsTheUsualLook();
    void theKeyLightStandsWhereItIsPut();
    void fogHidesWhatIsFar();
    void inkIsOnPaper();
    void normalsAreNumbers();
    void coloursComeFromMapHeightAndDepth();
    void movedBranchesAreInView();
    void sameBytesForAnyThreadsAndInstructions();
    void optionsThatMakeNoSenseAreRefused_data();
    void optionsThatMakeNoSenseAreRefused();

private:
    QImage drawn(const QByteArray& arguments);
};

// A solid cube, [0, 1]³, out of eight.
void CliSolidTest::init() {
    QByteArray maps;
    for (int k = 0; k < 8; ++k) {
        maps += ".5 0 0 0 .5 0 0 0 .5";
        for (int axis = 0; axis < 3; ++axis)
            maps += (k >> axis & 1) != 0 ? " .5" : " 0";
        maps += " 1\n";
    }
    write("cube.ifs", "cube (3D) {\n" + maps + "}\n");
}

QImage CliSolidTest::drawn(const QByteArray& arguments) {
    const Result result = run("render cube.ifs -o solid.png --size 80x60 --view 0.5,0.5,0.5,2 " + arguments);
    if (result.status != 0) qWarning("%s", result.err.constData());
    return result.status == 0 ? QImage(path("solid.png")) : QImage();
}

// Three faces: the top and the front are in the light, the right one is in the shade.
void CliSolidTest::stoneIsTheUsualLook() {
    const QImage image = drawn("");
    QCOMPARE(image.size(), QSize(80, 60));
    QCOMPARE(image.pixelColor(2, 2), QColor(13, 16, 23));
    const int top = image.pixelColor(40, 18).lightness(), front = image.pixelColor(34, 36).lightness();
    const int right = image.pixelColor(52, 34).lightness();
    QVERIFY2(top > right + 30 && front > right + 30 && right > 40,
             qPrintable(QStringLiteral("%1, %2, %3").arg(top).arg(front).arg(right)));
    const QByteArray bytes = read("solid.png");
    QCOMPARE(drawn("--look stone --orbit 30,20 --light -40,40 --fog 0 --supersample 2").isNull(), false);
    QCOMPARE(read("solid.png"), bytes);
}

void CliSolidTest::theKeyLightStandsWhereItIsPut() {
    const QImage left = drawn("--light -60,0"), right = drawn("--light 60,0");
    QVERIFY(left.pixelColor(34, 36).lightness() > right.pixelColor(34, 36).lightness() + 20);
    QVERIFY(left.pixelColor(52, 34).lightness() < right.pixelColor(52, 34).lightness() - 20);
}

void CliSolidTest::fogHidesWhatIsFar() {
    const QImage clear = drawn("--background white"), misty = drawn("--background white --fog 3");
    QCOMPARE(misty.pixelColor(2, 2), QColor(Qt::white));
    const auto fading = [&](int x, int y) {
        return misty.pixelColor(x, y).lightness() - clear.pixelColor(x, y).lightness();
    };
    QVERIFY(fading(40, 12) > fading(40, 20) + 5); // the far corner of the top, and its middle
    QVERIFY(fading(40, 20) > 0);
}

void CliSolidTest::inkIsOnPaper() {
    const QImage image = drawn("--look ink");
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    QVERIFY(image.pixelColor(34, 36).lightness() > image.pixelColor(52, 34).lightness());
    QCOMPARE(drawn("--look ink --background transparent").pixelColor(2, 2).alpha(), 0);
}

// (n + 1)/2 of the full scale: to the right, up, towards the eye.
void CliSolidTest::normalsAreNumbers() {
    const QImage image = drawn("--look normals --orbit 0,0");
    QCOMPARE(image.format(), QImage::Format_RGBA64);
    QCOMPARE(drawn("--look normals --bits 8").format(), QImage::Format_ARGB32);
    QCOMPARE(image.pixelColor(2, 2).alpha(), 0);
    const QRgba64 front = image.pixelColor(40, 30).rgba64();
    QVERIFY(std::abs(front.red() - 32768) < 400);
    QVERIFY(std::abs(front.green() - 32768) < 400);
    QVERIFY(front.blue() > 65000);
    const QRgba64 left = drawn("--look normals --bits 16 --orbit 45,0").pixelColor(30, 30).rgba64();
    QVERIFY2(std::abs(left.red() - 65535 * (1 - std::sqrt(0.5)) / 2) < 2500,
             qPrintable(QString::number(left.red())));
}

void CliSolidTest::coloursComeFromMapHeightAndDepth() {
    QSet<QRgb> seen;
    const QList<QByteArray> choices = {"none", "map", "address", "height", "depth"};
    for (const QByteArray& colour : choices)
        seen << drawn("--colour " + colour).pixel(34, 36);
    QCOMPARE(seen.size(), choices.size());
    const QImage palette = drawn("--palette fern");
    QVERIFY(!palette.isNull());
    QCOMPARE(palette, drawn("--palette fern --colour height"));
    QCOMPARE(drawn("--bits 16").depth(), 64);
}

// The eighth at (1, 1, 1) is shown two units farther to the right, also where a cage holds the cube.
void CliSolidTest::movedBranchesAreInView() {
    const QByteArray text = read("cube.ifs");
    QByteArray moved = "  ; barycage: version 1\n  ; barycage: branch 8\n";
    for (const QByteArray row : {"1 0 0", "0 1 0", "0 0 1", "2 0 0"})
        moved += "  ; barycage: by " + row + '\n';
    moved += "}\n";
    QByteArray held = moved;
    for (const QByteArray place : {"rest", "current"})
        for (const QByteArray vertex : {"0 0 0", "3 0 0", "0 3 0", "0 0 3"})
            held.insert(held.size() - 2, "  ; barycage: " + place + ' ' + vertex + '\n');
    for (const QByteArray& comments : {moved, held})
        for (const QByteArray look : {"stone", "cloud"}) {
            write("moved.ifs", QByteArray(text).replace("}\n", comments));
            const Result result =
                run("render moved.ifs -o moved.png --size 120x60 --orbit 0,0 --look " + look);
            QVERIFY2(result.status == 0 && !result.err.contains("branch"), result.err.constData());
            const QImage image(path("moved.png"));
            const QColor ground = image.pixelColor(0, 0);
            const auto rowsOf = [&](int column) {
                int rows = 0;
                for (int y = 0; y < image.height(); ++y)
                    rows += image.pixelColor(column, y) != ground;
                return rows;
            };
            int first = 0, last = image.width() - 1;
            while (first < last && rowsOf(first) == 0)
                ++first;
            while (first < last && rowsOf(last) == 0)
                --last;
            // From 0 to 3: the cube without its corner, nothing, the corner.
            const auto columnAt = [&](double x) { return first + int(x / 3 * (last - first)); };
            QVERIFY2(last - first > 95, qPrintable(QStringLiteral("%1 to %2").arg(first).arg(last)));
            QVERIFY(rowsOf(columnAt(0.25)) > 30);
            QCOMPARE(rowsOf(columnAt(1.7)), 0);
            const int corner = rowsOf(columnAt(2.75));
            QVERIFY(corner > 14 && corner < 24);
        }
}

void CliSolidTest::sameBytesForAnyThreadsAndInstructions() {
    for (const QByteArray look : {"stone --fog 1 --colour map", "ink", "normals --bits 16"}) {
        const QByteArray call = "render cube.ifs --size 120x90 --perspective 50 --look " + look + " -o ";
        QCOMPARE(run(call + "one.png --threads 1").status, 0);
        QCOMPARE(run(call + "three.png --threads 3").status, 0);
        QCOMPARE(run(call + "scalar.png --threads 2 --simd scalar").status, 0);
        QVERIFY(!read("one.png").isEmpty());
        QCOMPARE(read("three.png"), read("one.png"));
        QCOMPARE(read("scalar.png"), read("one.png"));
    }
}

void CliSolidTest::optionsThatMakeNoSenseAreRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("message");
    QTest::newRow("light") << QByteArray("--light 40") << QByteArray("azimuth and elevation");
    QTest::newRow("fog") << QByteArray("--fog -1") << QByteArray("from 0 to 100");
    QTest::newRow("colour") << QByteArray("--colour density")
                            << QByteArray("map, address, height, depth or none");
    QTest::newRow("palette") << QByteArray("--colour map --palette fern") << QByteArray("--palette");
    QTest::newRow("points") << QByteArray("--points 9") << QByteArray("--points");
    QTest::newRow("gamma") << QByteArray("--look ink --gamma 2") << QByteArray("--gamma");
    QTest::newRow("contrast") << QByteArray("--contrast 2") << QByteArray("--contrast");
    QTest::newRow("vibrancy") << QByteArray("--look normals --vibrancy 0") << QByteArray("--vibrancy");
    QTest::newRow("shadow") << QByteArray("--shadow 0.5") << QByteArray("--shadow");
    QTest::newRow("ink") << QByteArray("--look ink --light 0,0") << QByteArray("--light");
    QTest::newRow("normals") << QByteArray("--look normals --fog 1") << QByteArray("--fog");
    QTest::newRow("cloud") << QByteArray("--look cloud --light 0,0") << QByteArray("only to solids");
    QTest::newRow("large") << QByteArray("--look cloud --size 60000x60000") << QByteArray("4 GB");
}

void CliSolidTest::optionsThatMakeNoSenseAreRefused() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, message);
    const Result result = run("render cube.ifs -o a.png " + arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(message), result.err.constData());
    QVERIFY(!QFile::exists(path("a.png")));
}

BARYCAGE_TEST(CliSolidTest, QGuiApplication);
#include "cli_solid_test.moc"
