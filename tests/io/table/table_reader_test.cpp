// SPDX-License-Identifier: MIT
#include "io/table/table_reader.h"
#include "io/table/table_writer.h"
#include "io/text/number.h"
#include "support/named_test.h"

#include <QLocale>
#include <QRandomGenerator>
#include <QtTest>

#include <cmath>
#include <cstring>
#include <limits>

namespace {

// "a b c d e f p|-" per row, rows parted by "/".
QString summary(const io::Table& table) {
    QStringList rows;
    for (const auto& row : table.rows) {
        QStringList numbers;
        const auto& [linear, translation] = row.map;
        for (const double n :
             {linear(0, 0), linear(0, 1), linear(1, 0), linear(1, 1), translation[0], translation[1]})
            numbers << QString::number(n);
        rows << numbers.join(QLatin1Char(' ')) + QLatin1Char(' ') +
                    (row.weight ? QString::number(*row.weight) : QStringLiteral("-"));
    }
    return rows.join(QLatin1Char('/'));
}

} // namespace

class TableReaderTest : public QObject {
    Q_OBJECT

private slots:
    // “e” and “phi” are names of columns.
    void constantsAreNumbers() {
        const auto rows = [](const char* text) { return summary(io::readTable(QString::fromUtf8(text))); };
        const QString wanted = QStringLiteral("0.5 0 0 0.5 3.14159 0 1/0.5 0 0 0.5 1 -3.14159 1");
        QCOMPARE(rows(".5,0,0,.5,pi,0,1\n.5,0,0,.5,1,-pi,1"), wanted);
        QCOMPARE(rows("a,b,c,d,e,f,p\n.5,0,0,.5,PI,0,1\n.5,0,0,.5,1,-pi,1"), wanted);
        QCOMPARE(rows(".5 0 0 .5 pi 0 1\n.5 0 0 .5 1 -π 1"), wanted);
        QCOMPARE(rows(".5\t0\t0\t.5\tπ\t0\t1\n.5\t0\t0\t.5\t1\t-pi\t1"), wanted);
        QCOMPARE(rows(".5,0,0,.5,sqrt(pi),0,1"), QStringLiteral("0.5 0 0 0.5 1.77245 0 1"));
        QCOMPARE(rows("pi,0,0,.5,1,0,1"), QStringLiteral("3.14159 0 0 0.5 1 0 1"));
        QCOMPARE(rows("r,s,theta,phi,e,f\n.5,.5,0,0,pi,0"), QStringLiteral("0.5 0 0 0.5 3.14159 0 -"));
    }

    void whyTextIsNoOrderOfColumns_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        QTest::newRow("words") << "p A b, c d e f"
                               << "";
        QTest::newRow("letters") << "pabcdef"
                                 << "";
        QTest::newRow("no weight") << "r s theta phi e f"
                                   << "";
        QTest::newRow("sums") << "cumulative a b c d e f"
                              << "";
        QTest::newRow("nothing") << ""
                                 << "Missing: a b c d e f.";
        QTest::newRow("begun") << "r s"
                               << "Missing: theta phi e f.";
        QTest::newRow("twice") << "a b c d e f a"
                               << "“a” occurs twice.";
        QTest::newRow("unknown")
            << "a b c d x y"
            << "There is no column “x”: the columns are a b c d or r s theta phi, e f, and p or cumulative.";
        QTest::newRow("two weights") << "a b c d e f p cumulative"
                                     << "A row has only one weight: p or cumulative.";
        QTest::newRow("mixed") << "a b theta phi e f"
                               << "a b c d and r s theta phi cannot be combined.";
    }
    void whyTextIsNoOrderOfColumns() {
        QFETCH(QString, text);
        QFETCH(QString, why);
        QCOMPARE(io::columnsObstacle(text), why);
        QCOMPARE(io::tableColumns(text).has_value(), why.isEmpty());
    }

    void tables_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("rows");
        const auto row = [](const char* name, const char* text, const char* rows) {
            QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(rows);
        };
        const char* one = "0.5 0 0.25 -0.5 1 2 -";
        const char* weighted = "0.5 0 0.25 -0.5 1 2 0.75";
        row("blanks", ".5 0 .25 -.5 1 2", one);
        row("with a weight", ".5 0 .25 -.5 1 2 .75\n", weighted);
        row("tabs", ".5\t0\t.25\t-.5\t1\t2\t.75\r\n", weighted);
        row("commas", "0.5,0,0.25,-0.5,1,2,0.75", weighted);
        row("commas and blanks", "0.5, 0, 0.25, -0.5, 1, 2", one);
        row("semicolons", "0.5;0;0.25;-0.5;1;2;0.75", weighted);
        row("decimal commas, semicolons", "0,5;0;0,25;-0,5;1;2;0,75", weighted);
        row("decimal commas, tabs", "0,5\t0\t0,25\t-0,5\t1\t2", one);
        row("typographic minus", "0.5 0 0.25 −0.5 1 2", one);
        row("labels", "w1 .5 0 .25 -.5 1 2\nw2 .5 0 .25 -.5 1 2",
            "0.5 0 0.25 -0.5 1 2 -/0.5 0 0.25 -0.5 1 2 -");
        row("a number as label", "1 .5 0 .25 -.5 1 2 .75", weighted);
        row("ƒ as label", "ƒ1\t.5\t0\t.25\t-.5\t1\t2\t.75", weighted);
        row("header", "a,b,c,d,e,f,p\n0.5,0,0.25,-0.5,1,2,0.75", weighted);
        row("header with label", "map a b c d e f\n1 .5 0 .25 -.5 1 2 .75", weighted);
        row("blank lines", "\n\n .5 0 .25 -.5 1 2 \n\n", one);
        row("comments", "; the fern\n.5 0 .25 -.5 1 2 .75 ; the stem, first", weighted);
        row("CR", "\r.5 0 .25 -.5 1 2\r", one);
        row("fractions", "1/2 0 ¼ -1/2 1 2", one);
        row("order in the header", "p a b e c d f\n.75 .5 0 1 .25 -.5 2", weighted);
        row("row by row", "map,a,b,e,c,d,f\nw1,.5,0,1,.25,-.5,2", one);
        row("one column per map", "a .5 .5\nb 0 0\nc .25 .25\nd -.5 -.5\ne 1 1\nf 2 2",
            "0.5 0 0.25 -0.5 1 2 -/0.5 0 0.25 -0.5 1 2 -");
        row("cumulative weights", "a b c d e f cumulative\n.5 0 .25 -.5 1 2 25\n.5 0 .25 -.5 1 2 100",
            "0.5 0 0.25 -0.5 1 2 25/0.5 0 0.25 -0.5 1 2 75");
        row("scales and angles", "r s theta phi h k p\n2 3 0 0 1 2 .5", "2 0 0 3 1 2 0.5");
        row("marked degrees", "r s theta phi e f\n.5 .5 90° 90° .5 0", "0 -0.5 0.5 0 0.5 0 -");
        row("radians", "r s theta phi e f\n.5 .5 pi/2 -π/2 .5 0", "0 0.5 0.5 0 0.5 0 -");
        row("a weight before the angles", "p r s theta phi e f\n.75 2 2 180° asin(1)*2 1 2",
            "-2 0 0 -2 1 2 0.75");
        row("expressions elsewhere", "r s theta phi e f\n180°/pi 3 0 0 cos(60°) 2*sin(pi/6)",
            "1 0 0 3 0.5 1 -");
        row("count and matrices", "1\n.75\n.5 0 1\n.25 -.5 2\n0 0 1\n", weighted);
        const char* two = "0.5 0 0.25 -0.5 1 2 0.75/0.5 0 0.25 -0.5 1 2 0.25";
        row("labels under a header that has none", "a b c d e f p\nw1 .5 0 .25 -.5 1 2 .75", weighted);
        row("numbers as labels", "1;0.5;0;0.25;-0.5;1;2;0.75\n2;0.5;0;0.25;-0.5;1;2;0.25", two);
        row("words and numbers as labels",
            "map;a;b;c;d;e;f;p\nstem;0.5;0;0.25;-0.5;1;2;0.75\n2;.5;0;.25;-.5;1;2;.25", two);
        row("labels of two words", "map 1,.5,0,.25,-.5,1,2,.75\nmap 2,.5,0,.25,-.5,1,2,.25", two);
        row("a label of two words and a header of two", "the map,a,b,c,d,e,f\nmap 1,.5,0,.25,-.5,1,2", one);
        row("a label and a blank", "w1 .5,0,.25,-.5,1,2", "0.5 0 0.25 -0.5 1 2 -");
        row("no name over the labels", ",a,b,c,d,e,f,p\n0,.5,0,.25,-.5,1,2,.75\n1,.5,0,.25,-.5,1,2,.25", two);
        row("no weight", "a,b,c,d,e,f,p\n.5,0,.25,-.5,1,2,", one);
        row("a title and a header", "The fern\na,b,c,d,e,f,p\n.5,0,.25,-.5,1,2,.75", weighted);
        row("remarks", "# of 1988, all maps\n# a b c d e f p\n.5 0 .25 -.5 1 2 .75\n# end\n", weighted);
        row("empty rows", "a,b,c,d,e,f,p\n,,,,,,\n.5,0,.25,-.5,1,2,.75\n,,,,,,\n", weighted);
        row("decimal commas, blanks", "0,5 0 0,25 -0,5 1 2\n", one);
        row("decimal commas, blanks, a header", "a b c d e f\n0,5 0 0,25 -0,5 1 2 0,75", weighted);
        row("quotation marks",
            "\"a\",\"b\",\"c\",\"d\",\"e\",\"f\",\"p\"\n\"0.5\",\"0\",\".25\",-.5,\"1\",\" 2 \",\".75\"",
            weighted);
        row("separators in quotation marks",
            "\"map, \"\"stem\"\"\",a,b,c,d,e,f\n\"a, b\",\"0,5\",0,\"0,25\",\"-0,5\",1,2", one);
        row("a count and matrices of one line", "2\n.75 .5 0 1 .25 -.5 2 0 0 1\n.25 .5 0 1 .25 -.5 2 0 0 1\n",
            two);
        row("exponents", "5e-1 0 2.5E-1 -.5 1 +2", one);
    }

    void tables() {
        QFETCH(QString, text);
        const io::Table table = io::readTable(text);
        QTEST(summary(table), "rows");
        QVERIFY2(table.problems.isEmpty(), qPrintable(table.problems.value(0).message));
    }

    void wordsAroundNumbers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("rows");
        const auto row = [](const char* name, const char* text, const char* rows) {
            QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(rows);
        };
        const char* weighted = "0.5 0 0.25 -0.5 1 2 0.75";
        const char* quarter = "0.5 0 0.25 -0.5 1 2 0.75/0.5 0 0.25 -0.5 1 2 0.25";

        row("words behind the numbers",
            "w a b c d e f p Portion generated\nƒ1 .5 0 .25 −.5 1 2 .75 Stem\n"
            "ƒ2 .5 0 .25 −.5 1 2 .25 Successively smaller leaflets",
            quarter);
        row("words behind the numbers, tabs",
            "w\ta\tb\tc\td\te\tf\tp\tPortion generated\nƒ1\t.5\t0\t.25\t−.5\t1\t2\t.75\tStem\n"
            "ƒ2\t.5\t0\t.25\t−.5\t1\t2\t.25\tSmaller, at the left",
            quarter);
        row("words behind the numbers, commas",
            "a,b,c,d,e,f,p,Portion\n.5,0,.25,-.5,1,2,.75,\"Stem, base\"\n.5,0,.25,-.5,1,2,.25,Largest leaf",
            quarter);
        row("words behind the numbers, no header",
            ".5 0 .25 -.5 1 2 .75 Stem, the first\n.5 0 .25 -.5 1 2 .25 A leaf of 2", quarter);
        row("words before and behind, no header",
            "1 .5 0 .25 -.5 1 2 .75 (stem)\n2 .5 0 .25 -.5 1 2 .25 (leaf)", quarter);
        row("words between the numbers",
            "map,a,b,note,c,d,e,f,p\n1,.5,0,up,.25,-.5,1,2,.75\n2,.5,0,,.25,-.5,1,2,.25", quarter);
        row("percentages", "a b c d e f p\n.5 0 .25 -.5 1 2 75%\n.5 0 .25 -.5 1 2 25%", quarter);
        row("percentages under a unit", "a\tb\tc\td\te\tf\tp (%)\tpart\n.5\t0\t.25\t-.5\t1\t2\t75 %\tstem",
            weighted);
        row("a comment behind the row, #", ".5, 0, .25, -.5, 1, 2, .75  # stem, the first 1\n", weighted);
        row("a comment behind the row, %", ".5 0 .25 -.5 1 2 .75 % stem, 2 3\n", weighted);
        row("a comment behind the row, //", ".5,0,.25,-.5,1,2,.75 // stem, 2 3\n", weighted);
        row("a comment glued to the row", ".5 0 .25 -.5 1 2 .75// stem\n", weighted);
        row("comments above", "% of 1988, all 4\n// the fern, 2\n% a b c d e f p\n.5 0 .25 -.5 1 2 .75",
            weighted);
    }
    void wordsAroundNumbers() { tables(); }

    void layoutsAndSigns_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("rows");
        const auto row = [](const char* name, const char* text, const char* rows) {
            QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(rows);
        };
        const char* one = "0.5 0 0.25 -0.5 1 2 -";
        const char* weighted = "0.5 0 0.25 -0.5 1 2 0.75";
        const char* quarter = "0.5 0 0.25 -0.5 1 2 0.75/0.5 0 0.25 -0.5 1 2 0.25";
        row("rules",
            "a b c d e f p\n--- --- --- --- --- --- ---\n.5 0 .25 -.5 1 2 .75\n=================", weighted);
        row("a header above columns for maps",
            "\tf1\tf2\na\t.5\t.5\nb\t0\t0\nc\t.25\t.25\nd\t-.5\t-.5\ne\t1\t1\nf\t2\t2\np\t.75\t.25\n"
            "part\tstem\tleaf",
            quarter);
        row("numbers above columns for maps",
            "map 1 2\na = .5 .5\nb = 0 0\nc = .25 .25\nd = -.5 -.5\ne = 1 1\nf = 2 2\np = .75 .25", quarter);
        row("a colon behind the letters", "a: .5\nb: 0\nc: .25\nd: -.5\ne: 1\nf: 2\n", one);
        row("indices", "a_i b_i c_i d_i e_i f_i p_i\n.5 0 .25 -.5 1 2 .75", weighted);
        row("elements of the matrix", "a11,a12,a21,a22,b1,b2\n.5,0,.25,-.5,1,2", one);
        for (const char16_t dash : u"-‐‑‒–—―−﹣－")
            if (dash != 0)
                QTest::newRow(qPrintable(QStringLiteral("dash U+%1").arg(int(dash), 4, 16)))
                    << QStringLiteral(".5 0 .25 ").append(QChar(dash)).append(QStringLiteral(".5 1 2"))
                    << QString::fromUtf8(one);
        row("a sign set apart", ".5\t0\t.25\t− .5\t1\t2", one);
        row("a sign set apart by a thin blank", ".5 0 .25 −\u2009.5 1 2", one);
        row("full width", "０.５ ０ ．２５ －．５ １ ２", one);
    }
    void layoutsAndSigns() { tables(); }

    void otherColumnsAreSaid() {
        const io::Table table = io::readTable(QStringLiteral(
            "n,a,b,c,d,e,f,p,det,note\n1,.5,0,.25,-.5,1,2,.75,-.25,x\n2,.5,0,.25,-.5,1,2,,7,y"));
        QCOMPARE(summary(table), QStringLiteral("0.5 0 0.25 -0.5 1 2 0.75/0.5 0 0.25 -0.5 1 2 -"));
        QCOMPARE(table.problems.size(), 1);
        QCOMPARE(table.problems[0].severity, document::Problem::Severity::Warning);
        QVERIFY(table.problems[0].message.endsWith(QStringLiteral(": det.")));
    }

    void chosenColumnsAmongOthers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("columns");
        const auto row = [](const char* name, const char* text, const char* columns) {
            QTest::newRow(name) << QString::fromUtf8(text) << QString::fromLatin1(columns);
        };
        row("names", "w\ta\tb\tc\td\te\tf\tp\tpart\nƒ1\t.5\t0\t1\t.25\t-.5\t2\t.75\tstem", "abecdfp");
        row("other names", "id,m11,m12,m13,m21,m22,m23,share,part\nx,.5,0,1,.25,-.5,2,.75,stem", "abecdfp");
        row("words", "m1 m2 m3 m4 m5 m6 share\nx .5 0 1 .25 -.5 2 .75 big stem", "abecdfp");
        row("no header", "1 .5 0 1 .25 -.5 2 .75 stem", "abecdfp");
        row("named in the order", "7,.5,0,3,1,.25,-.5,2,.75,9", "id a b - e c d f p area");
    }
    void chosenColumnsAmongOthers() {
        QFETCH(QString, text);
        QFETCH(QString, columns);
        const io::Table table = io::readTable(text, io::columnsToRead(columns));
        QVERIFY2(table.problems.isEmpty(), qPrintable(table.problems.value(0).message));
        QCOMPARE(summary(table), QStringLiteral("0.5 0 0.25 -0.5 1 2 0.75"));
    }

    void unitsStandBesideNames() {
        const io::Table table = io::readTable(
            QStringLiteral("θ°\tφ°\tr\ts\te\tf\tp %\n90\t90\t.5\t.5\t0\t0\t50\n0\t0\t.5\t.5\t1\t0\t50\n"));
        QVERIFY(table.problems.isEmpty());
        QCOMPARE(summary(table), QStringLiteral("0 -0.5 0.5 0 0 0 50/0.5 0 0 0.5 1 0 50"));
    }

    void anglesTurnCounterClockwise() {
        const io::Table table = io::readTable(QStringLiteral("1 2 30 60 0 0"),
                                              io::tableColumns(QStringLiteral("r s theta phi e f")));
        QCOMPARE(table.rows.size(), std::size_t(1));
        const auto& m = table.rows[0].map.linear;
        const double half = 0.5;
        const double root = std::sqrt(3.0) / 2;
        QVERIFY(std::abs(m(0, 0) - root) < 1e-15 && std::abs(m(1, 0) - half) < 1e-15);
        QVERIFY(std::abs(m(0, 1) + 2 * root) < 1e-15 && std::abs(m(1, 1) - 1) < 1e-15);
    }

    // The weight is missing from the row, and stands before the angles in the order.
    void anglesAreFoundBesideAMissingWeight() {
        const auto columns = io::tableColumns(QStringLiteral("r s p theta phi e f"));
        for (const char* text : {"2 2 180° 2*pi/2 1 2", "2 2 .5 180° 2*pi/2 1 2"}) {
            const io::Table table = io::readTable(QString::fromUtf8(text), columns);
            QCOMPARE(table.rows.size(), std::size_t(1));
            QVERIFY(table.rows[0].map == ifs::affineMap(-2, 0, 0, -2, 1, 2));
        }
    }

    void ordersOfColumns() {
        for (const char* good : {"abcdef", "a b c d e f p", "pabecdf", "r s theta phi e f", "A,B,C,D,E,F"})
            QVERIFY2(io::tableColumns(QString::fromLatin1(good)), good);
        for (const char* bad : {"", "abcde", "aabcdef", "abcdefg", "abcdefpp", "r s theta phi e f a"})
            QVERIFY2(!io::tableColumns(QString::fromLatin1(bad)), bad);
    }

    void anUnknownOrderIsSaidOnce() {
        const io::Table table = io::readTable(QStringLiteral("m,n,o,p,q,r\n1,2,3,4,5,6\n1,2,3,4,5,6\n"));
        QCOMPARE(table.problems.size(), 1);
        QVERIFY(table.problems.first().message.contains(QStringLiteral("choose the order")));
    }

    void errors_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<int>("column");
        QTest::newRow("five numbers") << QStringLiteral("1 2 3 4 5 6\n 1 2 3 4 5") << 2 << 2;
        QTest::newRow("nine numbers") << QStringLiteral("1 2 3 4 5 6 7 8 9") << 1 << 1;
        QTest::newRow("division by zero") << QStringLiteral("1 2 3 4 1/0 6") << 1 << 9;
        QTest::newRow("after a typographic minus") << QString::fromUtf8("−1 2 x 4 5 6") << 1 << 8;
        QTest::newRow("nan") << QStringLiteral("1 2 3 4 5 nan") << 1 << 11;
        QTest::newRow("mixed decimals") << QStringLiteral("0,5\t0.5\t3\t4\t5\t6") << 1 << 5;
        QTest::newRow("words later") << QStringLiteral("1 2 3 4 5 6\nend of table") << 2 << 1;
        QTest::newRow("unknown order of columns") << QStringLiteral("m n o p q r\n1 2 3 4 5 6") << 1 << 1;
        QTest::newRow("unknown columns in words")
            << QStringLiteral("scale x,scale y,turn x,turn y,to x,to y\n.5,.5,30,30,1,2") << 1 << 1;
        QTest::newRow("unknown unit")
            << QStringLiteral("r,s,theta (rad),phi (rad),e,f\n.5,.5,1,1,0,2\n.5,.5,0,0,0,2") << 1 << 1;
        QTest::newRow("last row of a matrix") << QStringLiteral("1\n.5\n1 0 0\n0 1 0\n0 0 2") << 5 << 1;
        const auto row = [](const char* text, int line, int column) {
            QTest::newRow(qPrintable(QString::fromUtf8(text).replace(u'\n', u'/')))
                << QString::fromUtf8(text) << line << column;
        };
        // A cell that is no number is never taken for a label.
        row("a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\nO.5,0,0,.4,1,2,.5", 3, 1);
        row("a,b,c,d,e,f,p\nO.5,0,0,.4,1,2,.5", 2, 1);
        row("O.5,0,0,.4,1,2,.5", 1, 1);
        row("a,b,c,d,e,f,p\n,0,0,.4,1,2,.5", 2, 1);
        row("a,b,c,d,e,f,p\n.5,,0,.4,1,2,.5", 2, 4);
        row(".5,0,0,.5,0,0,.5\n,0,0,.4,1,2,.5", 2, 1);
        row("a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\n1e400,0,0,.4,1,2,.5", 3, 1);
        row("a,b,c,d,e,f,p\n0x10,0,0,.5,0,0,.5", 2, 1);
        row("0x10 0 0 .5 0 0 .5", 1, 1);
        row("85%,0,0,.5,0,0,.5", 1, 1);
        row("nan 0 0 .5 0 0 .5", 1, 1);
        row("1½ 0 0 .5 0 0 .5", 1, 1);
        // … and a number neither.
        row("a,b,c,d,e,f,p\n.5,0,0,.5,0,0,.5\n.5,0,0,.4,1,2,.5,9", 3, 1);
        row(".5,0,0,.5,0,0,.5\n.5,0,0,.4,1,2,.5,9", 2, 1);
        row(".5,.5,0,0,.4,1,2,.5", 1, 1);
        row("1,.5,0,0,.4,1,2,.5\n5,.5,0,0,.4,1,2,.5", 2, 1);
        row("w,a,b,c,d,e,f\n.5,0,0,.5,0,0,.5", 1, 1);
        row("w1,.5,0,0,.5,0,0\n.5,0,0,.5,0,0,.5", 2, 1);
        row("w1 0,.5,0,0,.5,0,0", 1, 1); // the first of 7 numbers, or the end of the label
        row("0,5 0 0 0,5 1 0\n0.5 0 0 0.5 1 0", 1, 1);
        row("a b c d e f p\n.5 0 0 .5 0 0", 2, 1);
        row("m1,m2,m3,m4,m5,m6\n1,.5,0,0,.5,0,0", 1, 1);
        row("2\n.75 .5 0 1 .25 -.5 2 0 0 1\n.25 .5 0 1\n", 3, 1);
        row(".5 0 0 0 .5 0 0 0 .5 0 0 0", 1, 1); // a map in space, where a plane one is wanted
        QTest::newRow("wrong count") << QStringLiteral("2\n.5\n1 0 0\n0 1 0\n0 0 1") << 1 << 1;
        QTest::newRow("nothing") << QString() << 0 << 0;
    }

    void errors() {
        QFETCH(QString, text);
        const io::Table table = io::readTable(text);
        QVERIFY(!table.problems.isEmpty());
        QCOMPARE(table.problems[0].severity, document::Problem::Severity::Error);
        QTEST(table.problems[0].line, "line");
        QTEST(table.problems[0].column, "column");
        QVERIFY(table.problems[0].message.endsWith(QLatin1Char('.')));
    }

    void mapsInSpace_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isWeighted");
        QTest::newRow("12 numbers") << QStringLiteral("1,2,3,4,5,6,7,8,9,10,11,12") << false;
        QTest::newRow("13 numbers") << QStringLiteral("1 2 3 4 5 6 7 8 9 10 11 12 .5") << true;
        QTest::newRow("label") << QStringLiteral("w1;1;2;3;4;5;6;7;8;9;10;11;12;,5") << true;
        QTest::newRow("header") << QStringLiteral("a,b,c,d,e,f,g,h,i,j,k,l,p\n1,2,3,4,5,6,7,8,9,10,11,12,.5")
                                << true;
        QTest::newRow("header over labels")
            << QStringLiteral(
                   "map\ta\tb\tc\td\te\tf\tg\th\ti\tj\tk\tl\n1\t1\t2\t3\t4\t5\t6\t7\t8\t9\t10\t11\t12")
            << false;
    }

    void mapsInSpace() {
        QFETCH(QString, text);
        QFETCH(bool, isWeighted);
        const io::Table table = io::readTable(text, std::nullopt, io::TableMaps::PlaneOrSpace);
        QVERIFY2(table.problems.isEmpty(), qPrintable(table.problems.value(0).message));
        QCOMPARE(table.rows.size(), std::size_t(0));
        QCOMPARE(table.spaceRows.size(), std::size_t(1));
        const auto& map = table.spaceRows[0].map;
        for (int i = 0; i < 9; ++i)
            QCOMPARE(map.linear(i / 3, i % 3), i + 1.0);
        for (int i = 0; i < 3; ++i)
            QCOMPARE(map.translation[i], i + 10.0);
        QCOMPARE(table.spaceRows[0].weight, isWeighted ? std::optional(0.5) : std::nullopt);
        const io::Table mixed = io::readTable(QStringLiteral("1 2 3 4 5 6\n1 2 3 4 5 6 7 8 9 10 11 12"),
                                              std::nullopt, io::TableMaps::PlaneOrSpace);
        QCOMPARE(mixed.problems.value(0).line, 2);
    }

    void writtenTablesReadBack() {
        QRandomGenerator random(3);
        for (int round = 0; round < 200; ++round) {
            std::vector<ifs::WeightedMap<2>> rows;
            for (int i = random.bounded(1, 5); i > 0; --i) {
                ifs::WeightedMap<2> row;
                const auto number = [&] {
                    return (random.bounded(2.0) - 1) * std::pow(10.0, random.bounded(-30, 30));
                };
                row.map = ifs::affineMap(number(), number(), number(), number(), number(), number());
                if (random.bounded(2) == 0) row.weight = number();
                rows.push_back(row);
            }
            const io::Table table = io::readTable(io::writeTable(rows));
            QVERIFY(table.problems.isEmpty());
            QVERIFY(table.rows == rows);
        }
    }

    // Whatever the user's language, a number is written with a point and reads back as the same bits.
    void numbersIgnoreTheLocale() {
        QLocale::setDefault(QLocale(QLocale::German));
        QCOMPARE(io::formatNumber(1234.5), QByteArray("1234.5"));
        QCOMPARE(io::parseNumber(u"1234.5"), std::optional(1234.5));
        QVERIFY(!io::parseNumber(u"1234,5"));
        for (const char* text : {"", "1/3", "0x10", "inf", "nan", "1e999", "+-1", "--1", "1 2"})
            QVERIFY2(!io::parseNumber(QString::fromLatin1(text)), text);
        QRandomGenerator64 random(5);
        for (int i = 0; i < 10'000; ++i) {
            const quint64 bits = random.generate64();
            double value = 0;
            std::memcpy(&value, &bits, sizeof value);
            if (!std::isfinite(value)) continue;
            QCOMPARE(io::parseNumber(QString::fromLatin1(io::formatNumber(value))).value_or(std::nan("")),
                     value);
        }
        for (const double value :
             {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), 1.0 / 3})
            QVERIFY(*io::parseNumber(QString::fromLatin1(io::formatNumber(value))) == value);
        QLocale::setDefault(QLocale::c());
    }

    void largeTablesHaveALimit() {
        const io::Table table = io::readTable(QStringLiteral("1 2 3 4 5 6\n").repeated(250'001));
        QCOMPARE(table.rows.size(), std::size_t(250'000));
        QVERIFY(table.problems.value(0).message.contains(QStringLiteral("250000")));
    }
};

BARYCAGE_TEST(TableReaderTest);
#include "table_reader_test.moc"
