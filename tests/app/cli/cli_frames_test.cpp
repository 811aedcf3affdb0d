// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>

#include <vector>

// What the frames of barycage-cli animate are asked for, and how long the others will take.
class CliFramesTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void everyOptionIsAnotherRequest();
    void everyOptionInSpaceIsAnotherRequest();
    void noOptionIsForgotten();
    void framesHave16Bits();
    void theTimeLeftIsSaid();
    void aFullDiskNamesTheFrame_data();
    void aFullDiskNamesTheFrame();

private:
    void verifyAllDiffer(const QByteArray& file, const std::vector<const char*>& options);
};

namespace {

// No two of them ask for the same frame.
const std::vector<const char*> inPlane{
    "--size 48x36 --points 20000",
    "--size 49x36 --points 20000",
    "--size 48x37 --points 20000",
    "--size 48x36 --points 20001",
    "--size 48x36 --points 20000 --seed 2",
    "--size 48x36 --points 20000 --gamma 3",
    "--size 48x36 --points 20000 --brightness 9",
    "--size 48x36 --points 20000 --contrast 2",
    "--size 48x36 --points 20000 --vibrancy 0.5",
    "--size 48x36 --points 20000 --shadow 0.5",
    "--size 48x36 --points 20000 --shadow 0.5 --shadow-lean 2",
    "--size 48x36 --points 20000 --shadow 0.5 --shadow-length -0.4",
    "--size 48x36 --points 20000 --margin 6",
    "--size 48x36 --points 20000 --background black",
    "--size 48x36 --points 20000 --palette Fern",
    "--size 48x36 --points 20000 --colour map",
    "--size 48x36 --points 20000 --bits 16",
    "--size 48x36 --points 20000 --supersample 2",
    "--size 48x36 --points 20000 --dpi 300",
    "--size 48x36 --points 20000 --shutter 180",
    "--size 48x36 --points 20000 --exposure each",
    "--size 48x36 --points 20000 --exposure fixed",
    "--size 48x36 --points 20000 --view 0,5,12",
    "--size 48x36 --points 20000 --view 0,5,13",
    "--size 48x36 --points 20000 --view-rotation 30",
    "--size 48x36 --points 20000 --y-down",
};
const std::vector<const char*> inSpace{
    "",
    "--orbit 10,20",
    "--view 0.5,0.5,0.5,2",
    "--perspective 40",
    "--look stone",
    "--look normals",
    "--look stone --light 60,0",
    "--look stone --fog 0.5",
    "--slice 0,0,1,0.5",
    "--perspective 40 --stereo anaglyph",
    "--perspective 40 --stereo side-by-side",
    "--background black",
};

} // namespace

void CliFramesTest::init() {
    const QByteArray maps = " -0.04 0 -0.23 -0.65 -0.08 0.26 .25\n 0.61 0 0 0.31 0.07 3.5 .25\n"
                            " 0.65 0.29 -0.3 0.48 0.74 0.39 .25\n 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\n}\n";
    const auto wind = [&](const QByteArray& header) {
        return "wind {\n; barycage: animation " + header +
               "\n; barycage: motion sway\n; barycage: strength 4\n; barycage: pivot 0 0\n"
               "; barycage: wave 1\n; barycage: value 1 0 25\n" +
               maps;
    };
    write("wind.ifs", wind("6 24/1 cycle"));
    write("long.ifs", wind("3000 24/1 cycle"));
    QByteArray cube = "cube (3D) {\n; barycage: animation 4 24/1 cycle\n; barycage: motion orbit\n"
                      "; barycage: count 1\n; barycage: pivot 0 0 0\n";
    for (int k = 0; k < 4; ++k)
        cube += ".5 0 0 0 .5 0 0 0 .5 " + QByteArray(k & 1 ? ".5 " : "0 ") + (k & 2 ? ".5 " : "0 ") +
                (k == 3 ? ".5 1\n" : "0 1\n");
    write("cube.ifs", cube + "}\n");
}

void CliFramesTest::verifyAllDiffer(const QByteArray& file, const std::vector<const char*>& options) {
    QSet<QString> requests;
    for (const char* option : options) {
        const Result result = run("animate " + file + " -o f.#.png --existing replace " + option);
        QVERIFY2(result.status == 0, (QByteArray(option) + ": " + result.err).constData());
        const QString request = QImage(path("f.1.png")).text(QStringLiteral("barycage:request"));
        QCOMPARE(request.size(), 64);
        QVERIFY2(!requests.contains(request), option);
        requests << request;
    }
}

void CliFramesTest::everyOptionIsAnotherRequest() {
    verifyAllDiffer("wind.ifs --frames 1", inPlane);
}

void CliFramesTest::everyOptionInSpaceIsAnotherRequest() {
    verifyAllDiffer("cube.ifs --frames 1 --size 48x36", inSpace);
}

// What no frame looks different for is marked so in the table, and every other option is in a list above.
void CliFramesTest::noOptionIsForgotten() {
    const Result described = run("--describe frames");
    QCOMPARE(described.status, 0);
    QByteArray tried;
    for (const auto& options : {inPlane, inSpace})
        for (const char* option : options)
            tried += QByteArray(option) + ' ';
    const QByteArrayList all = described.out.trimmed().split('\n');
    QVERIFY(all.size() > 20);
    for (const QByteArray& name : all)
        QVERIFY2(tried.contains(name + ' '), name.constData());
}

void CliFramesTest::framesHave16Bits() {
    QCOMPARE(run("animate wind.ifs -o deep.#.png --frames 1-2 --size 48x36 --points 20000 --bits 16").status,
             0);
    QCOMPARE(run("animate wind.ifs -o flat.#.png --frames 1-2 --size 48x36 --points 20000").status, 0);
    for (const char* number : {"1", "2"}) {
        const QImage deep(path(QByteArray("deep.") + number + ".png"));
        QCOMPARE(deep.depth(), 64);
        QCOMPARE(QImage(path(QByteArray("flat.") + number + ".png")).depth(), 32);
        bool isFine = false; // not 8 bits twice over
        for (int y = 0; y < deep.height(); ++y)
            for (int x = 0; x < deep.width(); ++x)
                isFine = isFine || deep.pixelColor(x, y).rgba64().red() % 257 != 0;
        QVERIFY(isFine);
    }
}

// Once it can be told.
void CliFramesTest::theTimeLeftIsSaid() {
    QProcess process;
    start(process, "animate long.ifs -o long.####.png --size 320x240 --points 2000000 --progress always");
    QVERIFY(process.waitForStarted());
    QByteArray said;
    static const QRegularExpression left(QStringLiteral(", (\\d+:)?\\d+:\\d\\d left"));
    QTRY_VERIFY_WITH_TIMEOUT(
        (said += process.readAllStandardError(), left.match(QString::fromUtf8(said)).hasMatch()), 240'000);
    QVERIFY(process.state() == QProcess::Running);
    process.kill();
    process.waitForFinished();
}

void CliFramesTest::aFullDiskNamesTheFrame_data() {
    QTest::addColumn<QByteArray>("frames");
    QTest::addColumn<QByteArray>("failed");
    QTest::newRow("the first of many") << QByteArray("1-4") << QByteArray("f.1.png");
    QTest::newRow("the last one") << QByteArray("3") << QByteArray("f.3.png");
}

// A frame is encoded while the next one is drawn: what fails then is said of the frame that it is about.
void CliFramesTest::aFullDiskNamesTheFrame() {
    QFETCH(const QByteArray, frames);
    QFETCH(const QByteArray, failed);
    const QByteArray command =
        "animate wind.ifs --size 320x240 --points 300000 -o full/f.#.png --frames " + frames;
    QDir(path("full")).removeRecursively(); // what the row before has drawn
    QProcess limited;
    limited.setWorkingDirectory(path(""));
    limited.start(QStringLiteral("bash"),
                  {QStringLiteral("-c"),
                   QStringLiteral("ulimit -f 4 && exec \"$0\" ") + QString::fromUtf8(command),
                   support::buildPath(QStringLiteral("barycage-cli"))});
    QVERIFY(limited.waitForFinished(60'000));
    const QByteArray said = limited.readAllStandardError();
    QCOMPARE(limited.exitStatus(), QProcess::NormalExit);
    QVERIFY2(limited.exitCode() == 3, said.constData());
    QVERIFY2(said.contains(failed) && said.count("error:") == 1, said.constData());
    QVERIFY(QDir(path("full")).entryList(QDir::Files | QDir::Hidden).isEmpty());
    QCOMPARE(run(command).status, 0); // and where there is room, all is well
    QVERIFY(QFile::exists(path("full/" + failed)));
}

BARYCAGE_TEST(CliFramesTest, QGuiApplication);
#include "cli_frames_test.moc"
