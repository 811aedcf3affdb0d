// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>

#include <filesystem>

// What barycage-cli says of files: what is lost, what is guessed, what takes too long, and names that are
// bytes.
class CliFilesTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void writeSystems();
    void namesNeedNotBeUtf8();
    void otherArgumentsAreText();
    void anInputIsNotReplacedByLess_data();
    void anInputIsNotReplacedByLess();
    void anInputIsReplacedByAllItHolds();
    void whatAFormatDropsIsSaid_data();
    void whatAFormatDropsIsSaid();
    void lossesAreSaidAtTheLineOfTheEntry();
    void whatIsKeptIsNotLamented();
    void namesOfFlamesAreFound();
    void aifsComesBack();
    void bareRowsAreReadByLines_data();
    void bareRowsAreReadByLines();
    void leniencyIsSaid();
    void wordsOfInfo();
    void aBudgetEndsADimension();
    void aBudgetEndsAWholeCall();
    void listIsShort();
    void aHullThatIsNotReachedIsSaid();
    void aSheetOfSomeEntriesIsWhole();
    void aSheetIsAsWideAsAScreen();
    void aLightSheetHasLightTiles();
    void oddNamesAreShownAsTheyAre();
    void standardOutputLeavesNothingAnywhere();
    void hardLinksAreSaidToKeepTheOld();
    void cleanupTestCase();

private:
    // With raw bytes in the arguments, which QProcess cannot pass.
    Result shell(const char* script) const;
};

void CliFilesTest::writeSystems() {
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    write("caged.ifs", "caged {\n; barycage: rest 0 0\n; barycage: rest 1 0\n; barycage: rest 0 1\n"
                       "; barycage: current 0 0\n; barycage: current 2 0\n; barycage: current 0 1\n" +
                           rows + "plain {\n" + rows);
}

CliFilesTest::Result CliFilesTest::shell(const char* script) const {
    QProcess process;
    process.setWorkingDirectory(path(""));
    process.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), QString::fromLatin1(script),
                                              support::buildPath(QStringLiteral("barycage-cli"))});
    if (!process.waitForFinished(60'000)) return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

// Bytes in, bytes out.
void CliFilesTest::namesNeedNotBeUtf8() {
    const auto exists = [this](const char* name) {
        return std::filesystem::exists(std::filesystem::path(path("").toStdString()) / name);
    };
    QCOMPARE(shell("cp caged.ifs $(printf 'm\\344ple.ifs')").status, 0);
    const Result info = shell("exec $0 info --json $(printf 'm\\344ple.ifs')");
    QCOMPARE(info.status, 0);
    QVERIFY2(info.out.contains("\"file\": \"m\\udce4ple.ifs\""), info.out.left(200).constData());
    QCOMPARE(shell("exec $0 render $(printf 'm\\344ple.ifs') -o $(printf 'm\\344ple.png') --size 9x9").status,
             0);
    QVERIFY(exists("m\344ple.png"));
    QCOMPARE(shell("exec $0 render $(printf 'm\\344ple.ifs') -o $(printf '%%f-\\374.png') --size 9x9").status,
             0);
    QVERIFY(exists("m\344ple-\374.png"));
    QCOMPARE(shell("exec $0 convert $(printf 'm\\344ple.ifs') $(printf 'f\\344rn/') --to flame").status, 0);
    QVERIFY(exists("f\344rn/m\344ple.flame"));
    QCOMPARE(shell("exec $0 gallery $(printf 'm\\344ple.ifs') -o $(printf 'g\\344.png') --tile 40x40").status,
             0);
    QVERIFY(exists("g\344.png"));
    const Result absent = shell("exec $0 info $(printf 'no\\344.ifs')");
    QCOMPARE(absent.status, 3);
    QVERIFY2(absent.err.startsWith("no\\xe4.ifs: error: "), absent.err.constData());
    QCOMPARE(shell("exec $0 render caged.ifs -o $(printf 'no\\344/x.png')").status, 3);
    QCOMPARE(shell("exec $0 render caged.ifs -o x.png --palette $(printf 'no\\344.gpl')").status, 3);
}

void CliFilesTest::otherArgumentsAreText() {
    const Result entry = shell("exec $0 info caged.ifs --entry $(printf 'm\\344ple')");
    QCOMPARE(entry.status, 2);
    QVERIFY2(entry.err.contains("The value of --entry is not valid UTF-8."), entry.err.constData());
}

void CliFilesTest::anInputIsNotReplacedByLess_data() {
    QTest::addColumn<QByteArray>("arguments");
    for (const char* arguments :
         {"same.ifs same.ifs --entry plain", "same.ifs ./same.ifs --entry plain",
          "same.ifs link.ifs --entry plain", "same.ifs same.ifs --to flame", "same.ifs same.ifs --strict",
          "same.ifs same.ifs --entry caged --bake", "same.ifs same.ifs --to csv --entry plain",
          "same.ifs same.ifs --to csv --points 9 --entry plain",
          "other.ifs same.ifs . --to ifs --entry plain", "deep/same.ifs same.ifs . --to ifs --entry plain"})
        QTest::newRow(arguments) << QByteArray(arguments);
}

void CliFilesTest::anInputIsNotReplacedByLess() {
    QFETCH(QByteArray, arguments);
    write("same.ifs", read("caged.ifs"));
    write("other.ifs", read("caged.ifs"));
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("deep")));
    write("deep/same.ifs", read("caged.ifs"));
    QFile::link(QStringLiteral("same.ifs"), path("link.ifs"));
    const Result refused = run("convert " + arguments);
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains("--overwrite"), refused.err.constData());
    QVERIFY2(!refused.err.contains("Entries written"), refused.err.constData());
    QCOMPARE(read("same.ifs"), read("caged.ifs"));
    QCOMPARE(read("other.ifs"), read("caged.ifs"));
    QCOMPARE(run("convert " + arguments + " --overwrite").status, 0);
    QVERIFY(read("same.ifs") != read("caged.ifs"));
}

void CliFilesTest::anInputIsReplacedByAllItHolds() {
    write("whole.ifs", read("caged.ifs"));
    QCOMPARE(run("convert whole.ifs whole.ifs").status, 0);
    QCOMPARE(read("whole.ifs"), read("caged.ifs"));
    QCOMPARE(run("convert whole.ifs whole.ifs --entry all").status, 0);
    QCOMPARE(run("convert whole.ifs whole.ifs --bake").status, 0);
    QCOMPARE(run("info whole.ifs --list").out.count('\n'), 2);
}

void CliFilesTest::whatAFormatDropsIsSaid_data() {
    QTest::addColumn<QByteArray>("comment");
    QTest::addColumn<QByteArray>("format");
    QTest::addColumn<QByteArray>("said");
    const QByteArray cage = "; barycage: rest 0 0\n; barycage: rest 1 0\n; barycage: rest 0 1\n"
                            "; barycage: current 0 0\n; barycage: current 2 0\n; barycage: current 0 1\n";
    for (const char* format : {"flame", "csv", "tsv", "aifs"})
        QTest::newRow(format)
            << cage << QByteArray(format)
            << QByteArray("“e” is written without its cage: other programs will draw a different picture.");
    const QByteArray red("; barycage: background #ff0000ff\n");
    const QByteArray groundLost("“e” is written without its background.");
    QTest::newRow("background") << red << QByteArray("csv") << groundLost;
    QTest::newRow("background, strict") << red << QByteArray("fractint --strict") << groundLost;
    QTest::newRow("transparent") << QByteArray("; barycage: background #ff000000\n") << QByteArray("flame")
                                 << groundLost;
    QTest::newRow("palette, strict") << QByteArray("; barycage: palette Fire\n; barycage: stop 0 #000000ff\n"
                                                   "; barycage: stop 1 #ff0000ff\n")
                                     << QByteArray("fractint --strict")
                                     << QByteArray("“e” is written without its palette.");
    QTest::newRow("gamma") << QByteArray("; barycage: gamma 3\n") << QByteArray("csv")
                           << QByteArray("“e” is written without its other colour settings.");
    QTest::newRow("contrast") << QByteArray("; barycage: contrast 3\n") << QByteArray("fractint --strict")
                              << QByteArray("“e” is written without its other colour settings.");
    QTest::newRow("vibrancy") << QByteArray("; barycage: vibrancy 0\n") << QByteArray("tex")
                              << QByteArray("“e” is written without its other colour settings.");
    const QByteArray moving("; barycage: animation 6 24/1 cycle\n; barycage: motion sway\n"
                            "; barycage: strength 4\n; barycage: pivot 0 0\n; barycage: wave 1\n"
                            "; barycage: value 1 0 25\n");
    for (const char* format : {"flame", "csv", "aifs", "tex", "fractint --strict"})
        QTest::addRow("animation, %s", format)
            << moving << QByteArray(format) << QByteArray("“e” is written without its animation.");
    QTest::newRow("strict") << cage << QByteArray("fractint --strict")
                            << QByteArray(": warning: “e” is written without its cage");
}

void CliFilesTest::whatAFormatDropsIsSaid() {
    QFETCH(QByteArray, comment);
    QFETCH(QByteArray, format);
    QFETCH(QByteArray, said);
    write("loss.ifs", "e {\n" + comment + " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    const Result result = run("convert loss.ifs - --to " + format);
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("warning: ") && result.err.contains(said), result.err.constData());
    QCOMPARE(run("convert loss.ifs - -q --to " + format).err, QByteArray());
}

void CliFilesTest::lossesAreSaidAtTheLineOfTheEntry() {
    const QByteArray maps = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    write("lines.ifs", "first {\n" + maps + "\nsecond {\n; barycage: background #ff0000ff\n" + maps +
                           "a_name_that_is_longer_than_others {\n" + maps);
    for (const char* format : {"fractint --strict", "csv --entry second"}) {
        const Result result = run(QByteArray("convert lines.ifs - --to ") + format);
        QCOMPARE(result.status, 0);
        QVERIFY2(result.err.contains("lines.ifs:6:1: warning: “second” is"), result.err.constData());
    }
    const Result strict = run("convert lines.ifs - --to fractint --strict");
    QVERIFY2(strict.err.contains("others”: The entry is saved") &&
                 strict.err.contains("lines.ifs:11:1: warning: “a_name"),
             strict.err.constData());
}

void CliFilesTest::whatIsKeptIsNotLamented() {
    for (const char* format : {"flame", "aifs", "fractint"})
        QCOMPARE(run(QByteArray("convert caged.ifs - --entry plain --to ") + format).err, QByteArray());
    QCOMPARE(run("convert caged.ifs - --entry caged --bake --to csv").err, QByteArray());
    write("red.ifs",
          "e {\n; barycage: background #ff0000ff\n; barycage: colour-by map\n .5 0 0 .5 0 0 1\n}\n");
    QCOMPARE(run("convert red.ifs red.flame").err, QByteArray());
    QVERIFY(read("red.flame").contains("background=\"1 0 0\""));
    QCOMPARE(run("convert red.flame back.ifs").err, QByteArray());
    QVERIFY(read("back.ifs").contains("; barycage: background #ff0000ff"));
}

void CliFilesTest::namesOfFlamesAreFound() {
    write("long.flame",
          "<flames><flame name=\"Equilateral Sierpinski triangle by nobody\"><xform weight=\"1\" "
          "linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame></flames>");
    QCOMPARE(run("info long.flame --names").out, QByteArray("Equilateral Sierpinski triangle by nobody\n"));
    const Result found = run("info --json long.flame --entry \"Equilateral Sierpinski triangle by nobody\"");
    QCOMPARE(found.status, 0);
    QCOMPARE(found.entry()[QLatin1String("name")].toString().size(), 41);
    QCOMPARE(run("convert long.flame long.ifs").status, 0);
    QVERIFY2(read("long.ifs").startsWith("Equilateral_Sierpinski_triangle_by_nobody { ; Equilateral Sier"),
             read("long.ifs").constData());
    QCOMPARE(run("info long.ifs --names").out, QByteArray("Equilateral_Sierpinski_triangle_by_nobody\n"));
}

void CliFilesTest::aifsComesBack() {
    QCOMPARE(run("convert systems.ifs back.aifs --entry maple --entry fern").status, 0);
    QCOMPARE(run("info back.aifs --names").out, QByteArray("maple\nFern\n"));
    const auto maps = [this](const char* file) {
        return run(QByteArray("info --json --entry fern ") + file).entry()[QLatin1String("maps")].toArray();
    };
    const QJsonArray before = maps("systems.ifs"), after = maps("back.aifs");
    QCOMPARE(after.size(), 4);
    for (int i = 0; i < 4; ++i)
        for (const char* key : {"linear", "translation", "weight_in_file"})
            QVERIFY2(before[i][QLatin1String(key)] == after[i][QLatin1String(key)], key);
    QVERIFY(run("info back.aifs --json").out.contains("\"format\": \"aifs\""));
}

void CliFilesTest::bareRowsAreReadByLines_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<bool>("isOpen"); // as rows of seven the weights sum to 1 as well
    for (const char* file : {"rows.ifs", "rows.csv"})
        for (const bool isOpen : {false, true})
            QTest::addRow("%s %d", file, isOpen) << QByteArray(file) << isOpen;
}

// Seven lines of six numbers fill six rows of seven.
void CliFilesTest::bareRowsAreReadByLines() {
    QFETCH(QByteArray, file);
    QFETCH(bool, isOpen);
    QByteArrayList numbers;
    for (int i = 0; i < 42; ++i)
        numbers << (i % 7 != 6 ? "0." + QByteArray::number(i % 5)
                    : isOpen   ? QByteArray(i == 6 ? "0.5" : "0.1")
                               : "0.9");
    QByteArray bytes;
    for (int i = 0; i < 42; i += 6)
        bytes += numbers.mid(i, 6).join(file.endsWith("csv") ? "," : " ") + '\n';
    write(file, bytes);
    const Result result = run("info --json " + file);
    const QJsonArray maps = result.entry()[QLatin1String("maps")].toArray();
    QCOMPARE(maps.size(), 7);
    QCOMPARE(maps[1][QLatin1String("linear")][0][0].toDouble(), numbers[6].toDouble());
    QCOMPARE(result.err.contains("or as 6 maps of 7 numbers, whose weights then sum to 1"), isOpen);
    // With seven numbers on each line there is nothing to say.
    bytes.clear();
    for (int i = 0; i < 42; i += 7)
        bytes += numbers.mid(i, 7).join(file.endsWith("csv") ? "," : " ") + '\n';
    write(file, bytes);
    QCOMPARE(run("info --json " + file).entry()[QLatin1String("maps")].toArray().size(), 6);
}

void CliFilesTest::leniencyIsSaid() {
    write("cr.ifs", "a {\r .5 0 0 .5 0 0 1\r}\r");
    const Result cr = run("info --list cr.ifs");
    QCOMPARE(cr.status, 0);
    QVERIFY2(cr.err.contains("cr.ifs:1:1: warning: The lines end with CR alone"), cr.err.constData());
    write("prefix.ifs", "; head\n\nifs:a {\n .5 0 0 .5 0 0 1\n}\nifs:b {\n .5 0 0 .5 0 0 1\n}\n");
    const Result prefix = run("info --list prefix.ifs");
    QCOMPARE(prefix.err.count("“ifs:”"), 1);
    QVERIFY2(prefix.err.contains("prefix.ifs:3:"), prefix.err.constData());
    write("set.par", "view {\n type=ifs ifs=leaf\n}\nifs:leaf {\n .5 0 0 .5 0 0 1\n}\n");
    QVERIFY(!run("info --list set.par").err.contains("“ifs:”"));
}

void CliFilesTest::wordsOfInfo() {
    write("words.ifs", "one {\n .9999999999 0 0 .5 1 0 1\n}\n");
    const QString text = QString::fromUtf8(run("info words.ifs").out);
    QVERIFY2(text.startsWith(QStringLiteral("one — in the plane, 1 map\n")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("hyperbolic, s = 0.9999999999\n")), qPrintable(text));
    QVERIFY(run("info systems.ifs").out.contains("maple — in the plane, 4 maps\n"));
}

void CliFilesTest::aBudgetEndsADimension() {
    QByteArray rows;
    for (int i = 0; i < 59; ++i)
        rows += " ." + QByteArray::number(10 + i % 7) + " .0" + QByteArray::number(1 + i % 9) + " -.0" +
                QByteArray::number(1 + i % 8) + " .0" + QByteArray::number(5 + i % 4) + ' ' +
                QByteArray::number(i) + " 0 1\n";
    write("many.ifs", "many {\n" + rows + "}\n");
    const Result whole = run("info many.ifs --json --budget none");
    QVERIFY(whole.entry()[QLatin1String("affinity_dimension")].isDouble());
    QVERIFY(whole.entry()[QLatin1String("out_of_time")].toArray().isEmpty());
    const Result cut = run("info many.ifs --json --budget 1e-6");
    QCOMPARE(cut.status, 0);
    const QJsonArray late = cut.entry()[QLatin1String("out_of_time")].toArray();
    for (const char* key : {"attractor", "bounding_box", "hull", "affinity_dimension", "connectedness"}) {
        QVERIFY2(cut.entry()[QLatin1String(key)].isNull(), key);
        QVERIFY2(late.contains(QLatin1String(key)), key);
    }
    QCOMPARE(cut.entry()[QLatin1String("mean")], whole.entry()[QLatin1String("mean")]);
    const QString text = QString::fromUtf8(run("info many.ifs --budget 1e-6").out);
    for (const char* name :
         {"attractor", "bounding box", "convex hull", "affinity dimension", "connectedness"})
        QVERIFY2(text.contains(QRegularExpression(QLatin1String(name) +
                                                  QStringLiteral(" +not computed within the budget\n"))),
                 qPrintable(text));
    QVERIFY(!run("info many.ifs --no-dimension").out.contains("affinity"));
    const Result without = run("info many.ifs --no-dimension --json");
    QVERIFY(without.entry()[QLatin1String("affinity_dimension")].isNull());
    QVERIFY(without.entry()[QLatin1String("out_of_time")].toArray().isEmpty());
    for (const char* wrong : {"0", "-1", "soon", "1e7"})
        QCOMPARE(run(QByteArray("info many.ifs --budget ") + wrong).status, 2);
}

// A small file of many systems, each of which takes seconds: its facts would take minutes.
void CliFilesTest::aBudgetEndsAWholeCall() {
    QByteArray file;
    for (int i = 0; i < 60; ++i)
        file += "slow" + QByteArray::number(i) +
                " (3D) {\n"
                " 0.534899 0.346674 0.757496 0.833056 -0.222597 -0.486383 0 0.900204 -0.411985 -0.882235 "
                "6.22599 -2.0481 1\n"
                " -0.411985 0.588413 -0.681277 0.900204 0.269292 -0.311792 0 -0.749234 -0.647107 4.10419 "
                "5.4724 5.97484 1\n}\n";
    write("slow.ifs", file);
    QElapsedTimer timer;
    timer.start();
    const Result cut = run("info slow.ifs --json --budget 0.02");
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(cut.status, 0);
    const auto late = [&](int entry, const char* key) {
        return cut.entry(entry)[QLatin1String("out_of_time")].toArray().contains(QLatin1String(key));
    };
    QVERIFY(late(0, "hull") && !late(0, "attractor") && late(59, "hull") && late(59, "attractor"));
    QCOMPARE(cut.entry(59)[QLatin1String("maps")].toArray().size(), 2);
    const QByteArray text = run("info slow.ifs --budget 0.02").out;
    QVERIFY(text.mid(text.indexOf("slow59"))
                .contains("attractor               not computed within the budget\n"));
}

void CliFilesTest::listIsShort() {
    write("list.ifs", read("systems.ifs") + "bad {\n x\n}\nsolid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n");
    const QString list = QString::fromUtf8(run("info list.ifs --list").out);
    QCOMPARE(list.simplified(),
             QStringLiteral("1 in the plane, 4 maps maple 2 in the plane, 4 maps Fern 3 in the plane, "
                            "1 map spin 4 could not be read bad 5 in space, 1 map solid"));
    QVERIFY(run("info list.ifs --list --entry #5").out.startsWith("    5  in space"));
    const Result json = run("info list.ifs --list --json --entry #2 --entry #4 --entry #5");
    const QJsonArray entries = QJsonDocument::fromJson(json.out)[QLatin1String("entries")].toArray();
    QCOMPARE(entries.size(), 3);
    QCOMPARE(entries[0].toObject(), (QJsonObject{{QStringLiteral("number"), 2},
                                                 {QStringLiteral("name"), QStringLiteral("Fern")},
                                                 {QStringLiteral("dimension"), 2},
                                                 {QStringLiteral("loaded"), true},
                                                 {QStringLiteral("map_count"), 4}}));
    QCOMPARE(entries[1][QLatin1String("loaded")].toBool(true), false);
    QVERIFY(entries[1][QLatin1String("map_count")].isNull() &&
            entries[1][QLatin1String("dimension")].isNull());
    QCOMPARE(entries[2][QLatin1String("dimension")].toInt(), 3);
    QCOMPARE(run("info list.ifs --list --names").status, 2);
}

void CliFilesTest::aHullThatIsNotReachedIsSaid() {
    const Result near = run("info systems.ifs --entry fern --hull-tolerance 1e-3");
    QCOMPARE(near.err, QByteArray());
    const Result out = run("info systems.ifs --entry fern --hull-tolerance 1e-18");
    QCOMPARE(out.status, 0);
    QVERIFY2(out.err.contains("“Fern”: The convex hull has an error of up to ") &&
                 out.err.contains("the tolerance 1e-18 was not reached"),
             out.err.constData());
    constexpr int line = 7; // of the entry
    QVERIFY2(out.err.startsWith("systems.ifs:7:1: warning: "), out.err.constData());
    const Result json = run("info systems.ifs --entry fern --json --hull-tolerance 1e-18");
    QVERIFY(json.err.contains("was not reached"));
    const QJsonArray problems = QJsonDocument::fromJson(json.out)[QLatin1String("problems")].toArray();
    QCOMPARE(problems.size(), 1);
    QVERIFY(problems[0][QLatin1String("message")].toString().contains(QStringLiteral("was not reached")));
    QCOMPARE(problems[0][QLatin1String("entry")].toString(), QStringLiteral("Fern"));
    QCOMPARE(problems[0][QLatin1String("line")].toInt(), line);
    // Nor is the usual tolerance for a round hull in space.
    write("fern3.ifs",
          "fern3 (3D) {\n 0 0 0 0 .18 0 0 0 0 0 0 0 .01\n .85 0 0 0 .85 .1 0 -.1 .85 0 1.6 0 .85\n"
          " .2 -.2 0 .2 .2 0 0 0 .3 0 .8 0 .07\n -.2 .2 0 .2 .2 0 0 0 .3 0 .8 0 .07\n}\n");
    const Result round = run("info fern3.ifs");
    QVERIFY2(round.err.contains("was not reached"), (round.out + round.err).constData());
    QCOMPARE(run("info systems.ifs").err, QByteArray());
}

void CliFilesTest::aSheetOfSomeEntriesIsWhole() {
    const Result result = run("gallery broken.ifs -o some.png --tile 40x40");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.startsWith("broken.ifs:6:") && result.err.contains(": warning: ") &&
                 !result.err.contains("error"),
             result.err.constData());
    QCOMPARE(run("gallery broken.ifs systems.ifs -o one.png --tile 40x40 --entry fern").status,
             1); // none in the first
    const QByteArray fern = "gallery systems.ifs -o fern.png --tile 60x60 --entry fern ";
    QCOMPARE(run(fern).status, 0);
    const QImage usual(path("fern.png"));
    QCOMPARE(run(fern + "--palette Glacier").status, 0);
    const QImage glacier(path("fern.png"));
    QCOMPARE(glacier.size(), usual.size());
    QVERIFY(glacier != usual);
    QCOMPARE(run(fern + "--color map").status, 0);
    QVERIFY(QImage(path("fern.png")) != usual);
    QCOMPARE(run(fern + "--palette nonsense").status, 2);
}

void CliFilesTest::aSheetIsAsWideAsAScreen() {
    QByteArray bytes;
    for (int i = 0; i < 40; ++i)
        bytes += "e" + QByteArray::number(i) + " {\n .5 0 0 .5 0 0 1\n}\n";
    write("forty.ifs", bytes);
    QCOMPARE(run("gallery forty.ifs -o forty.png --tile 400x20").status, 0);
    const QImage sheet(path("forty.png"));
    QVERIFY2(sheet.width() > 1000 && sheet.width() <= 1920, qPrintable(QString::number(sheet.width())));
}

void CliFilesTest::aLightSheetHasLightTiles() {
    const auto darkShare = [this](const QByteArray& paper) {
        if (run("gallery systems.ifs -o paper.png --tile 90x90 --entry fern --paper " + paper).status != 0)
            return -1.0;
        const QImage sheet(path("paper.png"));
        int dark = 0;
        for (int y = 0; y < sheet.height(); ++y)
            for (int x = 0; x < sheet.width(); ++x)
                dark += qGray(sheet.pixel(x, y)) < 60;
        return double(dark) / double(sheet.width() * sheet.height());
    };
    QVERIFY(darkShare("dark") > 0.5);
    const double light = darkShare("light");
    QVERIFY2(light >= 0 && light < 0.25, qPrintable(QString::number(light)));
}

// Placeholders of our own messages, marks that turn text, backslashes and colons.
void CliFilesTest::oddNamesAreShownAsTheyAre() {
    const QByteArray body = " {\n; barycage: background #ff0000ff\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    const QByteArray turned = "a\xe2\x80\xae"
                              "b\xe2\x81\xa6";
    write("odd%1.ifs", "%1%2%3\\n:x" + body + turned + body + "%2 {\n .5 0 x\n}\n");
    for (const char* arguments : {"info odd%1.ifs --list", "info odd%1.ifs", "convert odd%1.ifs odd.csv",
                                  "convert odd%1.ifs odd.aifs", "info odd%1.ifs --entry #%2"}) {
        const Result result = run(arguments);
        const QByteArray all = result.out + result.err;
        QVERIFY2(all.contains(QByteArray(arguments).contains('#') ? "“#%2”" : "%1%2%3\\n:x"),
                 all.constData());
        QVERIFY2(!all.contains("\xe2\x80\xae") && !all.contains("\xe2\x81\xa6"), all.constData());
    }
    QCOMPARE(run("info odd.aifs --names").out, QByteArray("%1%2%3\\n:x\na\xef\xbf\xbd"
                                                          "b\xef\xbf\xbd\n"));
    QVERIFY(run("info odd%1.ifs --json").out.contains("\"%1%2%3\\\\n:x\""));
    QCOMPARE(run("render odd%1.ifs --entry #1 -o %n-%e%%.png --size 9x9").status, 0);
    QVERIFY(QFile::exists(path("1-%1%2%3\\n:x%.png")));
}

// Neither while it works nor when it is killed.
void CliFilesTest::standardOutputLeavesNothingAnywhere() {
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("temporary")));
    const QDir temporary(path("temporary"));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TMPDIR"), temporary.path());
    process.setProcessEnvironment(environment);
    start(process, "render systems.ifs -o - --to png --size 300x300 --points 1e15 --progress always");
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 60'000);
    QVERIFY(temporary.isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    process.kill();
    QVERIFY(process.waitForFinished(30'000));
    QVERIFY(temporary.isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    QCOMPARE(run("render systems.ifs -o file.png --size 60x40 --points 9999").status, 0);
    QCOMPARE(run("render systems.ifs -o - --to png --size 60x40 --points 9999").out, read("file.png"));
}

// QTemporaryDir cannot remove names that are not UTF-8.
void CliFilesTest::cleanupTestCase() {
    for (const auto& file : std::filesystem::directory_iterator(path("").toStdString()))
        std::filesystem::remove_all(file.path());
}

// As a backup may hold it by.
void CliFilesTest::hardLinksAreSaidToKeepTheOld() {
    for (const auto& [name, command] :
         {std::pair<QByteArray, QByteArray>("linked.csv", "convert linked.ifs linked.csv"),
          {"linked.png", "render linked.ifs --size 20x20 --points 9999 -o linked.png"}}) {
        write("linked.ifs", "plain {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
        const Result first = run(command);
        QVERIFY2(first.status == 0 && !first.err.contains("hard links"), first.err);
        const QByteArray old = read(name);
        std::filesystem::create_hard_link(path(name).toStdString(), path(name + ".kept").toStdString());
        write("linked.ifs", "plain {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 2 3 .5\n}\n");
        const Result again = run(command);
        QVERIFY2(again.status == 0 && again.err.contains("hard links"), again.err);
        QCOMPARE(read(name + ".kept"), old);
        QVERIFY(read(name) != old);
    }
}

BARYCAGE_TEST(CliFilesTest, QGuiApplication);
#include "cli_files_test.moc"
