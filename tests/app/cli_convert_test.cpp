// SPDX-License-Identifier: MIT
#include "app/command_line.h"

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
    void bakedCodeDrawsTheSame();
    void convertsThereAndBack_data();
    void convertsThereAndBack();
    void convertsManyFilesIntoAFolder();
    void writesPoints();
    void parameterFilesBecomeCollections();
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
    QVERIFY(read("one.ifs").contains("Fern { ; Barnsley\n 0 0 0 0.16 0 0 .01\n"));
    QVERIFY(!read("one.ifs").contains("maple"));
    QCOMPARE(run("convert broken.ifs strict.ifs --strict").status, 1);
    QVERIFY(!QFile::exists(path("strict.ifs")));
    QCOMPARE(run("convert systems.ifs strict.ifs --strict").status, 0);
    QVERIFY(read("strict.ifs").contains("maple {\n"));
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
    QVERIFY(!QFile::exists(path("many/broken.aifs")));
    // A table holds one system: one file for each, or none.
    QCOMPARE(run("convert systems.ifs all.csv").status, 1);
    QVERIFY(!QFile::exists(path("all.csv")));
    QCOMPARE(run("convert systems.ifs many --to csv").status, 0);
    QVERIFY(read("many/systems-Fern.csv").startsWith("a,b,c,d,e,f,p\n0,0,0,0.16,0,0,0.01\n"));
    QVERIFY(QFile::exists(path("many/systems-maple.csv")));
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
    QCOMPARE(run("convert old.par leaf.ifs").status, 0);
    const QByteArray bytes = read("leaf.ifs");
    QVERIFY2(bytes.startsWith("leaf { ; by hand\n"), bytes.constData());
    QVERIFY(!bytes.contains("type=ifs"));
}

QTEST_GUILESS_MAIN(CliConvertTest)
#include "cli_convert_test.moc"
