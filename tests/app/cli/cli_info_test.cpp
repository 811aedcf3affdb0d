// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QPointF>
#include <QTest>

using namespace Qt::StringLiterals;

// The facts that barycage-cli info prints as JSON.
class CliInfoTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void factsOfTheMaple();
    void addressesOfTheHull();
    void howACageOfManyCornersDeforms();
    void cageAndBranchesInSpace();
    void factsOfTheFern();
    void factsInSpace();
    void fixedPointsHaveErrors();
    void unknownFactsAreNull();
    void everyNameIsAString_data();
    void everyNameIsAString();
    void namesAreOnesThatEntryTakes();
    void linksAreReadInPlaceOfFiles();
};

// The exact values of docs/mathematics.md for the maple with equal weights.
void CliInfoTest::factsOfTheMaple() {
    const Result result = run("info systems.ifs --entry MAPLE --json");
    QCOMPARE(result.status, 0);
    const QJsonObject maple = result.entry();
    QCOMPARE(maple[QLatin1String("name")].toString(), QStringLiteral("maple"));
    QCOMPARE(maple[QLatin1String("dimension")].toInt(), 2);
    compare(maple[QLatin1String("mean")], 5135.0 / 70583, 101021.0 / 70583, 1e-12);
    compare(maple[QLatin1String("covariance")][0], 1.070887446859971, -0.052426065183732, 1e-12);
    compare(maple[QLatin1String("covariance")][1], -0.052426065183732, 3.782835052470806, 1e-12);
    const QJsonValue box = maple[QLatin1String("bounding_box")];
    compare(box[QLatin1String("min")], -3.30009395647353114, -3.17305096113017084, 1e-11);
    compare(box[QLatin1String("max")], 3.34421444954055797, 5.07246376811594203, 1e-11);
    QVERIFY(box[QLatin1String("error")].toDouble(1) < 1e-10);
    const QJsonValue simplex = maple[QLatin1String("canonical_simplex")];
    QCOMPARE(simplex[QLatin1String("orientation")].toString(), QStringLiteral("--"));
    compare(simplex[QLatin1String("leg")].toDouble(), 11.704657475156326, 1e-10);
    compare(simplex[QLatin1String("vertices")][0], 3.34421444954056, 5.07246376811594, 1e-10);
    compare(maple[QLatin1String("hull")][QLatin1String("area")].toDouble(), 35.754947908201, 1e-3);
    compare(maple[QLatin1String("attractor")][QLatin1String("contractivity")].toDouble(), 0.723195530540,
            1e-11);
    QCOMPARE(maple[QLatin1String("attractor")][QLatin1String("verdict")].toString(),
             QStringLiteral("hyperbolic"));
    QVERIFY(maple[QLatin1String("similarity_dimension")].isNull());
    compare(maple[QLatin1String("affinity_dimension")].toDouble(), 2, 0);
    const QJsonValue map = maple[QLatin1String("maps")][2];
    compare(map[QLatin1String("linear")][0], 0.65, 0.29, 0);
    compare(map[QLatin1String("linear")][1], -0.3, 0.48, 0);
    compare(map[QLatin1String("determinant")].toDouble(), 0.399, 1e-14);
    compare(map[QLatin1String("norm")].toDouble(), 0.722524371029, 1e-11);
    QVERIFY(maple[QLatin1String("cage")].isNull());
    const QString text = QString::fromUtf8(run("info systems.ifs --entry MAPLE").out).simplified();
    QVERIFY2(text.contains(QStringLiteral("map 3 0.65 0.29 -0.3 0.48 0.74 0.39 ")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral(" vertices (approximation), ")), qPrintable(text));
}

// Lévy's curve is held by an octagon of exact corners; map 1 is off, so the maps of the addresses are 2
// and 3.
void CliInfoTest::addressesOfTheHull() {
    const Result result =
        run("info - --json", "levy {\n .1 0 0 .1 0 0 0\n .5 -.5 .5 .5 0 0 1\n .5 .5 -.5 .5 .5 .5 1\n}\n");
    QCOMPARE(result.status, 0);
    const QJsonValue hull = result.entry()[QLatin1String("hull")];
    compare(hull[QLatin1String("area")].toDouble(), 35.0 / 16, 1e-14);
    const QJsonArray vertices = hull[QLatin1String("vertices")].toArray();
    const QJsonArray addresses = hull[QLatin1String("addresses")].toArray();
    QCOMPARE(vertices.size(), 8);
    QCOMPARE(addresses.size(), 8);
    int found = 0;
    for (int k = 0; k < 8; ++k) {
        const QJsonValue address = addresses[k];
        QCOMPARE(address[QLatin1String("period")].toArray().size(), 2);
        if (QPointF(vertices[k][0].toDouble(), vertices[k][1].toDouble()) != QPointF(1.5, 0)) continue;
        ++found; // 222(12) of the two maps
        QCOMPARE(address[QLatin1String("prefix")].toArray(), (QJsonArray{3, 3}));
        QCOMPARE(address[QLatin1String("period")].toArray(), (QJsonArray{3, 2}));
    }
    QCOMPARE(found, 1);
}

void CliInfoTest::howACageOfManyCornersDeforms() {
    const auto deformation = [&](const QByteArray& lines) {
        const Result result =
            run("info - --json", "square {\n" + lines + " .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 .5 1\n}\n");
        return result.entry()[QLatin1String("cage")][QLatin1String("deformation")].toString();
    };
    const auto vertices = [](const QByteArray& key, const QByteArrayList& places) {
        QByteArray lines;
        for (const QByteArray& place : places)
            lines += " ; barycage: " + key + ' ' + place + '\n';
        return lines;
    };
    const QByteArray four =
        vertices("rest", {"0 0", "1 0", "1 1", "0 1"}) + vertices("current", {"0 0", "1 0", "2 2", "0 1"});
    QCOMPARE(deformation(four), QStringLiteral("bend"));
    QCOMPARE(deformation(four + " ; barycage: deformation affine-fit\n"), QStringLiteral("affine_fit"));
    QCOMPARE(
        deformation(vertices("rest", {"0 0", "1 0", "0 1"}) + vertices("current", {"0 0", "1 0", "2 2"})),
        QStringLiteral("affine"));
}

void CliInfoTest::cageAndBranchesInSpace() {
    QByteArray lines;
    for (const char* line :
         {"rest 0 0 0", "rest 1 0 0", "rest 0 1 0", "rest 0 0 1", "current 0 0 0", "current 1 0 0",
          "current 0 1 0", "current 0 0 2", "branch 2 1", "by 1 0 0", "by 0 1 0", "by 0 0 1", "by 3 2 1",
          "branch 0 2", "by 1 0 0", "by 0 1 0", "by 0 0 1", "by 0 0 1"})
        lines += QByteArray(" ; barycage: ") + line + '\n';
    const QByteArray file =
        "solid (3D) {\n" + lines + " .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 .5 .5 .5 .5\n}\n";
    const QJsonObject solid = run("info - --json", file).entry();
    const QJsonObject cage = solid[QLatin1String("cage")].toObject();
    QCOMPARE(cage[QLatin1String("rest")].toArray().size(), 4);
    QCOMPARE(cage[QLatin1String("current")][3].toArray(), (QJsonArray{0, 0, 2}));
    QCOMPARE(cage[QLatin1String("deformation")].toString(), QStringLiteral("affine"));
    const QJsonArray branches = solid[QLatin1String("moved_branches")].toArray();
    QCOMPARE(branches.size(), 2);
    QVERIFY(!branches[0][QLatin1String("recurs")].toBool(true));
    QVERIFY(branches[1][QLatin1String("recurs")].toBool());
    QCOMPARE(branches[1][QLatin1String("address")].toArray(), QJsonArray{2});
    QCOMPARE(branches[0][QLatin1String("address")].toArray(), (QJsonArray{2, 1}));
    QCOMPARE(branches[0][QLatin1String("translation")].toArray(), (QJsonArray{3, 2, 1}));
    const Result text = run("info -", file);
    QVERIFY2(text.out.contains("(0, 0, 2)"), text.out.constData());
    QVERIFY2(text.out.contains("moved branch"), text.out.constData());
    QCOMPARE(text.out.count("and inside itself"), 1);
    QVERIFY2(text.out.contains("those of the code, where no branch is moved"), text.out.constData());
    QVERIFY(!run("info --entry fern systems.ifs").out.contains("no branch is moved"));
}

void CliInfoTest::factsOfTheFern() {
    const Result result = run("info --entry fern systems.ifs --json");
    QCOMPARE(result.status, 0);
    const QJsonObject fern = result.entry();
    compare(fern[QLatin1String("mean")], 2659956.0 / 3338159, 20588360.0 / 3338159, 1e-11);
    compare(fern[QLatin1String("canonical_simplex")][QLatin1String("leg")].toDouble(), 10.793878466453615,
            1e-10);
    compare(fern[QLatin1String("affinity_dimension")].toDouble(), 1.834896, 3e-6);
    compare(fern[QLatin1String("maps")][0][QLatin1String("fixed_point")], 0, 0, 0);
    compare(fern[QLatin1String("maps")][1][QLatin1String("weight_in_file")].toDouble(), 0.85, 0);
}

void CliInfoTest::factsInSpace() {
    const Result result =
        run("info - --json", "tetra (3D) {\n"
                             " .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 .5 0 0 .25\n"
                             " .5 0 0 0 .5 0 0 0 .5 0 .5 0 .25\n .5 0 0 0 .5 0 0 0 .5 0 0 .5 .25\n}\n");
    QCOMPARE(result.status, 0);
    const QJsonObject tetra = result.entry();
    QCOMPARE(tetra[QLatin1String("dimension")].toInt(), 3);
    const QJsonValue hull = tetra[QLatin1String("hull")];
    QCOMPARE(hull[QLatin1String("vertices")].toArray().size(), 4);
    QCOMPARE(hull[QLatin1String("vertices")][0].toArray().size(), 3);
    compare(hull[QLatin1String("volume")].toDouble(), 1.0 / 6, 1e-11);
    QVERIFY(hull[QLatin1String("error")].toDouble(1) < 1e-10);
    const QJsonArray facets = hull[QLatin1String("facets")].toArray();
    QCOMPARE(facets.size(), 4);
    for (const QJsonValue& facet : facets) {
        QCOMPARE(facet.toArray().size(), 3);
        for (const QJsonValue& corner : facet.toArray())
            QVERIFY(corner.toInt(-1) >= 0 && corner.toInt() < 4);
    }
    QCOMPARE(tetra[QLatin1String("canonical_simplex")][QLatin1String("orientation")].toString(),
             QStringLiteral("+++"));
    compare(tetra[QLatin1String("similarity_dimension")].toDouble(), 2, 1e-12);
    compare(tetra[QLatin1String("affinity_dimension")].toDouble(), 2, 1e-12); // of similarities, the same
    QVERIFY(!hull.toObject().contains(QLatin1String("area")));
}

// Also of maps that are almost translations.
void CliInfoTest::fixedPointsHaveErrors() {
    const Result result = run("info - --json", "a {\n .9999999 0 0 .9999999 1 2 1\n 1 0 0 .5 1 0 1\n}\n");
    const QJsonArray maps = result.entry()[QLatin1String("maps")].toArray();
    const double there = 1 / (1 - .9999999), error = maps[0][QLatin1String("fixed_point_error")].toDouble(1);
    compare(maps[0][QLatin1String("fixed_point")], there, 2 * there, error + 1e-15 * there);
    QVERIFY(error < 1e-10 * there);
    QVERIFY(maps[1][QLatin1String("fixed_point")].isNull());
    QVERIFY(maps[1][QLatin1String("fixed_point_error")].isNull());
}

void CliInfoTest::unknownFactsAreNull() {
    const Result result = run("info systems.ifs --entry spin --json");
    QCOMPARE(result.status, 0);
    const QJsonObject spin = result.entry();
    QCOMPARE(spin[QLatin1String("attractor")][QLatin1String("verdict")].toString(), QStringLiteral("none"));
    for (const char* key :
         {"mean", "covariance", "bounding_box", "canonical_simplex", "hull", "affinity_dimension"})
        QVERIFY2(spin.contains(QLatin1String(key)) && spin[QLatin1String(key)].isNull(), key);
    QVERIFY(!result.out.contains(": nan") && !result.out.contains(": inf"));
}

void CliInfoTest::everyNameIsAString_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a\"b", "a\\b", "\\", "\\u0041", "é√𝔉", "\"\\\"", "a/b", "a\302\237b"})
        QTest::newRow(name) << QString::fromUtf8(name);
    for (char16_t c = 1; c < 0x20; ++c)
        if (c != u'\t' && c != u'\n' && c != u'\r' && c != 0x1a)
            QTest::addRow("control character %d", c) << QStringLiteral("a%1b").arg(QChar(c));
    QTest::newRow("delete") << QStringLiteral("a%1b").arg(QChar(0x7f));
}

// The names of an entry, of its problem and of a message that quotes it come back as they are in the file.
void CliInfoTest::everyNameIsAString() {
    QFETCH(QString, name);
    const Result result = run("info - --json", name.toUtf8() + " {\n .5 0 0 .5 0 0 1\n}\n" + name.toUtf8() +
                                                   "2 {\n .5 0 0 .5 0 0 x\n}\n");
    QJsonParseError error;
    const QJsonDocument json = QJsonDocument::fromJson(result.out, &error);
    QVERIFY2(error.error == QJsonParseError::NoError, result.out.constData());
    QCOMPARE(json[QLatin1String("entries")][0][QLatin1String("name")].toString(), name);
    const QJsonArray problems = json[QLatin1String("problems")].toArray();
    QCOMPARE(problems.last()[QLatin1String("entry")].toString(), name + u'2');
    for (const char c : result.out)
        QVERIFY(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
}

// One on a line without control characters, each once; the exact name goes before one but for case.
void CliInfoTest::namesAreOnesThatEntryTakes() {
    const QByteArray map = " {\n .5 0 0 .5 0 0 1\n}\n";
    write("names.ifs",
          "Maple" + map + "maple" + map + "\x1b[41mred" + map + "two words" + map + "maple" + map);
    const Result names = run("info names.ifs --names");
    QCOMPARE(names.status, 0);
    QCOMPARE(names.out, QByteArray("Maple\nmaple\n\xef\xbf\xbd[41mred\ntwo words\n"));
    for (const QByteArray& name : names.out.trimmed().split('\n')) {
        const QString found =
            run("info names.ifs --json --entry \"" + name + '"').entry()[QLatin1String("name")].toString();
        QCOMPARE(found.toUtf8().replace("\x1b", "\xef\xbf\xbd"), name);
    }
    QCOMPARE(run("info names.ifs --names --json").status, 2);
}

void CliInfoTest::linksAreReadInPlaceOfFiles() {
    // triangle { .5 0 0 .5 0 0 .3; .5 0 0 .5 .5 0 .3; .5 0 0 .5 .25 .5 .4 }, by another program.
    const QByteArray data = "KynKTMxLz0lVqOZS0DNVMABCGGWMLAJmoQkZgYX1TLhquQA";
    for (const QByteArray& link : {"barycage:" + data, "https://example.org/a.html#" + data}) {
        const Result result = run("info --json " + link);
        QCOMPARE(result.status, 0);
        QCOMPARE(result.entry()[u"name"].toString(), u"triangle"_s);
        QCOMPARE(result.entry()[u"maps"].toArray().size(), 3);
        QVERIFY(result.out.contains("\"format\": \"link\""));
    }
    QCOMPARE(run("info --json -", "barycage:" + data + '\n').entry()[u"name"].toString(), u"triangle"_s);
    QCOMPARE(run("render barycage:" + data + " --size 20x20 -o link.png").status, 0);
    const Result cut = run("info barycage:" + data.chopped(4));
    QCOMPARE(cut.status, 1);
    QVERIFY2(cut.err.contains("error: This link was cut off"), cut.err);
    write("barycage:" + data, read("systems.ifs")); // a file that is called so goes first
    QVERIFY(run("info barycage:" + data).out.contains("maple"));
}

BARYCAGE_TEST(CliInfoTest, QGuiApplication);
#include "cli_info_test.moc"
