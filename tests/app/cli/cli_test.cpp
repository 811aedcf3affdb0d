// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"
#include "support/thorough.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

// What barycage-cli says to every command: usage, messages, standard input and output, interrupts.
class CliTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void helpAndVersion();
    void wrongUsage_data();
    void wrongUsage();
    void emptyArgumentsAreNoneLeftOut_data();
    void emptyArgumentsAreNoneLeftOut();
    void unknownCommandIsNamed();
    void messagesHoldNoControlCharacters();
    void missingFiles();
    void brokenEntries();
    void standardInput();
    void standardInputHasALimit();
    void unreadableStandardInputIsNoEmptyFile();
    void palettesThatAreNone();
    void threadsThatAreNotToBeHad();
    void littleMemoryIsSaid_data();
    void littleMemoryIsSaid();
    void fullOutputIsSaid_data();
    void fullOutputIsSaid();
    void problemsOfAWholeFileHaveAPlace();
    void everyCommandTakesProgress();
    void onlyOrdinaryFilesAreReplaced_data();
    void onlyOrdinaryFilesAreReplaced();
    void interruptLeavesNothing();
    void interruptEndsWaiting_data();
    void interruptEndsWaiting();
    void whateverEndsItLeavesNothing_data();
    void whateverEndsItLeavesNothing();
    void aReaderThatGoesLeavesNothing();
    void aLimitOnFilesIsSaid();

private:
    QStringList files() const { // all there are, hidden ones too
        return QDir(path("")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    // Whether the program has come to where it minds signals.
    static bool mindsSignals(const QProcess& process) {
        QFile status(QStringLiteral("/proc/%1/status").arg(process.processId()));
        if (!status.open(QIODevice::ReadOnly)) return false;
        const QByteArray text = status.readAll();
        const qsizetype at = text.indexOf("SigBlk:\t") + 8;
        return (text.mid(at, 16).toULongLong(nullptr, 16) & 1ULL << (SIGTERM - 1)) != 0;
    }
};

void CliTest::helpAndVersion() {
    const Result version = run("--version");
    QCOMPARE(version.status, 0);
    QVERIFY(version.out.startsWith("barycage-cli "));
    for (const char* command : {"info", "render", "convert"}) {
        const Result help = run(QByteArray(command) + " --help");
        QCOMPARE(help.status, 0);
        QVERIFY(help.out.contains("--entry"));
        QVERIFY(help.err.isEmpty());
    }
}

void CliTest::wrongUsage_data() {
    QTest::addColumn<QByteArray>("arguments");
    const auto row = [](const char* text) { QTest::newRow(text) << QByteArray(text); };
    row("");
    row("frobnicate");
    row("info");
    row("info systems.ifs --nonsense");
    row("info systems.ifs --hull-tolerance -1");
    row("render systems.ifs");
    row("render systems.ifs -o x.gif");
    row("render systems.ifs -o x.png --size 12by9");
    row("render systems.ifs -o x.png --size 0x9");
    row("render systems.ifs -o x.png --palette no-such-palette");
    row("render systems.ifs -o x.png --background colourless");
    row("render systems.ifs -o x.png --background #ff0000800000");
    row("render systems.ifs -o x.png --gamma -1");
    row("render systems.ifs -o x.png --gamma 2,2");
    row("render systems.ifs -o x.png --contrast 0");
    row("render systems.ifs -o x.png --vibrancy 1.5");
    row("render systems.ifs -o x.png --vibrancy -1");
    row("render systems.ifs -o x.png --shadow 2");
    row("render systems.ifs -o x.png --shadow-lean 11");
    row("render systems.ifs -o x.svg --contrast 2");
    row("render systems.ifs -o x.pdf --vibrancy 0");
    row("render systems.ifs -o x.png --bits 12");
    row("render systems.ifs -o x.svg --bits 16");
    row("render systems.ifs -o x.png --simd mmx");
    row("render systems.ifs -o x.png --dpi 0.001");
    row("render systems.ifs -o x.png --dpi 1e9");
    row("render systems.ifs -o x.png --algorithm deterministic --iterations -1");
    row("render systems.ifs -o x.png --colour rainbow");
    row("render systems.ifs -o x.png --supersample 5");
    row("render systems.ifs -o x.png --depth 3");
    row("render systems.ifs -o x.svg --points 1000");
    row("render systems.ifs -o x.svg --svg spiral");
    row("render systems.ifs -o x.svg --depth 150");
    row("render systems.ifs -o x.png --algorithm deterministic");
    row("render systems.ifs -o x.png --rest-cage hull:2");
    row("render systems.ifs -o x.png --rest-cage hull:many");
    row("render systems.ifs -o x.png --rest-cage 0,0;1,0");
    row("render systems.ifs -o x.png --view 1,2");
    row("render systems.ifs -o x.png --view 1,2,0");
    row("render systems.ifs -o x.png --margin 50");
    row("render systems.ifs -o x.png --progress sometimes");
    row("render systems.ifs -o x.png --seed -1");
    row("render systems.ifs -o x.png --seed 99999999999999999999");
    row("render systems.ifs -o x.png --points 0");
    row("render systems.ifs -o x.png --points -5");
    row("render systems.ifs -o x.png --points 1e");
    row("convert systems.ifs x.docx");
}

void CliTest::wrongUsage() {
    QFETCH(QByteArray, arguments);
    const Result result = run(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.startsWith("barycage-cli"), result.err.constData());
    QVERIFY(result.err.contains(": error: "));
    for (const char* name : {"x.png", "x.svg", "x.gif", "x.docx"})
        QVERIFY(!QFile::exists(path(name)));
}

void CliTest::emptyArgumentsAreNoneLeftOut_data() {
    QTest::addColumn<QString>("arguments"); // a row has '' for the empty one
    const auto row = [](const char* text) { QTest::newRow(text) << QString::fromLatin1(text); };
    row("render systems.ifs -o x.png --bits ''");
    row("render systems.ifs -o x.png --threads ''");
    row("render systems.ifs -o x.png --entry ''");
    row("render systems.ifs --to png -o ''");
    row("info systems.ifs --entry maple --entry ''");
    row("convert systems.ifs x.ifs --to ''");
    row("convert systems.ifs '' --to flame");
    row("gallery systems.ifs -o x.png --columns ''");
}

// An empty variable of a script is no wish for what would be without it.
void CliTest::emptyArgumentsAreNoneLeftOut() {
    QFETCH(QString, arguments);
    QStringList words = arguments.split(u' ');
    words.replaceInStrings(QStringLiteral("''"), QString());
    QProcess process;
    process.setWorkingDirectory(path(""));
    process.start(support::buildPath(QStringLiteral("barycage-cli")), words);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 2);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.startsWith("barycage-cli "), said.constData());
    for (const char* name : {"x.png", "x.ifs"})
        QVERIFY(!QFile::exists(path(name)));
}

void CliTest::unknownCommandIsNamed() {
    const Result result = run("galery systems.ifs");
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("galery"), result.err.constData());
}

// Text from a file is printed; it can neither control the terminal nor change the message that contains it.
void CliTest::messagesHoldNoControlCharacters() {
    write("%4.ifs", "a\x1b[31mb {\n 1/%2\x07 0 0\n}\nc\rd {\n .5 0 0 .5 0 0 1\n}\n");
    for (const char* arguments : {"info %4.ifs", "convert %4.ifs x.flame"}) {
        const Result result = run(arguments);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.startsWith("%4.ifs:2:2: error: "), result.err.constData());
        QVERIFY2(result.err.contains("“1/%2"), result.err.constData());
        for (const QByteArray& text : {result.out, result.err})
            QVERIFY(
                std::none_of(text.begin(), text.end(), [](char c) { return c < ' ' && c > 0 && c != '\n'; }));
    }
}

void CliTest::missingFiles() {
    const Result absent = run("info absent.ifs");
    QCOMPARE(absent.status, 3);
    QVERIFY(absent.err.startsWith("absent.ifs: error: "));
    const Result folder = run("render systems.ifs -o no/such/folder.png --size 9x9");
    QCOMPARE(folder.status, 3);
    const Result entry = run("info systems.ifs --entry oak --json");
    QCOMPARE(entry.status, 1);
    QVERIFY(entry.err.contains("oak"));
    QVERIFY(QJsonDocument::fromJson(entry.out).isObject());
}

void CliTest::brokenEntries() {
    const Result result = run("info broken.ifs --json");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.startsWith("broken.ifs:6:"), result.err.constData());
    const QJsonDocument json = QJsonDocument::fromJson(result.out);
    QCOMPARE(json[QLatin1String("problems")][0][QLatin1String("line")].toInt(), 6);
    QCOMPARE(json[QLatin1String("problems")][0][QLatin1String("severity")].toString(),
             QStringLiteral("error"));
    QCOMPARE(result.entry(0)[QLatin1String("loaded")].toBool(), true);
    QCOMPARE(result.entry(1)[QLatin1String("loaded")].toBool(true), false);
    // The first entry that can be read is drawn all the same; the broken one is not.
    const QByteArray render = "render broken.ifs -o broken.png --size 20x20";
    QCOMPARE(run(render).status, 0);
    QFile::remove(path("broken.png"));
    QCOMPARE(run(render + " --entry bad").status, 1);
    QVERIFY(!QFile::exists(path("broken.png")));
}

void CliTest::standardInput() {
    const Result result = run("info - --json", read("systems.ifs"));
    QCOMPARE(result.status, 0);
    const QJsonDocument json = QJsonDocument::fromJson(result.out);
    QCOMPARE(json[QLatin1String("file")].toString(), QStringLiteral("-"));
    QCOMPARE(json[QLatin1String("entries")].toArray().size(), 3);
}

void CliTest::standardInputHasALimit() {
    QFile large(path("large"));
    QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(257LL * 1024 * 1024)); // sparse
    QProcess process;
    process.setStandardInputFile(large.fileName());
    start(process, "info -");
    QVERIFY(process.waitForFinished(120'000));
    QVERIFY(process.exitCode() != 0);
    QVERIFY(process.readAllStandardError().contains("256 MB"));
    large.remove();
}

void CliTest::unreadableStandardInputIsNoEmptyFile() {
    write("kept.ifs", "old\n");
    QProcess process;
    process.setChildProcessModifier([] { ::dup2(::open("/", O_RDONLY), STDIN_FILENO); });
    start(process, "convert - kept.ifs");
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 3);
    QVERIFY(process.readAllStandardError().contains("Standard input cannot be read"));
    QCOMPARE(read("kept.ifs"), QByteArray("old\n"));
}

void CliTest::palettesThatAreNone() {
    const QByteArray render = "render systems.ifs -o palette.png --size 20x15 --palette ";
    QCOMPARE(run(render + "absent.gpl").status, 3);
    QCOMPARE(run(render + "./absent").status, 3);
    const Result damaged = run(render + "systems.ifs");
    QCOMPARE(damaged.status, 1);
    QVERIFY2(damaged.err.startsWith("systems.ifs: error: "), damaged.err.constData());
    QVERIFY(!QFile::exists(path("palette.png")));
}

// Those there are draw the same picture, if they leave memory for it.
void CliTest::threadsThatAreNotToBeHad() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("a sanitizer takes more memory than the limit");
#endif
    const QByteArray render = "render systems.ifs --size 60x40 --points 1000 -o ";
    QCOMPARE(run(render + "one.png --threads 1").status, 0);
    QProcess process;
    process.setChildProcessModifier([] {
        const rlimit limit{1'000'000'000, 1'000'000'000}; // each thread asks for 8 MB
        ::setrlimit(RLIMIT_AS, &limit);
    });
    start(process, render + "many.png --threads 1000");
    QVERIFY(process.waitForFinished(120'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    if (process.exitCode() == 0) {
        QCOMPARE(read("many.png"), read("one.png"));
    } else {
        QCOMPARE(process.exitCode(), 3);
        QVERIFY(process.readAllStandardError().contains("not enough memory"));
        QVERIFY(!QFile::exists(path("many.png")));
    }
}

void CliTest::littleMemoryIsSaid_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::newRow("facts") << QByteArray("info systems.ifs --entry fern");
    QTest::newRow("a picture") << QByteArray("render systems.ifs -o little.png --size 400x300 --points 1000");
    QTest::newRow("a mesh") << QByteArray("convert little.ifs little.stl --resolution 200");
    QTest::newRow("a video") << QByteArray("animate moving.ifs -o little.mkv --size 64x48 --points 1000");
    QTest::newRow("a sheet") << QByteArray("gallery systems.ifs -o little.webp --tile 40x40");
}

// From none at all to enough: it works, or there is not enough memory, which is no fault of the file.
void CliTest::littleMemoryIsSaid() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("a sanitizer takes more memory than the limit");
#endif
    QFETCH(const QByteArray, arguments);
    write("little.ifs", "tetra (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 5 5 0 .25\n"
                        " .5 0 0 0 .5 0 0 0 .5 5 0 5 .25\n .5 0 0 0 .5 0 0 0 .5 0 5 5 .25\n}\n");
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    write("still.ifs", "one {\n" + rows + "two {\n" + rows);
    QCOMPARE(run("morph still.ifs --from one --to two --length 2 -o moving.ifs").status, 0);
    bool isEnough = false;
    const rlim_t step = support::isThorough() ? 10 : 30;
    for (rlim_t megabytes = 10; megabytes <= 2000 && !isEnough; megabytes += megabytes < 300 ? step : 100) {
        QProcess process;
        process.setChildProcessModifier([megabytes] {
            const rlimit limit{megabytes << 20, megabytes << 20}, none{0, 0};
            ::setrlimit(RLIMIT_CORE, &none);
            ::setrlimit(RLIMIT_AS, &limit);
        });
        start(process, arguments);
        if (!process.waitForFinished(120'000) || process.error() == QProcess::FailedToStart) continue;
        const QByteArray said = process.readAllStandardError();
        const QByteArray where = QByteArray::number(quint64(megabytes)) + " MB: " + said;
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, where.constData());
        isEnough = process.exitCode() == 0;
        const bool isLoaded = !said.contains("error while loading shared libraries"); // before any of ours
        QVERIFY2(!isLoaded || isEnough || process.exitCode() == 3, where.constData());
        QVERIFY2(!said.contains("not installed"), where.constData());
        QVERIFY2(!isLoaded || isEnough || said.contains("memory"), where.constData());
    }
    QVERIFY(isEnough);
}

void CliTest::fullOutputIsSaid_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("facts") << QByteArray("info systems.ifs") << QByteArray("systems.ifs: error: ");
    QTest::newRow("help") << QByteArray("--help") << QByteArray("-: error: ");
    QTest::newRow("help of a command") << QByteArray("render --help") << QByteArray("-: error: ");
    QTest::newRow("version") << QByteArray("--version") << QByteArray("-: error: ");
    QTest::newRow("table") << QByteArray("convert systems.ifs - --to csv --entry fern")
                           << QByteArray("-: error: ");
    QTest::newRow("picture") << QByteArray("render systems.ifs -o - --to png --size 9x9")
                             << QByteArray("-: error: ");
}

void CliTest::fullOutputIsSaid() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, said);
    if (!QFile::exists(QStringLiteral("/dev/full"))) QSKIP("needs /dev/full");
    QProcess process;
    process.setStandardOutputFile(QStringLiteral("/dev/full"));
    start(process, arguments);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 3);
    const QByteArray error = process.readAllStandardError();
    QVERIFY2(error.contains(said) && error.contains("No space left on device"), error.constData());
}

void CliTest::problemsOfAWholeFileHaveAPlace() {
    write("empty.ifs", "");
    write("prose.ifs", "Once upon a time\n");
    for (const QByteArray name : {"empty.ifs", "prose.ifs"}) {
        const Result result = run("info " + name);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.startsWith(name + ":1:1: error: "), result.err.constData());
    }
}

void CliTest::everyCommandTakesProgress() {
    for (const char* command :
         {"info systems.ifs --entry fern", "render systems.ifs -o progress.svg --depth 2",
          "convert systems.ifs progress.ifs", "gallery systems.ifs -o progress.png --tile 40x40"}) {
        for (const char* when : {"never", "auto", "always"})
            QCOMPARE(run(QByteArray(command) + " --progress=" + when).status, 0);
        QCOMPARE(run(QByteArray(command) + " --progress=sometimes").status, 2);
    }
}

void CliTest::onlyOrdinaryFilesAreReplaced_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("output");
    const auto row = [](const char* arguments, const char* output) {
        QTest::newRow(output) << QByteArray(arguments) << QByteArray(output);
    };
    row("render systems.ifs --size 20x15 -o ", "pipe.png");
    row("render systems.ifs --size 20x15 --bits 16 --to png -o ", "pipe.16");
    row("render systems.ifs --size 20x15 -o ", "pipe.svg");
    row("render systems.ifs --size 20x15 -o ", "pipe.pdf");
    row("gallery systems.ifs --tile 40x40 -o ", "sheet.png");
    row("convert systems.ifs ", "pipe.ifs");
    row("convert systems.ifs ", "pipe.flame");
    row("convert systems.ifs --entry fern ", "pipe.csv");
    row("convert systems.ifs --entry fern --points 10 ", "pipe.ply");
    row("convert systems.ifs --entry fern --to pdf ", "pages.pdf");
}

// A pipe stays a pipe, whoever runs the program.
void CliTest::onlyOrdinaryFilesAreReplaced() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, output);
    const QByteArray pipe = path(output).toLocal8Bit();
    QCOMPARE(::mkfifo(pipe.constData(), 0600), 0);
    const Result result = run(arguments + output);
    struct stat status {};
    QCOMPARE(::lstat(pipe.constData(), &status), 0);
    QVERIFY(S_ISFIFO(status.st_mode));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains("not a regular file"), result.err.constData());
}

void CliTest::interruptLeavesNothing() {
    QProcess process;
    start(process, "render systems.ifs -o never.png --points 1000000000000 --progress always");
    QVERIFY(process.waitForStarted());
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 60'000);
    process.terminate();
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 143);
    QVERIFY(!QFile::exists(path("never.png")));
}

void CliTest::interruptEndsWaiting_data() {
    QTest::addColumn<QByteArray>("arguments");
    const auto row = [](const char* text) { QTest::newRow(text) << QByteArray(text); };
    row("render - -o never.png");
    row("convert - never.csv");
    row("gallery - -o never.png");
    row("render systems.ifs -o never.svg --svg points --points 1000000");
}

void CliTest::interruptEndsWaiting() {
    QFETCH(QByteArray, arguments);
    const QStringList before = files();
    QProcess process;
    start(process, arguments);
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(mindsSignals(process), 60'000);
    process.terminate();
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 143);
    QCOMPARE(files(), before);
}

void CliTest::whateverEndsItLeavesNothing_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("the terminal closes") << SIGHUP;
    QTest::newRow("killed") << SIGKILL;
}

void CliTest::whateverEndsItLeavesNothing() {
    QFETCH(int, signal);
    const int nameless = ::open(path("").toLocal8Bit().constData(), O_TMPFILE | O_WRONLY, 0600);
    if (nameless < 0) QSKIP("needs files without a name");
    ::close(nameless);
    const QStringList before = files();
    QProcess process;
    start(process, "render systems.ifs -o never.png --points 1000000000000 --progress always");
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 60'000);
    QCOMPARE(::kill(pid_t(process.processId()), signal), 0);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(files(), before);
}

void CliTest::aReaderThatGoesLeavesNothing() {
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("temporary")));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TMPDIR"), path("temporary"));
    process.setProcessEnvironment(environment);
    process.setChildProcessModifier([] { // nobody reads
        int ends[2];
        if (::pipe(ends) != 0) return;
        ::close(ends[0]);
        ::dup2(ends[1], STDOUT_FILENO);
    });
    start(process, "convert systems.ifs - --entry fern --to csv --points 200000");
    QVERIFY(process.waitForFinished(60'000));
    QVERIFY(process.exitStatus() == QProcess::CrashExit || process.exitCode() == 3);
    QVERIFY(QDir(path("temporary")).isEmpty());
}

void CliTest::aLimitOnFilesIsSaid() {
    const QStringList before = files();
    QProcess process;
    process.setChildProcessModifier([] {
        const rlimit limit{20'000, 20'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    });
    start(process, "render systems.ifs -o large.png --size 600x400 --points 100000");
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 3);
    QVERIFY(process.readAllStandardError().contains("large.png: error: "));
    QCOMPARE(files(), before);
}

BARYCAGE_TEST(CliTest, QGuiApplication);
#include "cli_test.moc"
