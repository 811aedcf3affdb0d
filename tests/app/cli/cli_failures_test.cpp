// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/faults.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <optional>

using support::Ended;
using support::FaultyProgram;
using support::Lasting;

// Every kind of file that barycage-cli writes, while each system call and each request for memory fails in
// turn: the old file is there or the new one, whole, and nothing else; the program ends with a sentence and
// status 3, or has written what it writes otherwise.
class CliFailuresTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void noThreadIsWaitedFor_data();
    void noThreadIsWaitedFor();
    void startsWithoutMemory();
    void fewOpenFilesEndNothingSuddenly();
    void everyFrameIsReadOrSaid();
    void everyFileIsOldOrNew_data();
    void everyFileIsOldOrNew();

private:
    using Files = QMap<QString, QByteArray>;

    void makeInputs() const;
    FaultyProgram program(QString command) const;
    std::optional<QByteArrayList> begin(const QString& command);
    void restore() const;
    void judge(const Ended& ended, const QByteArray& what) const;

    Files m_before;   // everything in the folder, with an old file under each name of an output
    Files m_expected; // when nothing fails
    QByteArray m_expectedOut;
};

void CliFailuresTest::everyFileIsOldOrNew_data() {
    QTest::addColumn<QString>("command"); // @ stands for the folder
    const auto row = [](const char* name, const char* command) {
        QTest::newRow(name) << QString::fromLatin1(command);
    };
    row("ifs", "convert @p.ifs @o.ifs --bake");
    row("strict", "convert @p.ifs @o.ifs --strict");
    row("flame", "convert @p.ifs @o.flame");
    row("aifs", "convert @p.ifs @o.aifs");
    row("tex", "convert @p.ifs @o.tex");
    row("csv", "convert @p.ifs @o.csv --entry one");
    row("points", "convert @p.ifs @o.ply --entry one --points 1000");
    row("pages", "convert @p.ifs @o.pdf");
    row("stl", "convert @s.ifs @o.stl --resolution 12");
    row("obj", "convert @s.ifs @o.obj --resolution 12");
    row("glb", "convert @s.ifs @o.glb --resolution 12");
    row("ply", "convert @s.ifs @o.ply --resolution 12");
    row("scad", "convert @s.ifs @o.scad");
    row("png", "render @p.ifs -o @o.png --size 40x30 --points 1k");
    row("jpeg", "render @p.ifs -o @o.jpg --size 40x30 --points 1k");
    row("webp", "render @p.ifs -o @o.webp --size 40x30 --points 1k");
    row("tiff", "render @p.ifs -o @o.tif --size 40x30 --points 1k");
    row("exr", "render @p.ifs -o @o.exr --size 40x30 --points 1k");
    row("svg", "render @p.ifs -o @o.svg --size 40x30");
    row("pdf", "render @p.ifs -o @o.pdf --size 40x30");
    row("letters", "render @p.ifs -o @o.png --size 40x30 --points 1k --overlay maps,numbers");
    row("solid", "render @s.ifs -o @o.png --size 40x30");
    row("sums", "render @p.ifs -o @o.sum --size 40x30 --points 1k");
    row("cloud sums", "render @s.ifs -o @o.sum --look cloud --size 40x30 --points 1k");
    row("merged", "merge @a.sum @b.sum -o @o.png");
    row("resumed", "render --resume @c.sum --points 3k -o @o.sum");
    row("sheet", "gallery @p.ifs -o @o.png --tile 20x20");
    row("sheets", "gallery @p.ifs -o @o.pdf --tile 20x20");
    row("morph", "morph @p.ifs --from one --to two -o @o.ifs");
    row("collage", "collage @shape.png -o @o.ifs --starts 1 --maps 2");
    row("steal",
        "steal @p.ifs --entry one --from two --picture @shape.png -o @o.png --size 30x30 --points 1k");
    row("page", "page @p.ifs -o @o.html --entry one");
    row("info", "info @p.ifs --json --entry one");
    row("frames", "animate @m.ifs -o @f.####.png --frames 1-2 --size 32x32 --points 1k");
#ifdef BARYCAGE_VIDEO
    for (const char* suffix : {"mp4", "webm", "mkv", "gif", "webp", "apng"})
        row(qPrintable(QStringLiteral("video ") + QLatin1String(suffix)),
            ("animate @m.ifs -o @o." + QByteArray(suffix) + " --frames 1-3 --size 32x32 --points 1k")
                .constData());
    row("encode", "encode @g.####.png -o @o.mp4");
#endif
}

// What the commands read.
void CliFailuresTest::makeInputs() const {
    if (QFile::exists(path("m.ifs"))) return;
    const QByteArray rows = " .5 0 0 .5 0 0 .34\n .5 0 0 .5 .5 0 .33\n .5 0 0 .5 0 .5 .33\n}\n";
    write("p.ifs", "one {\n" + rows + "two {\n" + QByteArray(rows).replace(".5 0 .33", ".4 .1 .33"));
    write("s.ifs", "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 1 0 0 .25\n"
                   " .5 0 0 0 .5 0 0 0 .5 0 1 0 .25\n .5 0 0 0 .5 0 0 0 .5 0 0 1 .25\n}\n");
    for (const char* command : {"morph p.ifs --from one --to two --length 3 -o m.ifs",
                                "render p.ifs -o a.sum --size 40x30 --points 1k --part 0/2",
                                "render p.ifs -o b.sum --size 40x30 --points 1k --part 1/2",
                                "render p.ifs -o c.sum --size 40x30 --points 1k",
                                "render p.ifs -o shape.png --size 60x60 --background white",
                                "animate m.ifs -o g.####.png --size 32x32 --points 1k"})
        QCOMPARE(run(command).status, 0);
}

FaultyProgram CliFailuresTest::program(QString command) const {
    command.replace(u'@', path("") + u'/');
    return {QStringList(support::buildPath(QStringLiteral("barycage-cli"))) + command.split(u' '), path("")};
}

// What is in the folder before each run, and what is after one in which nothing fails. The calls of that.
std::optional<QByteArrayList> CliFailuresTest::begin(const QString& command) {
    makeInputs();
    for (const QString& name : QDir(path("")).entryList({QStringLiteral("[of].*")}, QDir::Files))
        QFile::remove(path(name.toUtf8()));
    const auto output = command.indexOf(u"@o.");
    if (output >= 0) write(command.sliced(output + 1).split(u' ').first().toUtf8(), "old");
    m_before = support::contentsOf(path(""));
    Ended ended;
    const auto calls = program(command).calls(ended);
    if (!calls) return std::nullopt;
    m_expected = support::contentsOf(path(""));
    m_expectedOut = ended.out;
    if (ended.status != 0) qWarning("%s", ended.err.constData());
    restore();
    return ended.status == 0 ? *calls : QByteArrayList();
}

// The folder as before a run.
void CliFailuresTest::restore() const {
    const Files now = support::contentsOf(path(""));
    for (auto at = now.begin(); at != now.end(); ++at)
        if (!m_before.contains(at.key())) QVERIFY(QFile::remove(path(at.key().toUtf8())));
    for (auto at = m_before.begin(); at != m_before.end(); ++at)
        if (now.value(at.key()) != at.value()) write(at.key().toUtf8(), at.value());
}

void CliFailuresTest::judge(const Ended& ended, const QByteArray& what) const {
    const Files after = support::contentsOf(path(""));
    const QByteArray said = what + ": status " + QByteArray::number(ended.status) + ", “" + ended.err + "”";
    QVERIFY2(ended.status == 0 || ended.status == 3, said.constData());
    QVERIFY2(ended.status == 0 || ended.err.contains(": error: "), said.constData());
    // The fonts of the system may be those that could not be read.
    const QByteArray kind = QTest::currentDataTag();
    const bool hasLetters = kind == "letters" || kind.startsWith("sheet");
    for (const QString& name : after.keys() + m_expected.keys()) {
        const QByteArray bytes = after.value(name);
        const bool isNew = bytes == m_expected.value(name);
        const bool isWhole =
            hasLetters && name.startsWith(u"o.") &&
            (bytes.endsWith(QByteArray("IEND\xae\x42\x60\x82", 8)) || bytes.endsWith("%%EOF\n"));
        const bool isOld = ended.status != 0 && bytes == m_before.value(name);
        QVERIFY2(isNew || isOld || isWhole, (said + ": " + name.toUtf8()).constData());
    }
    if (ended.status == 0) QCOMPARE(ended.out, m_expectedOut);
}

void CliFailuresTest::noThreadIsWaitedFor_data() {
    QTest::addColumn<QString>("command");
    QTest::newRow("sheet") << QStringLiteral("gallery @p.ifs -o @o.png --tile 320x240");
    QTest::newRow("png") << QStringLiteral("render @p.ifs -o @o.png --size 300x200 --points 100k");
    QTest::newRow("exr") << QStringLiteral("render @p.ifs -o @o.exr --size 300x200 --points 100k");
    QTest::newRow("frames") << QStringLiteral("animate @m.ifs -o @f.####.png --size 300x200 --points 10k");
}

// Qt waits without end for the work of threads that the system does not start.
void CliFailuresTest::noThreadIsWaitedFor() {
    QFETCH(const QString, command);
    const auto calls = begin(command);
    if (!calls) QSKIP("The kernel does not let a program answer the calls of another one.");
    int threads = 0;
    for (int i = 0; i < calls->size(); ++i) {
        if (!calls->at(i).startsWith("clone")) continue;
        ++threads;
        judge(program(command).withFailingCall(i + 1, Lasting::No), "thread " + QByteArray::number(threads));
        restore();
        if (QTest::currentTestFailed()) return;
    }
    QVERIFY(threads > 0);
}

// A limit on memory ends the program with a sentence, from where its libraries are loaded on.
// Qt would abort where it cannot open a pipe or find its platform.
void CliFailuresTest::fewOpenFilesEndNothingSuddenly() {
    const QString line =
        QStringLiteral("ulimit -c 0; ulimit -n %1; cd '%2'; exec %3 gallery few.ifs -o few.png --tile 40x40");
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("few.ifs")));
    QVERIFY(file.open(QIODevice::WriteOnly) &&
            file.write("a {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n") > 0);
    file.close();
    constexpr int notLoaded = 127;
    int done = 0;
    for (int limit = 4; done == 0 && limit < 100; ++limit) {
        QProcess process;
        process.start(QStringLiteral("sh"),
                      {QStringLiteral("-c"), line.arg(QString::number(limit), folder.path(),
                                                      support::buildPath(QStringLiteral("barycage-cli")))});
        QVERIFY(process.waitForFinished(60'000));
        const QByteArray said = QByteArray::number(limit) + ": " + process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, said.constData());
        const int status = process.exitCode();
        QVERIFY2(status == 0 || status == 3 || status == notLoaded, said.constData());
        done += status == 0;
    }
    QVERIFY(done > 0);
}

void CliFailuresTest::startsWithoutMemory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("The sanitizers need more memory than that.");
#endif
    const QString line = QStringLiteral("ulimit -c 0; ulimit -v %1; exec %2 --version")
                             .arg(QStringLiteral("%1"), support::buildPath(QStringLiteral("barycage-cli")));
    const int step = support::isThorough() ? 50 : 1000; // KB
    constexpr int notLoaded = 127;
    int begun = 0;
    for (int limit = 60'000, done = 0; done < 3 && limit < 1'000'000; limit += step) {
        QProcess process;
        process.start(QStringLiteral("sh"), {QStringLiteral("-c"), line.arg(limit)});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        const QByteArray said = process.readAllStandardError();
        const int status = process.exitCode();
        QVERIFY2(status == 0 || status == 3 || (status == notLoaded && begun == 0),
                 (QByteArray::number(status) + ": " + said).constData());
        if (status == 3) QVERIFY2(said.contains("There is not enough memory for this."), said.constData());
        begun += status == notLoaded ? 0 : 1;
        done += status == 0 ? 1 : 0;
    }
    QVERIFY(begun > 0);
    const FaultyProgram version(
        {support::buildPath(QStringLiteral("barycage-cli")), QStringLiteral("--version")}, QString());
    const long count = version.allocations();
    QVERIFY(count > 100);
    for (const long which : support::sampleOf(count, support::isThorough() ? count : 25, 0)) {
        const Ended ended = version.withFailingAllocation(which, Lasting::No);
        QVERIFY2(ended.status == 0 || ended.status == 3,
                 ("allocation " + QByteArray::number(qint64(which)) + ": " + ended.err).constData());
        QVERIFY(ended.status == 0 || ended.err.contains("There is not enough memory for this."));
    }
}

// A video of frames carries the entry that they carry, or there is none.
void CliFailuresTest::everyFrameIsReadOrSaid() {
#ifndef BARYCAGE_VIDEO
    QSKIP("No videos are written.");
#endif
    const QString command = QStringLiteral("encode @g.####.png -o @o.gif");
    const auto calls = begin(command);
    if (!calls) QSKIP("The kernel does not let a program answer the calls of another one.");
    constexpr int most = 8; // each frame, and the one that has the entry
    int opened = 0;
    for (int i = 0; i < calls->size() && opened < most && !QTest::currentTestFailed(); ++i) {
        if (calls->at(i) != "openat") continue;
        ++opened;
        judge(program(command).withFailingCall(i + 1, Lasting::No),
              "openat, call " + QByteArray::number(i + 1));
        restore();
    }
    QCOMPARE(opened, most);
}

void CliFailuresTest::everyFileIsOldOrNew() {
    QFETCH(const QString, command);
    const auto calls = begin(command);
    if (!calls) QSKIP("The kernel does not let a program answer the calls of another one.");
    QVERIFY(calls->size() > 20);
    const FaultyProgram run = program(command);
    const bool isThorough = support::isThorough();
    const int turn = int(qHash(QByteArray(QTest::currentDataTag())) % 1000);
    const auto failCalls = [&](Lasting lasting, int most) {
        for (const int which : support::sampleOf(*calls, most, turn)) {
            const Ended ended = run.withFailingCall(which, lasting);
            judge(ended, calls->at(which - 1) + ", call " + QByteArray::number(which));
            restore();
            if (QTest::currentTestFailed()) return;
        }
    };
    failCalls(Lasting::No, isThorough ? int(calls->size()) : 2);
    if (!QTest::currentTestFailed()) failCalls(Lasting::Yes, isThorough ? 100 : 1);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which have an allocator of their own
    if (QTest::currentTestFailed()) return;
    const long count = run.allocations();
    QVERIFY(count > 1000);
    restore();
    const auto failMemory = [&](Lasting lasting, long most) {
        for (const long which : support::sampleOf(count, most, turn)) {
            const Ended ended = run.withFailingAllocation(which, lasting);
            judge(ended, "allocation " + QByteArray::number(qint64(which)));
            restore();
            if (QTest::currentTestFailed()) return;
        }
    };
    failMemory(Lasting::No, isThorough ? 1500 : 1);
    if (!QTest::currentTestFailed()) failMemory(Lasting::Yes, isThorough ? 100 : 1);
#endif
}

BARYCAGE_TEST(CliFailuresTest, QGuiApplication);
#include "cli_failures_test.moc"
