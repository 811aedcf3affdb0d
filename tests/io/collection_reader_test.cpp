// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "io/collection_reader.h"
#include "io/exchange/text_formats.h"
#include "io/table/table_reader.h"
#include "support/named_test.h"

#include <QTest>

// Files of any kind, told from their content.
class CollectionReaderTest : public QObject {
    Q_OBJECT

private slots:
    void formats_data();
    void formats();
    void listsAreTables_data();
    void listsAreTables();
    void systemsInListsHaveTheirNames();
    void parameterFilesGiveTheirSystems();
    void ambiguousTablesAsk();
    void chosenColumnsAreTaken();
    void weightsWithoutAPartAreSaid_data();
    void weightsWithoutAPartAreSaid();
    void weightsThatRiseAreSaid_data();
    void weightsThatRiseAreSaid();
    void sumsAreReadAsTheRemarkSays_data();
    void sumsAreReadAsTheRemarkSays();
    void listsOfWeightsThatDoNotFitAreSaid_data();
    void listsOfWeightsThatDoNotFitAreSaid();
    void someWeightsMissingAreSaid();
    void roundTrips_data();
    void roundTrips();
};

namespace {

const document::System2& firstSystem(const document::FractalFile& file) {
    static const document::System2 none;
    if (file.entries.isEmpty()) return none;
    const document::System2* system = document::system2(*file.entries.first().fractal);
    return system ? *system : none;
}

document::Fractal fern() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("fern");
    document::System2 system = canonical::system(canonical::fern(), canonical::fernWeights);
    ifs::append(system, ifs::affineMap(1.0 / 3, 0.1, 0.7, -1e-9, 2.5, 1e12), 0);
    fractal.shape = document::Shape<2>{system};
    return fractal;
}

} // namespace

void CollectionReaderTest::formats_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("format");
    QTest::addColumn<int>("maps");
    const auto row = [](const char* name, const char* bytes, const char* format, int maps) {
        QTest::newRow(name) << QByteArray(bytes) << QString::fromLatin1(format) << maps;
    };
    row("collection", "x {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n", "fractint", 2);
    row("bare rows", ".5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n", "fractint", 2);
    row("csv", "a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\n.5,0,0,.5,1,0,.5\n", "table", 2);
    row("tsv with labels", "map\ta\tb\tc\td\te\tf\nw1\t0,5\t0\t0\t,5\t0\t0\nw2\t0,5\t0\t0\t,5\t1\t0\n",
        "table", 2);
    row("one column per map", "a .5 .5 .5\nb 0 0 0\nc 0 0 0\nd .5 .5 .5\ne 0 1 0\nf 0 0 1\n", "table", 3);
    row("count and matrices", "2\n.5\n.5 0 0\n0 .5 0\n0 0 1\n.5\n.5 0 1\n0 .5 0\n0 0 1\n", "table", 2);
    row("count and matrices, a line each", "2\n.5 .5 0 0 0 .5 0 0 0 1\n.5 .5 0 1 0 .5 2 0 0 1\n", "table", 2);
    row("count and three matrices, a line each",
        "3\n.5 .5 0 0 0 .5 0 0 0 1\n.25 .5 0 1 0 .5 2 0 0 1\n.25 .5 0 1 0 .5 2 0 0 1\n", "table", 3);
    row("semicolons and labels", "1;0.5;0;0;0.5;0;0;0.5\n2;0.5;0;0;0.5;1;0;0.5\n", "table", 2);
    row("semicolons, first numbers that fill a row",
        "1;0;0;1;0;0;1\n1;0;0;1;0;0;1\n1;0;0;1;0;0;1\n1;0;0;1;0;0;1\n1;0;0;1;0;0;1\n1;0;0;1;0;0;1\n1;0;0;1;0;"
        "0;1\n",
        "table", 7);
    row("bare rows with remarks",
        ".5 0 0 .5 0 0 .5 ; a; b; c; d; e; f\n.5 0 0 .5 1 0 .5 ; 1; 2; 3; 4; 5; 6\n", "fractint", 2);
    row("quotation marks",
        "\"a\",\"b\",\"c\",\"d\",\"e\",\"f\",\"p\"\n\"0.5\",\"0\",\"0\",\"0.5\",\"0\",\"0\",\"1\"\n", "table",
        1);
    row("a bad first row", "a,b,c,d,e,f,p\nO.5,0,0,.5,0,0,.5\n.5,0,0,.5,1,0,.5\n", "table", 0);
    row("bad rows alone", ".5,0,0,.5,0,0,nan\n", "table", 0);
    row("flame", "<flame><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame>", "flame", 1);
    row("braces in a flame",
        "<flame name=\"{a\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame>", "flame", 1);
    row("braces in a drawing", "<svg><style>.a{fill:red}\n.b{fill:red}</style></svg>", "svg", 0);
    row("an entry named like a tag", "<flame>a {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n", "fractint", 2);
    row("an entry named like a drawing", "<svg {\n .5 0 0 .5 0 0 1\n}\n", "fractint", 1);
    row("expressions are no table", "0, 0.16*y;0.5\r\n0.5*x, y/2;0.5\r\n", "unknown", 0);
    row("prose", "Once upon a time\nthere were 6 maps\n", "unknown", 0);
    row("binary", "\x01\x02\x03\x04\x05\x06\x07\x08", "unknown", 0);
    row("a flame in a letter",
        "Hi,\nhere it is:\n<flame name=\"a\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 "
        "0\"/></flame>\nBye {\n",
        "flame", 1);
    row("a program with braces", "int main(void) {\n    puts(\"one\");\n    return 0;\n}\n", "unknown", 0);
    row("a document", "\\documentclass{article}\n\\begin{document}\nText.\n\\end{document}\n", "unknown", 0);
    row("a style sheet", "h1 {\n  color: red;\n}\np.a() {\n  margin: 0;\n}\n", "unknown", 0);
    row("a damaged entry", "x (y) {\n .5 0 0 .5 0 0 oops\n}\n", "fractint", 0);
    row("other JSON", "{\"points\": [[1, 2], [3, 4]], \"name\": \"a\"}\n", "unknown", 0);
    row("dictionaries of Python", "maps = [{\"a\": np.pi, \"b\": f(2)}]\n", "unknown", 0);
    row("another program", "import math\n\ndef f(x):\n    return 2*x\n", "unknown", 0);
}

void CollectionReaderTest::formats() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    QTEST(collection.format, "format");
    QTEST(int(firstSystem(collection.file).maps.size()), "maps");
    QCOMPARE(collection.file.entries.isEmpty(),
             std::any_of(collection.file.problems.begin(), collection.file.problems.end(),
                         [](const auto& p) { return p.severity == document::Problem::Severity::Error; }));
}

void CollectionReaderTest::listsAreTables_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("hasWeights");
    const auto row = [](const char* name, const char* bytes, bool hasWeights = true) {
        QTest::newRow(name) << QByteArray(bytes) << hasWeights;
    };
    row("JSON rows", "[[0.5, 0.1, -0.2, 0.4, 3, 7, 0.25],\n [1e-1, 0, 0, 0.5, 1, 0, 0.75]]\n");
    row("JSON rows without weights", "{\"maps\": [[0.5,0.1,-0.2,0.4,3,7],[0.1,0,0,0.5,1,0]]}", false);
    row("JSON names",
        "{\"maps\": [{\"f\": 7, \"e\": 3, \"a\": 0.5, \"b\": 0.1, \"c\": -0.2, \"d\": 0.4, \"prob\": 0.25, "
        "\"colour\": \"red\"},\n"
        "{\"f\": 0, \"e\": 1, \"a\": 0.1, \"b\": 0, \"c\": 0, \"d\": 0.5, \"prob\": 0.75}]}");
    row("JSON matrices", "{\"transforms\": [{\"matrix\": [[0.5, 0.1], [-0.2, 0.4]], \"translation\": [3, 7], "
                         "\"weight\": 0.25}, {\"matrix\": [[0.1, 0], [0, 0.5]], \"translation\": [1, 0], "
                         "\"weight\": 0.75}]}");
    row("Python tuples",
        "# a fern\nimport numpy as np\nmaps = [\n  (0.5, 0.1, -0.2, 2/5, 3, 7, .25),  # stem\n"
        "  (.1, 0, 0, .5, 1, 0, .75),\n]\nfor m in maps:\n    print(m[0] * 2)\n");
    row("arrays and weights",
        "import numpy as np\nA = [np.array([[0.5, 0.1, 3], [-0.2, 0.4, 7], [0, 0, 1]]),\n"
        "     np.array([[.1, 0, 1], [0, .5, 0], [0, 0, 1]])]\nprobs = [0.25, 0.75]\n");
    row("matrix, vector, weight", "ifs = [([[0.5, 0.1], [-0.2, 0.4]], [3, 7], 0.25),\n"
                                  "       ([[0.1, 0], [0, 0.5]], [1, 0], 0.75)]\n");
    row("two by three", "let maps = [ [[0.5, 0.1, 3], [-0.2, 0.4, 7]], [[.1, 0, 1], [0, .5, 0]] ];", false);
    row("C", "static const float maps[2][7] = {\n  {0.5f, 0.1f, -0.2f, 0.4f, 3, 7, 0.25f},\n"
             "  {0.1f, 0, 0, 0.5f, 1, 0, 0.75f},\n};\n");
    row("Mathematica", "fern = {{{{0.5, 0.1}, {-0.2, 0.4}}, {3, 7}}, {{{0.1, 0}, {0, 0.5}}, {1, 0}}};",
        false);
    row("Markdown",
        "# Fern\n\n| map | a | b | c | d | e | f | p |\n|---|---|---|---|---|---|---|---|\n"
        "| w1 | 0.5 | 0.1 | -0.2 | 0.4 | 3 | 7 | 0.25 |\n| w2 | 0.1 | 0 | 0 | 0.5 | 1 | 0 | 0.75 |\n");
    row("LaTeX", "\\begin{tabular}{ccccccc}\n$a$ & $b$ & $c$ & $d$ & $e$ & $f$ & $p$ \\\\ \\hline\n"
                 "0.5 & 0.1 & -0.2 & 0.4 & 3 & 7 & 0.25 \\\\\n0.1 & 0 & 0 & 0.5 & 1 & 0 & 0.75 "
                 "\\\\\n\\end{tabular}\n");
}

void CollectionReaderTest::listsAreTables() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, hasWeights);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.format, QStringLiteral("table"));
    QCOMPARE(collection.file.problems.size(), 1); // the remark
    QVERIFY(collection.file.problems.first().severity == document::Problem::Severity::Warning);
    const document::System2& system = firstSystem(collection.file);
    QCOMPARE(system.maps.size(), std::size_t(2));
    QVERIFY(system.maps[0].map == ifs::affineMap(0.5, 0.1, -0.2, 0.4, 3, 7));
    QVERIFY(system.maps[1].map == ifs::affineMap(0.1, 0, 0, 0.5, 1, 0));
    QCOMPARE(system.maps[0].weight.has_value(), hasWeights);
    if (!hasWeights) return;
    QCOMPARE(*system.maps[0].weight, 0.25);
    QCOMPARE(*system.maps[1].weight, 0.75);
}

void CollectionReaderTest::systemsInListsHaveTheirNames() {
    const io::Collection collection = io::readCollection(
        "{\"fern\": [[0.5,0,0,0.5,0,0,1],[0.5,0,0,0.5,1,0,1]],\n \"cube\": {\"maps\": ["
        "[0.5,0,0,0,0.5,0,0,0,0.5,0,0,0],[0.5,0,0,0,0.5,0,0,0,0.5,1,0,0]]},\n \"points\": [[0,1],[2,3]]}");
    QCOMPARE(collection.file.entries.size(), 2);
    QCOMPARE(collection.file.entries[0].fractal->name, QStringLiteral("fern"));
    QCOMPARE(collection.file.entries[1].fractal->name, QStringLiteral("cube"));
    QCOMPARE(document::dimension(*collection.file.entries[1].fractal), 3);
    QVERIFY(collection.file.entries[0].id != collection.file.entries[1].id);
}

void CollectionReaderTest::parameterFilesGiveTheirSystems() {
    const io::Collection collection = io::readCollection(
        "picture { ; drawn with Fractint\n  reset=1960 type=ifs ifsfile=x.ifs ifs=leaf corners=-2/2/0/3\n}\n"
        "frm:julia (XAXIS) {\n z = pixel: z = z*z + p1, |z| < 4 }\n"
        "IFS:leaf { ; by hand\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n"
        "ifs:twig (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n");
    QCOMPARE(collection.file.entries.size(), 2);
    QCOMPARE(collection.file.entries[0].fractal->name, QStringLiteral("leaf"));
    QCOMPARE(document::dimension(*collection.file.entries[0].fractal), 2);
    QCOMPARE(collection.file.entries[1].fractal->name, QStringLiteral("twig"));
    QCOMPARE(document::dimension(*collection.file.entries[1].fractal), 3);
}

void CollectionReaderTest::ambiguousTablesAsk() {
    const io::Collection collection =
        io::readCollection("m11,m12,m13,m21,m22,m23\n.5,0,1,0,.5,2\n.5,0,3,0,.5,4\n");
    QCOMPARE(collection.format, QStringLiteral("table"));
    QVERIFY(collection.file.entries.isEmpty());
    QCOMPARE(collection.file.problems.value(0).line, 1);
    QVERIFY(collection.file.problems.value(0).message.contains(QStringLiteral("order")));
}

void CollectionReaderTest::chosenColumnsAreTaken() {
    io::ReadOptions options;
    options.columns = io::tableColumns(QStringLiteral("abecdf"));
    QVERIFY(options.columns);
    const auto collection = io::readCollection("m11,m12,m13,m21,m22,m23\n.5,.1,1,.2,.4,2\n",
                                               QStringLiteral("/tmp/My maps.csv"), options);
    QCOMPARE(collection.file.entries.value(0).fractal->name, QStringLiteral("My_maps"));
    QCOMPARE(firstSystem(collection.file).maps.size(), std::size_t(1));
    QVERIFY(firstSystem(collection.file).maps[0].map == ifs::affineMap(.5, .1, .2, .4, 1, 2));
    QVERIFY(!firstSystem(collection.file).maps[0].weight);
}

void CollectionReaderTest::weightsWithoutAPartAreSaid_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("table") << QByteArray(
        "a,b,c,d,e,f,p\n.5,0,0,.4,1,2,-.5\n.5,0,0,.5,0,0,0\n.5,0,0,.5,0,1,1\n");
    QTest::newRow("cumulative weights")
        << QByteArray("a,b,c,d,e,f,cumulative\n.5,0,0,.4,1,2,-1\n.5,0,0,.5,0,0,-1\n.5,0,0,.5,0,1,4\n");
    QTest::newRow("space") << QByteArray("a,b,c,d,e,f,g,h,i,j,k,l,p\n.5,0,0,0,.5,0,0,0,.5,0,0,0,-1\n"
                                         ".5,0,0,0,.5,0,0,0,.5,0,0,0,0\n.5,0,0,0,.5,0,0,0,.5,1,0,0,1\n");
    QTest::newRow("flame") << QByteArray(
        "<flame>\n<xform weight=\"-1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/>\n"
        "<xform linear=\"1\" coefs=\".5 0 0 .5 0 0\"/>\n"
        "<xform weight=\"2\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame>");
    QTest::newRow("collection") << QByteArray(
        "x {\n.5 0 0 .5 0 0 -.5\n.5 0 0 .5 1 0 0\n.5 0 0 .5 1 0 1\n}\n");
}

// As for a Fractint collection: where, and which map.
void CollectionReaderTest::weightsWithoutAPartAreSaid() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    const document::Entry& entry = collection.file.entries.first();
    const document::Problems problems = entry.problems;
    QVERIFY(problems.size() >= 2);
    QCOMPARE(problems[0].severity, document::Problem::Severity::Warning);
    QCOMPARE(problems[0].entry, entry.fractal->name);
    QCOMPARE(problems[0].line, 2);
    QVERIFY2(problems[0].message.startsWith(QStringLiteral("The weight of map 1 is negative")),
             qPrintable(problems[0].message));
    QCOMPARE(problems[1].line, 3);
    QVERIFY(problems[1].message.startsWith(QStringLiteral("The weight of map 2 is 0")));
}

void CollectionReaderTest::weightsThatRiseAreSaid_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("isSaid");
    const auto row = [](const char* name, const char* head, const QList<const char*>& weights, bool isSaid) {
        QByteArray text = head;
        for (const char* weight : weights)
            text += QByteArray(".5,0,0,.5,0,1,") + weight + '\n';
        QTest::newRow(name) << text << isSaid;
    };
    row("to 100", "a,b,c,d,e,f,p\n", {"1", "86", "93", "100"}, true);
    row("to 1", "", {"0.01", "0.86", "0.93", "1"}, true);
    row("two maps", "a,b,c,d,e,f,p\n", {"0.85", "1"}, true);
    row("all in the last", "", {"0", "0", "1"}, false);
    row("a map without a part", "", {"1", "86", "86", "100"}, true);
    row("two of the largest", "", {"0.5", "1", "1"}, false);
    row("to 100 %", "a,b,c,d,e,f,p\n", {"1%", "86%", "93%", "100%"}, true);
    row("named", "a,b,c,d,e,f,cumulative\n", {"1", "86", "93", "100"}, false);
    row("probabilities", "", {"0.01", "0.07", "0.07", "0.85"}, false);
    row("all 1", "", {"1", "1", "1"}, false);
    row("counts", "", {"1", "2", "3"}, false);
    row("falling", "", {"100", "50"}, false);
    QTest::newRow("bare rows") << QByteArray(".5 0 0 .5 0 0 1\n.5 0 0 .5 1 0 86\n.5 0 0 .5 0 1 100\n")
                               << true;
    QTest::newRow("lists") << QByteArray("[[.5,0,0,.5,0,0,1],[.5,0,0,.5,1,0,86],[.5,0,0,.5,0,1,100]]")
                           << true;
}

void CollectionReaderTest::weightsThatRiseAreSaid() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, isSaid);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    const document::Problems problems = collection.file.entries.first().problems;
    QCOMPARE(std::any_of(problems.begin(), problems.end(),
                         [](const auto& problem) {
                             return problem.message.contains(QStringLiteral("running sums")) &&
                                    problem.message.contains(QStringLiteral("“cumulative”"));
                         }),
             isSaid);
}

void CollectionReaderTest::sumsAreReadAsTheRemarkSays_data() {
    QTest::addColumn<QByteArray>("bytes");
    const char* map = ".5,0,0,.5,0,";
    QTest::newRow("table") << QByteArray("a,b,c,d,e,f,cumulative\n") + map + "0,25\n" + map + "1,100\n";
    const char* solid = ".5 0 0 0 .5 0 0 0 .5 0 0 ";
    QTest::newRow("solid") << QByteArray("a b c d e f g h i j k l cumulative\n") + solid + "0 25\n" + solid +
                                  "1 100\n";
    QTest::newRow("solid, first") << QByteArray("cumulative a b c d e f g h i j k l\n25 ") + solid +
                                         "0\n100 " + solid + "1\n";
    QTest::newRow("solid, more columns")
        << QByteArray("name;cum;a;b;c;d;e;f;g;h;i;j;k;l\nx;25;.5;0;0;0;.5;0;0;0;.5;0;0;0\n"
                      "y;100;.5;0;0;0;.5;0;0;0;.5;0;0;1\n");
    QTest::newRow("beside lists") << QByteArray(
        "maps = [[.5,0,0,.5,0,0],[.5,0,0,.5,0,1]]\ncumulative = [25, 100]\n");
    QTest::newRow("beside matrices") << QByteArray(
        "A1 = [[.5,0],[0,.5]]\nb1 = [0,0]\nA2 = [[.5,0],[0,.5]]\nb2 = [0,1]\ncumulative = [25, 100]\n");
    QTest::newRow("beside letters") << QByteArray(
        "a = [.5,.5]\nb = [0,0]\nc = [0,0]\nd = [.5,.5]\ne = [0,0]\nf = [0,1]\ncum = [25,100]\n");
    QTest::newRow("keys") << QByteArray(
        "[{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":0,\"cumulative\":25},"
        "{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":1,\"cumulative\":100}]");
}

// In all that is read: “cumulative” instead of “p”.
void CollectionReaderTest::sumsAreReadAsTheRemarkSays() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    const document::Entry& entry = collection.file.entries.first();
    QVERIFY(entry.problems.isEmpty());
    QList<double> weights;
    if (const auto* system = document::system2(*entry.fractal))
        for (const auto& map : system->maps)
            weights << map.weight.value_or(-1);
    if (const auto* system = document::system3(*entry.fractal))
        for (const auto& map : system->maps)
            weights << map.weight.value_or(-1);
    QCOMPARE(weights, (QList<double>{25, 75}));
}

void CollectionReaderTest::listsOfWeightsThatDoNotFitAreSaid_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("start");
    const QByteArray matrices = "A1 = [[.5,0],[0,.5]]\nb1 = [0,0]\nA2 = [[.5,0],[0,.5]]\nb2 = [0,1]\n";
    const QByteArray maps = "maps = [[.5,0,0,.5,0,0],[.5,0,0,.5,0,1]]\n";
    const QByteArray letters = "a = [.5,.5]\nb = [0,0]\nc = [0,0]\nd = [.5,.5]\ne = [0,0]\nf = [0,1]\n";
    const auto named = [](const char* name, int numbers) {
        return QStringLiteral("“%1” has %2 numbers for 2 maps").arg(QLatin1String(name)).arg(numbers);
    };
    QTest::newRow("more than matrices") << matrices + "p = [.2,.3,.5]\n" << named("p", 3);
    QTest::newRow("fewer than matrices") << matrices + "prob = [.2]\n" << named("prob", 1);
    QTest::newRow("one for two matrices") << matrices + "p1 = .2\n" << named("p", 1);
    QTest::newRow("more than lists") << maps + "weights = [.2,.3,.5]\n" << named("weights", 3);
    QTest::newRow("more than letters") << letters + "p = [.2,.3,.5]\n" << named("p", 3);
    QTest::newRow("before letters") << "p = [.2,.3,.5]\n" + letters << named("p", 3);
    QTest::newRow("keys") << QByteArray("[{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":0,\"p\":0.3},"
                                        "{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":1}]")
                          << QStringLiteral("Map 2 has no weight");
    QTest::newRow("keys, of the last one")
        << QByteArray("[{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":0},"
                      "{\"a\":.5,\"b\":0,\"c\":0,\"d\":.5,\"e\":0,\"f\":1,\"p\":0.3}]")
        << QStringLiteral("Map 1 has no weight");
    QTest::newRow("lists of six and seven")
        << QByteArray("[[.5,0,0,.5,0,0],[.5,0,0,.5,0,1,.3]]") << QStringLiteral("Map 1 has no weight");
    QTest::newRow("named maps") << QByteArray("w1 = [.5,0,0,.5,0,0]\nw2 = [.5,0,0,.5,0,1,.3]\n")
                                << QStringLiteral("Map 1 has no weight");
    QTest::newRow("matrices in LaTeX")
        << QByteArray("\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}, p=.2\n"
                      "\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}\\begin{bmatrix}0\\\\1\\end{bmatrix}\n")
        << QStringLiteral("Map 2 has no weight");
    QTest::newRow("equations") << QByteArray("p = .2\nx' = .5x\ny' = .5y\n\nx' = .5x\ny' = .5y + 1\n")
                               << QStringLiteral("Map 2 has no weight");
    QTest::newRow("Markdown")
        << QByteArray("|a|b|c|d|e|f|p|\n|-|-|-|-|-|-|-|\n|.5|0|0|.5|0|0|.2|\n|.5|0|0|.5|0|1||\n")
        << QStringLiteral("Map 2 has no weight");
}

// The maps are read, and their weights computed.
void CollectionReaderTest::listsOfWeightsThatDoNotFitAreSaid() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, start);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    QCOMPARE(firstSystem(collection.file).maps.size(), std::size_t(2));
    const document::Problems problems = collection.file.entries.first().problems;
    QCOMPARE(problems.size(), 1);
    QCOMPARE(problems[0].severity, document::Problem::Severity::Warning);
    QVERIFY2(problems[0].message.startsWith(start), qPrintable(problems[0].message));
}

// Those that are given do not go silently, and nothing is said where there are all or none.
void CollectionReaderTest::someWeightsMissingAreSaid() {
    const auto problemsOf = [](const QByteArray& bytes) {
        return io::readCollection(bytes).file.entries.value(0).problems;
    };
    const auto problems = problemsOf(".5,0,0,.5,0,0,.25\n.5,0,0,.1,1,0\n.3,0,0,.3,0,1,7\n");
    QCOMPARE(problems.size(), 1);
    QCOMPARE(problems[0].severity, document::Problem::Severity::Warning);
    QCOMPARE(problems[0].line, 2);
    QVERIFY2(problems[0].message.startsWith(QStringLiteral("Map 2 has no weight")),
             qPrintable(problems[0].message));
    QVERIFY(problemsOf(".5,0,0,.5,0,0,.25\n.5,0,0,.1,1,0,.75\n").isEmpty());
    QVERIFY(problemsOf(".5,0,0,.5,0,0\n.5,0,0,.1,1,0\n").isEmpty());
}

void CollectionReaderTest::roundTrips_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("columns");
    QTest::newRow("fractint") << QStringLiteral("ifs") << QStringLiteral("abcdefp");
    QTest::newRow("flame") << QStringLiteral("flame") << QStringLiteral("abcdefp");
    QTest::newRow("csv") << QStringLiteral("csv") << QStringLiteral("abcdefp");
    QTest::newRow("csv, row by row") << QStringLiteral("csv") << QStringLiteral("a b e c d f p");
    QTest::newRow("tsv, weight first") << QStringLiteral("tsv") << QStringLiteral("pacbdef");
}

// Every number comes back as the same double.
void CollectionReaderTest::roundTrips() {
    QFETCH(QString, format);
    QFETCH(QString, columns);
    const auto fractal = std::make_shared<const document::Fractal>(fern());
    io::TextOptions options;
    options.columns = io::tableColumns(columns).value();
    const QByteArray text = io::textOf({fractal}, io::textFormat(format).value(), options);
    const io::Collection back = io::readCollection(text);
    const auto& maps = firstSystem(back.file).maps;
    const auto& before = document::system2(*fractal)->maps;
    QCOMPARE(maps.size(), before.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        QVERIFY2(maps[i].map == before[i].map, text.constData());
        QCOMPARE(maps[i].weight, before[i].weight);
    }
}

BARYCAGE_TEST(CollectionReaderTest);
#include "collection_reader_test.moc"
