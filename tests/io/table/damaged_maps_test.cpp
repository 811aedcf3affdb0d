// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <utility>
#include <vector>

// Maps in every notation, one of them damaged: either all are read rightly, or none, with the row.
class DamagedMapsTest : public QObject {
    Q_OBJECT

private slots:
    void noMapIsLost_data();
    void noMapIsLost();
    void damagedMapsAreNamed_data();
    void damagedMapsAreNamed();
    void unusualMapsAreReadRightly_data();
    void unusualMapsAreReadRightly();
    void numbersAreNotChanged_data();
    void numbersAreNotChanged();
    void mapsNamedLikeColumnsHaveRows();
};

namespace {

QString filled(const char* pattern, int number, const QStringList& cells) {
    QString text = QString::fromUtf8(pattern).replace(u'#', QString::number(number));
    for (qsizetype i = 0; i < cells.size(); ++i)
        text.replace(u'{' + QString(QChar(u'a' + int(i))) + u'}', cells[i]);
    return text;
}

struct Notation {
    const char* name;
    const char* before;
    const char* map; // with {a} … {f}, and # for the number
    const char* after;
};

const std::vector<Notation>& notations() {
    static const std::vector<Notation> all{
        {"NumPy", "", "A# = np.array([[{a}, {b}], [{c}, {d}]])\nb# = np.array([{e}, {f}])\n", ""},
        {"Matlab", "", "A# = [{a} {b}; {c} {d}]; b# = [{e}; {f}];\n", ""},
        {"R", "", "A# <- matrix(c({a}, {c}, {b}, {d}), 2, 2)\nb# <- c({e}, {f})\n", ""},
        {"named lists", "", "w# = [{a}, {b}, {c}, {d}, {e}, {f}]\n", ""},
        {"Mathematica", "", "{{{{a}, {b}}, {{c}, {d}}}, {{e}, {f}}}\n", ""},
        {"transforms of Mathematica", "", "f# = AffineTransform[{{{{a}, {b}}, {{c}, {d}}}, {{e}, {f}}}];\n",
         ""},
        {"calls", "", "addMap({a}, {b}, {c}, {d}, {e}, {f});\n", ""},
        {"Python", "ifs = [\n", "  [{a}, {b}, {c}, {d}, {e}, {f}],\n", "]\n"},
        {"dictionaries", "ifs = [\n",
         "  {\"a\": {a}, \"b\": {b}, \"c\": {c}, \"d\": {d}, \"e\": {e}, \"f\": {f}},\n", "]\n"},
        {"YAML", "maps:\n", "  - {a: {a}, b: {b}, c: {c}, d: {d}, e: {e}, f: {f}}\n", ""},
        {"CSS", "", ".k# { transform: matrix({a}, {c}, {b}, {d}, {e}, {f}); }\n", ""},
        {"equations", "", "x' = {a} x + {b} y + {e}\ny' = {c} x + {d} y + {f}\n\n", ""},
        {"a program", "", "x = {a}*x + {b}*y + {e}\ny = {c}*x + {d}*y + {f}\n\n", ""},
        {"points", "", "f#(x,y) = ({a} x + {b} y + {e}, {c} x + {d} y + {f})\n", ""},
        {"lambdas", "", "f# = lambda x,y: ({a}*x + {b}*y + {e}, {c}*x + {d}*y + {f})\n", ""},
        {"arrows", "", "(x,y) -> ({a}*x + {b}*y + {e}, {c}*x + {d}*y + {f})\n", ""},
        {"matrices in LaTeX", "",
         "w_#(x)=\\begin{bmatrix}{a}&{b}\\\\{c}&{d}\\end{bmatrix}x+\\begin{bmatrix}{e}\\\\{f}\\end{bmatrix}"
         "\n",
         ""},
        {"a LaTeX table", "\\begin{tabular}{cccccc}\n", "{a} & {b} & {c} & {d} & {e} & {f}\\\\\n",
         "\\end{tabular}\n"},
        {"HTML", "<table>", "<tr><td>{a}<td>{b}<td>{c}<td>{d}<td>{e}<td>{f}\n", "</table>"},
        {"Markdown", "|a|b|c|d|e|f|\n|-|-|-|-|-|-|\n", "|{a}|{b}|{c}|{d}|{e}|{f}|\n", ""},
        {"a table", "", "{a} {b} {c} {d} {e} {f}\n", ""},
        {"by name", "", "a={a} b={b} c={c} d={d} e={e} f={f}\n", ""},
    };
    return all;
}

const document::System2* systemIn(const io::Collection& collection) {
    if (collection.file.entries.size() != 1) return nullptr;
    return document::system2(*collection.file.entries.first().fractal);
}

bool hasError(const io::Collection& collection) {
    return std::ranges::any_of(collection.file.problems, [](const document::Problem& problem) {
        return problem.severity == document::Problem::Severity::Error;
    });
}

void addText(const char* name, const char* text) {
    QTest::newRow(name) << QByteArray(text);
}

} // namespace

void DamagedMapsTest::noMapIsLost_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isDamaged");
    const auto cells = [](const char* words) { return QString::fromLatin1(words).split(u' '); };
    const QStringList first = cells("0.5 0.1 -0.2 0.4 3 7");
    const QStringList last = cells("0.1 0 0 0.5 1 0");
    const std::vector<std::pair<const char*, QStringList>> middles{
        {"as it is", cells("0.25 0.125 -0.75 0.3 2 1")},
        {"a letter", cells("k 0.125 -0.75 0.3 2 1")},
        {"two points", cells("0.25 0.1.5 -0.75 0.3 2 1")},
        {"a question mark", cells("0.25 0.125 -0.75 ? 2 1")},
        {"letters only", cells("u v w q s t")},
    };
    for (const Notation& notation : notations())
        for (const auto& [name, middle] : middles) {
            QString text = QString::fromUtf8(notation.before);
            int number = 0;
            for (const QStringList& map : {first, middle, last})
                text += filled(notation.map, ++number, map);
            QTest::addRow("%s, %s", notation.name, name)
                << text + QString::fromUtf8(notation.after) << (name != middles.front().first);
        }
}

void DamagedMapsTest::noMapIsLost() {
    QFETCH(QString, text);
    QFETCH(bool, isDamaged);
    const io::Collection collection = io::readCollection(text.toUtf8());
    const document::System2* system = systemIn(collection);
    if (isDamaged) {
        QVERIFY(!system);
        QVERIFY(hasError(collection) || !collection.file.entries.isEmpty());
        return;
    }
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(3));
    QVERIFY(system->maps[0].map == ifs::affineMap(.5, .1, -.2, .4, 3, 7));
    QVERIFY(system->maps[1].map == ifs::affineMap(.25, .125, -.75, .3, 2, 1));
    QVERIFY(system->maps[2].map == ifs::affineMap(.1, 0, 0, .5, 1, 0));
}

namespace {

void addDamagedMatrices() {
    const auto add = [](const char* name, const char* text, const char* where) {
        QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(where);
    };
    const char* const matrices = "In matrices in LaTeX, row 2: ";
#define FIRST "w_1(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}x+\\begin{bmatrix}1\\\\0\\end{bmatrix}\n"
    add("a name in a matrix", FIRST "w_2(x)=\\begin{bmatrix}r&0\\\\0&.5\\end{bmatrix}x\n" FIRST, matrices);
    add("an unread vector",
        FIRST "w_2(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}x+\\begin{bmatrix}\\frac1k\\\\0\\end{bmatrix}"
              "\n" FIRST,
        matrices);
    add("a vector by name", FIRST "w_2(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}x+\\mathbf b\n" FIRST,
        matrices);
    add("another point",
        FIRST
        "w_2(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}(x-v)+\\begin{bmatrix}1\\\\0\\end{bmatrix}\n" FIRST,
        matrices);
    add("a point less one",
        FIRST
        "w_2(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}\\begin{bmatrix}x-1\\\\y\\end{bmatrix}\n" FIRST,
        matrices);
    add("a product",
        FIRST
        "w_2(x)=\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}\\begin{bmatrix}0&1\\\\1&0\\end{bmatrix}x\n" FIRST,
        matrices);
    add("half of a sum",
        FIRST "w_2(x)=\\frac12\\left(\\begin{bmatrix}1&0\\\\0&1\\end{bmatrix}x+\\begin{bmatrix}1\\\\0\\end{"
              "bmatrix}\\right)\n" FIRST,
        matrices);
    add("the vector first",
        FIRST
        "w_2(x)=\\begin{bmatrix}1\\\\0\\end{bmatrix}+\\begin{bmatrix}.5&0\\\\0&.5\\end{bmatrix}x\n" FIRST,
        matrices);
    add("no matrix", FIRST "w_2(x)=\\operatorname{diag}(.5,.5)x\n" FIRST, matrices);
    add("a matrix of something else", FIRST "D=\\begin{bmatrix}2&0\\\\0&3\\end{bmatrix}\n" FIRST, matrices);
    add("a factor by name", FIRST "w_2(x)=\\lambda\\begin{bmatrix}1&0\\\\0&1\\end{bmatrix}x\n" FIRST,
        matrices);
#undef FIRST
}

} // namespace

void DamagedMapsTest::damagedMapsAreNamed_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("where");
    const auto add = [](const char* name, const char* text, const char* where) {
        QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(where);
    };
    add("points", "f1(x,y)=(x/2,y/2)\nf2(x,y)=(r x, r y)\nf3(x,y)=(x/2+1,y/2)\n", "In equations, row 2: ");
    add("a product of coordinates", "f1(x,y)=(x/2,y/2)\nf2(x,y)=(x*y, y/2)\nf3(x,y)=(x/2+1,y/2)\n",
        "In equations, row 2: ");
    add("two numbers without a sign", "f1(x,y)=(x/2,y/2)\nf2(x,y)=(.1.5y, y/2)\nf3(x,y)=(x/2+1,y/2)\n",
        "In equations, row 2: ");
    add("a program", "x = .5*x + 1\ny = .5*y\nx = k*x + 2\ny = .5*y\nx = .5*x\ny = .5*y\n",
        "In equations, row 2: ");
    add("NumPy",
        "A1 = np.array([[.5, 0], [0, .5]])\nb1 = np.array([1, 0])\n"
        "A2 = s*np.array([[1, 0], [0, 1]])\nb2 = np.array([0, 1])\n"
        "A3 = np.array([[.5, 0], [0, .5]])\nb3 = np.array([0, 0])\n",
        "In lists of numbers, row 2: ");
    add("a missing number",
        "A1 = [.5 0; 0 .5]; b1 = [1; 0];\nA2 = s; b2 = [1; 0];\nA3 = [.5 0; 0 .5]; b3 = [0; 0];\n",
        "In lists of numbers, row 2: ");
    add("a list", "ifs = [[.5, 0, 0, .5, 0, 0], [k, 0, 0, .5, 0, 0], [.5, 0, 0, .5, 1, 0]]\n",
        "In lists of numbers, row 2: ");
    add("GIMP",
        "center_x 0.5\ncenter_y 0.5\nelement {\n x 0.25\n y 0.75\n theta o\n scale 0.5\n asym 1\n shear 0\n"
        " flip 0\n red_color { 1,0,0 }\n}\n",
        "In a text of GIMP’s IFS Fractal, row 1: ");
    addDamagedMatrices();
}

void DamagedMapsTest::damagedMapsAreNamed() {
    QFETCH(QByteArray, text);
    QFETCH(QString, where);
    const io::Collection collection = io::readCollection(text);
    QVERIFY(collection.file.entries.isEmpty());
    QCOMPARE(collection.file.problems.size(), 1);
    QVERIFY2(collection.file.problems.first().message.startsWith(where),
             qPrintable(collection.file.problems.first().message));
}

// Each is the same pair of maps: .5 0 0 .5 3 7 and .1 0 0 .5 1 0.
void DamagedMapsTest::unusualMapsAreReadRightly_data() {
    QTest::addColumn<QByteArray>("text");
    addText("a point first", "x, y = .5*x + 3, .5*y + 7\nx, y = .1*x + 1, .5*y\n");
    addText("returned", "def f(x, y): return .5*x + 3, .5*y + 7\ndef g(x, y): return .1*x + 1, .5*y\n");
    addText("angles in degrees", "f1(x,y)=(x cos 60° + 3, y cos(60°) + 7)\nf2(x,y)=(.1x + 1, .5y)\n");
    addText("factors of Matlab", "A1 = 0.5*[1 0; 0 1]; b1 = [3; 7];\nA2 = [1 0; 0 5]/10; b2 = [1; 0];\n");
    addText("factors of NumPy", "A1 = 0.5 * np.array([[1, 0], [0, 1]])\nb1 = np.array([3, 7])\n"
                                "A2 = np.array([[1, 0], [0, 5]]) * 0.1\nb2 = np.array([1, 0])\n");
    addText("factors of Mathematica", "{1/2 {{1, 0}, {0, 1}}, {3, 7}}\n{1/10 {{1, 0}, {0, 5}}, {1, 0}}\n");
    addText("fractions of SymPy",
            "A1 = Matrix([[Rational(1, 2), 0], [0, Rational(1, 2)]])\nb1 = Matrix([3, 7])\n"
            "A2 = Matrix([[Rational(1, 10), 0], [0, Rational(1, 2)]])\nb2 = Matrix([1, 0])\n");
#define HALF "\\begin{bmatrix}{1\\over 2}&0\\\\0&\\cos\\frac{\\pi}{3}\\end{bmatrix}"
#define LAST "\nw_2(x)=\\begin{bmatrix}.1&0\\\\0&.5\\end{bmatrix}x+\\binom10\n"
    addText("a list as a vector", "w_1(x)=" HALF "x+(3,7)^T" LAST);
    addText("a list in brackets", "w_1(x)=" HALF "x+[3,7]^{\\mathsf T}" LAST);
    addText("a turned row", "w_1(x)=" HALF "x+\\begin{bmatrix}3&7\\end{bmatrix}^T" LAST);
    addText("a choice", "w_1(x)=" HALF "x+{3\\choose 7}" LAST);
#undef HALF
#undef LAST
}

void DamagedMapsTest::unusualMapsAreReadRightly() {
    QFETCH(QByteArray, text);
    const io::Collection collection = io::readCollection(text);
    const document::System2* system = systemIn(collection);
    QVERIFY2(system,
             collection.file.problems.isEmpty() ? "" : qPrintable(collection.file.problems.first().message));
    QCOMPARE(system->maps.size(), std::size_t(2));
    const auto isNear = [](const ifs::AffineMap<2>& one, const ifs::AffineMap<2>& other) {
        return (one.linear - other.linear).norm() < 1e-12 && one.translation == other.translation;
    };
    QVERIFY(isNear(system->maps[0].map, ifs::affineMap(.5, 0, 0, .5, 3, 7)));
    QVERIFY(isNear(system->maps[1].map, ifs::affineMap(.1, 0, 0, .5, 1, 0)));
}

// The first coefficient is a half, or nothing is read.
void DamagedMapsTest::numbersAreNotChanged_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isRead");
    const auto add = [](const char* cell, bool isRead) {
        const QByteArray one(cell);
        const QByteArray row = "|" + one + "|0|0|.5|0|0|\n|.5|0|0|.5|1|0|\n";
        QTest::newRow(("Markdown, " + one).constData()) << "|a|b|c|d|e|f|\n|-|-|-|-|-|-|\n" + row << isRead;
    };
    for (const char* cell : {"5×10−1", "0.(5)"})
        add(cell, false);
    for (const char* cell : {"5·10⁻¹", "5 × 10⁻¹", "5×10^-1", "0·5"})
        add(cell, true);
    const auto addHtml = [](const char* cell, bool isRead) {
        QTest::newRow(cell) << "<table><tr><td>" + QByteArray(cell) +
                                   "<td>0<td>0<td>.5<td>0<td>0<tr><td>.5<td>0<td>0<td>.5<td>1<td>0</table>"
                            << isRead;
    };
    addHtml("5×10<sup>−1</sup>", true);
    addHtml("1<sub>0</sub>", false);
    const auto addWiki = [](const char* cell, bool isRead) {
        QTest::newRow(cell) << "{|\n|-\n|" + QByteArray(cell) +
                                   "||0||0||.5||0||0\n|-\n|.5||0||0||.5||1||0\n|}\n"
                            << isRead;
    };
    addWiki("{{sfrac|1|2}}", true);
    addWiki("{{frac|1|2}}", true);
    addWiki("{{val|5|e=-1}}", true);
    addWiki("<ref>5</ref>0.5", true);
    addWiki("{{unknown|1|2}}", false);
    QTest::newRow("accounting") << QByteArray("a,b,c,d,e,f\n(0.2),0,0,.5,0,0\n.5,0,0,.5,1,0\n") << false;
    QTest::newRow("a British point") << QByteArray("0·5 0 0 0·5 0 0\n.5 0 0 .5 1 0\n") << true;
    QTest::newRow("a decimal comma among points")
        << QByteArray(
               "m = [{a: 0,5, b: 0, c: 0, d: .5, e: 0, f: 0}, {a: .5, b: 0, c: 0, d: .5, e: 1, f: 0}]\n")
        << false;
    QTest::newRow("an escaped minus")
        << QByteArray("|a|b|c|d|e|f|\n|-|-|-|-|-|-|\n|0.5|0|0|\\-0.5|0|0|\n|.5|0|0|.5|1|0|\n") << true;
}

void DamagedMapsTest::numbersAreNotChanged() {
    QFETCH(QByteArray, text);
    const io::Collection collection = io::readCollection(text);
    const document::System2* system = systemIn(collection);
    QFETCH(bool, isRead);
    QCOMPARE(system != nullptr, isRead);
    if (!system) return;
    QCOMPARE(system->maps.size(), std::size_t(2));
    QCOMPARE(system->maps[0].map.linear(0, 0), .5);
    QCOMPARE(system->maps[0].map.linear(1, 1), text.contains("\\-") ? -.5 : .5);
}

// A to F above rows a to f are maps.
void DamagedMapsTest::mapsNamedLikeColumnsHaveRows() {
    const io::Collection collection = io::readCollection(
        "\tA\tB\tC\tD\tE\tF\na\t.5\t.4\t.3\t.2\t.1\t.6\nb\t0\t0\t0\t0\t0\t0\nc\t0\t0\t0\t0\t0\t0\n"
        "d\t.5\t.4\t.3\t.2\t.1\t.6\ne\t1\t2\t3\t4\t5\t6\nf\t0\t0\t0\t0\t0\t0\n");
    const document::System2* system = systemIn(collection);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(6));
    QVERIFY(system->maps[1].map == ifs::affineMap(.4, 0, 0, .4, 2, 0));
}

BARYCAGE_TEST(DamagedMapsTest);
#include "damaged_maps_test.moc"
