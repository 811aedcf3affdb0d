// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QFile>
#include <QJsonArray>
#include <QTest>

// The files that barycage-cli convert writes.
class CliConvertTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void nothingLeftIsNotWritten();
    void anEntryNamedTwiceIsTakenOnce();
    void copyKeepsEveryByte();
    void whatIsNoCollectionIsNotCopied();
    void bakedCodeDrawsTheSame();
    void convertsThereAndBack_data();
    void convertsThereAndBack();
    void convertsManyFilesIntoAFolder();
    void labelsNeedNoHeader();
    void aNameOfAMillionLettersIsCut();
    void writesPoints();
    void parameterFilesBecomeCollections();
    void aBrokenEntryStopsNoOther_data();
    void aBrokenEntryStopsNoOther();
    void refusedFlamesAreLeftOut();
    void cagesThatCannotBeBaked();
    void systemsInSpaceGoToTablesAndBack_data();
    void systemsInSpaceGoToTablesAndBack();
    void filesOfOneNameGetNumbers();
    void writesToStandardOutput();
};

void CliConvertTest::nothingLeftIsNotWritten() {
    write("off.ifs", "off {\n .5 0 0 .5 0 0 0\n .5 0 0 .5 1 0 -1\n}\n");
    QCOMPARE(run("convert off.ifs left.ifs --strict").status, 1);
    QVERIFY(!QFile::exists(path("left.ifs")));
    write("space.ifs", "space (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n");
    QCOMPARE(run("convert space.ifs left.flame").status, 1);
    QVERIFY(!QFile::exists(path("left.flame")));
}

void CliConvertTest::anEntryNamedTwiceIsTakenOnce() {
    QCOMPARE(run("convert systems.ifs once.ifs --entry fern --entry FERN").status, 0);
    QCOMPARE(read("once.ifs").count('{'), 1);
}

void CliConvertTest::copyKeepsEveryByte() {
    QCOMPARE(run("convert broken.ifs copy.ifs").status, 0);
    QCOMPARE(read("copy.ifs"), read("broken.ifs"));
    QCOMPARE(run("convert systems.ifs one.ifs --entry fern").status, 0);
    // Whatever it holds: rows that make a table with an error, or one that Fractint reads otherwise.
    for (const QByteArray& bytes :
         {QByteArray("fern ; a forgotten brace\n.85 .04 -.04 .85 0 1.6 .85\n.2 -.26 .23 .22 0 1.6 .07\n}\n"),
          QByteArray(".85 .04 -.04 .85 0 1.6 .85\n.2 -.26 x .22 0 1.6 .07\n"),
          QByteArray("0.5;0;0;0.5;0;0\n0.5;0;0;0.5;1;0\n"),
          QByteArray("<flames><flame name=\"a\"/></flames>\n")}) {
        write("rows.ifs", bytes);
        QCOMPARE(run("convert rows.ifs copy.ifs").status, 0);
        QCOMPARE(read("copy.ifs"), bytes);
    }
    QVERIFY(read("one.ifs").contains("Fern { ; Barnsley\n 0 0 0 0.16 0 0 .01\n"));
    QVERIFY(!read("one.ifs").contains("maple"));
    QCOMPARE(run("convert broken.ifs strict.ifs --strict").status, 1);
    QVERIFY(read("strict.ifs").contains("good {\n"));
    QVERIFY(!read("strict.ifs").contains("bad"));
    QCOMPARE(run("convert systems.ifs strict.ifs --strict").status, 0);
    QVERIFY(read("strict.ifs").contains("maple {\n"));
}

// Under a name that does not say what it is, content decides.
void CliConvertTest::whatIsNoCollectionIsNotCopied() {
    write("collection.txt", read("broken.ifs"));
    QCOMPARE(run("convert collection.txt copied.ifs").status, 0);
    QCOMPARE(read("copied.ifs"), read("broken.ifs"));
    QCOMPARE(run("convert - from-pipe.ifs", read("broken.ifs")).status, 0);
    QCOMPARE(read("from-pipe.ifs"), read("broken.ifs"));
    for (const QByteArray& bytes :
         {QByteArray("%PDF-1.4\n1 0 obj << >>\n%%EOF\n"), QByteArray("# Read me\n\nThis is a text.\n"),
          QByteArray("\x7f\x45LF\x02\x01\x01\0\0\0\0\0\0\x01\xff\xfe\x80\n", 18), QByteArray("hello world\n"),
          QByteArray("2\n.5 0 0 .5 0 0 50\n.5 0 0 .5 1 0 100\n0 0 1 1\n"), QByteArray()}) {
        write("alien", bytes);
        for (const char* arguments : {"convert alien alien.ifs", "convert - alien.ifs"}) {
            const Result result = run(arguments, bytes);
            QCOMPARE(result.status, 1);
            QVERIFY2(result.err.contains("No entry could be written"), result.err.constData());
            QVERIFY(!QFile::exists(path("alien.ifs")));
        }
    }
}

// T∘w∘T⁻¹ for the stored cage, a translation by (1, 2): the mean moves along.
void CliConvertTest::bakedCodeDrawsTheSame() {
    QCOMPARE(
        run("render systems.ifs -o moved.svg --rest-cage \"0,0 1,0 0,1\" --cage \"1,2 2,2 1,3\" --depth 1")
            .status,
        0);
    QCOMPARE(run("convert moved.svg baked.ifs --bake").status, 0);
    const Result result = run("info baked.ifs --json");
    QCOMPARE(result.status, 0);
    compare(result.entry()[QLatin1String("mean")], 1 + 5135.0 / 70583, 2 + 101021.0 / 70583, 1e-11);
}

void CliConvertTest::convertsThereAndBack_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("there");
    QTest::addColumn<QByteArray>("back");
    QTest::newRow("flame") << QByteArray("fern.flame") << QByteArray() << QByteArray();
    QTest::newRow("flame, y down") << QByteArray("down.flame") << QByteArray(" --y-as-written")
                                   << QByteArray(" --y-as-written");
    QTest::newRow("csv") << QByteArray("fern.csv") << QByteArray() << QByteArray();
    QTest::newRow("tsv") << QByteArray("fern.tsv") << QByteArray(" --columns abecdfp")
                         << QByteArray(" --in-columns \"a b e c d f p\"");
}

// .ifs → another form → .ifs: the same numbers, to the last digit.
void CliConvertTest::convertsThereAndBack() {
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, there);
    QFETCH(QByteArray, back);
    QCOMPARE(run("convert systems.ifs --entry fern " + file + there).status, 0);
    QCOMPARE(run("convert " + file + " back.ifs" + back).status, 0);
    const auto maps = [this](const char* arguments) {
        return run(QByteArray("info --json ") + arguments).entry()[QLatin1String("maps")].toArray();
    };
    const QJsonArray before = maps("systems.ifs --entry fern");
    const QJsonArray after = maps("back.ifs");
    QCOMPARE(before.size(), 4);
    QCOMPARE(after.size(), 4);
    for (int i = 0; i < 4; ++i)
        for (const char* key : {"linear", "translation", "weight_in_file"})
            QVERIFY2(before[i][QLatin1String(key)] == after[i][QLatin1String(key)], key);
}

void CliConvertTest::convertsManyFilesIntoAFolder() {
    const QByteArray convert = "convert systems.ifs broken.ifs";
    QCOMPARE(run(convert + " one.flame").status, 2);
    QCOMPARE(run(convert + " many/").status, 2);
    QVERIFY(!QFile::exists(path("many")));
    const Result result = run(convert + " many/ --to aifs");
    QCOMPARE(result.status, 1); // the second file has a broken entry
    QVERIFY2(result.err.contains("broken.ifs:6:"), result.err.constData());
    QVERIFY(read("many/systems.aifs").contains("@spin:\n$dim=2\n"));
    QVERIFY(read("many/broken.aifs").contains("@good:\n$dim=2\n"));
    QVERIFY(!read("many/broken.aifs").contains("bad"));
    // A table holds one system: one file for each, or none.
    QCOMPARE(run("convert systems.ifs all.csv").status, 1);
    QVERIFY(!QFile::exists(path("all.csv")));
    QCOMPARE(run("convert systems.ifs many --to csv").status, 0);
    QVERIFY(read("many/systems-Fern.csv").startsWith("a,b,c,d,e,f,p\n0,0,0,0.16,0,0,0.01\n"));
    QVERIFY(QFile::exists(path("many/systems-maple.csv")));
}

// One system with labels, once between commas and once between tabs.
void CliConvertTest::labelsNeedNoHeader() {
    write("labels.csv", "1,.5,.1,-.2,.4,1,2,.25\n2,.5,0,0,.5,.5,0,.75\n");
    write("labels.tsv", read("labels.csv").replace(',', '\t'));
    for (const char* file : {"labels.csv", "labels.tsv"}) {
        const Result result = run(QByteArray("convert ") + file + " - --to csv");
        QVERIFY2(result.status == 0, result.err.constData());
        QCOMPARE(result.out,
                 QByteArray("a,b,c,d,e,f,p\n0.5,0.1,-0.2,0.4,1,2,0.25\n0.5,0,0,0.5,0.5,0,0.75\n"));
    }
}

// In time proportional to its length: quadratic time would be hours.
void CliConvertTest::aNameOfAMillionLettersIsCut() {
    const QByteArray name(1'000'000, 'n');
    write("long.flame", "<flames><flame name=\"" + name +
                            "\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame></flames>");
    write("long.ifs", name + " {\n .5 0 0 .5 0 0 1\n}\n");
    QCOMPARE(run("convert long.flame long.csv").status, 0);
    QCOMPARE(run("convert long.ifs short.ifs --strict").status, 0);
    QVERIFY(read("short.ifs").contains(name.left(18) + " {"));
    QVERIFY(!read("short.ifs").contains(name.left(19)));
}

void CliConvertTest::writesPoints() {
    const QByteArray points = "convert systems.ifs --entry fern --points 500";
    QCOMPARE(run(points + " points.csv").status, 0);
    QCOMPARE(read("points.csv").count('\n'), 501);
    QCOMPARE(run(points + " points.ply --seed 9").status, 0);
    QVERIFY(read("points.ply").contains("element vertex 500\n"));
    QCOMPARE(run(points + " points.flame").status, 2);
    QCOMPARE(run("convert systems.ifs none.ply").status, 2);
    QVERIFY(!QFile::exists(path("none.ply")));
}

void CliConvertTest::parameterFilesBecomeCollections() {
    write("old.par", "view { ; a picture\n type=ifs ifs=leaf\n}\nifs:leaf { ; by hand\n"
                     " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    const QByteArray rows = "{\n .5 0 0 .5 0 0 .5 ; stem\n .5 0 0 .5 1 0 .5 ; tip\n}\n";
    write("two.par",
          "; a head\n\n; above\nIFS: one" + rows + "; apart\n\n; over\nifs:two " + rows + "; tail\n");
    QCOMPARE(run("convert two.par two.ifs").status, 0);
    QCOMPARE(read("two.ifs"), "; above\none" + rows + "\n; over\ntwo " + rows);
    QCOMPARE(run("convert two.par strict.ifs --strict").status, 0);
    QCOMPARE(read("strict.ifs").count("; stem\n; tip\n"), 2);
    QCOMPARE(run("convert systems.ifs --entry fern flame.par --to flame").status, 0);
    QCOMPARE(run("convert flame.par flame.ifs").status, 0);
    QVERIFY(read("flame.ifs").startsWith("Fern {"));
    QCOMPARE(run("convert old.par leaf.ifs").status, 0);
    const QByteArray bytes = read("leaf.ifs");
    QVERIFY2(bytes.startsWith("leaf { ; by hand\n"), bytes.constData());
    QVERIFY(!bytes.contains("type=ifs"));
}

void CliConvertTest::aBrokenEntryStopsNoOther_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("output");
    QTest::addColumn<QByteArray>("first"); // of the entries written
    QTest::addColumn<int>("written");
    const auto row = [](const char* arguments, const char* output, const char* first, int written) {
        QTest::newRow(output) << QByteArray(arguments) << QByteArray(output) << QByteArray(first) << written;
    };
    row("", "rest.flame", "<flame name=\"one\"", 2);
    row("", "rest.aifs", "@one:", 3);
    row("", "rest.pdf", "%PDF", 3);
    row("--strict", "strict.ifs", "one {\n", 3);
    row("--bake", "baked.ifs", "one {\n", 3);
    row("--entry bad --entry one", "chosen.ifs", "one {\n", 1);
    row("--entry bad --entry one", "chosen.csv", "a,b,c,d,e,f,p\n", 1);
    row("--entry nowhere --entry one --entry one", "absent.flame", "<flame name=\"one\"", 1);
}

// What can be written is; the rest is named, counted and makes the status 1.
void CliConvertTest::aBrokenEntryStopsNoOther() {
    write("mixed.ifs", "one {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n_README {\n all by hand\n}\n"
                       "cube (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n"
                       "bad {\n .5 0 0 .5 0 0 x\n}\ntwo {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 0 1 .5\n}\n");
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, output);
    QFETCH(QByteArray, first);
    QFETCH(int, written);
    const Result result = run("convert mixed.ifs " + output + ' ' + arguments);
    QCOMPARE(result.status, 1);
    QVERIFY2(read(output).contains(first), read(output).constData());
    QVERIFY(!read(output).contains("bad") && !read(output).contains("README"));
    const bool isChosen = arguments.contains("--entry");
    const QByteArray closing =
        QByteArray("mixed.ifs: error: Entries written: ") + QByteArray::number(written) + "; omitted: ";
    QCOMPARE(result.err.contains(closing +
                                 (isChosen       ? "1"
                                  : written == 3 ? "2"
                                                 : "3") +
                                 ".\n"),
             !arguments.contains("nowhere"));
    QVERIFY2(result.err.contains(arguments.contains("nowhere") ? "“nowhere”" : "“bad”"),
             result.err.constData());
    QCOMPARE(result.err.contains("“cube” was omitted"), written == 2);
    QVERIFY(run("info --json " + output).status < 2);
}

void CliConvertTest::refusedFlamesAreLeftOut() {
    write("swirl.flame",
          "<x><flame name=\"swirl\"><xform weight=\"1\" swirl=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame>\n"
          "<flame name=\"good\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame></x>");
    const Result converted = run("convert swirl.flame swirl.ifs");
    QCOMPARE(converted.status, 1);
    QVERIFY2(converted.err.contains("swirl.flame:1:") &&
                 converted.err.contains("Entries written: 1; omitted: 1."),
             converted.err.constData());
    QVERIFY(read("swirl.ifs").startsWith("good {\n"));
    const Result told = run("info swirl.flame --json");
    QCOMPARE(told.status, 1);
    QStringList names;
    for (int i = 0; i < 2; ++i)
        names << told.entry(i)[QLatin1String("name")].toString() +
                     (told.entry(i)[QLatin1String("loaded")].toBool() ? u'+' : u'-');
    names.sort();
    QCOMPARE(names, (QStringList{QStringLiteral("good+"), QStringLiteral("swirl-")}));
    QVERIFY(told.out.contains("variation “swirl”"));
    QVERIFY(run("info swirl.flame").out.contains("reason"));
    QCOMPARE(run("info swirl.flame --entry good").status, 0);
    QCOMPARE(run("info swirl.flame --entry swirl").status, 1);
    const Result sheet = run("gallery swirl.flame -o swirl.png");
    QCOMPARE(sheet.status, 0);
    QVERIFY2(sheet.err.contains("warning: ") && !sheet.err.contains("error: "), sheet.err.constData());
    QCOMPARE(run("render swirl.flame -o swirl.svg").status, 0);

    write("cut.flame", read("swirl.flame").replace("swirl", "linear").chopped(12));
    for (const char* arguments : {"info cut.flame", "convert cut.flame cut.ifs",
                                  "gallery cut.flame -o cut.png", "render cut.flame -o cut.svg"}) {
        const Result result = run(arguments);
        QVERIFY2(result.err.contains("error: The XML cannot be read beyond this point"),
                 result.err.constData());
        QCOMPARE(result.status, 1);
    }
    for (const char* name : {"cut.ifs", "cut.png", "cut.svg"})
        QVERIFY(QFile::exists(path(name)));
}

void CliConvertTest::cagesThatCannotBeBaked() {
    const auto entry = [](const QByteArray& name, const QByteArrayList& rest, const QByteArrayList& current) {
        QByteArray text = name + " {\n";
        for (const QByteArray& place : rest)
            text += "; barycage: rest " + place + '\n';
        for (const QByteArray& place : current)
            text += "; barycage: current " + place + '\n';
        return text + " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n";
    };
    write("caged.ifs", entry("bent", {"0 0", "1 0", "1 1", "0 1"}, {"0 0", "1 0", "2 2", "0 1"}) +
                           entry("flat", {"0 0", "1 0", "0 1"}, {"1 1", "2 2", "3 3"}));
    const Result points = run("convert caged.ifs bent.csv --entry bent --points 4");
    QVERIFY2(points.status == 0 && read("bent.csv").count('\n') == 5, points.err.constData());
    const Result baked = run("convert caged.ifs baked-cages.ifs --bake");
    QCOMPARE(baked.status, 1);
    QVERIFY2(baked.err.contains("“bent” was omitted: its cage bends"), baked.err.constData());
    QVERIFY2(baked.err.contains("“flat” was omitted: its cage is too flat"), baked.err.constData());
    QVERIFY(!QFile::exists(path("baked-cages.ifs")));
}

void CliConvertTest::systemsInSpaceGoToTablesAndBack_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("header");
    QTest::newRow("csv") << QByteArray("space-fern.csv") << QByteArray("a,b,c,d,e,f,g,h,i,j,k,l,p\n");
    QTest::newRow("tsv") << QByteArray("space-fern.tsv")
                         << QByteArray("a\tb\tc\td\te\tf\tg\th\ti\tj\tk\tl\tp\n");
}

// .ifs → table → .ifs: the same numbers, to the last digit.
void CliConvertTest::systemsInSpaceGoToTablesAndBack() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, header);
    write("space-fern.ifs", "fern3 (3D) {\n .11 .12 .13 .21 .22 .23 .31 .32 .33 1 2 3 .25\n"
                            " .333333333333333314 0 -1e-9 0 .5 0 0 0 .5 0 1e12 -1 .75\n}\n");
    QCOMPARE(run("convert space-fern.ifs " + name).status, 0);
    QVERIFY2(read(name).startsWith(header), read(name).constData());
    QCOMPARE(run("convert " + name + " space-back.ifs").status, 0);
    const auto maps = [this](const char* file) {
        return run(QByteArray("info --json ") + file).entry()[QLatin1String("maps")].toArray();
    };
    const QJsonArray before = maps("space-fern.ifs");
    const QJsonArray after = maps("space-back.ifs");
    QCOMPARE(before.size(), 2);
    QCOMPARE(after.size(), 2);
    for (int i = 0; i < 2; ++i)
        for (const char* key : {"linear", "translation", "weight_in_file"})
            QVERIFY2(before[i][QLatin1String(key)] == after[i][QLatin1String(key)], key);
    QCOMPARE(run("convert space-fern.ifs x.csv --columns abecdfp").status, 1);
    QVERIFY(!QFile::exists(path("x.csv")));
}

void CliConvertTest::filesOfOneNameGetNumbers() {
    write("same.ifs", "a {\n .5 0 0 .5 0 0 1\n}\n");
    write("same.csv", "a,b,c,d,e,f,p\n.5,0,0,.5,0,0,1\n");
    write("same-2.csv", read("same.csv"));
    const Result result = run("convert same.ifs same.csv same-2.csv same/ --to flame");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.startsWith("same.csv: warning: ") && result.err.contains("same-2.flame"),
             result.err.constData());
    for (const char* name : {"same/same.flame", "same/same-2.flame", "same/same-2-2.flame"})
        QVERIFY2(QFile::exists(path(name)), name);
    QVERIFY(read("same/same.flame").contains("name=\"a\""));
    QVERIFY(read("same/same-2.flame").contains("name=\"same\""));
}

void CliConvertTest::writesToStandardOutput() {
    QCOMPARE(run("convert systems.ifs --entry fern fern-file.csv").status, 0);
    const Result table = run("convert - - --to csv --entry fern", read("systems.ifs"));
    QCOMPARE(table.status, 0);
    QCOMPARE(table.out, read("fern-file.csv"));
    QVERIFY(table.err.isEmpty());
    QCOMPARE(run("convert systems.ifs - --to ifs").out, read("systems.ifs"));
    QVERIFY(run("convert systems.ifs - --to pdf").out.startsWith("%PDF"));
    QCOMPARE(run("convert systems.ifs --entry fern - --to ply --points 7").out.count("element vertex 7\n"),
             1);
    QCOMPARE(run("convert systems.ifs - --to csv").status, 1);
    QCOMPARE(run("convert systems.ifs -").status, 2);
    QCOMPARE(run("convert systems.ifs broken.ifs - --to flame").status, 2);
    QVERIFY(!QFile::exists(path("-")));
}

BARYCAGE_TEST(CliConvertTest, QGuiApplication);
#include "cli_convert_test.moc"
