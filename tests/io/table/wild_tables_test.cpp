// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "io/exchange/latex.h"
#include "support/named_test.h"

#include <QTest>

#include <memory>

// Two maps as programs print them, as people write them down, and what looks like maps and is none.
class WildTablesTest : public QObject {
    Q_OBJECT

private slots:
    void printedTables_data();
    void printedTables();
    void rowsOfWordsAreNotSkipped_data();
    void rowsOfWordsAreNotSkipped();
    void namesOfColumns_data();
    void namesOfColumns();
    void equations_data();
    void equations();
    void programs_data();
    void programs();
    void lists_data();
    void lists();
    void tablesInSpace_data();
    void tablesInSpace();
    void nothingIsTakenForMaps_data();
    void nothingIsTakenForMaps();
    void factorsStandForMatrices();
    void writtenFormulasReadBackToTheLastDigit();

private:
    static void checkMaps();
};

namespace {

void addWild(const char* name, const char* bytes, bool hasWeights = true) {
    QTest::newRow(name) << QByteArray(bytes) << hasWeights;
}

void addWildColumns() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("hasWeights");
}

} // namespace

// Each is the same pair of maps.
void WildTablesTest::checkMaps() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, hasWeights);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    const auto* system = document::system2(*collection.file.entries.first().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(2));
    QVERIFY(system->maps[0].map == ifs::affineMap(0.5, 0.1, -0.2, 0.4, 3, 7));
    QVERIFY(system->maps[1].map == ifs::affineMap(0.1, 0, 0, 0.5, 1, 0));
    QCOMPARE(system->maps[0].weight.has_value(), hasWeights);
    if (!hasWeights) return;
    QCOMPARE(*system->maps[0].weight / *system->maps[1].weight, 1.0 / 3);
}

void WildTablesTest::printedTables_data() {
    addWildColumns();
    addWild("R, data frame", "    a   b    c   d e f    p\n1 0.5 0.1 -0.2 0.4 3 7 0.25\n"
                             "2 0.1 0.0  0.0 0.5 1 0 0.75\n");
    addWild("R, data frame without weights",
            "    a   b    c   d e f\n1 0.5 0.1 -0.2 0.4 3 7\n2 0.1 0.0  0.0 0.5 1 0\n", false);
    addWild("R, matrix", "     [,1] [,2] [,3] [,4] [,5] [,6] [,7]\n[1,]  0.5  0.1 -0.2  0.4    3    7 0.25\n"
                         "[2,]  0.1  0.0  0.0  0.5    1    0 0.75\n");
    addWild("pandas", "     a    b    c    d  e  f     p\n0  0.5  0.1 -0.2  0.4  3  7  0.25\n"
                      "1  0.1  0.0  0.0  0.5  1  0  0.75\n");
    addWild("Julia", "2×7 Matrix{Float64}:\n 0.5  0.1  -0.2  0.4  3.0  7.0  0.25\n"
                     " 0.1  0.0   0.0  0.5  1.0  0.0  0.75\n");
    addWild("BASIC", "10 REM TWO MAPS, 1991\n20 DATA .5,.1,-.2,.4,3,7,.25\n30 DATA .1,0,0,.5,1,0,.75\n");
    addWild("a sum below", "a b c d e f p\n.5 .1 -.2 .4 3 7 .25\n.1 0 0 .5 1 0 .75\nSum: 1.00\n");
    addWild("a caption with a number",
            "Table 1. Coefficients for the Barnsley fern\n\nw\ta\tb\tc\td\te\tf\tp\n"
            "ƒ1\t.5\t.1\t−.2\t.4\t3\t7\t.25\nƒ2\t.1\t0\t0\t.5\t1\t0\t.75\n");
    addWild("a source below", "0.5\t0.1\t-0.2\t0.4\t3\t7\t.25\n0.1\t0\t0\t0.5\t1\t0\t.75\n\n"
                              "Source: M. Barnsley, Fractals Everywhere (1988), p. 86\n");
    addWild("a sentence below", "a b c d e f p\n.5 .1 -.2 .4 3 7 .25\n.1 0 0 .5 1 0 .75\n\n"
                                "The weights were chosen by hand.\n");
    addWild("a listing on a page", "<html><body><pre>\na b c d e f p\n.5 .1 &minus;.2 .4 3 7 <b>.25</b>\n"
                                   ".1 0 0 .5 1 0 .75\n</pre></body></html>\n");
    addWild("bullets", "• .5, .1, -.2, .4, 3, 7, .25\n• .1, 0, 0, .5, 1, 0, .75\n");
    addWild("asterisks", "* .5 .1 -.2 .4 3 7 .25\n* .1 0 0 .5 1 0 .75\n");
    addWild("numbers with parentheses", "1) .5, .1, -.2, .4, 3, 7, .25\n2) .1, 0, 0, .5, 1, 0, .75\n");
    addWild("minus signs apart", "a b c d e f p\n.5 .1 − .2 .4 3 7 .25\n.1 0 0 .5 1 0 .75\n");
    addWild("comments of Lua and SQL",
            "-- two maps\n.5 .1 -.2 .4 3 7 .25 -- stem, 1\n.1 0 0 .5 1 0 .75 -- leaf\n");
    addWild("numbers by name behind a label",
            "w1: a=.5 b=.1 c=-.2 d=.4 e=3 f=7 p=.25\nw2: a=.1 b=0 c=0 d=.5 e=1 f=0 p=.75\n");
}

// Words are no reason to lose a map.
void WildTablesTest::rowsOfWordsAreNotSkipped_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray first = "a b c d e f\n.5 .1 -.2 .4 3 7\n", last = "\n.1 0 0 .5 1 0\n";
    QTest::newRow("formulas") << first + "r*cosθ -r*sinθ r*sinθ r*cosθ 0.5 0" + last;
    QTest::newRow("words") << first + "zero none half 0 0.5 0" + last;
    QTest::newRow("words only") << first + "zero none half full low high" + last;
    QTest::newRow("cells") << QByteArray(
        "a,b,c,d,e,f\n.5,.1,-.2,.4,3,7\nzero,none,half,full,0,0\n.1,0,0,.5,1,0\n");
}

void WildTablesTest::rowsOfWordsAreNotSkipped() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    for (const document::Entry& entry : collection.file.entries)
        QVERIFY(!document::system2(*entry.fractal)); // rather none than two of three
}

void WildTablesTest::printedTables() {
    checkMaps();
}

void WildTablesTest::namesOfColumns_data() {
    addWildColumns();
    const QByteArray rows = "\nw1;0,5;0,1;-0,2;0,4;3;7;25 %\nw2;0,1;0;0;0,5;1;0;75 %\n";
    for (const char* weight : {"Wahrscheinlichkeit", "Gewicht", "probabilité", "poids", "probabilidad",
                               "peso", "веројатност", "Prob. (p)", "Probability of f", "p (%)"})
        QTest::newRow(weight) << QByteArray("map;a;b;c;d;e;f;") + weight + rows << true;
    for (const char* names :
         {"xx;xy;yx;yy;x0;y0", "a_{11};a_{12};a_{21};a_{22};t_x;t_y", "m11;m12;m21;m22;dx;dy"})
        QTest::newRow(names) << QByteArray("map;") + names + ";p" + rows << true;
    addWild("LaTeX",
            "\\begin{tabular}{l*{7}{S}}\nMap & {$a$} & {$b$} & {$c$} & {$d$} & {$e$} & {$f$} & {Prob.\\ "
            "$p$} \\\\\n"
            "$w_1$ & 0.5 & 0.1 & -0.2 & 0.4 & 3 & 7 & 0.25 \\\\\n$w_2$ & 0.1 & 0 & 0 & 0.5 & 1 & 0 & 0.75 "
            "\\\\\n\\end{tabular}\n");
}

void WildTablesTest::namesOfColumns() {
    checkMaps();
}

void WildTablesTest::equations_data() {
    addWildColumns();
    addWild("decimal commas", "x' = 0,5 x + 0,1 y + 3; y' = -0,2 x + 0,4 y + 7; p = 0,25\n"
                              "x' = 0,1 x + 1; y' = 0,5 y; p = 0,75\n");
    addWild("points with decimal commas",
            "f1(x; y) = (0,5x + 0,1y + 3; -0,2x + 0,4y + 7)\n"
            "f2(x; y) = (0,1x + 1; 0,5y)\n",
            false);
    addWild("y before x", "y' = -.2x + .4y + 7\nx' = .5x + .1y + 3\n\ny' = .5y\nx' = .1x + 1\n", false);
    addWild("the general form before",
            "x' = ax + by + e\ny' = cx + dy + f\n\nx' = .5x + .1y + 3\n"
            "y' = -.2x + .4y + 7\nx' = .1x + 1\ny' = .5y\n",
            false);
    addWild("a dash and words behind",
            "x' = .5x + .1y + 3 – the stem\ny' = -.2x + .4y + 7\nx' = .1x + 1 — "
            "leaves\ny' = .5y\n",
            false);
    addWild("cases of LaTeX",
            "\\begin{cases} x' = \\frac12 x + 0.1y + 3 \\\\ y' = -0.2x + 0.4y + 7 \\end{cases}\n"
            "\\begin{cases} x' = 0.1 x + 1 \\\\ y' = \\frac{1}{2} y \\end{cases}\n",
            false);
    addWild("y after a semicolon", "x' = x/2 + y/10 + 3; y' = 2y/5 - x/5 + 7\nx' = x/10 + 1; y' = y/2\n",
            false);
}

void WildTablesTest::equations() {
    checkMaps();
}

void WildTablesTest::programs_data() {
    addWildColumns();
    addWild("the point is copied first",
            "x = 0\ny = 0\nfor n in range(11000):\n    pen.goto(65 * x, 37 * y - 252)\n    r = random() * "
            "100\n    xn = x\n    yn = y\n    if r < 25:\n        x = 0.5 * xn + 0.1 * yn + 3\n        y = "
            "-0.2 * xn + 0.4 * yn + 7\n    else:\n        x = 0.1 * xn + 1\n        y = 0.5 * yn\n");
    addWild("Matlab", "for i=1:n-1\n  r = rand();\n  if r <= 0.25\n    x(i+1) = 0.5*x(i) + 0.1*y(i) + 3;\n"
                      "    y(i+1) = -0.2*x(i) + 0.4*y(i) + 7;\n  else\n    x(i+1) = 0.1*x(i) + 1;\n"
                      "    y(i+1) = 0.5*y(i);\n  end\nend\n");
    addWild("Mathematica", "If[i <= 25, {xt = 0.5*x + 0.1*y + 3, yt = -0.2*x + 0.4*y + 7}, "
                           "{xt = 0.1*x + 1, yt = 0.5*y}]; {xt, yt}\n");
    addWild("coordinates by index",
            "def f1(p): return np.array([0.5*p[0] + 0.1*p[1] + 3, -0.2*p[0] + 0.4*p[1] + 7])\n"
            "def f2(p): return np.array([0.1*p[0] + 1, 0.5*p[1]])\n",
            false);
    addWild("coordinates of x by index",
            "def f1(x): return [0.5*x[0] + 0.1*x[1] + 3, -0.2*x[0] + 0.4*x[1] + 7]\n"
            "def f2(x): return [0.1*x[0] + 1, 0.5*x[1]]\n",
            false);
    addWild("Fortran",
            "      xn = 0.5d0*x + 0.1D0*y + 3.d0\n      yn = -2.0d-1*x + 0.4d0*y + 7\n"
            "      xn = 0.1d0*x + 1\n      yn = 0.5d0*y\n",
            false);
    addWild("placed in a picture",
            "xn = .5*x + .1*y + 3; yn = -.2*x + .4*y + 7;\nxn = .1*x + 1; yn = .5*y;\n"
            "x = xn; y = yn;\nplot(x * 60 + 300, 600 - y * 60)\n",
            false);
}

void WildTablesTest::programs() {
    checkMaps();
}

void WildTablesTest::lists_data() {
    addWildColumns();
    addWild("R, matrices by columns",
            "A1 <- matrix(c(.5, -.2, .1, .4), 2, 2)\nb1 <- c(3, 7)\n"
            "A2 <- matrix(c(.1, 0, 0, .5), nrow = 2)\nb2 <- c(1, 0)\np <- c(.25, .75)\n");
    addWild("R, matrices by rows",
            "A1 <- matrix(c(.5, .1, -.2, .4), 2, byrow = TRUE)\nb1 <- matrix(c(3, 7), ncol = 1)\n"
            "A2 <- matrix(c(.1, 0, 0, .5), nrow = 2)\nb2 <- matrix(c(1, 0), 2, 1)\n",
            false);
    addWild("R, a matrix by rows", "ifs <- matrix(c(.5, .1, -.2, .4, 3, 7, .25,\n  .1, 0, 0, .5, 1, 0, .75), "
                                   "ncol = 7, byrow = T)\n");
    addWild("R, a matrix by columns",
            "ifs <- matrix(c(.5, .1, .1, 0, -.2, 0, .4, .5, 3, 1, 7, 0, .25, .75), nrow = 2)\n");
    addWild("NumPy, reshaped",
            "ifs = np.array([.5, .1, -.2, .4, 3, 7, .25, .1, 0, 0, .5, 1, 0, .75]).reshape(2, 7)\n");
    addWild("strings of JSON", R"([{"a":"0.5","b":"0.1","c":"-0.2","d":"0.4","e":"3","f":"7","p":"0.25"},)"
                               R"({"a":"0.1","b":"0","c":"0","d":"0.5","e":"1","f":"0","p":"0.75"}])");
    addWild("matrices of CSS, by columns",
            ".a { transform: matrix(0.5, -0.2, 0.1, 0.4, 3, 7); }\n"
            ".b { transform: matrix(0.1, 0, 0, 0.5, 1, 0); }\n",
            false);
    addWild("transforms of Java, by columns",
            "new AffineTransform(0.5, -0.2, 0.1, 0.4, 3, 7),\n"
            "new AffineTransform(0.1, 0, 0, 0.5, 1, 0)\n",
            false);
    addWild("Matlab, continued lines",
            "T = [.5, .1, -.2, .4, 3, 7, .25; ... stem\n     .1, 0, 0, .5, 1, 0, .75];\n");
    addWild("Lua", "local maps = {\n  {.5, .1, -.2, .4, 3, 7, .25}, -- stem\n  {.1, 0, 0, .5, 1, 0, .75}, -- "
                   "leaf\n}\n");
    addWild(
        "Mathematica, precision",
        "{{{0.5`, 1.`*^-1}, {-0.2`15.9, 0.4`}}, {3.`, 7.`}} (* stem *)\n{{{0.1, 0}, {0, 0.5`}}, {1.`, 0}}\n",
        false);
}

void WildTablesTest::lists() {
    checkMaps();
}

void WildTablesTest::tablesInSpace_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("a column for every map")
        << QByteArray("w 1 2\na .5 .1\nb .1 0\nc .2 0\nd 0 0\ne .4 .5\nf 0 0\ng -.2 0\nh 0 0\ni .3 .2\nj 3 "
                      "1\nk 7 0\nl 5 0\n");
    QTest::newRow("numbered elements")
        << QByteArray("a11 a12 a13 a21 a22 a23 a31 a32 a33 b1 b2 b3\n.5 .1 .2 0 .4 0 -.2 0 .3 3 7 5\n"
                      ".1 0 0 0 .5 0 0 0 .2 1 0 0\n");
    QTest::newRow("equation by equation") << QByteArray(
        "a b c j d e f k g h i l\n.5 .1 .2 3 0 .4 0 7 -.2 0 .3 5\n.1 0 0 1 0 .5 0 0 0 0 .2 0\n");
    QTest::newRow("numbered rows") << QByteArray(
        "a b c d e f g h i j k l\n1 .5 .1 .2 0 .4 0 -.2 0 .3 3 7 5\n2 .1 0 0 0 .5 0 0 0 .2 1 0 0\n");
}

void WildTablesTest::tablesInSpace() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.file.entries.size(), 1);
    const auto* system = document::system3(*collection.file.entries.first().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(2));
    ifs::AffineMap<3> first;
    first.linear << .5, .1, .2, 0, .4, 0, -.2, 0, .3;
    first.translation << 3, 7, 5;
    QVERIFY(system->maps[0].map == first);
    QCOMPARE(system->maps[1].map.linear(2, 2), .2);
    QVERIFY(!system->maps[0].weight);
}

// A map would be lost, or a number; or the text counts, moves or draws something.
void WildTablesTest::nothingIsTakenForMaps_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("an unknown letter") << QByteArray("x' = .5x + .04w\ny' = .5y\nx' = .5x\ny' = .5y\n"
                                                     "x' = .5x + 1\ny' = .5y\n");
    QTest::newRow("a missing z") << QByteArray("x' = .5x\ny' = .5y\nz' = .5z\nx' = .5x + 1\ny' = .5y\n"
                                               "x' = .5x\ny' = .5y + 1\nz' = .5z\n");
    QTest::newRow("squares") << QByteArray(
        "x' = 1 - 1.4x² + y\ny' = 0.3x\nx' = .5x\ny' = .5y\nx' = .5y\ny' = .5x\n");
    QTest::newRow("a game") << QByteArray("x = x + 1\ny = y - 1\nif x > 10:\n    x = 0\n    y = y + 2\n"
                                          "x = x - 1\ny = y + 3\n");
    QTest::newRow("coefficients by index")
        << QByteArray("x = a[0]*x + a[1]*y + a[4]\ny = a[2]*x + a[3]*y + a[5]\n"
                      "x = b[0]*x + b[1]*y + b[4]\ny = b[2]*x + b[3]*y + b[5]\n");
    QTest::newRow("curves") << QByteArray("c.bezierCurveTo(1,2,3,4,5,6);\nc.bezierCurveTo(2,3,4,5,6,7);\n");
    QTest::newRow("prose") << QByteArray("In 1988, 4 maps of 6 numbers were found in 12 days.\n"
                                         "The 7 authors met on 3 May 1991, at 9, 10, 11 and 12.\n");
    QTest::newRow("a league") << QByteArray(
        "| Team | W | D | L | F | A | Pts |\n|---|---|---|---|---|---|---|\n"
        "| Ants | 3 | 1 | 0 | 9 | 2 | 10 |\n| Bees | 2 | 1 | 1 | 7 | 5 | 7 |\n");
}

void WildTablesTest::nothingIsTakenForMaps() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    for (const document::Entry& entry : collection.file.entries)
        QCOMPARE(document::dimension(*entry.fractal), 0);
    QVERIFY(!collection.file.problems.isEmpty());
}

// In the maps of Koch's curve, two have a factor only.
void WildTablesTest::factorsStandForMatrices() {
    const io::Collection collection = io::readCollection(
        "\\begin{align*}\nS_1(\\mathbf{x}) &= \\tfrac13 \\mathbf{x} \\\\\n"
        "S_2(\\mathbf{x}) &= \\begin{pmatrix} .5 & .1 \\\\ -.2 & .4 \\end{pmatrix}\\mathbf{x} + "
        "\\begin{pmatrix}3\\\\7\\end{pmatrix}\\\\\n"
        "S_3(\\mathbf{x}) &= 0.5\\mathbf{x} + \\begin{pmatrix}2/3\\\\1\\end{pmatrix}\n\\end{align*}\n");
    QCOMPARE(collection.file.entries.size(), 1);
    const auto* system = document::system2(*collection.file.entries.first().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(3));
    QVERIFY(system->maps[0].map == ifs::affineMap(1.0 / 3, 0, 0, 1.0 / 3, 0, 0));
    QVERIFY(system->maps[1].map == ifs::affineMap(.5, .1, -.2, .4, 3, 7));
    QVERIFY(system->maps[2].map == ifs::affineMap(.5, 0, 0, .5, 2.0 / 3, 1));
}

// m · 10ⁿ is one number: the product would be rounded.
void WildTablesTest::writtenFormulasReadBackToTheLastDigit() {
    document::System2 system;
    for (const double small : {-3.7772869190963985e-09, 4.509303724825448e-12, 2.7543326375274012e-05}) {
        ifs::WeightedMap<2> map;
        map.map = ifs::affineMap(.5, small, 0, 1.0 / 3, small, -.1);
        system.maps.push_back(map);
    }
    auto fractal = std::make_shared<document::Fractal>();
    fractal->shape = document::Shape<2>{system};
    const io::Collection collection = io::readCollection(io::writeLatex({fractal}));
    QCOMPARE(collection.file.entries.size(), 1);
    const auto* read = document::system2(*collection.file.entries.first().fractal);
    QVERIFY(read);
    QCOMPARE(read->maps.size(), system.maps.size());
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        QVERIFY(read->maps[i].map == system.maps[i].map);
}

BARYCAGE_TEST(WildTablesTest);
#include "wild_tables_test.moc"
