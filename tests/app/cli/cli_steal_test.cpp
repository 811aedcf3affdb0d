// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <sys/stat.h>

// barycage-cli steal: pictures, points and tears.
class CliStealTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void printsPoints();
    void printsPointsAsText();
    void orderOfTheMaps();
    void pointsOffTheAttractor();
    void manyMapsHaveNumbersInTheirAddresses();
    void mapsThatAreOffDoNotCount();
    void printsTears();
    void identityReturnsThePicture_data();
    void identityReturnsThePicture();
    void pictureLiesWhereRenderDrawsG();
    void viewsShowAPart();
    void cagesAreApplied();
    void sameBytes();
    void drawsWhatTheEntryKeeps();
    void embeddedPicturesAreDrawn();
    void thePictureIsNotWrittenOver();
    void foreignPicturesAreRefused_data();
    void foreignPicturesAreRefused();
    void keptTransformationsAreChecked();
    void readsAnyPicture_data();
    void readsAnyPicture();
    void badPicturesAreErrors_data();
    void badPicturesAreErrors();
    void refuses_data();
    void refuses();
    void warningsAreSaidOnce();
};

namespace {

QImage board(int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.setPixel(x, y, qRgb(255 * x / width, 255 * y / height, (x / 16 + y / 16) % 2 * 200));
    return image;
}

QByteArray encodedAs(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return bytes;
}

QJsonObject line(const QByteArray& out, int index = 0) {
    return QJsonDocument::fromJson(out.split('\n').value(index)).object();
}

} // namespace

void CliStealTest::init() {
    write("tops.ifs", "halves {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n"
                      "thirds {\n .3333333333333333 0 0 .3333333333333333 0 0 .5\n"
                      " .6666666666666667 0 0 .6666666666666667 .3333333333333333 0 .5\n}\n"
                      "cantor {\n .3333333333333333 0 0 .3333333333333333 0 0 .5\n"
                      " .3333333333333333 0 0 .3333333333333333 .6666666666666667 0 .5\n}\n"
                      "square {\n .5 0 0 .5 0 0 .25\n .5 0 0 .5 0 .5 .25\n .5 0 0 .5 .5 0 .25\n"
                      " .5 0 0 .5 .5 .5 .25\n}\n"
                      "uneven {\n .3 0 0 .4 0 0 .25\n .3 0 0 .6 0 .4 .25\n .7 0 0 .4 .3 0 .25\n"
                      " .7 0 0 .6 .3 .4 .25\n}\n"
                      "partly {\n .5 0 0 .5 0 0 .5\n .1 0 0 .1 7 7 0\n .5 0 0 .5 .5 0 .5\n}\n"
                      "space (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n .5 0 0 0 .5 0 0 0 .5 1 1 1 1\n}\n"
                      "escapes {\n 2 0 0 2 0 0 1\n .5 0 0 .5 1 0 1\n}\n");
    write("board.png", encodedAs(board(160, 120), "PNG"));
}

void CliStealTest::printsPoints() {
    const Result result = run("steal tops.ifs --entry halves --from thirds --map \"0.5,0 0.25,0 .75,0 "
                              "0.3333333333333333,0\" --json");
    QCOMPARE(result.status, 0);
    QCOMPARE(result.err, QByteArray());
    QCOMPARE(result.out.count('\n'), 4);
    compare(line(result.out, 0)[QLatin1String("point")], .5, 0, 0);
    compare(line(result.out, 0)[QLatin1String("image")], 1.0 / 3, 0, 1e-12);
    compare(line(result.out, 1)[QLatin1String("image")], 1.0 / 9, 0, 1e-12);
    compare(line(result.out, 2)[QLatin1String("image")], 5.0 / 9, 0, 1e-12);
    compare(line(result.out, 3)[QLatin1String("image")], 1.0 / 7, 0, 1e-12);
    QVERIFY(
        line(result.out, 0)[QLatin1String("address")].toString().startsWith(QStringLiteral("1222222222")));
    QVERIFY(line(result.out, 3)[QLatin1String("address")].toString().startsWith(
        QStringLiteral("12121212121212121212")));
    for (int k = 0; k < 4; ++k)
        QVERIFY(line(result.out, k)[QLatin1String("address")].toString().size() >= 40);
}

void CliStealTest::printsPointsAsText() {
    const Result result = run("steal tops.ifs --entry halves --from cantor --map 0.5,0");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.out.startsWith("(0.5, 0) -> (0.333"), result.out.constData());
    QVERIFY(result.out.contains("address 12222"));
}

void CliStealTest::orderOfTheMaps() {
    const Result usual = run("steal tops.ifs --entry halves --from cantor --map .5,0 --json --order 1,2");
    compare(line(usual.out)[QLatin1String("image")], 1.0 / 3, 0, 1e-12);
    const Result other = run("steal tops.ifs --entry halves --from cantor --map .5,0 --json --order 2,1");
    compare(line(other.out)[QLatin1String("image")], 2.0 / 3, 0, 1e-12);
    QVERIFY(line(other.out)[QLatin1String("address")].toString().startsWith(QStringLiteral("21111")));
}

void CliStealTest::pointsOffTheAttractor() {
    const Result result =
        run("steal tops.ifs --entry halves --from cantor --map \"0.5,1e-8 0.25,1e-10 9,9\" --json");
    QCOMPARE(result.status, 1);
    QCOMPARE(result.err.count('\n'), 2);
    QVERIFY2(result.err.contains("tops.ifs: error: The point (0.5, 1e-08) is not on the attractor."),
             result.err.constData());
    QVERIFY(line(result.out, 0)[QLatin1String("image")].isNull() &&
            line(result.out, 0)[QLatin1String("address")].isNull());
    compare(line(result.out, 1)[QLatin1String("image")], 1.0 / 9, 0, 1e-6);
    QVERIFY(line(result.out, 2)[QLatin1String("image")].isNull());
}

void CliStealTest::manyMapsHaveNumbersInTheirAddresses() {
    QByteArray text = "many {\n";
    for (int k = 0; k < 12; ++k)
        text += " .05 0 0 .05 " + QByteArray::number(k * .08) + " 0 1\n";
    write("many.ifs", text + "}\n");
    const Result result = run("steal many.ifs --from many --json --map \"0,0 0.9263157894736842,0\"");
    QCOMPARE(result.status, 0);
    QVERIFY(line(result.out, 0)[QLatin1String("address")].toString().startsWith(QStringLiteral("1 1 1 1")));
    QVERIFY(line(result.out, 1)[QLatin1String("address")].toString().startsWith(QStringLiteral("12 12 12")));
}

void CliStealTest::mapsThatAreOffDoNotCount() {
    const Result result = run("steal tops.ifs --entry partly --from cantor --map 0.75,0 --json --order 3,1");
    QCOMPARE(result.status, 0);
    compare(line(result.out)[QLatin1String("image")], 8.0 / 9, 0, 1e-12); // 3311…: on top the third map
    QVERIFY(line(result.out)[QLatin1String("address")].toString().startsWith(QStringLiteral("33111")));
    QCOMPARE(run("steal tops.ifs --entry partly --from cantor --map 0,0 --order 1,2,3").status, 2);
}

void CliStealTest::printsTears() {
    const Result torn = run("steal tops.ifs --entry halves --from cantor --tear 0.001 --json");
    QCOMPARE(torn.status, 0);
    const double size = line(torn.out)[QLatin1String("tear")].toDouble();
    QVERIFY(size >= 1.0 / 3 - 0.001 && size < 0.36);
    compare(line(torn.out)[QLatin1String("at")][0], .5, 0, .002);
    QCOMPARE(line(torn.out)[QLatin1String("homeomorphism")], QJsonValue(false));
    const Result mended = run("steal tops.ifs --entry halves --from thirds --tear 0.001 --json");
    QVERIFY(line(mended.out)[QLatin1String("tear")].toDouble() < .03);
    QVERIFY(line(mended.out)[QLatin1String("homeomorphism")].isNull()); // not proved, and not refuted
    const Result none = run("steal tops.ifs --entry cantor --from cantor --tear 0.001 --json");
    QCOMPARE(line(none.out)[QLatin1String("tear")].toDouble(-1), 0.0);
    QVERIFY(line(none.out)[QLatin1String("at")].isNull());
    QCOMPARE(line(none.out)[QLatin1String("homeomorphism")], QJsonValue(true));
    const Result text = run("steal tops.ifs --entry halves --from cantor --tear 0.1");
    QVERIFY2(text.out.startsWith("Tear: 0.") && text.out.endsWith("Homeomorphism: no\n"),
             text.out.constData());
}

void CliStealTest::identityReturnsThePicture_data() {
    QTest::addColumn<QByteArray>("how");
    QTest::newRow("samples") << QByteArray("--points 3M");
    QTest::newRow("exact") << QByteArray("--exact");
}

void CliStealTest::identityReturnsThePicture() {
    QFETCH(QByteArray, how);
    const QImage picture = board(160, 120);
    QCOMPARE(run("steal tops.ifs --entry square --from square --picture board.png -o same.png --size 160x120 "
                 "--background transparent " +
                 how)
                 .status,
             0);
    const QImage same = QImage::fromData(read("same.png"));
    QCOMPARE(same.size(), picture.size());
    int compared = 0;
    for (int y = 2; y < 118; ++y)
        for (int x = 2; x < 158; ++x) {
            if (qAlpha(same.pixel(x, y)) == 0) continue;
            ++compared;
            QVERIFY(std::abs(qRed(same.pixel(x, y)) - qRed(picture.pixel(x, y))) <= 3); // to 1 px
            QVERIFY(std::abs(qGreen(same.pixel(x, y)) - qGreen(picture.pixel(x, y))) <= 4);
        }
    QVERIFY(compared >= 107 * 107); // 90 % of the height
}

void CliStealTest::pictureLiesWhereRenderDrawsG() {
    QCOMPARE(
        run("render tops.ifs --entry uneven -o g.png --size 300x200 --colour map --background white").status,
        0);
    QCOMPARE(
        run("steal tops.ifs --entry square --from uneven --picture g.png -o f.png --size 300x200 --exact "
            "--background black")
            .status,
        0);
    // The pieces of F have the colours of the pieces of G.
    const QImage g = QImage::fromData(read("g.png")), f = QImage::fromData(read("f.png"));
    const auto inG = [&](double x, double y) {
        return g.pixelColor(int(150 + 180 * (x - .5)), int(100 - 180 * (y - .5)));
    };
    const auto inF = [&](double x, double y) {
        return f.pixelColor(int(150 + 180 * (x - .5)), int(100 - 180 * (y - .5)));
    };
    for (const double x : {.1, .9})
        for (const double y : {.1, .9}) {
            const int turn = std::abs(inF(x, y).hslHue() - inG(x, y).hslHue());
            QVERIFY(std::min(turn, 360 - turn) < 20);
        }
    QVERIFY(std::abs(inF(.1, .1).hslHue() - inF(.1, .9).hslHue()) > 30);
}

// The upper left quarter of the square, twice as large.
void CliStealTest::viewsShowAPart() {
    const auto drawn = [&](const QByteArray& view) {
        const Result result = run("steal tops.ifs --entry square --from uneven --picture board.png "
                                  "--picture-view .5,.5,1 -o - --size 64x64 --exact --view " +
                                  view);
        [&] { QVERIFY2(result.status == 0, result.err.constData()); }();
        return QImage::fromData(result.out);
    };
    const QImage whole = drawn(".5,.5,1"), part = drawn(".25,.75,.5");
    QCOMPARE(part.size(), QSize(64, 64));
    const auto differ = [](QRgb a, QRgb b) {
        return std::abs(qRed(a) - qRed(b)) > 24 || std::abs(qGreen(a) - qGreen(b)) > 24;
    };
    int moved = 0;
    for (int y = 4; y < 60; ++y)
        for (int x = 4; x < 60; ++x) {
            QVERIFY(!differ(part.pixel(x, y), whole.pixel(x / 2, y / 2)));
            moved += differ(part.pixel(x, y), whole.pixel(x, y)) ? 1 : 0;
        }
    QVERIFY(moved > 1000);
}

void CliStealTest::cagesAreApplied() {
    write("caged.ifs", "halves {\n ; barycage: version 1\n ; barycage: rest 0 0\n ; barycage: rest 1 0\n"
                       " ; barycage: rest 0 1\n ; barycage: current 0 0\n ; barycage: current 2 0\n"
                       " ; barycage: current 0 1\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    const Result result = run("steal caged.ifs --from-file tops.ifs --from cantor --map 1,0 --json");
    compare(line(result.out)[QLatin1String("image")], 1.0 / 3, 0, 1e-12);
}

void CliStealTest::sameBytes() {
    const QByteArray call =
        "steal tops.ifs --entry square --from uneven --picture board.png --size 200x150 -o ";
    QCOMPARE(run(call + "a.png --threads 1 --simd scalar").status, 0);
    QCOMPARE(run(call + "b.png --threads 3").status, 0);
    QCOMPARE(run(call + "c.png --seed 2").status, 0);
    QCOMPARE(run(call + "d.png --exact --threads 1").status, 0);
    QCOMPARE(run(call + "e.png --exact --threads 3 --simd scalar").status, 0);
    QVERIFY(!read("a.png").isEmpty() && read("a.png") == read("b.png"));
    QVERIFY(read("a.png") != read("c.png"));
    QVERIFY(read("d.png") == read("e.png"));
    QCOMPARE(run(call + "-").out, read("a.png"));
    QCOMPARE(run("info a.png --names").out, QByteArray("square\n")); // what is drawn is in the picture
}

// Without --from: partner, order, mode and picture are those of the entry, and each gives way to an option.
void CliStealTest::drawsWhatTheEntryKeeps() {
    const QByteArray kept =
        " ; barycage: partner uneven\n ; barycage: partner-mode transform\n"
        " ; barycage: partner-order 4 3 2 1\n ; barycage: partner-picture deep/board.png\n";
    const QByteArray square = " .5 0 0 .5 0 0 .25\n .5 0 0 .5 0 .5 .25\n .5 0 0 .5 .5 0 .25\n"
                              " .5 0 0 .5 .5 .5 .25\n}\n";
    const QByteArray uneven = "uneven {\n .3 0 0 .4 0 0 .25\n .3 0 0 .6 0 .4 .25\n .7 0 0 .4 .3 0 .25\n"
                              " .7 0 0 .6 .3 .4 .25\n}\n";
    QVERIFY(QDir().mkpath(path("pictures/deep")));
    write("pictures/kept.ifs", "square {\n" + kept + square + uneven + "plain {\n" + square);
    write("pictures/deep/board.png", encodedAs(board(160, 120), "PNG"));
    const auto drawn = [&](const QByteArray& options) {
        const Result result = run("steal pictures/kept.ifs -o - --size 60x60 --points 1M " + options);
        [&] { QVERIFY2(result.status == 0, result.err.constData()); }();
        return QImage::fromData(result.out);
    };
    const QByteArray picture = "--picture pictures/deep/board.png ";
    const QImage asKept = drawn("");
    QVERIFY(!asKept.isNull());
    QCOMPARE(asKept, drawn("--from uneven --mode transform --order 4,3,2,1 " + picture));
    QCOMPARE(drawn("--order 1,2,3,4"), drawn("--from uneven --mode transform " + picture));
    QCOMPARE(drawn("--mode steal"), drawn("--from uneven --order 4,3,2,1 " + picture));
    QCOMPARE(drawn("--mode grid"), drawn("--from uneven --mode grid --order 4,3,2,1 " + picture));
    QVERIFY(drawn("--mode posterise") != asKept && drawn("--mode reduce") != asKept);

    const Result points = run("steal pictures/kept.ifs --map 0.5,0.5 --json");
    QCOMPARE(points.out,
             run("steal pictures/kept.ifs --from uneven --order 4,3,2,1 --map 0.5,0.5 --json").out);
}

// The picture in the entry, wherever the one is that it was made of.
void CliStealTest::embeddedPicturesAreDrawn() {
    const QByteArray picture = encodedAs(board(60, 60), "PNG");
    const QByteArray data = picture.toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals);
    QByteArray lines = " ; barycage: partner uneven\n ; barycage: partner-picture lost.png\n";
    for (qsizetype at = 0; at < data.size(); at += 44)
        lines += " ; barycage: partner-data " + data.mid(at, 44) + '\n';
    const QByteArray rows =
        " .5 0 0 .5 0 0 .25\n .5 0 0 .5 0 .5 .25\n .5 0 0 .5 .5 0 .25\n .5 0 0 .5 .5 .5 .25\n}\n"
        "uneven {\n .3 0 0 .4 0 0 .25\n .3 0 0 .6 0 .4 .25\n .7 0 0 .4 .3 0 .25\n"
        " .7 0 0 .6 .3 .4 .25\n}\n";
    write("embedded.ifs", "square {\n" + lines + rows);
    write("board60.png", picture);
    const QByteArray options = "-o - --size 60x60 --points 1M ";
    const Result kept = run("steal embedded.ifs " + options);
    QVERIFY2(kept.status == 0, kept.err.constData());
    const Result given = run("steal embedded.ifs --picture board60.png " + options);
    QVERIFY2(given.status == 0, given.err.constData());
    QCOMPARE(QImage::fromData(kept.out), QImage::fromData(given.out));
    write("damaged.ifs", "square {\n ; barycage: partner uneven\n ; barycage: partner-data AAAA\n" + rows);
    const Result damaged = run("steal damaged.ifs " + options);
    QCOMPARE(damaged.status, 1);
    QVERIFY2(damaged.err.contains("damaged.ifs"), damaged.err.constData());
}

void CliStealTest::thePictureIsNotWrittenOver() {
    const QByteArray before = read("board.png");
    const Result result =
        run("steal tops.ifs --entry square --from uneven --picture board.png -o ./board.png");
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("is an input file"), result.err.constData());
    write("kept.ifs", "halves {\n ; barycage: partner thirds\n ; barycage: partner-picture board.png\n"
                      " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n"
                      "thirds {\n .3 0 0 .3 0 0 .5\n .6 0 0 .6 .3 0 .5\n}\n");
    QCOMPARE(run("steal kept.ifs -o board.png").status, 2);
    QCOMPARE(read("board.png"), before);
}

// A file from a stranger could name any file of whoever draws it, or a pipe that never ends.
void CliStealTest::foreignPicturesAreRefused_data() {
    QTest::addColumn<QByteArray>("picture");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("sentence");
    const QByteArray foreign = "not in the folder of the file";
    QTest::newRow("absolute") << QFile::encodeName(path("board.png")) << 1 << foreign;
    QTest::newRow("outside") << QByteArray("../board.png") << 1 << foreign;
    QTest::newRow("outside, through a folder") << QByteArray("deep/../../board.png") << 1 << foreign;
    QTest::newRow("device") << QByteArray("/dev/zero") << 1 << foreign;
    QTest::newRow("link to a file outside") << QByteArray("link.png") << 1 << foreign;
    QTest::newRow("link to a folder outside") << QByteArray("up/board.png") << 1 << foreign;
    QTest::newRow("pipe inside") << QByteArray("pipe") << 3 << QByteArray("not a regular file");
    QTest::newRow("link inside") << QByteArray("own.png") << 0 << QByteArray();
}

void CliStealTest::foreignPicturesAreRefused() {
    QFETCH(QByteArray, picture);
    QFETCH(int, status);
    QFETCH(QByteArray, sentence);
    QVERIFY(QDir().mkpath(path("strange/deep")));
    write("strange/inside.png", encodedAs(board(60, 60), "PNG"));
    QFile::link(path("board.png"), path("strange/link.png"));
    QFile::link(QStringLiteral(".."), path("strange/up"));
    QFile::link(QStringLiteral("inside.png"), path("strange/own.png"));
    ::mkfifo(QFile::encodeName(path("strange/pipe")).constData(), 0600);
    write("strange/kept.ifs", "halves {\n ; barycage: partner thirds\n ; barycage: partner-picture " +
                                  picture +
                                  "\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n"
                                  "thirds {\n .3 0 0 .3 0 0 .5\n .6 0 0 .6 .3 0 .5\n}\n");
    QFile::remove(path("foreign.png"));
    const Result result = run("steal strange/kept.ifs -o foreign.png --size 40x40 --points 1e4");
    QCOMPARE(result.status, status);
    QVERIFY2(result.err.contains(sentence), result.err.constData());
    QCOMPARE(QFile::exists(path("foreign.png")), status == 0);
    // Who names it, trusts it.
    if (picture == "../board.png")
        QCOMPARE(
            run("steal strange/kept.ifs --picture board.png -o foreign.png --size 40x40 --points 1e4").status,
            0);
}

void CliStealTest::keptTransformationsAreChecked() {
    const auto fails = [&](const QByteArray& comments, const QByteArray& options, int status,
                           const QByteArray& sentence) {
        write("kept.ifs", "halves {\n" + comments +
                              " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n"
                              "thirds {\n .3 0 0 .3 0 0 .5\n .6 0 0 .6 .3 0 .5\n}\n");
        const Result result = run("steal kept.ifs -o out.png " + options);
        QCOMPARE(result.status, status);
        QVERIFY2(result.err.contains(sentence), result.err.constData());
        QVERIFY(!QFile::exists(path("out.png")));
    };
    fails("", "", 2, "--from NAME is missing, and “halves” has no stored fractal transformation.");
    fails(" ; barycage: partner gone\n", "", 1, "gone");
    fails(" ; barycage: partner thirds\n ; barycage: partner-order 2 2\n", "", 1,
          "The order stored in “halves” does not list every active map once. Give --order.");
    fails(" ; barycage: partner thirds\n ; barycage: partner-picture lost.png\n", "", 3, "lost.png");
    fails(" ; barycage: partner thirds\n", "--mode sideways", 2, "--mode “sideways” is not valid");
    fails(" ; barycage: partner thirds\n", "--from-file kept.ifs", 2, "--from-file");
    fails(" ; barycage: partner thirds\n", "--mode grid --picture-view 0,0,1", 2, "--picture-view");
    fails(" ; barycage: partner thirds\n", "--from thirds", 2, "Give one of --picture");
}

void CliStealTest::readsAnyPicture_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("jpeg") << encodedAs(board(64, 64), "JPG");
    QTest::newRow("bmp") << encodedAs(board(64, 64), "BMP");
    QTest::newRow("ppm") << encodedAs(board(64, 64), "PPM");
    QTest::newRow("one pixel") << encodedAs(board(1, 1), "PNG");
    QTest::newRow("thin") << encodedAs(board(3000, 1), "PNG");
    QTest::newRow("16 bits") << encodedAs(board(9, 9).convertToFormat(QImage::Format_RGBA64), "PNG");
    QTest::newRow("two colours") << encodedAs(board(9, 9).convertToFormat(QImage::Format_Mono), "PNG");
    QTest::newRow("transparent") << encodedAs(QImage(9, 9, QImage::Format_ARGB32), "PNG");
}

void CliStealTest::readsAnyPicture() {
    QFETCH(QByteArray, bytes);
    QVERIFY(!bytes.isEmpty());
    write("picture", bytes);
    const Result result = run(
        "steal tops.ifs --entry square --from uneven --picture picture -o out.png --size 60x40 --points 1e5");
    QCOMPARE(result.err, QByteArray());
    QCOMPARE(result.status, 0);
    QCOMPARE(QImage::fromData(read("out.png")).size(), QSize(60, 40));
}

void CliStealTest::badPicturesAreErrors_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("said");
    const QByteArray png = encodedAs(board(64, 64), "PNG");
    QByteArray huge = png;
    huge.replace(16, 8, QByteArray("\0\0\xff\xff\0\0\xff\xff", 8));
    QTest::newRow("empty") << QByteArray() << QByteArray("This is not a PNG");
    QTest::newRow("text") << QByteArray("hello") << QByteArray("This is not a PNG");
    QTest::newRow("cut") << png.left(png.size() / 2) << QByteArray("The picture is damaged");
    QTest::newRow("header") << png.left(30) << QByteArray("The picture ");
    QTest::newRow("huge") << QByteArray("P6\n9000 9000\n255\n")
                          << QByteArray("The picture has 9000 × 9000 pixels");
    QTest::newRow("huge PNG") << huge << QByteArray("The picture ");
    QTest::newRow("svg") << QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>")
                         << QByteArray("This is not a PNG");
}

void CliStealTest::badPicturesAreErrors() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, said);
    write("bad", bytes);
    const Result result =
        run("steal tops.ifs --entry square --from uneven --picture bad -o bad.png --size 60x40");
    QCOMPARE(result.status, 1); // it was read, and has problems
    QVERIFY2(result.err.contains("error: " + said), result.err.constData());
    QVERIFY(read("bad.png").isEmpty());
    const Result absent =
        run("steal tops.ifs --entry square --from uneven --picture absent -o bad.png --size 60x40");
    QCOMPARE(absent.status, 3);
    QVERIFY2(absent.err.contains("error: "), absent.err.constData());
}

void CliStealTest::refuses_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* arguments, int status, const char* said) {
        QTest::newRow(arguments) << QByteArray(arguments) << status << QByteArray(said);
    };
    row("tops.ifs --entry halves --from square --map 0,0", 1,
        "“halves” and “square” must have the same number of active maps; they have 2 and 4.");
    row("tops.ifs --entry halves --from escapes --map 0,0", 1, "No attractor could be proved for “escapes”");
    row("tops.ifs --entry escapes --from halves --tear .1", 1, "No attractor could be proved for “escapes”");
    row("tops.ifs --entry halves --from space --map 0,0", 1, "“space” is in space");
    row("tops.ifs --entry halves --from nothing --map 0,0", 1, "There is no entry “nothing”.");
    row("absent.ifs --from halves --map 0,0", 3, "does not exist");
    row("tops.ifs --from halves --from-file absent.ifs --map 0,0", 3, "does not exist");
    row("tops.ifs --map 0,0", 2, "--from NAME is missing, and “halves” has no stored fractal transformation");
    row("tops.ifs --from halves", 2, "Give one of --picture");
    row("tops.ifs --from halves --map 0,0 --tear .1", 2, "Give one of --picture");
    row("tops.ifs --from halves --picture board.png", 2, "-o OUT.png is missing");
    row("tops.ifs --from halves --picture board.png -o x.jpg", 2, "The output must be a .png file");
    row("tops.ifs --from halves --picture board.png -o x.png --json", 2, "--json cannot be used here");
    row("tops.ifs --from halves --picture board.png -o x.png --exact --points 9", 2,
        "--points cannot be used");
    row("tops.ifs --from halves --picture absent.png -o x.png", 3, "does not exist");
    row("tops.ifs --from halves --picture board.png -o absent/x.png", 3, "absent/x.png");
    row("tops.ifs --from halves --map 0,0 --exact", 2, "--exact cannot be used here");
    row("tops.ifs --from halves --map nonsense", 2, "--map “nonsense” is not valid");
    row("tops.ifs --from halves --map \" \"", 2, "--map “ ” is not valid");
    row("tops.ifs --from halves --tear 0", 2, "--tear “0” is not valid");
    row("tops.ifs --from halves --tear nan", 2, "--tear “nan” is not valid");
    row("tops.ifs --from halves --map 0,0 --order 1", 2, "--order must list every active map of “halves”");
    row("tops.ifs --from halves --map 0,0 --order 1,1", 2, "--order must list every active map of “halves”");
    row("tops.ifs --from halves --map 0,0 --order 1,x", 2, "--order “1,x” is not valid");
    row("tops.ifs --from halves --map 0,0 --order 0,1", 2, "--order “0,1” is not valid");
    row("- --from halves --from-file - --map 0,0", 2, "Only one of the files");
}

void CliStealTest::refuses() {
    QFETCH(QByteArray, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, said);
    const Result result = run("steal " + arguments);
    QVERIFY2(result.err.contains(said), result.err.constData());
    QCOMPARE(result.status, status);
    QVERIFY(result.out.isEmpty());
    QVERIFY(read("x.png").isEmpty());
}

void CliStealTest::warningsAreSaidOnce() {
    write("odd.ifs", "\xef\xbb\xbf"
                     "odd {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .6\n}\n"
                     "other {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    for (const QByteArray from : {"other", "odd", "other --from-file odd.ifs", "odd --from-file ./odd.ifs"}) {
        const Result result = run("steal odd.ifs --map 0,0 --from " + from);
        QCOMPARE(result.status, 0);
        QCOMPARE(result.err.count('\n'), 2);
        QVERIFY2(result.err.count("The weights sum to") == 1, result.err.constData());
    }
}

BARYCAGE_TEST(CliStealTest, QGuiApplication);
#include "cli_steal_test.moc"
