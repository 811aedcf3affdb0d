// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <filesystem>

// Where barycage-cli writes: over none of the files that it reads, and under names that every file system
// takes.
class CliOutputsTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void noCommandReplacesAnInput_data();
    void noCommandReplacesAnInput();
    void standardInputIsNotReplaced_data();
    void standardInputIsNotReplaced();
    void noOutputReplacesAnother();
    void noOutputReplacesAnotherThroughALink();
    void sumsAreReplacedByMore();
    void everyNameMakesAFile_data();
    void everyNameMakesAFile();
    void longNamesAreToldApart();
    void librariesPrintNothing_data();
    void librariesPrintNothing();
};

void CliOutputsTest::noCommandReplacesAnInput_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QString>("file"); // which is read and would be written
    const auto row = [](const char* arguments, const char* file) {
        QTest::newRow(arguments) << QByteArray(arguments) << QString::fromLatin1(file);
    };
    row("render p.ifs -o p.ifs --to png", "p.ifs");
    row("render p.ifs -o ./p.ifs --to png --dry-run", "p.ifs");
    row("render p.ifs -o pointing.png", "p.ifs");
    row("render p.ifs -o pointing.sum --points 1k --size 9x9", "p.ifs");
    row("render space.ifs -o space.ifs --to png", "space.ifs");
    row("render other.ifs p.ifs -o %f.ifs --to png", "p.ifs");
    row("render p.ifs --palette two.gpl -o two.gpl --to png", "two.gpl");
    row("render --resume p.sum --points 3k --part 0/2 -o p.sum", "p.sum");
    row("render --resume p.png --points 3k -o p.png", "p.png");
    row("merge p.png -o p.png", "p.png");
    row("gallery a.png p.ifs -o a.png", "a.png");
    row("gallery p.ifs --palette two.png -o two.png", "two.png");
    row("animate frame.0002.png -o frame.####.png --size 9x9", "frame.0002.png");
    row("animate film.apng -o film.apng --size 9x9", "film.apng");
    row("encode frame.####.png -o pointing.apng", "frame.0001.png");
    row("page p.ifs --entry one -o p.ifs", "p.ifs");
    row("render p.ifs -o named.png --size 9x9", "p.ifs"); // another name of it, no link
    row("morph p.ifs --from one --to two -o p.ifs", "p.ifs");
    row("collage shape.ifs -o shape.ifs --seconds 1", "shape.ifs");
    row("collage shape.png -o new.ifs --report shape.png --seconds 1", "shape.png");
    row("steal p.ifs --entry one --from two --picture a.png -o a.png --size 9x9", "a.png");
    row("steal one.png --entry one --from two --from-file p.ifs --picture a.png -o one.png --size 9x9",
        "one.png");
}

// What it holds would be gone.
void CliOutputsTest::noCommandReplacesAnInput() {
    QFETCH(const QByteArray, arguments);
    QFETCH(const QString, file);
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    write("p.ifs", "one {\n" + rows + "two {\n" + rows);
    write("other.ifs", "other {\n" + rows);
    write("space.ifs", "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 1 1 1 .5\n}\n");
    write("two.gpl", "GIMP Palette\nName: two\n0 0 0 black\n255 255 255 white\n");
    write("two.png", read("two.gpl"));
    QFile::link(QStringLiteral("p.ifs"), path("pointing.png"));
    const QByteArray made[]{"render p.ifs -o a.png --size 9x9",
                            "render p.ifs --entry one -o one.png --size 9x9",
                            "render p.ifs -o shape.png --size 60x60 --background white",
                            "render p.ifs -o p.sum --points 1k --size 9x9",
                            "morph p.ifs --from one --to two --length 2 -o moving.ifs",
                            "animate moving.ifs -o frame.####.png --size 9x9",
                            "animate moving.ifs -o film.apng --size 9x9"};
    for (const QByteArray& command : made) {
        const Result result = run(command);
        QVERIFY2(result.status == 0, result.err.constData());
    }
    write("p.png", read("p.sum"));
    write("shape.ifs", read("shape.png"));
    QFile::remove(path("named.png"));
    std::filesystem::create_hard_link(path("p.ifs").toStdString(), path("named.png").toStdString());
    QFile::link(QStringLiteral("p.ifs"), path("pointing.sum"));
    QFile::link(QStringLiteral("frame.0001.png"), path("pointing.apng"));
    const QByteArray before = read(file.toLatin1());
    QVERIFY(!before.isEmpty());
    const Result refused = run(arguments);
    QVERIFY2(refused.err.contains("is an input file, and the output would replace it"),
             refused.err.constData());
    QCOMPARE(refused.status, 2);
    QCOMPARE(read(file.toLatin1()), before);
}

void CliOutputsTest::standardInputIsNotReplaced_data() {
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("status");
    const auto row = [](const char* arguments, int status) {
        QTest::newRow(arguments) << QString::fromLatin1(arguments) << status;
    };
    row("render - -o in.ifs --to png --size 9x9", 2);
    row("render - -o given.ifs --to png --size 9x9", 2);
    row("gallery - -o given.png", 2);
    row("render in.ifs -o - --to png --size 9x9 1<>in.ifs", 2);
    row("render in.ifs -o - --to png --size 9x9 1<>given.ifs", 2);
    row("convert in.ifs - --to flame --entry one 1<>in.ifs", 1);
    row("convert - in.ifs --to flame", 1);
    row("convert - in.ifs --entry one", 1);
    row("convert - given.ifs --to csv --entry one", 1);
    row("convert - in.ifs", 0); // which holds as much
}

// A file that the shell gives to the program is read as well.
void CliOutputsTest::standardInputIsNotReplaced() {
    QFETCH(const QString, arguments);
    QFETCH(const int, status);
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    write("in.ifs", "one {\n" + rows + "two {\n" + rows);
    for (const char* link : {"given.ifs", "given.png"})
        QFile::link(QStringLiteral("in.ifs"), path(link));
    const QByteArray before = read("in.ifs");
    QProcess shell;
    shell.setWorkingDirectory(path(""));
    shell.start(QStringLiteral("/bin/sh"),
                {QStringLiteral("-c"), QStringLiteral("exec $0 ") + arguments + QStringLiteral(" < in.ifs"),
                 support::buildPath(QStringLiteral("barycage-cli"))});
    QVERIFY(shell.waitForFinished(60'000));
    QVERIFY2(shell.exitCode() == status, shell.readAllStandardError().constData());
    QCOMPARE(read("in.ifs"), before);
}

// Neither one that is there nor one that is about to be.
void CliOutputsTest::noOutputReplacesAnother() {
    write("p.ifs", "one {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    QCOMPARE(run("render p.ifs -o drawn.png --size 60x60 --background white").status, 0);
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("deep")));
    for (const char* report : {"both.ifs", "./both.ifs", "deep/../both.ifs"}) {
        const Result result =
            run(QByteArray("collage drawn.png -o both.ifs --starts 1 --maps 2 --report ") + report);
        QVERIFY2(result.status == 2 && result.err.contains("names the output"), result.err.constData());
    }
    QVERIFY(!QFile::exists(path("both.ifs")));
}

// Nor through links, which lead to it only once it is written.
void CliOutputsTest::noOutputReplacesAnotherThroughALink() {
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    write("l.ifs", "left {\n" + rows + "right {\n" + rows);
    QVERIFY(QFile::link(QStringLiteral("right.png"), path("left.png")));
    const Result drawn = run("render l.ifs --entry all -o %e.png --size 9x9");
    QVERIFY2(drawn.status == 2 && drawn.err.contains("has just been written"), drawn.err.constData());
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("tables")));
    QFile::link(QStringLiteral("l-right.csv"), path("tables/l-left.csv"));
    const Result converted = run("convert l.ifs tables/ --to csv");
    QVERIFY2(converted.status == 2 && converted.err.contains("has just been written"),
             converted.err.constData());
    // The same name is written again and again while a picture gets better.
    QCOMPARE(run("render l.ifs --entry left -o once.png --size 9x9 --points 3k").status, 0);
    QCOMPARE(run("render l.ifs --entry left -o once.png --size 9x9 --points 3k").status, 0);
}

void CliOutputsTest::sumsAreReplacedByMore() {
    write("p.ifs", "one {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    QCOMPARE(run("render p.ifs -o a.sum --points 1k --size 9x9 --part 0/2").status, 0);
    QCOMPARE(run("render p.ifs -o b.sum --points 1k --size 9x9 --part 1/2").status, 0);
    QCOMPARE(run("merge a.sum b.sum -o a.sum").status, 0);
    const Result more = run("render --resume a.sum --points 3k -o a.sum");
    QVERIFY2(more.status == 0, more.err.constData());
    QCOMPARE(run("merge a.sum -o whole.png").status, 0);
}

void CliOutputsTest::everyNameMakesAFile_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("part"); // of the name of the file
    const auto row = [](const QByteArray& name, const QString& part) {
        QTest::newRow(name.left(20).toPercentEncoding().constData()) << name << part;
    };
    row("a/b", QStringLiteral("a_b"));
    row("../up", QStringLiteral("_._up"));
    row(".hidden", QStringLiteral("_hidden"));
    row("a\x01z", QStringLiteral("a_z"));
    row("a\xe2\x80\xaez", QStringLiteral("a_z"));     // U+202E
    row("a\xe2\x80\x8bz", QStringLiteral("a_z"));     // U+200B
    row("a\xe2\x80\xa8z", QStringLiteral("a_z"));     // U+2028
    row("\xef\xbf\xbd", QStringLiteral("_"));         // U+FFFD
    row("\xe3\x85\xa4", QStringLiteral("_"));         // U+3164
    row("a\xf3\xa0\x81\x81z", QStringLiteral("a_z")); // U+E0041
    row(QByteArray("x").repeated(300), QString(u'x').repeated(251));
    row(QByteArray("\xc3\xa4").repeated(200), QString(QChar(0xe4)).repeated(125));
}

// By each command that makes names of files out of names of entries.
void CliOutputsTest::everyNameMakesAFile() {
    QFETCH(const QByteArray, name);
    QFETCH(const QString, part);
    const QDir folder(path("named"));
    QVERIFY(QDir(folder).removeRecursively());
    const QByteArray body = " {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    write("n.ifs", "other" + body + name + body);
    QVERIFY(folder.mkpath(QStringLiteral(".")));
    const Result drawn = run("render n.ifs --entry #2 -o named/%e.png --size 9x9");
    QVERIFY2(drawn.status == 0, drawn.err.constData());
    QCOMPARE(folder.entryList(QDir::Files | QDir::Hidden), QStringList{part + QStringLiteral(".png")});
    const Result converted = run("convert n.ifs named/ --to csv");
    QVERIFY2(converted.status == 0, converted.err.constData());
    const QStringList tables = folder.entryList({QStringLiteral("n-*.csv")}, QDir::Files | QDir::Hidden);
    QCOMPARE(tables.size(), 2);
    const auto isOfName = [&](const QString& file) {
        return file.startsWith(QStringLiteral("n-") + part.left(100)) && !file.startsWith(u"n-other");
    };
    QCOMPARE(std::ranges::count_if(tables, isOfName), 1);
}

void CliOutputsTest::longNamesAreToldApart() {
    const QByteArray body = " {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    const QByteArray name = QByteArray("x").repeated(300);
    write("long.ifs", name + "1" + body + name + "2" + body);
    const Result one = run("render long.ifs --entry all -o long-%e.png --size 9x9");
    QCOMPARE(one.status, 2);
    QVERIFY2(one.err.contains("%n"), one.err.constData());
    const Result both = run("render long.ifs --entry all -o long-%n-%e.png --size 9x9");
    QVERIFY2(both.status == 0, both.err.constData());
    QCOMPARE(QDir(path("")).entryList({QStringLiteral("long-?-x*.png")}).size(), 2);
    QVERIFY(QDir(path("")).mkpath(QStringLiteral("long")));
    const Result tables = run("convert long.ifs long/ --to csv");
    QVERIFY2(tables.status == 0, tables.err.constData());
    QCOMPARE(QDir(path("long")).entryList({QStringLiteral("*.csv")}).size(), 2);
}

void CliOutputsTest::librariesPrintNothing_data() {
    QTest::addColumn<QByteArray>("suffix");
    for (const char* suffix : {"jpg", "png", "tif", "webp", "exr"})
        QTest::newRow(suffix) << QByteArray(suffix);
}

// What is wrong with a picture is one sentence of ours, also where Qt or a library of the system has its own.
void CliOutputsTest::librariesPrintNothing() {
    QFETCH(const QByteArray, suffix);
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    write("p.ifs", "one {\n" + rows + "two {\n" + rows);
    QCOMPARE(run("render p.ifs -o whole." + suffix + " --size 64x64 --points 10k").status, 0);
    const QByteArray whole = read("whole." + suffix), damagedName = "damaged." + suffix;
    int refused = 0;
    for (qsizetype at = 2; at < whole.size(); at += std::max<qsizetype>(1, whole.size() / 40)) {
        QByteArray damaged = whole;
        damaged[at] = char(damaged[at] ^ 0x5a);
        write(damagedName, at % 3 == 0 ? damaged.left(at + 1) : damaged);
        const Result result = runProgram("steal p.ifs --entry one --from two --picture " + damagedName +
                                         " -o stolen.png --size 9x9 --points 1k");
        QVERIFY(result.status >= 0);
        refused += result.status == 0 ? 0 : 1;
        for (const QByteArray& line : result.err.split('\n'))
            QVERIFY2(line.isEmpty() || line.contains(": error: ") || line.contains(": warning: "),
                     line.constData());
    }
    QVERIFY(refused > 5);
}

BARYCAGE_TEST(CliOutputsTest, QGuiApplication);
#include "cli_outputs_test.moc"
