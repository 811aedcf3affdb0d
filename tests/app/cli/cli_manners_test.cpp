// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QProcess>
#include <QRegularExpression>

#include <csignal>

// How barycage-cli takes what people type: options that are mistyped, numbers as they are written, several
// pictures in one call, signals.
class CliMannersTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void wrongOptionsAreNamed_data();
    void wrongOptionsAreNamed();
    void messagesAreOurs_data();
    void messagesAreOurs();
    void onesAreSingular_data();
    void onesAreSingular();
    void percentSignsOfNamesStay();
    void helpHasGroupsAndDefaults();
    void helpIsFoundByEveryName();
    void countsAreTakenAsTheyAreWritten_data();
    void countsAreTakenAsTheyAreWritten();
    void limitsAreSaid_data();
    void limitsAreSaid();
    void oneSideKeepsTheProportions();
    void shortNames();
    void quietSaysNoWarnings();
    void signalsHaveTheirStatus_data();
    void signalsHaveTheirStatus();
    void whatAnInterruptLeavesIsSaid();
    void severalPicturesInOneCall();
    void foldersAreNoPatterns();
    void outputsThatCollideAreRefused();
    void entriesByNumber();
    void stepsInOneCall();
    void stepsAsAStrip();
    void palettesAreListed();

private:
    QStringList pictures(const char* pattern) const {
        return QDir(path("")).entryList({QString::fromLatin1(pattern)}, QDir::Files, QDir::Name);
    }
    QSize size(const QByteArray& name) const { return QImage(path(name)).size(); }
};

void CliMannersTest::wrongOptionsAreNamed_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* arguments, const char* said) {
        QTest::newRow(arguments) << QByteArray(arguments) << QByteArray(said);
    };
    row("render --sise 3x3", "unknown option --sise; did you mean --size?");
    row("render absent.ifs -o x.gif --size 0 --sise=3x3", "unknown option --sise; did you mean --size?");
    row("render --size 3 -o x.png --thread 3 a b c", "unknown option --thread; did you mean --threads?");
    row("render systems.ifs -o x.png --colour-by map", "unknown option --colour-by; did you mean --colour?");
    row("render systems.ifs -o x.png -size 9x9", "unknown option -size; did you mean --size?");
    row("render systems.ifs -o x.png -jx --tile 3x3", "unknown option --tile; it is an option of gallery.");
    row("info systems.ifs --qqqqqqqq", "unknown option --qqqqqqqq.");
    row("info systems.ifs -Z", "unknown option -Z.");
    row("--size 9x9 render systems.ifs", "--size must follow its command");
    row("--versoin", "unknown option --versoin; did you mean --version?");
    row("galery systems.ifs -o x.png", "There is no command “galery”; did you mean gallery?");
    row("draw systems.ifs", "There is no command “draw”; the commands are info, render, convert, gallery, "
                            "animate, encode, morph, merge, collage, steal and page.");
}

void CliMannersTest::wrongOptionsAreNamed() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, said);
    const Result result = run(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(": error: " + said), result.err.constData());
}

void CliMannersTest::messagesAreOurs_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* arguments, const char* said) {
        QTest::newRow(arguments) << QByteArray(arguments) << QByteArray(said);
    };
    row("", "Give a command: info, render, convert, gallery, animate, encode, morph, merge, collage, steal "
            "or page.");
    row("encode - -o x.gif",
        "The pictures are .png files with a name such as NAME.####.png, and “-” is not.");
    row("render systems.ifs -o", "-o needs a value: -o OUT.");
    row("render systems.ifs", "-o OUT is missing. Usage: barycage-cli render FILE... -o OUT");
    row("render -o x.png", "FILE is missing. Usage: barycage-cli render");
    row("convert systems.ifs", "OUT is missing. Usage: barycage-cli convert FILE... OUT");
    row("info a.ifs b.ifs", "“b.ifs” is one argument too many. Usage: barycage-cli info FILE");
    row("info systems.ifs --json=yes", "--json takes no value.");
    row("info systems.ifs --json --names", "--json and --names cannot be used together.");
    row("render systems.ifs -o x.png --size 9x9 --size 8x8", "--size can be given only once.");
    row("render systems.ifs -o x.png --size=", "The value of --size is empty.");
    row("render systems.ifs -o x.png --bits many", "--bits “many” is not valid: it must be 8, 16 or 32.");
    row("render systems.ifs -o x.svg --depth 1.5",
        "--depth “1.5” is not valid: it must be a whole number from 0 to 2147483647.");
    row("render systems.ifs -o x.png --algorithm chaosgame", "--algorithm “chaosgame” is not valid");
    row("render systems.ifs -o x.png --threads 0",
        "--threads “0” is not valid: it must be a whole number from 1 to 1024.");
    row("gallery systems.ifs -o x.png --paper red", "--paper “red” is not valid: it must be dark or light.");
}

void CliMannersTest::messagesAreOurs() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, said);
    const Result result = run(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(": error: " + said), result.err.constData());
    QVERIFY(pictures("x.*").isEmpty());
}

void CliMannersTest::onesAreSingular_data() {
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* arguments, const char* input, const char* said) {
        QTest::newRow(said) << QByteArray(input) << QByteArray(arguments) << QByteArray(said);
    };
    row("info -", "a {\n .5 0 0 .5 0 0 1\n 2\n}\n", "this line has 1, the entry has 8, and each map has 7.");
    row("info -", "a (3D) {\n .5\n}\n", "this line has 1, the entry has 1, and each map has 13 in an entry");
    row("info -", "a,b,c,d,e,f,p\n.5,0,0,.5,0,0,1\n1\n", "names 7 columns, but this row has 1.");
    row("info -", "1\n1 .5 0 0 0 .5 0 0 0 1\n1 .5 0 0 0 .5 1 0 0 1\n", "but the number of maps is 2.");
    row("info -", "a {\n ; barycage: animation 1 24/1 cycle\n .5 0 0 .5 0 0 1\n}\n",
        "frames: 1, 24 per second");
    row("animate - -o x.##.png --frames 9", "a {\n ; barycage: animation 1 24/1 cycle\n .5 0 0 .5 0 0 1\n}\n",
        "The last frame of “a” has the number 1; larger ones");
    row("render - -o x.sum --size 9x1 --band 0/2", "a {\n .5 0 0 .5 0 0 1\n}\n",
        "has no rows: the height of the picture is 1.");
    row("steal - --entry a --from b --map 0,0",
        "a {\n .5 0 0 .5 0 0 1\n}\nb {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 1 0 1\n}\n",
        "“a” and “b” must have the same number of active maps; they have 1 and 2.");
}

void CliMannersTest::onesAreSingular() {
    QFETCH(QByteArray, input);
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, said);
    const Result result = run(arguments, input);
    QVERIFY2((result.out + result.err).contains(said), (result.out + result.err).constData());
    static const QRegularExpression plural(
        QStringLiteral("\\b1 (more )?(active )?(number|map|frame|entr|pixel|"
                       "point|column|vertic|facet|problem|picture)(s|ies|es)\\b"));
    QVERIFY2(!plural.match(QString::fromUtf8(result.out + result.err)).hasMatch(), result.err.constData());
}

// What is put in the places of a message has no places of its own.
void CliMannersTest::percentSignsOfNamesStay() {
    const QByteArray moving =
                         "%1%2%3%4 {\n ; barycage: animation 8 24/1 cycle\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 "
                         "0 .5\n}\n",
                     single = "a%2 {\n .5 0 0 .5 0 0 1\n}\n";
    write("percent.ifs", moving + single + single);
    const auto says = [this](const QByteArray& arguments, const QByteArray& sentence) {
        const Result result = run(arguments);
        QVERIFY2(result.err.contains(sentence), result.err.constData());
    };
    says("render percent.ifs -o x.png --frame 99", "“%1%2%3%4” has the frames 0 to 8;");
    says("animate percent.ifs -o x.#.png --size 9x9 --points 99 --frames 99",
         "The last frame of “%1%2%3%4” has the number 8;");
    says("steal percent.ifs --entry %1%2%3%4 --from a%2 --map 0,0",
         "“%1%2%3%4” and “a%2” must have the same number of active maps; they have 2 and 1.");
    QCOMPARE(run("convert percent.ifs percent.flame").status, 0);
    QCOMPARE(run("info percent.flame --names").out, QByteArray("%1%2%3%4\na%2\na%2_2\n"));
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("f")));
    QCOMPARE(run("animate percent.ifs -o f/50%2.#.png --size 10x10 --points 99").status, 0);
    const Result encoded = run("encode f/50%2.#.png -o percent.gif");
    QVERIFY2(encoded.status == 0, encoded.err.constData());
}

void CliMannersTest::helpHasGroupsAndDefaults() {
    for (const QByteArray command : {"info", "render", "convert", "gallery", ""}) {
        const QByteArray help = run(command + " --help").out;
        for (const char* raw :
             {"TEXT", "INT", "UINT", "FLOAT", "BOOLEAN", "REQUIRED", " x ", "Excludes", "(2"})
            QVERIFY2(command == "gallery" && raw == QByteArray("TEXT") ? help.contains("--title TEXT")
                                                                       : !help.contains(raw),
                     help.constData());
        for (const QByteArray& line : help.split('\n'))
            QVERIFY2(QString::fromUtf8(line).size() <= 80, line.constData());
    }
    const QByteArray render = run("render --help").out;
    for (const char* part :
         {"\nFiles:\n", "\nView and cage:\n", "\nAlgorithm:\n", "\nColours:\n", "-o, --output OUT",
          "[default: 1200x900]", "[default: 5]", "[default: density]", "else Maple]", "avx512"})
        QVERIFY2(render.contains(part), part);
    QVERIFY(!render.contains("avx3"));
}

void CliMannersTest::helpIsFoundByEveryName() {
    const QByteArray render = run("render --help").out;
    QVERIFY(render.size() > 1000);
    for (const char* arguments :
         {"help render", "--help render", "render -h", "render systems.ifs -h --size"})
        QCOMPARE(run(arguments).out, render);
    QCOMPARE(run("help").out, run("--help").out);
    QCOMPARE(run("-h").out, run("--help").out);
    QVERIFY(run("-V").out.startsWith("barycage-cli "));
    QCOMPARE(run("help nonsense").status, 2);
}

void CliMannersTest::countsAreTakenAsTheyAreWritten_data() {
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<QByteArray>("plain");
    const auto row = [](const char* written, const char* plain) {
        QTest::newRow(written) << QByteArray(written) << QByteArray(plain);
    };
    row("2e4", "20000");
    row("2E+4", "20000");
    row("20k", "20000");
    row("0.02M", "20000");
    row("2.50e4", "25000");
    row("0.00002G", "20000");
}

void CliMannersTest::countsAreTakenAsTheyAreWritten() {
    QFETCH(QByteArray, written);
    QFETCH(QByteArray, plain);
    const QByteArray render = "render systems.ifs --size 40x30 --algorithm chaos-game -o ";
    QCOMPARE(run(render + "written.png --points " + written).status, 0);
    QCOMPARE(run(render + "plain.png --points " + plain).status, 0);
    QCOMPARE(read("written.png"), read("plain.png"));
    QCOMPARE(run("convert systems.ifs --entry fern - --to csv --points " + written).out.count('\n'),
             plain.toInt() + 1);
}

void CliMannersTest::limitsAreSaid_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("limits");
    const auto row = [](const char* arguments, const char* limits) {
        QTest::newRow(arguments) << QByteArray(arguments) << QByteArray(limits);
    };
    row("--points 1e-3", "from 1 to 18446744073709551615");
    row("--points 1.5", "from 1 to 18446744073709551615");
    row("--points 1e99", "from 1 to 18446744073709551615");
    row("--points 20T20", "from 1 to 18446744073709551615");
    row("--points 30000000000G", "from 1 to 18446744073709551615");
    row("--points ''", "is not valid");
    row("--size 1000001x9", "1 to 1000000 pixels");
    row("--size x", "1 to 1000000 pixels");
    row("--size 12", "1 to 1000000 pixels");
    row("--size -5x", "1 to 1000000 pixels");
    row("--margin 50", "from 0 to less than 50");
    row("--supersample 5", "from 1 to 4");
    row("--dpi 0.5", "from 1 to 100000");
    row("--dpi 0", "“0” is not valid: it must be a number from 1 to 100000");
}

void CliMannersTest::limitsAreSaid() {
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, limits);
    const Result result = run("render systems.ifs -o x.png " + arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(limits), result.err.constData());
}

// The maple is 6.64 wide and 8.25 high.
void CliMannersTest::oneSideKeepsTheProportions() {
    const QByteArray render = "render systems.ifs --points 1000 -o side.png --size ";
    QCOMPARE(run(render + "664x").status, 0);
    QCOMPARE(size("side.png"), QSize(664, 824));
    QCOMPARE(run(render + "x824").status, 0);
    QCOMPARE(size("side.png"), QSize(664, 824));
    write("line.ifs", "line {\n .5 0 0 0 0 0 1\n .5 0 0 0 .5 0 1\n}\n");
    QCOMPARE(run("render line.ifs --points 1000 -o side.png --size 500x").status, 0);
    QCOMPARE(size("side.png"), QSize(500, 5));
    const Result view = run(render + "664x --view 0,0,10");
    QCOMPARE(view.status, 2);
    QVERIFY2(view.err.contains("give both sides"), view.err.constData());
}

void CliMannersTest::shortNames() {
    const QByteArray render = "render systems.ifs --size 40x30 --points 20000 -o ";
    QCOMPARE(run(render + "long.png --colour map --threads 2 --simd scalar").status, 0);
    QCOMPARE(run("render systems.ifs --size 40x30 --points 20000 -oshort.png --color map -qj2 --simd=scalar")
                 .status,
             0);
    QCOMPARE(read("short.png"), read("long.png"));
}

void CliMannersTest::quietSaysNoWarnings() {
    const QByteArray render =
        "render systems.ifs --entry spin --size 20x15 --points 1000 -o spin.png --progress always";
    QVERIFY(run(render).err.contains("warning"));
    const Result quiet = run(render + " -q");
    QCOMPARE(quiet.status, 0);
    QCOMPARE(quiet.err, QByteArray());
    QVERIFY(run("info broken.ifs --quiet").err.startsWith("broken.ifs:6:"));
}

void CliMannersTest::signalsHaveTheirStatus_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<QByteArray>("arguments");
    for (const char* arguments :
         {"render systems.ifs -o never.png --size 300x300 --points 1e15 --progress always",
          "convert systems.ifs never.csv --entry fern --points 2e7 --progress always"})
        for (const int signal : {SIGINT, SIGTERM, SIGHUP})
            QTest::addRow("%d %s", signal, arguments) << signal << QByteArray(arguments);
}

void CliMannersTest::signalsHaveTheirStatus() {
    QFETCH(int, signal);
    QFETCH(QByteArray, arguments);
    QProcess process;
    start(process, arguments);
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 60'000);
    QVERIFY(process.state() == QProcess::Running && process.processId() > 0);
    QCOMPARE(::kill(pid_t(process.processId()), signal), 0);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 128 + signal);
    QVERIFY(process.readAllStandardError().contains("Interrupted"));
    QVERIFY(pictures("never.*").isEmpty());
}

// The first picture is there before the second, which never ends, is stopped.
void CliMannersTest::whatAnInterruptLeavesIsSaid() {
    write("slow.ifs", "quick {\n .5 0 0 .5 0 0 1\n}\nslow {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 .1 1\n .5 0 0 "
                      ".5 .1 .5 1\n}\n");
    QProcess process;
    start(process,
          "render slow.ifs --entry all -o cut-%e.png --size 9x9 --algorithm chaos-game --points 1e8 -j1");
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForFinished(10) || !pictures("cut-quick.png").isEmpty(), 60'000);
    process.terminate();
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 143);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.contains("Interrupted; pictures written: 1 of 2."), said.constData());
    QVERIFY(pictures("cut-slow.png").isEmpty());
}

void CliMannersTest::severalPicturesInOneCall() {
    const QByteArray render = "render --size 20x15 --points 1000 -q ";
    QCOMPARE(run(render + "systems.ifs --entry all -o all-%n-%e.png").status, 0);
    QCOMPARE(pictures("all-*.png"),
             (QStringList{QStringLiteral("all-1-maple.png"), QStringLiteral("all-2-Fern.png"),
                          QStringLiteral("all-3-spin.png")}));
    QCOMPARE(run(render + "systems.ifs --entry fern -o fern.png").status, 0);
    QCOMPARE(read("all-2-Fern.png"), read("fern.png"));
    // The first of each file, then chosen ones; what cannot be drawn is said and stops no other.
    QCOMPARE(run(render + "systems.ifs broken.ifs -o of-%f.png").status, 0);
    QCOMPARE(pictures("of-*.png"),
             (QStringList{QStringLiteral("of-broken.png"), QStringLiteral("of-systems.png")}));
    const Result some = run(render + "broken.ifs absent.ifs systems.ifs --entry all -o some-%f-%e-100%%.png");
    QCOMPARE(some.status, 3);
    QVERIFY2(some.err.contains("broken.ifs:6:") && some.err.contains("absent.ifs: error: "),
             some.err.constData());
    QCOMPARE(pictures("some-*.png").size(), 4);
    QVERIFY(pictures("some-*.png").contains(QStringLiteral("some-broken-good-100%.png")));
    // No name leads out of the folder.
    write("odd.ifs", "../odd {\n .5 0 0 .5 0 0 1\n}\n");
    QCOMPARE(run(render + "odd.ifs --entry all -o odd-%e.png").status, 0);
    QVERIFY(QFile::exists(path("odd-_._odd.png")));
    // None is read in another order than it has.
    write("turned.ifs", "a\u202Egnp.b {\n .5 0 0 .5 0 0 1\n}\n");
    QCOMPARE(run(render + "turned.ifs --entry all -o %e.png").status, 0);
    QVERIFY(QFile::exists(path("a_gnp.b.png")));
}

void CliMannersTest::foldersAreNoPatterns() {
    const QString folder = path("%n-%e-%f-%i-%%");
    QVERIFY(QDir().mkpath(folder));
    const QByteArray render = "render systems.ifs --size 9x9 -q -o %n-%e-%f-%i-%%/";
    QCOMPARE(run(render + "one.png").status, 0);
    QCOMPARE(run(render + "%n-100%%.png --entry all").status, 0);
    QCOMPARE(run(render + "step-%i.png --algorithm deterministic --iterations 0-1").status, 0);
    QCOMPARE(
        QDir(folder).entryList(QDir::Files),
        (QStringList{QStringLiteral("1-100%.png"), QStringLiteral("2-100%.png"), QStringLiteral("3-100%.png"),
                     QStringLiteral("one.png"), QStringLiteral("step-0.png"), QStringLiteral("step-1.png")}));
    const Result several = run(render + "all.png --entry all");
    QCOMPARE(several.status, 2);
    QVERIFY2(several.err.contains("into the name of the output"), several.err.constData());
}

void CliMannersTest::outputsThatCollideAreRefused() {
    const QByteArray map = " {\n .5 0 0 .5 0 0 1\n}\n";
    write("twins.ifs", "twin" + map + "other" + map + "twin" + map);
    const QByteArray render = "render twins.ifs --entry all --size 9x9 --points 100 -o ";
    const Result same = run(render + "twins-%e.png");
    QCOMPARE(same.status, 2);
    QVERIFY2(same.err.contains(
                 "“twin” of twins.ifs and “twin” of twins.ifs would both be written to “twins-twin.png”"),
             same.err.constData());
    const Result plain = run(render + "twins-all.png");
    QCOMPARE(plain.status, 2);
    QVERIFY2(plain.err.contains("-o '%e.png'"), plain.err.constData());
    QCOMPARE(run(render + "- --to png").status, 2);
    QVERIFY(pictures("twins-*").isEmpty());
    QCOMPARE(run(render + "twins-%n-%e.png").status, 0);
    QCOMPARE(pictures("twins-*").size(), 3);
}

void CliMannersTest::entriesByNumber() {
    const QByteArray rows = " .5 0 0 .5 0 0 1\n}\n";
    write("numbers.ifs",
          "twin {\n" + rows + "twin {\n 0 0 0 0 7 0 1\n" + rows + "#1 {\n 0 0 0 0 9 0 1\n" + rows);
    const Result second = run("info numbers.ifs --json --entry #2");
    QCOMPARE(second.status, 0);
    QCOMPARE(second.entry()[QLatin1String("maps")].toArray().size(), 2);
    QCOMPARE(run("convert numbers.ifs - --to csv --entry #2").out.count('\n'), 3);
    // A name goes before a number.
    QCOMPARE(run("info numbers.ifs --json --entry #1").entry()[QLatin1String("name")].toString(),
             QStringLiteral("#1"));
    const Result none = run("info numbers.ifs --entry #4");
    QCOMPARE(none.status, 1);
    QVERIFY2(none.err.contains("“#4”; the file has 3 entries"), none.err.constData());
    write("one.ifs", "one {\n" + rows);
    const Result other = run("info one.ifs --entry #2");
    QVERIFY2(other.err.contains("“#2”; the file has 1 entry."), other.err.constData());
    for (const char* number : {"#0", "#-1", "#", "#2x"})
        QCOMPARE(run(QByteArray("info numbers.ifs --entry ") + number).status, 1);
}

void CliMannersTest::stepsInOneCall() {
    const QByteArray render = "render systems.ifs --algorithm deterministic --size 60x45 -o ";
    QCOMPARE(run(render + "step-%i.png --iterations 0-3").status, 0);
    QCOMPARE(pictures("step-*.png").size(), 4);
    // All show the same part of the plane, so a step is the picture that the same view gives alone.
    QCOMPARE(run(render + "alone.png --iterations 2 --view 0,0,30").status, 0);
    QCOMPARE(run(render + "view-%i.png --iterations 1-2 --view 0,0,30").status, 0);
    QCOMPARE(read("view-2.png"), read("alone.png"));
    QVERIFY(QImage(path("step-0.png")) != QImage(path("step-3.png")));
    QCOMPARE(run(render + "many-%i.png --iterations 8-10").status, 0);
    QCOMPARE(pictures("many-*.png").first(), QStringLiteral("many-08.png"));
    for (const char* wrong : {"6-0", "0-", "-3", "a-b", "0-6-7", "0-2000"})
        QCOMPARE(run(render + "wrong.png --iterations " + wrong).status, 2);
    QVERIFY(pictures("wrong.png").isEmpty());
}

void CliMannersTest::stepsAsAStrip() {
    const QByteArray render =
        "render systems.ifs --algorithm deterministic --size 60x45 --view 0,0,30 --dpi 254 -o ";
    QCOMPARE(run(render + "strip.png --iterations 0-3").status, 0);
    QCOMPARE(run(render + "third.png --iterations 2").status, 0);
    const QImage strip(path("strip.png"));
    QCOMPARE(strip.size(), QSize(240, 45));
    QCOMPARE(strip.dotsPerMeterX(), 10000);
    QCOMPARE(strip.copy(120, 0, 60, 45), QImage(path("third.png")));
    QCOMPARE(run("info strip.png --json").entry()[QLatin1String("name")].toString(), QStringLiteral("maple"));
    QCOMPARE(run(render + "strip16.png --iterations 0-3 --bits 16").status, 2);
    QCOMPARE(run(render + "strip.svg --iterations 0-3").status, 2);
    QVERIFY(run(render + "- --to png --iterations 0-3").out == read("strip.png"));
}

void CliMannersTest::palettesAreListed() {
    const Result list = run("render --list-palettes");
    QCOMPARE(list.status, 0);
    const QByteArrayList names = list.out.trimmed().split('\n');
    QVERIFY(names.size() > 200);
    for (qsizetype i = 0; i < names.size(); i += i < 13 ? 1 : 13) // all built-in ones, some of the library
        QCOMPARE(run("render systems.ifs -o palette.png --size 9x9 --points 100 --palette \"" +
                     names[i].toLower() + '"')
                     .status,
                 0);
}

BARYCAGE_TEST(CliMannersTest, QGuiApplication);
#include "cli_manners_test.moc"
