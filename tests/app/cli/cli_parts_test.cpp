// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>
#include <QTest>

// barycage-cli render --part, --band and --resume, and merge.
class CliPartsTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void partsMergeToTheSameBytes();
    void partsMergeToEveryKindOfFile_data();
    void partsMergeToEveryKindOfFile();
    void bandsMergeToTheSameBytes();
    void picturesInSpaceMergeToTheSameBytes_data();
    void picturesInSpaceMergeToTheSameBytes();
    void solidsAreDividedInBandsAlone();
    void aPartIsTheSameForAnyThreadsAndInstructions();
    void aPictureIsResumed();
    void aPartIsNotMergedTwice();
    void aTransparentPictureIsNotMergedToJpeg();
    void dryRunsSayWhatIsWrong_data();
    void dryRunsSayWhatIsWrong();
    void whatMakesNoSenseIsRefused_data();
    void whatMakesNoSenseIsRefused();
    void killedAtAnyTimeLeavesWholeFiles_data();
    void killedAtAnyTimeLeavesWholeFiles();
};

namespace {
const QByteArray maple = "systems.ifs --entry maple --size 240x180 --points 20M ";
const QByteArray pyramid = "pyramid (3D) {\n"
                           ".5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n"
                           ".5 0 0 0 .5 0 0 0 .5 .5 0 0 .25\n"
                           ".5 0 0 0 .5 0 0 0 .5 0 .5 0 .25\n"
                           ".5 0 0 0 .5 0 0 0 .5 0 0 .5 .25\n"
                           "}\n";
} // namespace

void CliPartsTest::partsMergeToTheSameBytes() {
    QCOMPARE(run("render " + maple + "-o whole.png").status, 0);
    for (const char* part : {"0", "1", "2"})
        QCOMPARE(run("render " + maple + "--part " + part + "/3 -o p" + part + ".sum").status, 0);
    const Result merged = run("merge p2.sum p0.sum p1.sum -o merged.png");
    QCOMPARE(merged.err, QByteArray());
    QCOMPARE(merged.status, 0);
    QVERIFY(!read("whole.png").isEmpty());
    QVERIFY(read("merged.png") == read("whole.png"));
}

void CliPartsTest::partsMergeToEveryKindOfFile_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("options");
    for (const char* suffix : {"png", "webp", "tiff", "tif", "exr", "JPG"})
        QTest::newRow(suffix) << "." + QByteArray(suffix) << QByteArray();
    QTest::newRow("jpeg of a quality") << QByteArray(".jpeg") << QByteArray(" --quality 40");
}

void CliPartsTest::partsMergeToEveryKindOfFile() {
    QFETCH(const QByteArray, name);
    QFETCH(const QByteArray, options);
    const QByteArray small = "systems.ifs --entry maple --size 60x45 --points 20M ";
    QCOMPARE(run("render " + small + "-o whole" + name + options).status, 0);
    for (const char* part : {"0", "1"})
        QCOMPARE(run("render " + small + "--part " + part + "/2 -o p" + part + ".sum").status, 0);
    const Result merged = run("merge p0.sum p1.sum -o merged" + name + options);
    QCOMPARE(merged.err, QByteArray());
    QCOMPARE(merged.status, 0);
    QVERIFY(!read("whole" + name).isEmpty());
    QVERIFY(read("merged" + name) == read("whole" + name));
    QCOMPARE(run("merge p0.sum p1.sum -o all.sum").status, 0);
    QCOMPARE(run("render --resume all.sum --points 21M -o more" + name + options).status, 0);
    QVERIFY(!read("more" + name).isEmpty());
}

void CliPartsTest::bandsMergeToTheSameBytes() {
    QCOMPARE(run("render " + maple + "-o whole.png").status, 0);
    QCOMPARE(run("render " + maple + "--band 0/2 -o top.sum").status, 0);
    QCOMPARE(run("render " + maple + "--band 1/2 --part 0/2 -o left.sum").status, 0);
    QCOMPARE(run("render " + maple + "--band 1/2 --part 1/2 -o right.sum").status, 0);
    QCOMPARE(run("merge left.sum right.sum -o bottom.sum").status, 0);
    QCOMPARE(run("merge top.sum bottom.sum -o merged.png").status, 0);
    QVERIFY(read("merged.png") == read("whole.png"));
}

void CliPartsTest::picturesInSpaceMergeToTheSameBytes_data() {
    QTest::addColumn<QByteArray>("look");
    QTest::addColumn<QByteArray>("division"); // of the first file and the second
    QTest::newRow("cloud") << QByteArray("cloud --points 20M --colour map") << QByteArray("--part");
    QTest::newRow("x-ray") << QByteArray("x-ray --points 20M") << QByteArray("--part");
    QTest::newRow("cloud in bands") << QByteArray("cloud --points 20M") << QByteArray("--band");
    QTest::newRow("stone") << QByteArray("stone --fog 1 --light 10,20") << QByteArray("--band");
    QTest::newRow("ink on a ground") << QByteArray("ink --background #0d1017") << QByteArray("--band");
    QTest::newRow("depth") << QByteArray("depth") << QByteArray("--band");
}

void CliPartsTest::picturesInSpaceMergeToTheSameBytes() {
    QFETCH(const QByteArray, look);
    QFETCH(const QByteArray, division);
    write("pyramid.ifs", pyramid);
    const QByteArray call =
        "render pyramid.ifs --size 200x150 --orbit 40,25 --perspective 40 --rest-cage box "
        "--slice 1,1,0,.9 --look " +
        look + " ";
    QCOMPARE(run(call + "-o whole.png").status, 0);
    for (const char* part : {"0", "1"}) {
        const Result drawn = run(call + division + " " + part + "/2 -o p" + part + ".sum");
        QCOMPARE(drawn.err, QByteArray());
        QCOMPARE(drawn.status, 0);
    }
    const Result merged = run("merge p1.sum p0.sum -o merged.png");
    QCOMPARE(merged.err, QByteArray());
    QCOMPARE(merged.status, 0);
    QVERIFY(!read("whole.png").isEmpty());
    QVERIFY(read("merged.png") == read("whole.png"));
}

void CliPartsTest::solidsAreDividedInBandsAlone() {
    write("pyramid.ifs", pyramid);
    const QByteArray call = "render pyramid.ifs --size 80x60 ";
    const Result part = run(call + "--look stone --part 0/2 -o p.sum");
    QCOMPARE(part.status, 2);
    QVERIFY(part.err.contains("--band"));
    const Result eyes = run(call + "--look cloud --stereo anaglyph --part 0/2 -o p.sum");
    QCOMPARE(eyes.status, 2);
    QVERIFY(eyes.err.contains("--stereo"));
    QVERIFY(!QFile::exists(path("p.sum")));
    QCOMPARE(run(call + "--look stone -o all.sum").status, 0);
    const Result more = run("render --resume all.sum --points 1M -o more.png");
    QCOMPARE(more.status, 2);
    QVERIFY(more.err.contains("samples"));
    const Result deep = run("merge all.sum -o x.exr");
    QCOMPARE(deep.status, 2);
    QVERIFY(deep.err.contains("8 bits"));
    QCOMPARE(run("merge all.sum -o x.webp").status, 0);
}

void CliPartsTest::aPartIsTheSameForAnyThreadsAndInstructions() {
    QCOMPARE(run("render " + maple + "--part 1/2 --threads 1 -o a.sum").status, 0);
    QCOMPARE(run("render " + maple + "--part 1/2 --threads 3 --simd scalar -o b.sum").status, 0);
    QVERIFY(!read("a.sum").isEmpty());
    QVERIFY(read("a.sum") == read("b.sum"));
}

void CliPartsTest::aPictureIsResumed() {
    QCOMPARE(run("render " + maple + "-o all.sum").status, 0);
    QCOMPARE(run("render --resume all.sum --points 30M -o more.png").status, 0);
    QCOMPARE(run("render --resume all.sum --points 30M --part 0/2 -o m0.sum").status, 0);
    QCOMPARE(run("render --resume all.sum --points 30M --part 1/2 -o m1.sum").status, 0);
    QCOMPARE(run("merge m0.sum m1.sum all.sum -o merged.png").status, 0);
    QVERIFY(read("merged.png") == read("more.png"));
    // Into its own file.
    QCOMPARE(run("render --resume all.sum --points 30M -o all.sum").status, 0);
    QCOMPARE(run("merge all.sum -o again.png").status, 0);
    QVERIFY(read("again.png") == read("more.png"));
}

void CliPartsTest::aPartIsNotMergedTwice() {
    QCOMPARE(run("render " + maple + "--part 0/2 -o p0.sum").status, 0);
    const Result twice = run("merge p0.sum p0.sum -o x.sum");
    QCOMPARE(twice.status, 1);
    QVERIFY(twice.err.contains("counted twice"));
    const Result half = run("merge p0.sum -o x.png");
    QCOMPARE(half.status, 1);
    QVERIFY(half.err.contains("50 %"));
    write("x.sum", "BaryCSum and then nothing of the kind");
    const Result damaged = run("merge x.sum -o x.png");
    QCOMPARE(damaged.status, 1);
    QVERIFY(damaged.err.contains("x.sum"));
    QCOMPARE(run("merge absent.sum -o x.png").status, 3);
    QVERIFY(!QFile::exists(path("x.png")));
}

void CliPartsTest::aTransparentPictureIsNotMergedToJpeg() {
    QCOMPARE(run("render " + maple + "--background transparent -o all.sum").status, 0);
    const Result merged = run("merge all.sum -o x.jpg");
    QCOMPARE(merged.status, 2);
    QVERIFY(merged.err.contains("transparent"));
    QVERIFY(!QFile::exists(path("x.jpg")));
}

void CliPartsTest::dryRunsSayWhatIsWrong_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* arguments, int status, const char* says) {
        QTest::newRow(arguments) << QByteArray(arguments) << status << QByteArray(says);
    };
    // As submit-picture.sh and submit-animation.sh ask before any task begins.
    row("render systems.ifs --entry maple --part 0/3 -o dry/0.sum", 0, "");
    row("render pyramid.ifs --band 0/3 -o dry/0.sum", 0, "");
    row("render systems.ifs --entry maple -o dry/a.png --points 1e15", 0, "");
    row("render pyramid.ifs -o dry/a.png --size 4000x4000", 0, "");
    row("render systems.ifs --entry absent --part 0/3 -o dry/0.sum", 1, "absent");
    row("render systems.ifs --entry maple --part 0/3 -o dry/0.png", 2, ".sum");
    row("render systems.ifs --entry maple --part 0/3 -o dry/0.sum --points many", 2, "many");
    row("render pyramid.ifs --part 0/3 -o dry/0.sum", 2, "--band");
    row("render none.ifs -o dry/a.png", 3, "none.ifs");
    row("encode -o dry/a.mkv --frames all --fps 24 -- dry/######.png", 0, "");
    row("encode -o dry/a.mkv --frames 1-5 -- dry/######.png", 0, "");
    row("encode -o dry/a.mkv --fps 3O -- dry/######.png", 2, "3O");
    row("encode -o dry/a.avi -- dry/######.png", 2, "a.avi");
    row("encode -o dry/a.mkv -- dry/a.png", 2, "#");
}

// And draw nothing, however long it would take.
void CliPartsTest::dryRunsSayWhatIsWrong() {
    QFETCH(const QByteArray, arguments);
    QFETCH(const int, status);
    QFETCH(const QByteArray, says);
    write("pyramid.ifs", pyramid);
    const QDir dry(path("dry"));
    QVERIFY(dry.mkpath(QStringLiteral(".")));
    const qsizetype options = arguments.contains(" -- ") ? arguments.indexOf(" -- ") : arguments.size();
    const Result result = run(QByteArray(arguments).insert(options, " --dry-run"));
    QVERIFY2(result.status == status && result.err.contains(says), result.err.constData());
    QVERIFY(status != 0 || result.err.isEmpty());
    QVERIFY(dry.isEmpty());
}

void CliPartsTest::whatMakesNoSenseIsRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("sentence");
    const auto row = [](const char* name, const QByteArray& arguments, const char* sentence) {
        QTest::newRow(name) << arguments << QByteArray(sentence);
    };
    row("beyond", "render " + maple + "--part 3/3 -o x.sum", "i counts from 0");
    row("no numbers", "render " + maple + "--part half -o x.sum", "write i/n");
    row("a picture", "render " + maple + "--part 0/2 -o x.png", ".sum");
    row("bands", "render " + maple + "--band 0/2 -o x.png", ".sum");
    row("many bands", "render " + maple + "--band 1/999 -o x.sum", "no rows");
    row("chaos game", "render " + maple + "--part 0/2 --algorithm chaos-game -o x.sum", "--algorithm");
    row("no points", "render --resume all.sum -o x.png", "--points");
    row("two sources", "render systems.ifs --resume all.sum --points 1e9 -o x.png", "--resume");
    row("another size", "render --resume all.sum --size 10x10 --points 1e9 -o x.png", "--size");
    row("merged to shapes", "merge a.sum -o x.svg", ".exr or .sum");
    row("resumed to shapes", "render --resume a.sum --svg points --points 1000 -o x.svg", "made of pixels");
    row("overlay on it", "render --resume a.sum --points 1e9 --overlay cage -o x.png", "--overlay cannot");
    row("legend beside it", "render --resume a.sum --points 1e9 --legend -o x.png", "--legend cannot");
    row("frame of it", "render --resume a.sum --points 1e9 --frame 3 -o x.png", "--frame cannot");
    row("quality of sums", "merge a.sum -o x.sum --quality 50", "only to .jpg and .webp");
    row("quality of a PNG", "merge a.sum -o x.png --quality 50", "only to .jpg and .webp");
}

void CliPartsTest::whatMakesNoSenseIsRefused() {
    QFETCH(const QByteArray, arguments);
    QFETCH(const QByteArray, sentence);
    const Result result = run(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(sentence), result.err.constData());
}

void CliPartsTest::killedAtAnyTimeLeavesWholeFiles_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("picture") << QByteArray("all.png");
    QTest::newRow("sums") << QByteArray("all.sum");
}

// kill −9 at any time leaves the file that was there or the new one, never a part of it.
void CliPartsTest::killedAtAnyTimeLeavesWholeFiles() {
    QFETCH(const QByteArray, name);
    const QByteArray large = "systems.ifs --entry maple --size 1200x900 --points 20M ";
    for (const char* part : {"0", "1"})
        QCOMPARE(run("render " + large + "--part " + part + "/2 -o p" + part + ".sum").status, 0);
    QDir(path("killed")).removeRecursively();
    QDir().mkpath(path("killed"));
    const QByteArray command = "merge p0.sum p1.sum -o killed/" + name;
    QElapsedTimer clock;
    clock.start();
    QCOMPARE(run("merge p0.sum p1.sum -o whole-" + name).status, 0);
    const int duration = int(clock.elapsed()) + 1;
    const QByteArray whole = read("whole-" + name);
    QVERIFY(!whole.isEmpty());
    QRandomGenerator random(5);
    for (int n = 0; n < 16; ++n) {
        write("killed/" + name, "old");
        QProcess process;
        start(process, command);
        QVERIFY(process.waitForStarted());
        process.waitForFinished(random.bounded(duration));
        process.kill();
        process.waitForFinished();
        const QStringList files =
            QDir(path("killed")).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot);
        QVERIFY(files.contains(QString::fromUtf8(name)));
        for (const QString& file : files) {
            const QByteArray left = read("killed/" + file.toUtf8());
            QVERIFY2(left == "old" || left == whole, qPrintable(file));
        }
    }
    QCOMPARE(run(command).status, 0);
    QVERIFY(read("killed/" + name) == whole);
}

BARYCAGE_TEST(CliPartsTest, QGuiApplication);
#include "cli_parts_test.moc"
