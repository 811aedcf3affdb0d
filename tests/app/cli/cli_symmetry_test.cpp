// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

// Symmetries given, shown and listed by barycage-cli.
class CliSymmetryTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void aSymmetryIsGivenAndShown();
    void thePictureIsThatOfTheListedMaps();
    void formatsThatHoldNoSymmetryListTheMaps();
    void polyhedraAreInSpace();
    void wrongSymmetries_data();
    void wrongSymmetries();

private:
    QJsonObject entryOf(const char* file) {
        const Result result = run(QByteArray("info --json ") + file);
        return QJsonDocument::fromJson(result.out)
            .object()[QLatin1String("entries")]
            .toArray()
            .first()
            .toObject();
    }
    void writeLeaf() { write("leaf.ifs", "leaf {\n .5 .2 -.2 .5 .4 .1 .6\n .3 0 0 .1 .5 .2 .4\n}\n"); }
};

void CliSymmetryTest::aSymmetryIsGivenAndShown() {
    writeLeaf();
    QCOMPARE(run("convert leaf.ifs star.ifs --symmetry d6:15@1,2").status, 0);
    QVERIFY(read("star.ifs").contains("; barycage: symmetry d6:15"));
    QVERIFY(read("star.ifs").contains(".5 .2 -.2 .5 .4 .1 .6"));
    const QJsonObject entry = entryOf("star.ifs");
    QCOMPARE(entry[QLatin1String("maps")].toArray().size(), 2);
    const QJsonObject symmetry = entry[QLatin1String("symmetry")].toObject();
    QCOMPARE(symmetry[QLatin1String("group")].toString(), QStringLiteral("d6"));
    QCOMPARE(symmetry[QLatin1String("elements")].toInt(), 12);
    QCOMPARE(symmetry[QLatin1String("angle")].toDouble(), 15.0);
    QCOMPARE(symmetry[QLatin1String("centre")].toArray(), (QJsonArray{1.0, 2.0}));
    const QJsonArray mean = entry[QLatin1String("mean")].toArray(); // of a symmetric measure, the centre
    QVERIFY(std::abs(mean[0].toDouble() - 1) < 1e-9 && std::abs(mean[1].toDouble() - 2) < 1e-9);
    QVERIFY(run("info star.ifs").out.contains("6-fold dihedral about (1, 2), a mirror at 15"));
    QVERIFY(entryOf("leaf.ifs")[QLatin1String("symmetry")].isNull());
    QCOMPARE(run("convert star.ifs plain.ifs --symmetry none").status, 0);
    QVERIFY(!read("plain.ifs").contains("barycage"));
}

void CliSymmetryTest::thePictureIsThatOfTheListedMaps() {
    writeLeaf();
    QCOMPARE(run("convert leaf.ifs star.ifs --symmetry c6").status, 0);
    QCOMPARE(run("convert star.ifs listed.ifs --expand").status, 0);
    QVERIFY(!read("listed.ifs").contains("symmetry"));
    QCOMPARE(entryOf("listed.ifs")[QLatin1String("maps")].toArray().size(), 12);
    QCOMPARE(run("render star.ifs -o star.png --size 200x200 --points 300000").status, 0);
    QCOMPARE(run("render listed.ifs -o listed.png --size 200x200 --points 300000").status, 0);
    const QImage star(path("star.png")), listed(path("listed.png"));
    QCOMPARE(star.size(), QSize(200, 200));
    QVERIFY(star == listed);
    QCOMPARE(run("render leaf.ifs -o leaf.png --size 200x200 --points 300000").status, 0);
    QVERIFY(QImage(path("leaf.png")) != star);
    QJsonObject one = entryOf("star.ifs"), other = entryOf("listed.ifs");
    for (const char* fact :
         {"mean", "covariance", "bounding_box", "hull", "similarity_dimension", "attractor"})
        QCOMPARE(one[QLatin1String(fact)], other[QLatin1String(fact)]);
}

void CliSymmetryTest::formatsThatHoldNoSymmetryListTheMaps() {
    writeLeaf();
    QCOMPARE(run("convert leaf.ifs star.ifs --symmetry c5@1,0").status, 0);
    const Result table = run("convert star.ifs star.csv");
    QCOMPARE(table.status, 0);
    QVERIFY2(table.err.contains("The symmetry of"), table.err.constData());
    QCOMPARE(read("star.csv").trimmed().count('\n'), 10);
    const Result strict = run("convert star.ifs strict.ifs --strict");
    QCOMPARE(strict.status, 0);
    QVERIFY2(strict.err.contains("The symmetry of"), strict.err.constData());
    QCOMPARE(entryOf("strict.ifs")[QLatin1String("maps")].toArray().size(), 10);
    const Result flame = run("convert star.ifs star.flame");
    QCOMPARE(flame.status, 0);
    QVERIFY2(!flame.err.contains("symmetry"), flame.err.constData());
    QCOMPARE(entryOf("star.flame")[QLatin1String("symmetry")].toObject()[QLatin1String("group")].toString(),
             QStringLiteral("c5"));
    QCOMPARE(run("convert star.ifs listed.flame --expand").status, 0);
    QCOMPARE(entryOf("listed.flame")[QLatin1String("maps")].toArray().size(), 10);
}

void CliSymmetryTest::polyhedraAreInSpace() {
    writeLeaf();
    write("space.ifs", "corner (3D) {\n .3 0 0 0 .3 0 0 0 .3 1 0 0 1\n}\n");
    QCOMPARE(run("convert space.ifs octahedron.ifs --symmetry octahedral").status, 0);
    const QJsonObject entry = entryOf("octahedron.ifs");
    QCOMPARE(entry[QLatin1String("symmetry")].toObject()[QLatin1String("elements")].toInt(), 24);
    const QJsonArray high = entry[QLatin1String("bounding_box")].toObject()[QLatin1String("max")].toArray();
    for (int i = 0; i < 3; ++i)
        QVERIFY(std::abs(high[i].toDouble() - 1 / 0.7) < 1e-6);
    const Result flat = run("convert leaf.ifs no.ifs --symmetry octahedral");
    QCOMPARE(flat.status, 1);
    QVERIFY2(flat.err.contains("in the plane"), flat.err.constData());
    QCOMPARE(run("convert leaf.ifs lifted.ifs --lift auto --symmetry icosahedral").status, 0);
    QCOMPARE(entryOf("lifted.ifs")[QLatin1String("symmetry")].toObject()[QLatin1String("elements")].toInt(),
             60);
}

void CliSymmetryTest::wrongSymmetries_data() {
    QTest::addColumn<QByteArray>("symmetry");
    for (const char* wrong :
         {"c1", "c25", "d0", "p4m", "c6:30", "mirror:up", "c6@1", "c6@1,2,3,4", "c6@", ":30"})
        QTest::newRow(wrong) << QByteArray(wrong);
}

void CliSymmetryTest::wrongSymmetries() {
    QFETCH(QByteArray, symmetry);
    writeLeaf();
    const Result result = run("convert leaf.ifs no.ifs --symmetry " + symmetry);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("is not a symmetry"), result.err.constData());
    QVERIFY(!QFile::exists(path("no.ifs")));
}

BARYCAGE_TEST(CliSymmetryTest, QGuiApplication);
#include "cli_symmetry_test.moc"
