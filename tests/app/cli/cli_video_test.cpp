// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"
#include "support/thorough.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRandomGenerator>
#include <QSet>
#include <QtEndian>

#include <cmath>
#include <csignal>

// barycage-cli animate to a video, and encode. ffprobe and ffmpeg look at what was written.
class CliVideoTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void videosAreWhatTheyShouldBe_data();
    void videosAreWhatTheyShouldBe();
    void webPIsWhatItShouldBe();
    void durationsAddUp_data();
    void durationsAddUp();
    void aWebPThatStandsStillIsAnAnimation();
    void framesShowThePictures_data();
    void framesShowThePictures();
    void transparencyIsStored_data();
    void transparencyIsStored();
    void whatAFormatLacksIsSaid();
    void encodeWritesTheSameBytes_data();
    void encodeWritesTheSameBytes();
    void videosOpenAsTheirAnimation_data();
    void videosOpenAsTheirAnimation();
    void gifsKeepOnePalette();
    void theDitherOfGifsStaysInPlace();
    void aRateIsKept();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void existingVideosCanBeRefused();
    void killedAtAnyTimeLeavesWholeFiles_data();
    void killedAtAnyTimeLeavesWholeFiles();
    void anInterruptLeavesNothing();
    void aFullDiskLeavesNothing_data();
    void aFullDiskLeavesNothing();

private:
    QStringList files(const QByteArray& folder) const {
        return QDir(path(folder)).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    QByteArray program(const QString& name, const QStringList& arguments) const;
    QJsonObject probe(const QByteArray& file) const;
    QImage frame(const QByteArray& file, int index, const QStringList& decoder = {}) const;
};

namespace {

constexpr const char* small = " --size 64x48 --points 60000 ";

void formats() {
    QTest::addColumn<QByteArray>("suffix");
    for (const char* suffix : {"mp4", "webm", "mkv", "gif", "webp", "apng"})
        QTest::newRow(suffix) << QByteArray(suffix);
}

double psnr(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            for (const int d : {p.red() - q.red(), p.green() - q.green(), p.blue() - q.blue()})
                sum += d * d;
        }
    return sum > 0 ? 10 * std::log10(255.0 * 255 * 3 * a.width() * a.height() / sum) : 99;
}

// Contents of the chunks of a WebP file that are called so.
QByteArrayList chunks(const QByteArray& file, const QByteArray& name) {
    QByteArrayList found;
    for (qsizetype at = 12; at + 8 <= file.size();) {
        const auto size = qsizetype(qFromLittleEndian<quint32>(file.constData() + at + 4));
        if (file.mid(at, 4) == name) found << file.mid(at + 8, size);
        at += 8 + size + size % 2;
    }
    return found;
}

} // namespace

void CliVideoTest::init() {
    const auto animated = [](const QByteArray& name, const QByteArray& header) {
        return name + " {\n; barycage: animation " + header +
               "\n; barycage: motion sway\n; barycage: strength 9\n; barycage: pivot 0 0\n"
               "; barycage: wave 1\n; barycage: value 1 0 25\n"
               " -0.04 0 -0.23 -0.65 -0.08 0.26 .25\n 0.61 0 0 0.31 0.07 3.5 .25\n"
               " 0.65 0.29 -0.3 0.48 0.74 0.39 .25\n 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\n}\n";
    };
    write("wind.ifs", animated("wind", "6 24/1 cycle") + animated("once", "8 30/1 off"));
    for (const char* folder : {"a", "b", "c"}) {
        QDir(path(folder)).removeRecursively();
        QDir().mkpath(path(folder));
    }
}

QByteArray CliVideoTest::program(const QString& name, const QStringList& arguments) const {
    QProcess process;
    process.setWorkingDirectory(path(""));
    process.start(name, arguments);
    if (!process.waitForStarted() || !process.waitForFinished(60'000)) qFatal("%s", qPrintable(name));
    return process.readAllStandardOutput() + process.readAllStandardError();
}

QJsonObject CliVideoTest::probe(const QByteArray& file) const {
    const QByteArray answer =
        program(QStringLiteral("ffprobe"),
                {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-count_frames"),
                 QStringLiteral("-show_streams"), QStringLiteral("-show_format"), QStringLiteral("-of"),
                 QStringLiteral("json"), QString::fromUtf8(file)});
    const QJsonObject object = QJsonDocument::fromJson(answer).object();
    QJsonObject facts = object[QLatin1String("streams")][0].toObject();
    facts[QLatin1String("seconds")] =
        object[QLatin1String("format")][QLatin1String("duration")].toString().toDouble();
    return facts;
}

QImage CliVideoTest::frame(const QByteArray& file, int index, const QStringList& decoder) const {
    QStringList arguments{QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-y")};
    arguments << decoder << QStringLiteral("-i") << QString::fromUtf8(file) << QStringLiteral("-vf")
              << QStringLiteral(
                     "select=eq(n\\,%1),scale=in_color_matrix=bt709:flags=accurate_rnd+full_chroma_int")
                     .arg(index)
              << QStringLiteral("-frames:v") << QStringLiteral("1") << QStringLiteral("frame.png");
    QFile::remove(path("frame.png"));
    program(QStringLiteral("ffmpeg"), arguments);
    return QImage(path("frame.png"));
}

void CliVideoTest::videosAreWhatTheyShouldBe_data() {
    QTest::addColumn<QByteArray>("suffix");
    QTest::addColumn<QString>("codec");
    QTest::addColumn<QString>("pixels");
    QTest::addColumn<QString>("colours");
    const auto row = [](const char* suffix, const char* codec, const char* pixels, const char* colours) {
        QTest::newRow(suffix) << QByteArray(suffix) << QString::fromLatin1(codec)
                              << QString::fromLatin1(pixels) << QString::fromLatin1(colours);
    };
    row("mp4", "h264", "yuv420p", "bt709");
    row("webm", "vp9", "yuv420p", "bt709");
    row("mkv", "ffv1", "bgr0", "gbr");
    row("gif", "gif", "bgra", "");
    row("apng", "apng", "rgb24", "");
}

void CliVideoTest::videosAreWhatTheyShouldBe() {
    QFETCH(QByteArray, suffix);
    QFETCH(QString, codec);
    QFETCH(QString, pixels);
    QFETCH(QString, colours);
    const QByteArray name = "a/v." + suffix;
    const Result result = run("animate wind.ifs --entry once -o " + name + small);
    QVERIFY2(result.status == 0 && result.err.isEmpty(), result.err.constData());
    const QJsonObject facts = probe(name);
    QCOMPARE(facts[QLatin1String("codec_name")].toString(), codec);
    QCOMPARE(facts[QLatin1String("width")].toInt(), 64);
    QCOMPARE(facts[QLatin1String("height")].toInt(), 48);
    QCOMPARE(facts[QLatin1String("pix_fmt")].toString(), pixels);
    QCOMPARE(facts[QLatin1String("color_space")].toString(), colours);
    QCOMPARE(facts[QLatin1String("nb_read_frames")].toString(), QStringLiteral("9"));
    if (suffix == "apng") { // says no duration
        // Other programs look for it at the beginning alone, and the text may be long.
        const QByteArray file = read("a/v.apng");
        QVERIFY(file.indexOf("IDAT") > 0 && file.indexOf("IDAT") < file.indexOf("iTXt"));
        return;
    }
    QVERIFY(std::abs(facts[QLatin1String("seconds")].toDouble() - 0.3) < 0.011);
    if (suffix == "gif") return; // hundredths of a second
    QCOMPARE(facts[QLatin1String("r_frame_rate")].toString(), QStringLiteral("30/1"));
    if (suffix != "mp4") return;
    QCOMPARE(facts[QLatin1String("color_transfer")].toString(), QStringLiteral("bt709"));
    QCOMPARE(facts[QLatin1String("color_primaries")].toString(), QStringLiteral("bt709"));
    QCOMPARE(facts[QLatin1String("color_range")].toString(), QStringLiteral("tv"));
    const QByteArray bytes = read(name); // one can begin to watch before all of it is there
    QVERIFY(bytes.indexOf("moov") < bytes.indexOf("mdat"));
}

// Which ffmpeg writes but does not read.
void CliVideoTest::webPIsWhatItShouldBe() {
    QCOMPARE(run(QByteArray("animate wind.ifs --entry wind -o a/v.webp") + small).status, 0);
    QCOMPARE(run(QByteArray("animate wind.ifs --entry wind -o b/f.#.png --frames 1") + small).status, 0);
    const QByteArray bytes = read("a/v.webp");
    QCOMPARE(qsizetype(qFromLittleEndian<quint32>(bytes.constData() + 4)) + 8, bytes.size());
    const QByteArrayList frames = chunks(bytes, "ANMF");
    QCOMPARE(frames.size(), 6);
    int milliseconds = 0;
    for (const QByteArray& one : frames)
        milliseconds += int(qFromLittleEndian<quint32>(one.constData() + 12) & 0xffffff);
    QCOMPARE(milliseconds, 250);
    QCOMPARE(qFromLittleEndian<quint16>(chunks(bytes, "ANIM").first().constData() + 4),
             quint16(0)); // for ever
    QByteArray still = "RIFF----WEBP" + frames.first().mid(16);
    qToLittleEndian(quint32(still.size() - 8), still.data() + 4);
    write("a/first.webp", still);
    const QImage shown = frame("a/first.webp", 0), wanted(path("b/f.1.png"));
    QCOMPARE(shown.size(), wanted.size());
    QCOMPARE(psnr(shown, wanted), 99.0);
}

// All pictures together are shown as long as their number and the rate say, to within half a tick.
void CliVideoTest::durationsAddUp_data() {
    QTest::addColumn<QByteArray>("timing");
    QTest::addColumn<double>("seconds");
    QTest::newRow("24") << QByteArray("7 24/1 cycle") << 7 / 24.0;
    QTest::newRow("24, one picture more") << QByteArray("7 24/1 off") << 8 / 24.0;
    QTest::newRow("30") << QByteArray("11 30/1 cycle") << 11 / 30.0;
    QTest::newRow("29.97") << QByteArray("10 30000/1001 cycle") << 10 * 1001 / 30000.0;
    QTest::newRow("48") << QByteArray("13 48/1 cycle") << 13 / 48.0;
    QTest::newRow("two pictures") << QByteArray("2 7/1 cycle") << 2 / 7.0;
}

void CliVideoTest::durationsAddUp() {
    QFETCH(QByteArray, timing);
    QFETCH(double, seconds);
    QByteArray entry = read("wind.ifs");
    write("timed.ifs", entry.left(entry.indexOf('}') + 1).replace("6 24/1 cycle", timing));
    QCOMPARE(run(QByteArray("animate timed.ifs -o a/v.webp") + small).status, 0);
    int milliseconds = 0;
    for (const QByteArray& one : chunks(read("a/v.webp"), "ANMF"))
        milliseconds += int(qFromLittleEndian<quint32>(one.constData() + 12) & 0xffffff);
    QCOMPARE(milliseconds, int(std::lround(1000 * seconds)));
    QCOMPARE(run(QByteArray("animate timed.ifs -o a/v.gif") + small).status, 0);
    QImageReader gif(path("a/v.gif"));
    int shown = 0;
    while (!gif.read().isNull())
        shown += gif.nextImageDelay();
    QCOMPARE(shown, 10 * int(std::lround(100 * seconds)));
}

// Its encoder makes one picture of several that are the same.
void CliVideoTest::aWebPThatStandsStillIsAnAnimation() {
    QByteArray still = read("wind.ifs");
    write("still.ifs", still.replace("strength 9", "strength 0"));
    for (const QByteArray background : {"", " --background transparent"}) {
        QCOMPARE(run("animate still.ifs --entry once -o a/v.webp" + background + small).err, QByteArray());
        QCOMPARE(run("animate still.ifs --entry once -o b/f.#.png --frames 1" + background + small).status,
                 0);
        const QByteArray bytes = read("a/v.webp");
        QCOMPARE(qsizetype(qFromLittleEndian<quint32>(bytes.constData() + 4)) + 8, bytes.size());
        QCOMPARE(bytes[20] & 0x12, background.isEmpty() ? 0x02 : 0x12);
        const QByteArrayList frames = chunks(bytes, "ANMF");
        QCOMPARE(frames.size(), 1);
        QCOMPARE(qFromLittleEndian<quint32>(frames.first().constData() + 12) & 0xffffff, 300u); // 9 of 30
        QByteArray picture = "RIFF----WEBP" + frames.first().mid(16);
        qToLittleEndian(quint32(picture.size() - 8), picture.data() + 4);
        write("a/first.webp", picture);
        QCOMPARE(psnr(frame("a/first.webp", 0), QImage(path("b/f.1.png"))), 99.0);
        QCOMPARE(run("info --json a/v.webp").entry(), run("info --json still.ifs --entry once").entry());
        QCOMPARE(run("animate a/v.webp -o b/v.webp" + background + small).status, 0);
        QCOMPARE(read("b/v.webp"), bytes);
    }
}

void CliVideoTest::framesShowThePictures_data() {
    QTest::addColumn<QByteArray>("suffix");
    QTest::addColumn<double>("least"); // dB
    // In a quarter of the colours, against a picture that has gone through the same.
    QTest::newRow("mp4") << QByteArray("mp4") << 40.0;
    QTest::newRow("webm") << QByteArray("webm") << 40.0;
    QTest::newRow("mkv") << QByteArray("mkv") << 99.0;
    QTest::newRow("apng") << QByteArray("apng") << 99.0;
    QTest::newRow("gif") << QByteArray("gif") << 35.0;
}

void CliVideoTest::framesShowThePictures() {
    QFETCH(QByteArray, suffix);
    QFETCH(double, least);
    const QByteArray size = " --size 160x120 --points 600000 ";
    QCOMPARE(run("animate wind.ifs --entry wind -o a/v." + suffix + size).status, 0);
    QCOMPARE(run("animate wind.ifs --entry wind -o b/f.#.png" + size).status, 0);
    for (const int index : {0, 5}) {
        const QByteArray picture = "b/f." + QByteArray::number(index + 1) + ".png";
        QImage wanted(path(picture));
        if (suffix == "mp4" || suffix == "webm") {
            program(QStringLiteral("ffmpeg"),
                    {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-y"),
                     QStringLiteral("-i"), QString::fromUtf8(picture), QStringLiteral("-vf"),
                     QStringLiteral(
                         "scale=out_color_matrix=bt709:flags=accurate_rnd+full_chroma_inp,format=yuv420p"),
                     QStringLiteral("-c:v"), QStringLiteral("ffv1"), QStringLiteral("-colorspace"),
                     QStringLiteral("bt709"), QStringLiteral("wanted.mkv")});
            wanted = frame("wanted.mkv", 0);
        }
        const QImage shown = frame("a/v." + suffix, index);
        QCOMPARE(shown.size(), wanted.size());
        const double found = psnr(shown, wanted);
        QVERIFY2(found >= least, qPrintable(QString::number(found)));
        const QImage other(path("b/f." + QByteArray::number(index == 0 ? 3 : 2) + ".png"));
        QVERIFY(psnr(shown, other) < found - 3); // and no other
    }
}

void CliVideoTest::transparencyIsStored_data() {
    QTest::addColumn<QByteArray>("suffix");
    QTest::addColumn<int>("tolerance"); // of the mean opacity of 255
    QTest::newRow("webm") << QByteArray("webm") << 2;
    QTest::newRow("mkv") << QByteArray("mkv") << 0;
    QTest::newRow("apng") << QByteArray("apng") << 0;
    QTest::newRow("gif") << QByteArray("gif") << 255; // all or nothing
}

void CliVideoTest::transparencyIsStored() {
    QFETCH(QByteArray, suffix);
    QFETCH(int, tolerance);
    const QByteArray options = QByteArray(small) + "--background transparent";
    QCOMPARE(run("animate wind.ifs --entry wind -o a/v." + suffix + options).status, 0);
    QCOMPARE(run("animate wind.ifs --entry wind -o b/f.#.png" + options).status, 0);
    const QStringList decoder =
        suffix == "webm" ? QStringList{QStringLiteral("-c:v"), QStringLiteral("libvpx-vp9")} : QStringList();
    const QImage shown = frame("a/v." + suffix, 4, decoder), wanted(path("b/f.5.png"));
    QVERIFY(shown.hasAlphaChannel());
    double sum = 0;
    int clear = 0, opaque = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            sum += std::abs(qAlpha(shown.pixel(x, y)) - qAlpha(wanted.pixel(x, y)));
            clear += qAlpha(shown.pixel(x, y)) == 0;
            opaque += qAlpha(shown.pixel(x, y)) > 127;
        }
    QVERIFY(sum / (48 * 64) <= tolerance);
    QVERIFY(clear > 1000 && opaque > 50);
}

void CliVideoTest::whatAFormatLacksIsSaid() {
    const Result odd = run("animate wind.ifs -o a/odd.mp4 --size 63x47 --points 20000");
    QCOMPARE(odd.status, 0);
    QVERIFY(odd.err.contains("64x48"));
    QCOMPARE(probe("a/odd.mp4")[QLatin1String("width")].toInt(), 64);
    QCOMPARE(probe("a/odd.mp4")[QLatin1String("height")].toInt(), 48);
    const Result clear = run(QByteArray("animate wind.ifs -o a/clear.mp4 --background transparent") + small);
    QCOMPARE(clear.status, 0);
    QVERIFY(clear.err.contains("transparency"));
    QCOMPARE(run("animate wind.ifs -o a/odd.webm --size 63x47 --points 20000").err, QByteArray());
    QCOMPARE(probe("a/odd.webm")[QLatin1String("width")].toInt(), 63);
    const Result fast = run(QByteArray("animate wind.ifs -o a/fast.gif --fps 60") + small);
    QCOMPARE(fast.status, 3);
    QVERIFY(fast.err.contains("50 frames per second"));
    QVERIFY(!QFile::exists(path("a/fast.gif")));
}

void CliVideoTest::encodeWritesTheSameBytes_data() {
    formats();
}

void CliVideoTest::encodeWritesTheSameBytes() {
    QFETCH(QByteArray, suffix);
    for (const QByteArray& options : {QByteArray(), QByteArray("--background transparent")}) {
        const QByteArray all = small + options;
        QCOMPARE(run("animate wind.ifs --entry wind -o a/f.###.png --existing replace" + all).status, 0);
        QCOMPARE(run("animate wind.ifs --entry wind -o a/v." + suffix + all).status, 0);
        QCOMPARE(run("animate wind.ifs --entry wind -o b/v." + suffix + " --threads 1" + all).status, 0);
        qputenv("MALLOC_PERTURB_", "85"); // memory that nobody has written is something else
        QCOMPARE(run("encode a/f.###.png -o c/v." + suffix).status, 0);
        qunsetenv("MALLOC_PERTURB_");
        QVERIFY(!read("a/v." + suffix).isEmpty());
        QCOMPARE(read("b/v." + suffix), read("a/v." + suffix));
        QCOMPARE(read("c/v." + suffix), read("a/v." + suffix));
    }
}

void CliVideoTest::videosOpenAsTheirAnimation_data() {
    formats();
}

void CliVideoTest::videosOpenAsTheirAnimation() {
    QFETCH(QByteArray, suffix);
    QCOMPARE(run("animate wind.ifs --entry once -o a/v." + suffix + small).status, 0);
    const Result file = run("info --json a/v." + suffix);
    QCOMPARE(file.status, 0);
    const QJsonObject video = file.entry(), entry = run("info --json wind.ifs --entry once").entry();
    QVERIFY(!entry.isEmpty());
    QCOMPARE(video, entry);
    // And is played from it again.
    QCOMPARE(run("animate a/v." + suffix + " -o b/v." + suffix + small).status, 0);
    QCOMPARE(read("b/v." + suffix), read("a/v." + suffix));
    write("a/cut." + suffix, read("a/v." + suffix).first(40));
    QVERIFY(run("info a/cut." + suffix).status != 0);
}

void CliVideoTest::gifsKeepOnePalette() {
    QCOMPARE(run(QByteArray("animate wind.ifs --entry wind -o a/v.gif") + small).status, 0);
    const QByteArray bytes = read("a/v.gif");
    QVERIFY((bytes[10] & 0x80) != 0); // one for all
    QSet<QRgb> palette;
    for (int n = 0; n < 2 << (bytes[10] & 7); ++n) {
        const auto at = [&bytes, n](int k) { return uchar(bytes[13 + 3 * n + k]); };
        palette << qRgb(at(0), at(1), at(2));
    }
    QList<QImage> images;
    for (int k = 0; k < 6; ++k)
        images << frame("a/v.gif", k);
    QVERIFY(frame("a/v.gif", 6).isNull()); // there are no more
    for (const QImage& image : images) {
        QCOMPARE(image.size(), QSize(64, 48));
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                QVERIFY(palette.contains(image.pixel(x, y) | 0xff000000));
    }
    // What does not move does not change: the dither stays where it is on the screen.
    const QImage &first = images[0], &second = images[1];
    for (const QPoint corner : {QPoint(0, 0), QPoint(63, 0), QPoint(1, 1)})
        QCOMPARE(first.pixel(corner), second.pixel(corner));
}

// What rests below does not change while something moves above it, in more colours than there are.
void CliVideoTest::theDitherOfGifsStaysInPlace() {
    constexpr int width = 64, height = 48;
    QList<QImage> sources;
    for (int n = 1; n <= 3; ++n) {
        QImage image(width, height, QImage::Format_RGB32);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int moved = y < height / 2 ? (x + 9 * n) % width : x;
                image.setPixel(x, y, qRgb(4 * moved, 5 * y, (7 * moved + 3 * y) % 256));
            }
        QVERIFY(image.save(path("b/f." + QByteArray::number(n) + ".png")));
        sources << image;
    }
    QCOMPARE(run("encode b/f.#.png -o a/v.gif").status, 0);
    const auto half = [](const QImage& image, int top) {
        return image.copy(0, top, width, height / 2).convertToFormat(QImage::Format_RGB32);
    };
    const QImage first = frame("a/v.gif", 0);
    QCOMPARE(first.size(), QSize(width, height));
    QVERIFY(half(first, height / 2) != half(sources[0], height / 2)); // it is dithered
    for (const int n : {1, 2}) {
        const QImage image = frame("a/v.gif", n);
        QCOMPARE(half(image, height / 2), half(first, height / 2));
        QVERIFY(half(image, 0) != half(first, 0));
    }
}

void CliVideoTest::aRateIsKept() {
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/v.mp4 --fps 30000/1001 --frames 1-4") + small).status, 0);
    QCOMPARE(probe("a/v.mp4")[QLatin1String("r_frame_rate")].toString(), QStringLiteral("30000/1001"));
    QCOMPARE(probe("a/v.mp4")[QLatin1String("nb_read_frames")].toString(), QStringLiteral("4"));
    QCOMPARE(run(QByteArray("animate wind.ifs -o b/f.#.png") + small).status, 0);
    QCOMPARE(run("encode b/f.#.png -o a/v.mkv --fps 12.5").status, 0);
    QCOMPARE(probe("a/v.mkv")[QLatin1String("r_frame_rate")].toString(), QStringLiteral("25/2"));
}

void CliVideoTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    for (const char* arguments :
         {"animate wind.ifs -o a/v.#.mp4", "animate wind.ifs -o a/v.avi",
          "animate wind.ifs -o a/v.mp4 --chunk 0/2", "animate wind.ifs -o a/v.mp4 --existing skip",
          "animate wind.ifs -o a/v.mp4 --bits 16", "animate wind.ifs -o a/v.mp4 --dpi 300",
          "animate wind.ifs -o a/v.mp4 --fps 0", "animate wind.ifs -o a/v.mp4 --fps 1/0",
          "animate wind.ifs -o a/v.mp4 --fps 2000", "animate wind.ifs -o a/v.mp4 --fps fast",
          "animate wind.ifs -o a/f.#.png --fps 24", "animate wind.ifs -o a/f.#.png --shutter 361",
          "animate wind.ifs -o a/f.#.png --shutter -1", "animate wind.ifs -o a/f.#.png --exposure bright",
          "encode a/f.png -o a/v.mp4", "encode a/f.#.png -o a/v.avi", "encode a/f.#.png",
          "encode a/f.#.png -o a/v.mp4 --fps -3"})
        QTest::newRow(arguments) << QByteArray(arguments);
}

void CliVideoTest::wrongUsageIsRefused() {
    QFETCH(QByteArray, arguments);
    const Result result = run(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY(!result.err.isEmpty());
    QVERIFY(files("a").isEmpty());
}

void CliVideoTest::existingVideosCanBeRefused() {
    write("a/v.mkv", "mine");
    const Result result = run(QByteArray("animate wind.ifs -o a/v.mkv --existing fail") + small);
    QCOMPARE(result.status, 3);
    QVERIFY(result.err.contains("exists already"));
    QCOMPARE(read("a/v.mkv"), QByteArray("mine"));
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/v.mkv") + small).status, 0);
    QVERIFY(read("a/v.mkv") != "mine");
}

void CliVideoTest::killedAtAnyTimeLeavesWholeFiles_data() {
    QTest::addColumn<QByteArray>("command"); // to a/v.SUFFIX
    for (const char* suffix : {"mp4", "gif", "webp"}) {
        QTest::addRow("animate %s", suffix)
            << QByteArray("animate wind.ifs --entry once --size 240x180 --points 300000 -o a/v.") + suffix;
        QTest::addRow("encode %s", suffix) << QByteArray("encode b/f.#.png -o a/v.") + suffix;
    }
}

void CliVideoTest::killedAtAnyTimeLeavesWholeFiles() {
    QFETCH(QByteArray, command);
    QCOMPARE(run("animate wind.ifs --entry once -o b/f.#.png --size 240x180 --points 300000").status, 0);
    QCOMPARE(run(command).status, 0);
    const QStringList whole = files("a");
    const QByteArray bytes = read("a/" + whole.first().toUtf8());
    const bool isNew = QFile::remove(path("a/" + whole.first().toUtf8()));
    QVERIFY(isNew);
    QRandomGenerator random(5);
    for (int n = 0; n < (support::isThorough() ? 8 : 3); ++n) {
        QProcess process;
        start(process, command);
        QVERIFY(process.waitForStarted());
        process.waitForFinished(20 + random.bounded(300));
        process.kill();
        process.waitForFinished();
        for (const QString& file : files("a"))
            QVERIFY2(whole.contains(file) && read("a/" + file.toUtf8()) == bytes, qPrintable(file));
    }
}

void CliVideoTest::anInterruptLeavesNothing() {
    QProcess process;
    start(process, "animate wind.ifs -o a/v.webm --size 640x480 --points 1e12 --progress always");
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 60'000);
    QVERIFY(process.state() == QProcess::Running && process.processId() > 0);
    QCOMPARE(::kill(pid_t(process.processId()), SIGINT), 0);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(process.readAllStandardError().contains("Interrupted"));
    QVERIFY(files("a").isEmpty());
}

void CliVideoTest::aFullDiskLeavesNothing_data() {
    formats();
}

// A limit on the size of files is met where a full disk is.
void CliVideoTest::aFullDiskLeavesNothing() {
    QFETCH(QByteArray, suffix);
    const QByteArray command =
        "animate wind.ifs --entry once --size 160x120 --points 300000 -o a/v." + suffix;
    QProcess process;
    start(process, command);
    process.waitForFinished();
    QVERIFY(read("a/v." + suffix).size() > 8192);
    QVERIFY(QFile::remove(path("a/v." + suffix)));
    QProcess limited;
    limited.setWorkingDirectory(path(""));
    limited.start(QStringLiteral("bash"),
                  {QStringLiteral("-c"),
                   QStringLiteral("ulimit -f 4 && exec \"$0\" ") + QString::fromUtf8(command),
                   support::buildPath(QStringLiteral("barycage-cli"))});
    QVERIFY(limited.waitForFinished(60'000));
    QCOMPARE(limited.exitStatus(), QProcess::NormalExit);
    QCOMPARE(limited.exitCode(), 3);
    QVERIFY(!limited.readAllStandardError().isEmpty());
    QVERIFY(files("a").isEmpty());
}

BARYCAGE_TEST(CliVideoTest, QGuiApplication);
#include "cli_video_test.moc"
