// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "io/collection_reader.h"
#include "io/exchange/latex.h"
#include "support/named_test.h"

#include <QStringConverter>
#include <QTest>

// Maps in tables of other languages, in formulas and in the texts of other programs.
class NotationsTest : public QObject {
    Q_OBJECT

private slots:
    void tablesInLatex_data();
    void tablesInLatex();
    void tablesInMarkup_data();
    void tablesInMarkup();
    void formulas_data();
    void formulas();
    void listsAndLetters_data();
    void listsAndLetters();
    void mapsWithNamesOfTheirOwn_data();
    void mapsWithNamesOfTheirOwn();
    void badRowsOfOtherNotationsAreNamed_data();
    void badRowsOfOtherNotationsAreNamed();
    void textsInUtf16_data();
    void textsInUtf16();
    void elementsOfGimp();
    void anglesByNameAreDegrees();
    void anglesInTablesOfOthersAreDegrees_data();
    void anglesInTablesOfOthersAreDegrees();
    void tablesBelowEachOtherAreEntries();
    void writtenLatexReadsBack();

private:
    static void checkNotation();
};

namespace {

const document::System2& firstSystem(const document::FractalFile& file) {
    static const document::System2 none;
    if (file.entries.isEmpty()) return none;
    const document::System2* system = document::system2(*file.entries.first().fractal);
    return system ? *system : none;
}

void addNotation(const char* name, const char* bytes, const char* recognised, bool hasWeights = true) {
    QTest::newRow(name) << QByteArray(bytes) << hasWeights << QByteArray(recognised);
}

void addNotationColumns() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("hasWeights");
    QTest::addColumn<QByteArray>("name");
}

} // namespace

void NotationsTest::tablesInLatex_data() {
    addNotationColumns();
    addNotation(
        "LaTeX, fractions and spaces",
        "% the fern\n\\begin{table}\\centering\n\\caption{Two & more "
        "maps}\n\\begin{tabular}{@{}l*{7}{r}@{}}\n"
        "\\toprule\nMap & $a$ & $b$ & $c$ & $d$ & $e$ & $f$ & $p$ \\\\\n\\midrule\n"
        "$w_1$ & $\\frac{1}{2}$ & $\\phantom{-}\\tfrac1{10}$ & $-\\frac15$ & $0{,}4$ & \\num{3} & $7$ & "
        "$\\dfrac14$ "
        "\\\\[2pt]\n\\addlinespace[3pt]\n"
        "$w_2$ & \\num{1e-1} & 0 & 0 & \\textbf{0,5} & 1 & \\multicolumn{1}{c}{0} & 75\\,\\% "
        "\\tabularnewline\n\\bottomrule\n\\end{tabular}\\end{table}\n",
        "a LaTeX table");
    addNotation("LaTeX, array",
                "\\[\\begin{array}{c|cccccc|c}\n & a & b & c & d & e & f & p\\\\\\hline\n"
                "w_1&\\tfrac12&.1&-.2&\\frac{2}{5}&3&7&.25\\\\\nw_2&.1&0&0&\\frac{1}{2}&1&0&.75\\\\\n"
                "\\end{array}\\]\n",
                "a LaTeX table");
    addNotation("LaTeX, rows alone",
                "w1 & 0.5 & 0.1 & --0.2 & 0.4 & 3 & 7 & 0.25 \\\\\n"
                "w2 & 0.1 & 0 & 0 & 0.5 & 1 & 0 & 0.75 \\\\ \\hline\n",
                "a LaTeX table");
    addNotation(
        "LaTeX, a column for every map",
        "\\begin{tabular}{ccc}\n & $w_1$ & $w_2$\\\\\na & 0.5 & 0.1\\\\\nb & 0.1 & 0\\\\\nc & $-0.2$ & "
        "0\\\\\n"
        "d & 0.4 & 0.5\\\\\ne & 3 & 1\\\\\nf & 7 & 0\\\\\np & 0.25 & 0.75\n\\end{tabular}",
        "a LaTeX table");
}

void NotationsTest::tablesInLatex() {
    checkNotation();
}

void NotationsTest::tablesInMarkup_data() {
    addNotationColumns();
    addNotation(
        "HTML",
        "<html><body><table><tr><td>Home<td>News</table><table class=\"x\">\n"
        "<tr><th>w<th><i>a</i><th>b<th>c<th>d<th>e<th>f<th>p<th>Portion</tr>\n"
        "<tr><td>&fnof;<sub>1</sub></td><td>0.5</td><td>&#x2E;1</td><td>&minus;0.2</td><td>2/5</td><td>3</td>"
        "<td>7</td><td>&frac14;</td><td>Stem, 1</td></tr>\n"
        "<TR><TD>&fnof;<sub>2</sub></TD><TD>0,1</TD><TD>0</TD><TD>0</TD><TD>&frac12;</TD><TD>1</TD><TD>0</TD>"
        "<TD>75&nbsp;%</TD><TD>Leaf</TD></TR></table></body></html>",
        "an HTML table");
    addNotation("Markdown, formulas",
                "| map | $a$ | $b$ | $c$ | $d$ | $e$ | $f$ | $p$ | what |\n|:--|--|--|--|--|--|--|--|--|\n"
                "| **w1** | $\\frac12$ | 0.1 | −0.2 | 0.4 | 3 | 7 | 25% | the stem |\n"
                "| **w2** | 0.1 | 0 | 0 | ½ | 1 | 0 | 75% | a leaf |\n",
                "a Markdown table");
    addNotation(
        "a table in a frame",
        "+---+-----+-----+------+-----+---+---+------+\n| n | a   | b   | c    | d   | e | f | p    |\n"
        "+---+-----+-----+------+-----+---+---+------+\n| 1 | 0.5 | 0.1 | -0.2 | 0.4 | 3 | 7 | 0.25 |\n"
        "| 2 | 0.1 | 0   | 0    | 0.5 | 1 | 0 | 0.75 |\n+---+-----+-----+------+-----+---+---+------+\n",
        "a Markdown table");
    addNotation(
        "wiki",
        "{| class=\"wikitable\"\n|+ The fern\n! w !! a !! b !! c !! d !! e !! f !! p !! Portion\n|-\n"
        "| ''ƒ''<sub>1</sub> || 0.5 || 0.1 || style=\"x\" | &minus;0.2 || {{math|0.4}} || 3 || 7 || 0.25 || "
        "[[Stem|the "
        "stem]]\n|-\n| ƒ<sub>2</sub>\n| 0.1\n| 0\n| 0\n| 0.5\n| 1\n| 0\n| 0.75\n| leaf\n|}\n",
        "a wiki table");
}

void NotationsTest::tablesInMarkup() {
    checkNotation();
}

void NotationsTest::formulas_data() {
    addNotationColumns();
    addNotation("arrows",
                "T1: x -> 0.5 x + 0.1 y + 3, y -> -0.2 x + 0.4 y + 7 (25 %)\n"
                "T2: x ↦ 0.1 x + 1, y ↦ 0.5 y (75 %)\n",
                "equations");
    addNotation(
        "matrices and vectors",
        "\\begin{align*}\nw_1\\begin{bmatrix}x\\\\y\\end{bmatrix} &= \\begin{bmatrix}\\frac12 & 0.1\\\\[2pt] "
        "-0.2 & "
        "0{,}4\\end{bmatrix}\\begin{bmatrix}x\\\\y\\end{bmatrix} + \\begin{bmatrix}3\\\\7\\end{bmatrix}, & "
        "p_1 &= 0.25\\\\\n"
        "w_2\\begin{bmatrix}x\\\\y\\end{bmatrix} &= \\tfrac{1}{10}\\begin{bmatrix}1&0\\\\0&5\\end{bmatrix}"
        "\\begin{bmatrix}x\\\\y\\end{bmatrix} + \\begin{bmatrix}1\\\\0\\end{bmatrix}, & p_2 &= "
        "\\frac{3}{4}\n\\end{align*}",
        "matrices in LaTeX");
    addNotation("augmented matrices",
                "\\[\\left(\\begin{array}{cc|c}0.5&0.1&3\\\\-0.2&0.4&7\\\\0&0&1\\end{array}\\right),\\quad"
                "\\left(\\begin{array}{cc|c}0.1&0&1\\\\0&0.5&0\\\\0&0&1\\end{array}\\right)\\]",
                "matrices in LaTeX", false);
    addNotation("equations",
                "Map 1 (p = 0.25):\nx' = 0.5x + 0.1y + 3\ny' = −0.2x + 0.4y + 7\n\nMap 2 (p = 0.75):\n"
                "x' = x/10 + 1\ny' = ½ y\n",
                "equations");
    addNotation("equations of Wikipedia",
                "ƒ1\nxn + 1 = 0.5 xn + 0.1 yn + 3\nyn + 1 = −0.2 xn + 0.4 yn + 7.\nƒ2\n"
                "xn + 1 = 0.1 xn + 1\nyn + 1 = 0.5 yn.\n",
                "equations", false);
    addNotation("equations in LaTeX",
                "\\begin{align}\nx_{n+1} &= \\tfrac12 x_n + 0.1 y_n + 3\\\\\n"
                "y_{n+1} &= -0.2\\,x_n + \\frac{2}{5}\\cdot y_n + 7\\\\\n"
                "x_{n+1} &= 0.1 x_n + 1\\\\\ny_{n+1} &= \\frac{y_n}{2}\n\\end{align}",
                "equations", false);
    addNotation("points",
                "w1(x, y) = (0.5x + 0.1y + 3, -0.2x + 0.4y + 7), with probability 25%\n"
                "w2(x, y) = (0.1x + 1, 0.5y), with probability 75%\n",
                "equations");
    addNotation("functions of Maple",
                "T1 := (x,y) -> [0.5*x+0.1*y+3, -0.2*x+0.4*y+7]\nT2 := (x,y) -> [0.1*x+1, 0.5*y]\n",
                "equations", false);
    addNotation("functions of JavaScript",
                "const f1 = (x, y) => [0.5*x + 0.1*y + 3, -0.2*x + 0.4*y + 7];\n"
                "const f2 = (x, y) => [0.1*x + 1, 0.5*y];\n",
                "equations", false);
    addNotation("arrows of a paper", "(x, y) ↦ (½x + y/10 + 3, −x/5 + 2/5 y + 7)\n(x, y) ↦ (x/10 + 1, y/2)\n",
                "equations", false);
    addNotation("functions and chances",
                "maps = [\n  (0.25, lambda x, y: (0.5*x + 0.1*y + 3, -0.2*x + 0.4*y + 7)),\n"
                "  (0.75, lambda x, y: (0.1*x + 1, 0.5*y)),\n]\n",
                "equations");
    addNotation("functions before chances",
                "maps = [\n  (lambda x, y: (0.5*x + 0.1*y + 3, -0.2*x + 0.4*y + 7), 0.25),\n"
                "  (lambda x, y: (0.1*x + 1, 0.5*y), .75)\n]\n",
                "equations");
    addNotation("a program",
                "x, y = 0, 0\nfor i in range(9):\n    r = random()\n    if r < 0.25:\n"
                "        x, y = 0.5*x + 0.1*y + 3, -0.2*x + 0.4*y + 7\n    else:\n"
                "        x, y = 0.1*x + 1, 0.5*y\n    plot(x, y)\n",
                "equations");
}

void NotationsTest::formulas() {
    checkNotation();
}

void NotationsTest::listsAndLetters_data() {
    addNotationColumns();
    addNotation("YAML",
                "# two maps\nmaps:\n  - {a: 0.5, b: 0.1, c: -0.2, d: 0.4, e: 3, f: 7, p: 0.25} # stem\n"
                "  - {a: 0.1, b: 0, c: 0, d: 0.5, e: 1, f: 0, p: 0.75}\n",
                "YAML");
    addNotation("YAML, a line for each",
                "fern:\n- a: 0.5\n  b: 0.1\n  c: -0.2\n  d: 0.4\n  e: 3\n  f: 7\n  p: 0.25\n"
                "- a: 0.1\n  b: 0\n  c: 0\n  d: 0.5\n  e: 1\n  f: 0\n  p: 0.75\n",
                "YAML");
    addNotation("YAML, matrices",
                "transforms:\n  - matrix:\n      - [0.5, 0.1]\n      - [-0.2, 0.4]\n    translation: [3, 7]\n"
                "    weight: 0.25\n  - matrix:\n    - - 0.1\n      - 0\n    - - 0\n      - 0.5\n"
                "    translation: [1, 0]\n    weight: 0.75\n",
                "YAML");
    const char* lists = "lists of numbers";
    addNotation(
        "an array for each letter, Python",
        "a = [0.5, .1]\nb = [.1, 0]\nc = [-.2, 0]\nd = [.4, .5]\ne = [3, 1]\nf = [7, 0]\np = [1/4, 3/4]\n",
        lists);
    addNotation("an array for each letter, C",
                "const double a[] = {0.5, 0.1};\ndouble b[2] = {0.1, 0.0};\ndouble c[2]={-0.2,0};\ndouble "
                "d[2]={0.4,0.5};\n"
                "double e[2]={3,1}, f[2]={7,0}; float p[2] = {.25f, .75f};\n",
                lists);
    addNotation("an array for each letter, R",
                "a <- c(0.5, 0.1)\nb <- c(0.1, 0)\nc <- c(-0.2, 0)\nd <- c(0.4, 0.5)\n"
                "e <- c(3, 1)\nf <- c(7, 0)\nprob <- c(0.25, 0.75)\n",
                lists);
    addNotation("an array for each letter, Matlab",
                "a = [0.5 0.1];\nb = [0.1 0];\nc = [-0.2 0];\nd = [0.4 0.5];\n"
                "e = [3 1];\nf = [7 0];\np = [0.25 0.75];\n",
                lists);
    addNotation(
        "an array for each letter, JSON",
        "{\"a\": [0.5, 0.1], \"b\": [0.1, 0], \"c\": [-0.2, 0], \"d\": [0.4, 0.5], \"e\": [3, 1], \"f\": [7, "
        "0],\n"
        "\"weights\": [0.25, 0.75]}",
        lists);
}

void NotationsTest::mapsWithNamesOfTheirOwn_data() {
    addNotationColumns();
    const char* lists = "lists of numbers";
    addNotation("matrices of NumPy",
                "A1 = np.array([[0.5, 0.1], [-0.2, 0.4]])\nb1 = np.array([3, 7])\n"
                "A2 = np.array([[0.1, 0], [0, 0.5]])\nb2 = np.array([1, 0])\np = [0.25, 0.75]\n",
                lists);
    addNotation("matrices of Matlab",
                "A1 = [0.5 0.1; -0.2 0.4]; b1 = [3; 7]; p1 = 0.25; % stem\n"
                "A2 = [0.1 0; 0 0.5]; b2 = [1; 0]; p2 = 0.75;\n",
                lists);
    addNotation("a matrix of Matlab", "ifs = [.5 .1 -.2 .4 3 7 .25 % stem\n .1 0 0 .5 1 0 .75];\n", lists);
    addNotation("rows of Julia", "w = [0.5 0.1 -0.2 0.4 3 7 0.25; 0.1 0 0 0.5 1 0 0.75]\n", lists);
    addNotation("Mathematica, line by line",
                "{{{0.5, 0.1}, {-0.2, 0.4}}, {3, 7}}\n{{{0.1, 0}, {0, 0.5}}, {1, 0}}\n", lists, false);
    addNotation("Mathematica, functions",
                "f1 = AffineTransform[{{{0.5, 0.1}, {-0.2, 0.4}}, {3, 7}}];\n"
                "f2 = AffineTransform[{{{0.1, 0}, {0, 0.5}}, {1, 0}}];\n",
                lists, false);
    addNotation("named maps", "w1 = [0.5, 0.1, -0.2, 0.4, 3, 7, 0.25]\nw2 = [0.1, 0, 0, 0.5, 1, 0, 0.75]\n",
                lists);
    addNotation("numbers by name", "a=.5 b=.1 c=-.2 d=.4 e=3 f=7 p=.25\na=.1 b=0 c=0 d=.5 e=1 f=0 p=.75\n",
                lists);
    addNotation("numbered numbers by name",
                "Map 1\na_1 = 1/2, b_1 = .1, c_1 = −.2, d_1 = .4, e_1 = 3, f_1 = 7\nMap 2\n"
                "a_2 = .1, b_2 = 0, c_2 = 0, d_2 = .5, e_2 = 1, f_2 = 0\n",
                lists, false);
}

void NotationsTest::mapsWithNamesOfTheirOwn() {
    checkNotation();
}

void NotationsTest::listsAndLetters() {
    checkNotation();
}

// What was recognised is said once.
void NotationsTest::checkNotation() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, hasWeights);
    QFETCH(QByteArray, name);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.format, QStringLiteral("table"));
    QCOMPARE(collection.file.problems.size(), 1);
    QVERIFY2(collection.file.problems.first().message.contains(QString::fromUtf8(name)),
             qPrintable(collection.file.problems.first().message));
    const document::System2& system = firstSystem(collection.file);
    QCOMPARE(system.maps.size(), std::size_t(2));
    QVERIFY(system.maps[0].map == ifs::affineMap(0.5, 0.1, -0.2, 0.4, 3, 7));
    QVERIFY(system.maps[1].map == ifs::affineMap(0.1, 0, 0, 0.5, 1, 0));
    QCOMPARE(system.maps[0].weight.has_value(), hasWeights);
    if (!hasWeights) return;
    QCOMPARE(*system.maps[0].weight, 0.25);
    QCOMPARE(*system.maps[1].weight, 0.75);
}

void NotationsTest::badRowsOfOtherNotationsAreNamed_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("where");
    QTest::addColumn<int>("line");
    QTest::newRow("LaTeX")
        << QByteArray("\\begin{tabular}{cccccc}\n\\hline\na & b & c & d & e & f\\\\\n"
                      "1 & 2 & 3 & 4 & 5 & 6\\\\\n0.5 & 0 & 0 & o.5 & 1 & 2\\\\\n\\end{tabular}\n")
        << QStringLiteral("In a LaTeX table, row 3: ") << 5;
    QTest::newRow("HTML") << QByteArray("<table>\n<tr><td>1<td>2<td>3<td>4<td>5<td>6\n"
                                        "<tr><td>1<td>2<td>3<td>4<td>5<td>x.6</table>")
                          << QStringLiteral("In an HTML table, row 2: ") << 3;
    QTest::newRow("Markdown") << QByteArray("|a|b|c|d|e|f|\n|-|-|-|-|-|-|\n|1|2|3|4|5|6|\n|1|2|3|4|5|\n")
                              << QStringLiteral("In a Markdown table, row 3: ") << 4;
}

void NotationsTest::badRowsOfOtherNotationsAreNamed() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    QCOMPARE(collection.format, QStringLiteral("table"));
    QVERIFY(collection.file.entries.isEmpty());
    QCOMPARE(collection.file.problems.size(), 1);
    QFETCH(QString, where);
    QVERIFY2(collection.file.problems.first().message.startsWith(where),
             qPrintable(collection.file.problems.first().message));
    QTEST(collection.file.problems.first().line, "line");
}

void NotationsTest::textsInUtf16_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("format");
    QTest::newRow("table") << QByteArray("a\tb\tc\td\te\tf\np1\t.5\t0\t0\t−.5\t0\t0\n") << "table";
    QTest::newRow("collection") << QByteArray("x {\n .5 0 0 -.5 0 0 1\n}\n") << "fractint";
    QTest::newRow("flame") << QByteArray(
                                  "<?xml version=\"1.0\" encoding=\"UTF-16\"?><flame><xform weight=\"1\" "
                                  "linear=\"1\" coefs=\".5 0 0 -.5 0 0\"/></flame>")
                           << "flame";
}

void NotationsTest::textsInUtf16() {
    QFETCH(QByteArray, text);
    const QString unicode = QString::fromUtf8(text);
    for (const bool hasMark : {true, false})
        for (const auto encoding : {QStringConverter::Utf16LE, QStringConverter::Utf16BE}) {
            if (!hasMark && text.contains("\xe2")) continue; // told by its zeros only
            QStringEncoder encode(encoding, hasMark ? QStringConverter::Flag::WriteBom
                                                    : QStringConverter::Flag::Default);
            const io::Collection collection = io::readCollection(encode(unicode));
            QTEST(collection.format, "format");
            QCOMPARE(firstSystem(collection.file).maps.size(), std::size_t(1));
            QCOMPARE(firstSystem(collection.file).maps[0].map.linear(1, 1), -.5);
        }
}

// Each under its own header, as in a paper; the title is the name.
void NotationsTest::tablesBelowEachOtherAreEntries() {
    const QByteArray text = "Table 1: triangle\nw a b c d e f p\n1 .5 0 0 .5 0 0 .33\n2 .5 0 0 .5 1 0 .33\n"
                            "3 .5 0 0 .5 0 1 .34\n\nTable 2: pair\n\nw a b e c d f p\n"
                            "1 .5 .1 3 -.2 .4 7 .25\n2 .1 0 1 0 .5 0 .75\n";
    const io::Collection collection = io::readCollection(text);
    QCOMPARE(collection.format, QStringLiteral("table"));
    QCOMPARE(collection.file.entries.size(), 2);
    QCOMPARE(collection.file.entries[0].fractal->name, QStringLiteral("Table_1__triangle"));
    const auto* pair = document::system2(*collection.file.entries[1].fractal);
    QVERIFY(pair && pair->maps.size() == 2);
    QVERIFY(pair->maps[0].map == ifs::affineMap(.5, .1, -.2, .4, 3, 7));
    QCOMPARE(*pair->maps[1].weight, .75);
    QCOMPARE(firstSystem(collection.file).maps.size(), std::size_t(3));
    QCOMPARE(collection.file.problems.size(), 1);
}

// ° changes nothing in a column of degrees, and what has a π is radians.
void NotationsTest::anglesInTablesOfOthersAreDegrees_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("LaTeX") << QByteArray(
        "\\begin{tabular}{rrrrrr}\n$r$ & $s$ & $\\theta$ & $\\varphi$ & $e$ & $f$ \\\\\n"
        "0.5 & 0.5 & $90^\\circ$ & \\ang{90} & 0.5 & 0 \\\\\n"
        "0.5 & 0.5 & 90 & $\\frac{\\pi}{2}$ & 0.5 & 0 \\\\\n\\end{tabular}");
    QTest::newRow("HTML") << QByteArray("<table><tr><th>r<th>s<th>&theta;<th>&phi;<th>e<th>f"
                                        "<tr><td>.5<td>.5<td>90&deg;<td>90 &deg;<td>.5<td>0"
                                        "<tr><td>.5<td>.5<td>&pi;/2<td>90<td>.5<td>0</table>");
    QTest::newRow("Markdown") << QByteArray(
        "| r | s | theta | phi | e | f |\n|--|--|--|--|--|--|\n"
        "| .5 | .5 | 90° | pi / 2 | .5 | 0 |\n| .5 | .5 | 90 ° | 90 | .5 | 0 |\n");
    QTest::newRow("a blank before the sign")
        << QByteArray("r;s;θ;φ;e;f\n0,5;0,5;90 °;90 deg;0,5;0\n0,5;0,5;π/2;90°;0,5;0\n");
}

void NotationsTest::anglesInTablesOfOthersAreDegrees() {
    QFETCH(QByteArray, bytes);
    const io::Collection collection = io::readCollection(bytes);
    const auto& maps = firstSystem(collection.file).maps;
    QCOMPARE(maps.size(), std::size_t(2));
    for (const auto& map : maps)
        QVERIFY((map.map.linear - ifs::affineMap(0, -.5, .5, 0, 0, 0).linear).norm() < 1e-15);
}

// As in the columns of a table.
void NotationsTest::anglesByNameAreDegrees() {
    const io::Collection collection =
        io::readCollection("r = 0.5, s = 0.5, theta = 90°, phi = 90, e = 0.5, f = 0\n"
                           "r = 0.5, s = 0.5, theta = pi/2, phi = 90°, e = 0.5, f = 0\n");
    const auto& maps = firstSystem(collection.file).maps;
    QCOMPARE(maps.size(), std::size_t(2));
    for (const auto& map : maps)
        QVERIFY((map.map.linear - ifs::affineMap(0, -.5, .5, 0, 0, 0).linear).norm() < 1e-15);
}

// Two elements of GIMP's plug-in, with what its source makes of them, seen with y upwards.
void NotationsTest::elementsOfGimp() {
    const io::Collection collection = io::readCollection(
        "iterations 10000\nmax_memory 4096\nsubdivide 3\nradius 0.69999999999999996\naspect_ratio 1\n"
        "center_x 0.5\ncenter_y 0.375\n"
        "element {\n    x 0.25\n    y 0.75\n    theta 0\n    scale 0.5\n    asym 2\n    shear 0.5\n    flip "
        "1\n"
        "    red_color { 1,0,0 }\n    green_color { 0,1,0 }\n    blue_color { 0,0,1 }\n    black_color { "
        "0,0,0 }\n"
        "    target_color { 1,0,0 }\n    hue_scale 0.5\n    value_scale 0.5\n    simple_color 1\n    prob "
        "0.25\n}\n"
        "element {\n    x 0.5\n    y 0.5\n    theta 1.5707963267948966\n    scale 0.5\n    asym 1\n    shear "
        "0\n"
        "    flip 0\n    red_color { 1,0,0 }\n    prob 0.75\n}\n");
    QCOMPARE(collection.format, QStringLiteral("table"));
    const auto& maps = firstSystem(collection.file).maps;
    QCOMPARE(maps.size(), std::size_t(2));
    // -0.5·(2 x + 0.5 y) and 0.25 y about (0.5, 0.375)
    QVERIFY((maps[0].map.linear - ifs::affineMap(-1, .25, 0, .25, 0, 0).linear).norm() < 1e-15);
    QVERIFY((maps[0].map(ifs::Vector<2>(.5, -.375)) - ifs::Vector<2>(.25, -.75)).norm() < 1e-15);
    QCOMPARE(*maps[0].weight, .25);
    // a quarter turn: x to the right goes up, as GIMP's rotation turns counter-clockwise on the screen
    QVERIFY((maps[1].map.linear - ifs::affineMap(0, -.5, .5, 0, 0, 0).linear).norm() < 1e-15);
    QVERIFY((maps[1].map(ifs::Vector<2>(.5, -.375)) - ifs::Vector<2>(.5, -.5)).norm() < 1e-15);
    QCOMPARE(collection.file.problems.size(), 1);
    QVERIFY(collection.file.problems[0].message.contains(QStringLiteral("GIMP")));
}

// The formulas that are written for a paper.
void NotationsTest::writtenLatexReadsBack() {
    document::Fractal fractal;
    document::System2 system = canonical::system(canonical::fern(), canonical::fernWeights);
    system.maps[1].map.translation.x() = 1.0 / 3;
    fractal.shape = document::Shape<2>{system};
    for (const QByteArray& text : {io::latexTable(fractal), io::latexMatrices(fractal)}) {
        const io::Collection collection = io::readCollection(text);
        const auto& maps = firstSystem(collection.file).maps;
        QCOMPARE(maps.size(), system.maps.size());
        for (std::size_t i = 0; i < maps.size(); ++i)
            QVERIFY2(maps[i].map == system.maps[i].map, text.constData());
    }
}

BARYCAGE_TEST(NotationsTest);
#include "notations_test.moc"
