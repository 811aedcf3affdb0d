// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QImage>
#include <QTest>

#include <cmath>

// barycage-cli render for entries in space.
class CliSpaceTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void depthsAreThoseOfTheSystem();
    void drawsACloud();
    void sameBytesForAnyThreadsAndInstructions();
    void theCageMovesThePicture();
    void aCageOfMoreCornersBendsThePicture();
    void aFlatCageIsDrawn();
    void aSliceKeepsWhatIsBetweenItsPlanes();
    void solidsWithoutAnAttractorMayBeEmpty();
    void stereoShowsBothEyes();
    void aPictureShowsWhatItsEntrySays();
    void theFirstEntryMayLieInSpace();
    void aLargePictureHasNoHoles();
    void piecesThatAreMissingAreSaid();
    void aVeryWideAngleIsSaid();
    void overlaysAreDrawn();
    void shapeFilesContainThePicture();
    void optionsThatMakeNoSenseAreRefused_data();
    void optionsThatMakeNoSenseAreRefused();

private:
    struct Depths {
        QImage image;
        double near = NAN;
        double far = NAN;
        bool isEmpty(int x, int y) const { return value(x, y) == 65535; }
        double at(int x, int y) const { return near + (far - near) * value(x, y) / 65534; }
        int value(int x, int y) const { return reinterpret_cast<const quint16*>(image.constScanLine(y))[x]; }
    };
    Depths depths(const QByteArray& arguments);
};

// A solid cube, [0, 1]³, out of eight.
void CliSpaceTest::init() {
    QByteArray maps;
    for (int k = 0; k < 8; ++k) {
        maps += ".5 0 0 0 .5 0 0 0 .5";
        for (int axis = 0; axis < 3; ++axis)
            maps += (k >> axis & 1) != 0 ? " .5" : " 0";
        maps += " 1\n";
    }
    write("cube.ifs", "cube (3D) {\n" + maps + "}\n");
}

CliSpaceTest::Depths CliSpaceTest::depths(const QByteArray& arguments) {
    const Result result = run("render cube.ifs -o depth.png --look depth " + arguments);
    Depths found;
    if (result.status != 0) {
        qWarning("%s", result.err.constData());
        return found;
    }
    found.image = QImage(path("depth.png"));
    found.near = found.image.text(QStringLiteral("barycage:near")).toDouble();
    found.far = found.image.text(QStringLiteral("barycage:far")).toDouble();
    return found;
}

// Along the view from the plane of the target, away from the eye, in units of the system.
void CliSpaceTest::depthsAreThoseOfTheSystem() {
    const Depths front = depths("--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,2");
    QCOMPARE(front.image.format(), QImage::Format_Grayscale16);
    QCOMPARE(front.image.size(), QSize(80, 60));
    QVERIFY(front.isEmpty(20, 10));
    QVERIFY(!front.isEmpty(30, 20));
    const double pixel = 2.0 / 60;
    for (int y = 16; y < 44; ++y)
        for (int x = 26; x < 54; ++x)
            QVERIFY(std::abs(front.at(x, y) + 0.5) < pixel);
    // A target farther away is seen in front of its plane.
    QVERIFY(std::abs(depths("--size 80x60 --orbit 0,0 --view 0.5,0.5,-3,2").at(40, 30) + 4) < pixel);
    // From above the top is what is nearest.
    QVERIFY(std::abs(depths("--size 80x60 --orbit 0,90 --view 0.5,0.5,0.5,2").at(40, 30) + 0.5) < pixel);
    // The edge towards the eye: half a diagonal of the cube.
    const Depths edge = depths("--size 81x61 --orbit 45,0 --view 0.5,0.5,0.5,2");
    QVERIFY(std::abs(edge.at(40, 30) + std::sqrt(0.5)) < 2 * pixel);
    // In perspective the front is larger than the plane of the target shows it.
    const Depths wide = depths("--size 80x60 --orbit 0,0 --perspective 60 --view 0.5,0.5,0.5,2");
    QVERIFY(std::abs(wide.at(40, 30) + 0.5) < pixel);
    int across = 0;
    for (int x = 0; x < 80; ++x)
        across += wide.isEmpty(x, 30) ? 0 : 1;
    const double eye = 1 / std::tan(M_PI / 6);
    QVERIFY(std::abs(across - 30 * eye / (eye - 0.5)) < 2);
}

void CliSpaceTest::aVeryWideAngleIsSaid() {
    const Result wide = run("render cube.ifs -o wide.png --size 40x30 --perspective 179.9");
    QCOMPARE(wide.status, 0);
    QVERIFY2(wide.err.contains("179.9 degrees"), wide.err.constData());
    QVERIFY(!run("render cube.ifs -o wide.png --size 40x30 --perspective 120").err.contains("degrees"));
}

void CliSpaceTest::drawsACloud() {
    QCOMPARE(run("render cube.ifs -o cloud.png --look cloud --size 90x60 --points 200000 --background black")
                 .status,
             0);
    const QImage image(path("cloud.png"));
    QCOMPARE(image.size(), QSize(90, 60));
    QCOMPARE(image.pixelColor(1, 1), QColor(Qt::black));
    QVERIFY(image.pixelColor(45, 30).lightness() > 60);
    QCOMPARE(
        run("render cube.ifs -o deep.png --look cloud --size 90x60 --points 200000 --bits 16 --colour map")
            .status,
        0);
    QCOMPARE(QImage(path("deep.png")).depth(), 64);
}

void CliSpaceTest::sameBytesForAnyThreadsAndInstructions() {
    for (const QByteArray look :
         {"cloud", "depth", "x-ray --slice 1,2,3,2", "depth --slice 1,2,3,2,0.1",
          "stone --stereo side-by-side --colour address", "cloud --stereo anaglyph"}) {
        const QByteArray call = "render cube.ifs --size 120x90 --perspective 50 --look " + look + " -o ";
        QCOMPARE(run(call + "one.png --threads 1").status, 0);
        QCOMPARE(run(call + "three.png --threads 3").status, 0);
        QCOMPARE(run(call + "scalar.png --threads 2 --simd scalar").status, 0);
        QVERIFY(!read("one.png").isEmpty());
        QCOMPARE(read("three.png"), read("one.png"));
        QCOMPARE(read("scalar.png"), read("one.png"));
    }
}

void CliSpaceTest::theCageMovesThePicture() {
    const QByteArray view =
        "--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,2 --rest-cage \"0,0,0 1,0,0 0,1,0 0,0,1\"";
    const Depths moved = depths(view + " --cage \"0,0,0.25 1,0,0.25 0,1,0.25 0,0,1.25\"");
    QVERIFY(std::abs(moved.at(40, 30) + 0.75) < 2.0 / 60);
    const Depths box = depths("--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,2 --rest-cage box");
    QVERIFY(std::abs(box.at(40, 30) + 0.5) < 2.0 / 60);
    // Around the cube its corners are one and a half sides from the middle; here it moves back by a quarter.
    const Depths octahedron =
        depths("--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,2 --rest-cage octahedron --cage \"-1,0.5,0.25 "
               "2,0.5,0.25 0.5,-1,0.25 0.5,2,0.25 0.5,0.5,-1.25 0.5,0.5,1.75\"");
    QVERIFY(std::abs(octahedron.at(40, 30) + 0.25) < 2.0 / 60);
}

// A corner of the box is pulled towards the eye: its part comes nearer, the opposite one stays.
void CliSpaceTest::aCageOfMoreCornersBendsThePicture() {
    const QByteArray view = "--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,3 --rest-cage box ";
    const Depths rest = depths(view);
    const Depths bent = depths(view + "--cage \"0,0,0 1,0,0 0,1,0 1,1,0 0,0,1 1,0,1 0,1,1 1,1,2\"");
    QVERIFY(std::abs(rest.at(48, 22) + 0.5) < 2.0 / 20);
    QVERIFY(bent.at(48, 22) < rest.at(48, 22) - 0.3);           // near the corner (1, 1, 1)
    QVERIFY(std::abs(bent.at(32, 38) - rest.at(32, 38)) < 0.1); // near (0, 0, 1)
    const QByteArray hull = "--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,3 --rest-cage hull:12";
    QVERIFY(std::abs(depths(hull).at(40, 30) + 0.5) < 2.0 / 20);
}

// A tetrahedron pressed into a plane has a picture all the same, and its opposite has the first one's bytes.
void CliSpaceTest::aFlatCageIsDrawn() {
    const QByteArray call = "render cube.ifs --look depth --size 80x60 --view 0.5,0.5,0.5,2 "
                            "--rest-cage \"0,0,0 1,0,0 0,1,0 0,0,1\" ";
    const Result flat = run(call + "-o flat.png --cage \"0,0,0 1,0,0 0,1,0 1,1,0\"");
    QCOMPARE(flat.status, 0);
    QVERIFY(flat.err.contains("flat"));
    QVERIFY(!QImage(path("flat.png")).isNull());
    QCOMPARE(run(call + "-o open.png --cage \"0,0,0 1,0,0 0,1,0 0,0,1\"").status, 0);
    QCOMPARE(run(call + "-o rest.png").status, 0);
    QCOMPARE(read("open.png"), read("rest.png"));
}

void CliSpaceTest::aSliceKeepsWhatIsBetweenItsPlanes() {
    const QByteArray view = "--size 80x60 --orbit 0,0 --view 0.5,0.5,0.5,2 ";
    const double pixel = 2.0 / 60;
    QVERIFY(std::abs(depths(view + "--slice 0,0,2,0.5").at(40, 30) - 0.25) < 2 * pixel); // z ≤ 1/4
    QVERIFY(std::abs(depths(view + "--slice 0,0,1,0.7,0.05").at(40, 30) + 0.25) < 2 * pixel);
    const Depths upright = depths(view + "--slice 1,0,0,0.5,0");
    int across = 0;
    for (int x = 0; x < 80; ++x)
        across += upright.isEmpty(x, 30) ? 0 : 1;
    QVERIFY(across >= 1 && across <= 3); // an infinitely thin slice is a pixel wide
    QVERIFY(depths(view + "--slice 0,0,1,-1").isEmpty(40, 30));
    const auto warnings = [&](const QByteArray& slice) {
        return run("render cube.ifs -o sliced.png --size 8x6 --slice " + slice).err;
    };
    const QByteArray missed = "The slice misses the attractor";
    QVERIFY(!warnings("0,0,2,0.5").contains(missed));
    QVERIFY(warnings("0,0,2,-1").contains("empty: along its normal, the attractor extends from 0 to 2"));
    QVERIFY(warnings("0,0,1,1.5,0.25").contains(missed));
    // What counts is where the cage puts it.
    QVERIFY(!warnings("0,0,1,1.5,0.25 --rest-cage \"0,0,0 1,0,0 0,1,0 0,0,1\" "
                      "--cage \"0,0,1 1,0,1 0,1,1 0,0,2\"")
                 .contains(missed));
}

// Of the first, nothing is drawn, and of the second a line: what is said is true of both.
void CliSpaceTest::solidsWithoutAnAttractorMayBeEmpty() {
    write("none.ifs", "four (3D) {\n1.02 0 0 0 .5 0 0 0 .5 0 0 0 .25\n.5 0 0 0 .5 0 0 0 .5 .5 0 0 .25\n"
                      ".5 0 0 0 .5 0 0 0 .5 0 .5 0 .25\n.5 0 0 0 .5 0 0 0 .5 0 0 .5 .25\n}\n"
                      "two (3D) {\n1.02 0 0 0 .5 0 0 0 .5 0 0 0 .5\n.5 0 0 0 .5 0 0 0 .5 1 0 0 .5\n}\n");
    for (const QByteArray entry : {"four", "two"}) {
        const Result result = run("render none.ifs -o none.png --size 40x30 --entry " + entry);
        QCOMPARE(result.status, 0);
        QVERIFY2(result.err.contains("The picture may be incomplete or empty"), result.err);
        QVERIFY(!result.err.contains("The picture shows"));
    }
}

void CliSpaceTest::stereoShowsBothEyes() {
    const QByteArray call = "render cube.ifs --view 0.5,0.5,0.5,2 --orbit 0,0 --perspective 40 --bits 8 ";
    QCOMPARE(run(call + "-o sides.png --size 160x60 --stereo side-by-side").status, 0);
    const QImage sides(path("sides.png"));
    QCOMPARE(sides.size(), QSize(160, 60));
    const QImage left = sides.copy(0, 0, 80, 60), right = sides.copy(80, 0, 80, 60);
    QVERIFY(left != right);
    const auto firstLit = [](const QImage& image) {
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, 30).lightness() > 60) return x;
        return -1;
    };
    // The front is before the plane of the target: the left eye sees it farther to the right.
    QVERIFY(firstLit(left) >= firstLit(right));
    QVERIFY(firstLit(left) > 0);
    QCOMPARE(run(call + "-o glasses.png --size 80x60 --stereo anaglyph").status, 0);
    const QImage glasses(path("glasses.png"));
    QCOMPARE(glasses.size(), QSize(80, 60));
    for (int x = 0; x < 80; x += 7) {
        QCOMPARE(qGreen(glasses.pixel(x, 30)), qGreen(right.pixel(x, 30)));
        QCOMPARE(qBlue(glasses.pixel(x, 30)), qBlue(right.pixel(x, 30)));
        QVERIFY(std::abs(qRed(glasses.pixel(x, 30)) - qGray(left.pixel(x, 30))) < 24);
    }
}

// Look, slice, light, fog and colours are stored in the entry, and in the picture that it gives.
void CliSpaceTest::aPictureShowsWhatItsEntrySays() {
    QByteArray entry = read("cube.ifs");
    entry.insert(entry.indexOf('{') + 2, "; barycage: version 1\n; barycage: space-look ink\n"
                                         "; barycage: clip-normal 0 0 1\n; barycage: clip-range - 0.5\n"
                                         "; barycage: solid-colour depth\n; barycage: fog 0.5\n");
    write("looked.ifs", entry);
    const QByteArray view = " --size 80x60 --view 0.5,0.5,0.5,2 -o ";
    QCOMPARE(run("render looked.ifs" + view + "stored.png").status, 0);
    QCOMPARE(run("render cube.ifs --look ink --slice 0,0,1,0.5 --colour depth --fog 0.5" + view + "asked.png")
                 .status,
             0);
    QVERIFY(!read("stored.png").isEmpty());
    QCOMPARE(QImage(path("asked.png")), QImage(path("stored.png")));
    QCOMPARE(run("render asked.png" + view + "again.png").status, 0);
    QCOMPARE(QImage(path("again.png")), QImage(path("stored.png")));
    QCOMPARE(run("convert looked.ifs kept.ifs").status, 0);
    QVERIFY(read("kept.ifs").contains("barycage: clip-range - 0.5"));
}

void CliSpaceTest::theFirstEntryMayLieInSpace() {
    write("both.ifs", read("cube.ifs") + "line {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 1 0 1\n}\n");
    QCOMPARE(run("render both.ifs --size 30x20 --look depth -o first.png").status, 0);
    QCOMPARE(run("render both.ifs --size 30x20 --entry line -o line.png").status, 0);
}

// Leaves behind leaves take hundreds of words a pixel, in large pictures as in small ones.
void CliSpaceTest::aLargePictureHasNoHoles() {
    const QByteArray plants = support::sourcePath(QStringLiteral("ifs_library/space_plants.ifs")).toUtf8();
    const auto covered = [&](const QByteArray& size) {
        const Result result =
            run("render \"" + plants + "\" --entry thuja --background black -o leaf.png --size " + size);
        [&] { QCOMPARE(result.err, QByteArray()); }();
        const QImage picture(path("leaf.png"));
        double count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += qGray(picture.pixel(x, y)) > 60 ? 1 : 0;
        return count / (double(picture.width()) * picture.height());
    };
    const double small = covered("500x500"), large = covered("1500x1500");
    QVERIFY2(small > 0.05 && large > 0.9 * small && large < 1.1 * small,
             qPrintable(QStringLiteral("%1 %2").arg(small).arg(large)));
}

void CliSpaceTest::piecesThatAreMissingAreSaid() {
    const QByteArray polyhedra =
        support::sourcePath(QStringLiteral("ifs_library/space_polyhedra.ifs")).toUtf8();
    QCOMPARE(run("convert \"" + polyhedra + "\" ball.ifs --entry tetrahedron --symmetry icosahedral").status,
             0);
    const Result result = run("render ball.ifs -o ball.png --size 50x50");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("parts of the solid may be missing"), result.err.constData());
    QCOMPARE(run("render ball.ifs -o ball.png --size 50x50 --look cloud").err, QByteArray());
}

void CliSpaceTest::overlaysAreDrawn() {
    const auto picture = [&](const QByteArray& arguments) {
        const Result result =
            run("render cube.ifs -o over.png --size 240x180 --orbit 0,0 --background white " + arguments);
        if (result.status != 0) qWarning("%s", result.err.constData());
        return QImage(path("over.png"));
    };
    const QByteArray view = "--view 0.5,0.5,0.5,2 "; // 90 pixels a side: from 75 to 165 and from 45 to 135
    const QImage plain = picture(view);
    const auto changed = [&](const QImage& over) {
        QRect found;
        for (int y = 0; y < plain.height(); ++y)
            for (int x = 0; x < plain.width(); ++x)
                if (over.pixel(x, y) != plain.pixel(x, y)) found |= QRect(x, y, 1, 1);
        return found;
    };
    const auto isNear = [](const QRect& a, const QRect& b) {
        constexpr int disc = 7;
        return std::abs(a.left() - b.left()) <= disc && std::abs(a.top() - b.top()) <= disc &&
               std::abs(a.right() - b.right()) <= disc && std::abs(a.bottom() - b.bottom()) <= disc;
    };
    const QImage hull = picture(view + "--overlay hull");
    QVERIFY(isNear(changed(hull), QRect(75, 45, 90, 90)));
    QVERIFY(hull.pixelColor(120, 90) == plain.pixelColor(120, 90)); // no diagonal, which is no edge of a cube
    QVERIFY(hull.pixelColor(100, 45) != plain.pixelColor(100, 45));
    QVERIFY(isNear(changed(picture(view + "--overlay fixed-points")), QRect(75, 45, 90, 90)));
    const QImage cage =
        picture(view + "--rest-cage box --look cloud --points 100000 --overlay cage --bits 16");
    QVERIFY(
        isNear(changed(picture(view + "--rest-cage box --overlay cage")).intersected(QRect(75, 45, 90, 90)),
               QRect(75, 45, 90, 90)));
    QCOMPARE(cage.size(), plain.size());
    QVERIFY(!changed(picture(view + "--overlay maps")).isNull());
    QVERIFY(!changed(picture(view + "--overlay numbers")).isNull());
    // Without a view, there is room for the images of the tetrahedron, which reach far beyond the cube.
    const QImage maps = picture("--overlay maps");
    for (int x = 0; x < maps.width(); ++x)
        QVERIFY(maps.pixelColor(x, 0) == QColor(Qt::white) && maps.pixelColor(x, 179) == QColor(Qt::white));
    for (int y = 0; y < maps.height(); ++y)
        QVERIFY(maps.pixelColor(0, y) == QColor(Qt::white) && maps.pixelColor(239, y) == QColor(Qt::white));
    QVERIFY(maps != picture({}));
    // A cage that bends has a hull of its own.
    const Result bent =
        run("render cube.ifs -o bent.png --overlay hull --rest-cage box --cage \"-1,0,0 1,0,0 0,1,0 "
            "1,1,0 0,0,1 1,0,1 0,1,1 1,1,1\"");
    QCOMPARE(bent.status, 2);
    QVERIFY2(bent.err.contains("the cage bends the picture"), bent.err.constData());
}

void CliSpaceTest::shapeFilesContainThePicture() {
    const QByteArray options = "render cube.ifs --size 80x60 --supersample 1 --overlay cage -o cube.";
    for (const char* format : {"svg", "pdf"}) {
        const Result result = run(options + format);
        QCOMPARE(result.status, 0);
        QVERIFY2(result.err.contains("warning: A solid has no shapes"), result.err.constData());
    }
    QVERIFY(read("cube.pdf").startsWith("%PDF-"));
    const QByteArray svg = read("cube.svg");
    QVERIFY(svg.contains("<polygon")); // the cage
    // The same entry draws the same file again.
    QCOMPARE(run("render cube.svg --size 80x60 --supersample 1 --overlay cage -o again.svg").status, 0);
    QCOMPARE(read("again.svg"), svg);
    // Beside a page of shapes.
    write("both.ifs", "dust {\n .5 0 0 .5 0 0\n .4 0 0 .4 1 1\n}\n" + read("cube.ifs"));
    const Result pages = run("convert both.ifs pages.pdf");
    QCOMPARE(pages.status, 0);
    QVERIFY2(pages.err.contains("warning: Solids have no shapes"), pages.err.constData());
    QCOMPARE(read("pages.pdf").count("/Type/Page/"), 2);
    QCOMPARE(read("pages.pdf").count("/Subtype/Image"), 1);
}

void CliSpaceTest::optionsThatMakeNoSenseAreRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("message");
    QTest::newRow("look") << QByteArray("cube.ifs -o a.png --look marble") << QByteArray("depth or normals");
    QTest::newRow("slice") << QByteArray("cube.ifs -o a.png --slice 0,0,0,1") << QByteArray("--slice");
    QTest::newRow("thin slice") << QByteArray("cube.ifs -o a.png --slice 0,0,1,1,-1")
                                << QByteArray("--slice");
    QTest::newRow("stereo") << QByteArray("cube.ifs -o a.png --stereo both") << QByteArray("anaglyph");
    QTest::newRow("odd stereo") << QByteArray("cube.ifs -o a.png --size 81x60 --stereo side-by-side")
                                << QByteArray("even width");
    QTest::newRow("stereo depth") << QByteArray("cube.ifs -o a.png --look depth --stereo anaglyph")
                                  << QByteArray("in stereo");
    QTest::newRow("overlay on depths")
        << QByteArray("cube.ifs -o a.png --look depth --overlay cage") << QByteArray("show data");
    QTest::newRow("overlay in stereo")
        << QByteArray("cube.ifs -o a.png --stereo anaglyph --overlay cage") << QByteArray("stereo");
    QTest::newRow("x-ray colour") << QByteArray("cube.ifs -o a.png --look x-ray --colour map")
                                  << QByteArray("--colour");
    QTest::newRow("plane slice") << QByteArray("systems.ifs -o a.png --slice 0,0,1,1")
                                 << QByteArray("in space");
    QTest::newRow("orbit") << QByteArray("cube.ifs -o a.png --orbit 30") << QByteArray("azimuth");
    QTest::newRow("view") << QByteArray("cube.ifs -o a.png --view 0,0,1") << QByteArray("target");
    QTest::newRow("margin") << QByteArray("cube.ifs -o a.png --view 0,0,0,1 --margin 3")
                            << QByteArray("--margin");
    QTest::newRow("angle") << QByteArray("cube.ifs -o a.png --perspective 180") << QByteArray("below 180");
    QTest::newRow("y") << QByteArray("cube.ifs -o a.png --y-down") << QByteArray("plane");
    QTest::newRow("rotation") << QByteArray("cube.ifs -o a.png --view-rotation 9") << QByteArray("plane");
    QTest::newRow("algorithm") << QByteArray("cube.ifs -o a.png --algorithm chaos-game")
                               << QByteArray("plane");
    QTest::newRow("svg kind") << QByteArray("cube.ifs -o a.svg --svg points") << QByteArray("--svg");
    QTest::newRow("svg levels") << QByteArray("cube.ifs -o a.svg --depth 3") << QByteArray("--depth");
    QTest::newRow("svg bits") << QByteArray("cube.ifs -o a.svg --bits 16") << QByteArray("8 bits");
    QTest::newRow("svg of depths") << QByteArray("cube.ifs -o a.svg --look depth")
                                   << QByteArray("only as .png");
    QTest::newRow("plane svg") << QByteArray("systems.ifs -o a.svg --gamma 2") << QByteArray("shapes");
    QTest::newRow("points") << QByteArray("cube.ifs -o a.png --look depth --points 9")
                            << QByteArray("--points");
    QTest::newRow("bits") << QByteArray("cube.ifs -o a.png --look depth --bits 8") << QByteArray("16 bits");
    QTest::newRow("corners") << QByteArray("cube.ifs -o a.png --cage \"0,0 1,0 0,1 1,1\"")
                             << QByteArray("points in space");
    QTest::newRow("number") << QByteArray(
                                   "cube.ifs -o a.png --rest-cage box --cage \"0,0,0 1,0,0 0,1,0 0,0,1\"")
                            << QByteArray("same number");
    QTest::newRow("flat rest") << QByteArray("cube.ifs -o a.png --rest-cage \"0,0,0 1,0,0 0,1,0 1,1,0\"")
                               << QByteArray("one plane");
    QTest::newRow("dented rest")
        << QByteArray("cube.ifs -o a.png --rest-cage \"0,0,0 1,0,0 0,1,0 0,0,1 0.2,0.2,0.2\"")
        << QByteArray("convex polyhedron");
    QTest::newRow("hull") << QByteArray("cube.ifs -o a.png --rest-cage hull:7") << QByteArray("8 to 24");
    QTest::newRow("hull text") << QByteArray("cube.ifs -o a.png --rest-cage hull:many")
                               << QByteArray("8 to 24");
    QTest::newRow("large") << QByteArray("cube.ifs -o a.png --look cloud --size 100000x100000")
                           << QByteArray("4 GB");
    QTest::newRow("plane") << QByteArray("systems.ifs -o a.png --orbit 30,20") << QByteArray("in space");
    QTest::newRow("plane look") << QByteArray("systems.ifs -o a.png --look depth") << QByteArray("in space");
}

void CliSpaceTest::optionsThatMakeNoSenseAreRefused() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, message);
    const Result result = run("render " + arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(message), result.err.constData());
    QVERIFY(!QFile::exists(path("a.png")) && !QFile::exists(path("a.svg")));
}

BARYCAGE_TEST(CliSpaceTest, QGuiApplication);
#include "cli_space_test.moc"
