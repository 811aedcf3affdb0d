// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTest>

// What a file manager calls for a file that nobody chose to open: the command in
// resources/linux/thumbnailer.in, and the limits of time and memory that it sets.
class CliThumbnailerTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void limitsItself();
    void drawsAThumbnail_data();
    void drawsAThumbnail();
    void endsInTime_data();
    void endsInTime();
    void waitingEndsInTime();
    void severalPicturesEndInTime();
    void endsWithinItsMemory();
    void limitsThatAreNone();

private:
    QByteArray command(const QByteArray& file, const QByteArray& output, int side) const;
};

namespace {

QByteArray exec() {
    QFile file(support::sourcePath(QStringLiteral("resources/linux/thumbnailer.in")));
    if (!file.open(QIODevice::ReadOnly)) return {};
    for (const QByteArray& line : file.readAll().split('\n'))
        if (line.startsWith("Exec=")) return line.mid(5);
    return {};
}

} // namespace

// As the desktop would call it, without the name of the program.
QByteArray CliThumbnailerTest::command(const QByteArray& file, const QByteArray& output, int side) const {
    QByteArray line = exec();
    line.replace("%i", file).replace("%o", output).replace("%s", QByteArray::number(side));
    return line.mid(line.indexOf(' ') + 1);
}

void CliThumbnailerTest::limitsItself() {
    const QByteArray line = exec();
    QVERIFY2(line.startsWith("barycage-cli render %i -o %o "), line.constData());
    QVERIFY2(line.contains(" --time-limit 5 "), line.constData());
    QVERIFY2(line.contains(" --memory-limit 256 "), line.constData());
}

void CliThumbnailerTest::drawsAThumbnail_data() {
    QTest::addColumn<int>("side");
    for (const int side : {128, 256, 512, 1024}) // as the specification of thumbnails has them
        QTest::addRow("%d pixels", side) << side;
}

void CliThumbnailerTest::drawsAThumbnail() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("a sanitizer takes more memory than the limit");
#endif
    QFETCH(int, side);
    for (const char* file : {"systems.ifs", "broken.ifs"}) {
        QFile::remove(path("thumbnail"));
        const Result result = runProgram(command(file, "thumbnail", side));
        QVERIFY2(result.status == 0, result.err.constData());
        QCOMPARE(QImage(path("thumbnail"), "PNG").size(), QSize(side, side));
    }
    if (side != 256 && !support::isThorough()) return;
    QDir library(support::sourcePath(QStringLiteral("ifs_library")));
    for (const QString& file : library.entryList({QStringLiteral("*.ifs")})) {
        const QByteArray source = '"' + library.filePath(file).toUtf8() + '"';
        QVERIFY2(runProgram(command(source, "thumbnail", side)).status == 0, qPrintable(file));
    }
}

void CliThumbnailerTest::endsInTime_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::newRow("samples") << QByteArray("--points 1e14");
    QTest::newRow("resumed") << QByteArray("--resume part.sum --points 1e14");
}

// Long before the work is done, with nothing left.
void CliThumbnailerTest::endsInTime() {
    QFETCH(QByteArray, options);
    QCOMPARE(runProgram("render systems.ifs -o part.sum --size 40x30 --points 10000").status, 0);
    const QByteArray file = options.contains("--resume") ? "" : "systems.ifs ";
    const QStringList before = QDir(path("")).entryList(QDir::AllEntries | QDir::Hidden | QDir::System);
    QElapsedTimer timer;
    timer.start();
    const Result result = runProgram("render " + file + "-o late.png --time-limit 0.5 " + options);
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("The time limit has passed"), result.err.constData());
    QCOMPARE(QDir(path("")).entryList(QDir::AllEntries | QDir::Hidden | QDir::System), before);
}

// Nothing looks at a stop request while it waits for a file to end.
void CliThumbnailerTest::waitingEndsInTime() {
    QProcess process;
    start(process, "render - -o late.png --time-limit 0.5");
    QVERIFY(process.waitForStarted());
    process.write("fern {\n");
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 3);
    QVERIFY(process.readAllStandardError().contains("The time limit has passed"));
}

void CliThumbnailerTest::severalPicturesEndInTime() {
    const QByteArray all = "render systems.ifs --entry maple --entry Fern -o x-%e.png --size 40x30 ";
    const Result result = runProgram(all + "--time-limit 0.5 --points 1e14");
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("nothing was written"), result.err.constData());
    QCOMPARE(runProgram(all + "--time-limit 600 --points 1e4").status, 0);
    QVERIFY(QFile::exists(path("x-maple.png")) && QFile::exists(path("x-Fern.png")));
}

void CliThumbnailerTest::endsWithinItsMemory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("a sanitizer takes more memory than the limit");
#endif
    QByteArray large = "large {\n";
    while (large.size() < 120'000'000)
        large += "; nothing but words, and never an end of them, in a line of its own\n";
    write("large.ifs", large + " .5 0 0 .5 0 0 1\n}\n");
    large.clear();
    const Result result = runProgram("render large.ifs -o large.png --size 40x30 --memory-limit 64");
    QVERIFY(QFile::remove(path("large.ifs")));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("not enough memory"), result.err.constData());
    QVERIFY(!QFile::exists(path("large.png")));
}

void CliThumbnailerTest::limitsThatAreNone() {
    const QByteArray render = "render systems.ifs -o limit.png --size 40x30 --points 1000 ";
    for (const char* wrong : {"--time-limit 0", "--time-limit -1", "--time-limit soon", "--time-limit 1e7",
                              "--memory-limit 0", "--memory-limit 63", "--memory-limit much"})
        QCOMPARE(runProgram(render + wrong).status, 2);
    QVERIFY(!QFile::exists(path("limit.png")));
    QCOMPARE(runProgram(render + "--time-limit 600 --memory-limit 1000").status, 0);
}

BARYCAGE_TEST(CliThumbnailerTest, QGuiApplication);
#include "cli_thumbnailer_test.moc"
