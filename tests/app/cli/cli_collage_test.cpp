// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <QProcess>

// barycage-cli collage.
class CliCollageTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void aPictureBecomesASystem();
    void theReportMatchesWhatIsDrawn();
    void distancesAgreeWithThoseOfAllPairs();
    void thresholdChoosesTheShape();
    void theSameStartsGiveTheSameBytes();
    void secondsDecideOnlyTheStarts();
    void opacityMakesTheShape();
    void invertTakesTheBackground();
    void similaritiesKeepAngles();
    void constraintsReachTheMaps();
    void picturesComeThroughPipes();
    void uselessPicturesAreRefused_data();
    void uselessPicturesAreRefused();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void anInterruptLeavesNothing();

private:
    QJsonObject report(const QByteArray& name) const { return QJsonDocument::fromJson(read(name)).object(); }
};

namespace {

// A black shape on white: an L, which is not symmetric.
QImage letter(int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = double(x) / width, v = double(y) / height;
            const bool isInside = u > 0.2 && u < 0.8 && v > 0.1 && v < 0.9 && (u < 0.4 || v > 0.7);
            image.setPixel(x, y, isInside ? qRgb(20, 20, 30) : qRgb(250, 250, 240));
        }
    return image;
}

QByteArray encoded(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return bytes;
}

QImage plain(int width, int height, QRgb colour) {
    QImage image(width, height, QImage::Format_ARGB32);
    image.fill(colour);
    return image;
}

// The JPEG with a fourth component in its frame header, as pictures in CMYK have it.
QByteArray withFourComponents(QByteArray jpeg) {
    for (qsizetype i = 2; i + 9 < jpeg.size(); ++i)
        if (jpeg.at(i) == '\xff' && jpeg.at(i + 1) == '\xc0') {
            jpeg[i + 9] = 4;
            break;
        }
    return jpeg;
}

// Two frames of 16 × 16 pixels in two colours, the smallest there are.
QByteArray animatedGif() {
    const QByteArray frame = QByteArray::fromHex("21f904000a000000") +
                             QByteArray::fromHex("2c00000000100010000002") +
                             QByteArray::fromHex("0e848fa9cbed0fa39cb4da8bb3de05") + QByteArray(1, '\0');
    return QByteArray("GIF89a") + QByteArray::fromHex("10001000800000000000ffffff") + frame + frame + ';';
}

using Cells = std::set<std::pair<int, int>>; // column and row

Cells darkCells(const QImage& image, int below) {
    Cells cells;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qGray(image.pixel(x, y)) < below) cells.emplace(x, y);
    return cells;
}

// W(L) for the target in a picture of 160 × 120 pixels.
Cells imagesOf(const Cells& target, const QJsonArray& maps) {
    Cells cells;
    for (const QJsonValue& map : maps) {
        const QJsonArray a = map[QLatin1String("linear")].toArray();
        const QJsonArray b = map[QLatin1String("translation")].toArray();
        for (const auto& [column, row] : target) {
            const double x = (column + 0.5 - 80) / 120, y = 0.5 - (row + 0.5) / 120;
            const double u = a[0][0].toDouble() * x + a[0][1].toDouble() * y + b[0].toDouble();
            const double v = a[1][0].toDouble() * x + a[1][1].toDouble() * y + b[1].toDouble();
            cells.emplace(int(std::floor(u * 120 + 80)), int(std::floor((0.5 - v) * 120)));
        }
    }
    return cells;
}

// Of each cell of `from` to the nearest of `to`.
std::vector<double> distances(const Cells& from, const Cells& to) {
    std::vector<double> result;
    for (const auto& [x, y] : from) {
        double least = HUGE_VAL;
        if (to.contains({x, y}))
            least = 0;
        else
            for (const auto& [u, v] : to)
                least = std::min(least, std::hypot(x - u, y - v));
        result.push_back(least);
    }
    return result;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

} // namespace

void CliCollageTest::init() {
    write("letter.png", encoded(letter(160, 120), "PNG"));
}

void CliCollageTest::aPictureBecomesASystem() {
    const Result result = run("collage letter.png -o found.ifs --starts 64 --maps 4 --report r.json");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.isEmpty(), result.err.constData());
    const QJsonObject entry = run("info found.ifs --json").entry();
    QCOMPARE(entry[QLatin1String("name")].toString(), QStringLiteral("letter"));
    QCOMPARE(entry[QLatin1String("maps")].toArray().size(), 4);
    // The L spans 0.2 … 0.8 of 4/3 units and 0.1 … 0.9 of one unit; y is up.
    const QJsonObject box = entry[QLatin1String("bounding_box")].toObject();
    compare(box[QLatin1String("min")], -0.4, -0.4, 0.06);
    compare(box[QLatin1String("max")], 0.4, 0.4, 0.06);
    QVERIFY(entry[QLatin1String("mean")].toArray()[1].toDouble() < -0.05); // its foot is at the bottom
    const QJsonObject said = report("r.json");
    QCOMPARE(said.keys(),
             (QStringList{QStringLiteral("bound"), QStringLiteral("hausdorff"), QStringLiteral("iou"),
                          QStringLiteral("mean"), QStringLiteral("overlap"), QStringLiteral("p95"),
                          QStringLiteral("size"), QStringLiteral("starts")}));
    QCOMPARE(said[QLatin1String("size")], (QJsonValue(QJsonArray{160, 120})));
    QCOMPARE(said[QLatin1String("starts")].toInt(), 64);
    QVERIFY(said[QLatin1String("mean")].toDouble() < 0.5);
    QVERIFY(said[QLatin1String("iou")].toDouble() > 0.7);
    QVERIFY(said[QLatin1String("overlap")].toDouble() >= 1 && said[QLatin1String("overlap")].toDouble() < 4);
    QVERIFY(said[QLatin1String("bound")].toDouble() > said[QLatin1String("hausdorff")].toDouble());
}

void CliCollageTest::theReportMatchesWhatIsDrawn() {
    QCOMPARE(run("collage letter.png -o found.ifs --starts 64 --maps 4 --report r.json").status, 0);
    QCOMPARE(run("render found.ifs -o drawn.png --view 0,0,1 --size 160x120 --points 4M --colour none "
                 "--background white")
                 .status,
             0);
    const QImage drawn(path("drawn.png")), target = letter(160, 120);
    int both = 0, either = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            const bool a = qGray(drawn.pixel(x, y)) < 250, l = qGray(target.pixel(x, y)) < 128;
            both += a && l;
            either += a || l;
        }
    QVERIFY(std::abs(double(both) / either - report("r.json")[QLatin1String("iou")].toDouble()) < 0.06);
}

void CliCollageTest::distancesAgreeWithThoseOfAllPairs() {
    QCOMPARE(run("collage letter.png -o found.ifs --starts 64 --maps 4 --report r.json").status, 0);
    QCOMPARE(run("render found.ifs -o drawn.png --view 0,0,1 --size 160x120 --points 4M --colour none "
                 "--background white")
                 .status,
             0);
    const QJsonObject said = report("r.json");
    const Cells target = darkCells(letter(160, 120), 128);
    const QJsonArray maps = run("info found.ifs --json").entry()[QLatin1String("maps")].toArray();
    QCOMPARE(maps.size(), 4);
    const Cells images = imagesOf(target, maps);
    const double hausdorff =
        std::max(std::ranges::max(distances(images, target)), std::ranges::max(distances(target, images)));
    compare(said[QLatin1String("hausdorff")].toDouble(), hausdorff, 1.5);
    double s = 0;
    for (const QJsonValue& map : maps)
        s = std::max(s, map[QLatin1String("norm")].toDouble());
    const double bound = said[QLatin1String("bound")].toDouble();
    QVERIFY(bound <= (hausdorff + 1.5 + (2 + s) / std::sqrt(2)) / (1 - s)); // or that of a better norm
    const Cells drawn = darkCells(QImage(path("drawn.png")), 250);
    std::vector<double> outwards = distances(drawn, target);
    const std::vector<double> inwards = distances(target, drawn);
    compare(said[QLatin1String("mean")].toDouble(), (mean(outwards) + mean(inwards)) / 2, 0.15);
    outwards.insert(outwards.end(), inwards.begin(), inwards.end());
    std::ranges::sort(outwards);
    QVERIFY(bound >= outwards.back() - 1);
    const auto rank = std::size_t(std::ceil(0.95 * double(outwards.size()))) - 1;
    compare(said[QLatin1String("p95")].toDouble(), outwards[rank], 1.01);
}

// A black square in a grey one.
void CliCollageTest::thresholdChoosesTheShape() {
    QImage image = plain(120, 120, qRgb(255, 255, 255));
    for (int y = 20; y < 100; ++y)
        for (int x = 20; x < 100; ++x) {
            const bool isBlack = x >= 45 && x < 75 && y >= 45 && y < 75;
            image.setPixel(x, y, isBlack ? qRgb(0, 0, 0) : qRgb(120, 120, 120));
        }
    write("squares.png", encoded(image, "PNG"));
    for (const auto& [threshold, half] : {std::pair{"60", 15.0 / 120}, std::pair{"150", 40.0 / 120}}) {
        const Result result =
            run(QByteArray("collage squares.png -o found.ifs --starts 32 --maps 4 --threshold ") + threshold);
        QCOMPARE(result.status, 0);
        const QJsonObject box =
            run("info found.ifs --json").entry()[QLatin1String("bounding_box")].toObject();
        compare(box[QLatin1String("min")], -half, -half, 0.04);
        compare(box[QLatin1String("max")], half, half, 0.04);
    }
}

void CliCollageTest::theSameStartsGiveTheSameBytes() {
    const QByteArray command = "collage letter.png --starts 40 --seed 3 --maps 2-4 ";
    QCOMPARE(run(command + "-o one.ifs --threads 1 --report one.json").status, 0);
    QCOMPARE(run(command + "-o two.ifs --threads 2 --report two.json").status, 0);
    QCOMPARE(run(command + "-o - -j 7").out, read("one.ifs"));
    QCOMPARE(read("two.ifs"), read("one.ifs"));
    QCOMPARE(read("two.json"), read("one.json"));
    QVERIFY(run("collage letter.png --starts 40 --seed 4 --maps 2-4 -o -").out != read("one.ifs"));
}

void CliCollageTest::secondsDecideOnlyTheStarts() {
    QCOMPARE(run("collage letter.png -o timed.ifs --seconds 0.2 --maps 3 --report r.json").status, 0);
    const int starts = report("r.json")[QLatin1String("starts")].toInt();
    QVERIFY(starts > 0);
    QCOMPARE(run("collage letter.png -o - --maps 3 --starts " + QByteArray::number(starts)).out,
             read("timed.ifs"));
}

// A white drawing on nothing.
void CliCollageTest::opacityMakesTheShape() {
    QImage clear = letter(160, 120).convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            clear.setPixel(x, y, qGray(clear.pixel(x, y)) < 128 ? qRgba(255, 255, 255, 255) : 0U);
    write("clear.png", encoded(clear, "PNG"));
    QCOMPARE(run("collage clear.png -o clear.ifs --starts 32 --maps 3 --report clear.json").status, 0);
    QCOMPARE(run("collage letter.png -o letter.ifs --starts 32 --maps 3 --report letter.json").status, 0);
    QCOMPARE(read("clear.json"), read("letter.json"));
}

void CliCollageTest::invertTakesTheBackground() {
    QImage negative = letter(160, 120);
    negative.invertPixels();
    write("negative.png", encoded(negative, "PNG"));
    QCOMPARE(run("collage letter.png -o a.ifs --starts 32 --maps 3 --report a.json").status, 0);
    QCOMPARE(run("collage negative.png -o b.ifs --invert --starts 32 --maps 3 --report b.json").status, 0);
    QCOMPARE(read("a.json"), read("b.json"));
    QCOMPARE(run("collage negative.png -o c.ifs --starts 32 --maps 3 --report c.json").status, 0);
    QVERIFY(read("c.json") != read("a.json"));
}

void CliCollageTest::similaritiesKeepAngles() {
    QCOMPARE(run("collage letter.png -o found.ifs --starts 32 --maps 4 --similarities").status, 0);
    const QJsonArray maps = run("info found.ifs --json").entry()[QLatin1String("maps")].toArray();
    QCOMPARE(maps.size(), 4);
    for (const QJsonValue& map : maps) {
        const double norm = map[QLatin1String("norm")].toDouble();
        compare(std::abs(map[QLatin1String("determinant")].toDouble()), norm * norm, 1e-7);
    }
}

void CliCollageTest::constraintsReachTheMaps() {
    QCOMPARE(
        run("collage letter.png -o found.ifs --starts 32 --maps 4 --no-mirrors --angles 90 --stem").status,
        0);
    const QJsonArray maps = run("info found.ifs --json").entry()[QLatin1String("maps")].toArray();
    QCOMPARE(maps.size(), 4);
    for (int i = 0; i < maps.size(); ++i) {
        const QJsonObject map = maps[i].toObject();
        const QJsonArray rows = map[QLatin1String("linear")].toArray();
        const double a = rows[0][0].toDouble(), b = rows[0][1].toDouble(), c = rows[1][0].toDouble(),
                     d = rows[1][1].toDouble();
        if (i == 0) {
            QVERIFY(std::abs(a * d - b * c) < 1e-9); // flat
            continue;
        }
        QVERIFY(a * d - b * c > 0);
        // A = Q S with a quarter turn Q: QᵀA is symmetric for one of four Q, so b = c or a = −d.
        QVERIFY(std::min(std::abs(b - c), std::abs(a + d)) < 1e-6);
    }
}

void CliCollageTest::picturesComeThroughPipes() {
    const Result result = run("collage - -o - --starts 16 --maps 2", encoded(letter(60, 60), "BMP"));
    QCOMPARE(result.status, 0);
    QVERIFY(result.out.startsWith("collage {"));
}

void CliCollageTest::uselessPicturesAreRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("said");
    const QImage l = letter(160, 120);
    const QByteArray png = encoded(l, "PNG"), jpeg = encoded(l, "JPG"), bmp = encoded(l, "BMP");
    QTest::newRow("1 x 1") << encoded(plain(1, 1, qRgb(0, 0, 0)), "PNG") << QByteArray("1 × 1 pixels");
    QTest::newRow("30000 x 1") << encoded(plain(30'000, 1, qRgb(0, 0, 0)), "PNG")
                               << QByteArray("30000 × 1 pixels");
    QTest::newRow("black") << encoded(plain(90, 90, qRgb(0, 0, 0)), "PNG") << QByteArray("one shade");
    QTest::newRow("white") << encoded(plain(90, 90, qRgb(255, 255, 255)), "PNG") << QByteArray("one shade");
    QTest::newRow("nothing") << encoded(plain(90, 90, 0), "PNG") << QByteArray("one shade");
    QTest::newRow("long") << encoded(plain(20'000, 10, qRgb(0, 0, 0)), "PNG") << QByteArray("long and thin");
    QTest::newRow("half a PNG") << png.left(png.size() / 2) << QByteArray("damaged or incomplete");
    QByteArray spoilt = png;
    spoilt[png.size() / 2] = char(~png[png.size() / 2]);
    QTest::newRow("a spoilt PNG") << spoilt << QByteArray("damaged or incomplete");
    QTest::newRow("half a JPEG") << jpeg.left(jpeg.size() / 2) << QByteArray("damaged or incomplete");
    QTest::newRow("half a BMP") << bmp.left(bmp.size() / 2) << QByteArray("damaged or incomplete");
    QTest::newRow("CMYK") << withFourComponents(jpeg) << QByteArray("CMYK");
    QTest::newRow("animation") << animatedGif() << QByteArray("animated");
    QTest::newRow("no picture") << QByteArray("leaf {\n .5 0 0 .5 0 0 1\n}\n") << QByteArray("not a PNG");
    QTest::newRow("SVG") << QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>")
                         << QByteArray("not a PNG");
    QTest::newRow("empty") << QByteArray() << QByteArray("not a PNG");
    const QByteArray huge = "P5\n30000 30000\n255\n";
    QTest::newRow("huge") << huge << QByteArray("At most 32 million pixels");
}

void CliCollageTest::uselessPicturesAreRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, said);
    write("useless", bytes);
    const Result result = run("collage useless -o none.ifs --starts 8 --report none.json");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.contains(said), result.err.constData());
    QCOMPARE(result.err.count('\n'), 1); // and nothing of what the readers mutter
    QVERIFY(!QFile::exists(path("none.ifs")) && !QFile::exists(path("none.json")));
}

void CliCollageTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    const auto row = [](const char* arguments, int status) {
        QTest::newRow(arguments) << QByteArray(arguments) << status;
    };
    row("letter.png", 2);
    row("letter.png -o x.png", 2);
    row("letter.png -o letter.png", 2);
    row("letter.png -o x.ifs --maps 1", 2);
    row("letter.png -o x.ifs --maps 8-2", 2);
    row("letter.png -o x.ifs --maps 2-4-6", 2);
    row("letter.png -o x.ifs --maps many", 2);
    row("letter.png -o x.ifs --maps 17", 2);
    row("letter.png -o x.ifs --starts 0", 2);
    row("letter.png -o x.ifs --starts 4 --seconds 1", 2);
    row("letter.png -o x.ifs --seconds -1", 2);
    row("letter.png -o x.ifs --threshold 256", 2);
    row("letter.png -o x.ifs --report x.ifs", 2);
    row("letter.png -o x.ifs --report letter.png", 2);
    row("letter.png -o x.ifs --threads 0", 2);
    row("letter.png -o x.ifs --angles 45", 2);
    row("letter.png -o x.ifs --angles sixty", 2);
    row("letter.png -o x.ifs --threshold 0", 1); // nothing is that dark
    row("missing.png -o x.ifs", 3);
    row("letter.png -o no/folder/x.ifs --starts 4 --maps 2", 3);
}

void CliCollageTest::wrongUsageIsRefused() {
    QFETCH(QByteArray, arguments);
    QFETCH(int, status);
    const Result result = run("collage " + arguments);
    QCOMPARE(result.status, status);
    QVERIFY(result.err.contains("error: "));
    QVERIFY(!QFile::exists(path("x.ifs")));
    QCOMPARE(read("letter.png"), encoded(letter(160, 120), "PNG"));
}

void CliCollageTest::anInterruptLeavesNothing() {
    QProcess process;
    start(process,
          "collage letter.png -o stopped.ifs --seconds 1000 --report stopped.json --progress always");
    process.setReadChannel(QProcess::StandardError);
    QVERIFY(process.waitForReadyRead(30'000)); // it says how far it is
    ::kill(pid_t(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(!QFile::exists(path("stopped.ifs")) && !QFile::exists(path("stopped.json")));
}

BARYCAGE_TEST(CliCollageTest, QGuiApplication);
#include "cli_collage_test.moc"
