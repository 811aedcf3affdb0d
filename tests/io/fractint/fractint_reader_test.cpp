// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_reader.h"
#include "support/fractint_bytes.h"
#include "support/named_test.h"

#include <QRandomGenerator>
#include <QtTest>

#include <algorithm>

using document::FractalFile;
using document::Problem;

namespace {

const QByteArray twoRows = ".5 0 0 .5 0 0 .25\n.5 0 0 .5 .5 0 .75\n";

// "name 2D 2; name none" and "line:column severity; …" — what a reader of the report would compare by hand.
QByteArray summary(const FractalFile& file) {
    QByteArrayList entries;
    for (const auto& entry : file.entries) {
        QByteArray text = entry.fractal->name.toUtf8() + ' ';
        if (const auto* plane = document::system2(*entry.fractal))
            text += "2D " + QByteArray::number(qulonglong(plane->maps.size()));
        else if (const auto* space = document::system3(*entry.fractal))
            text += "3D " + QByteArray::number(qulonglong(space->maps.size()));
        else
            text += "none";
        entries << text;
    }
    return entries.join("; ");
}

QByteArray places(const document::Problems& problems) {
    QByteArrayList texts;
    for (const Problem& problem : problems)
        texts << QByteArray::number(problem.line) + ':' + QByteArray::number(problem.column) +
                     (problem.severity == Problem::Severity::Error ? " E" : " W");
    return texts.join("; ");
}

document::Problems allProblems(const FractalFile& file) {
    document::Problems problems = file.problems;
    for (const auto& entry : file.entries)
        problems += entry.problems;
    return problems;
}

FractalFile readChecked(const QByteArray& bytes) {
    FractalFile file = io::readFractint(bytes);
    if (support::joined(file) != bytes) qFatal("bytes were lost");
    return file;
}

} // namespace

class FractintReaderTest : public QObject {
    Q_OBJECT

private slots:
    void rules_data();
    void rules();
    void whatEndsANameIsSaid();
    void coefficientsAndWeights();
    void threeDimensionalRowOrder();
    void commentsBelongToTheirEntry();
    void headStaysApart();
    void namesAreDecoded();
    void sumsOfWeightsAreRemarks();
    void ownLinesAreRead();
    void ownLinesThatAreNotUnderstood();
    void unrelatedFormats_data();
    void unrelatedFormats();
    void problemsNameTheirEntryAndSaySomething();
    void manyEntries();
    void hostileShapesTakeLinearTime_data();
    void hostileShapesTakeLinearTime();
    void randomBytesNeverLoseAnything();
};

void FractintReaderTest::rules_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("entries");
    QTest::addColumn<QByteArray>("problems"); // of the file, then of its entries
    const auto row = [](const char* name, const QByteArray& bytes, const char* entries,
                        const char* problems = "") {
        QTest::newRow(name) << bytes << QByteArray(entries) << QByteArray(problems);
    };
    const QByteArray body = "{\n" + twoRows + "}\n";
    row("plain", "a " + body, "a 2D 2");
    row("two entries", "a " + body + "\nb " + body, "a 2D 2; b 2D 2");
    row("CRLF", QByteArray("a " + body + "b " + body).replace('\n', "\r\n"), "a 2D 2; b 2D 2");
    row("CR only", QByteArray("; title\n\na " + body).replace('\n', '\r'), "a 2D 2", "1:1 W");
    row("no final newline", "a {\n" + twoRows + "}", "a 2D 2");
    row("tabs", QByteArray("a\t{\n" + twoRows + "\t}\n").replace("0 ", "0\t"), "a 2D 2");
    row("text after brace", "a " + body.chopped(1) + " the end\n", "a 2D 2");
    row("comment after brace", "a " + body.chopped(1) + " ; the end }\nb " + body, "a 2D 2; b 2D 2");
    row("brace in comment", "a { ; {}\n; }\n" + twoRows + "}\n", "a 2D 2");
    row("brace on next line", "a\n" + body, "a 2D 2", "1:1 W");
    row("comment, brace on next line", "a ; comment {\n" + body, "a 2D 2", "1:1 W");
    row("marker on next line", "a\n(3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1", "1:1 W");
    row("title above", "Some title words\na " + body, "a 2D 2");
    row("name with blanks", "New Top Design " + body, "New Top Design 2D 2", "1:1 W");
    row("name cut elsewhere", "abcdefghijklmnopqrs " + body, "abcdefghijklmnopqrs 2D 2", "1:1 W");
    row("unnamed", body + "b " + body, "b 2D 2", "1:1 W");
    row("comment block", "Comment {\n1 2 3 anything\n}\nb " + body, "b 2D 2");
    row("formula", "z {\nz = pixel\n}\nb " + body, "b 2D 2", "1:1 W");
    row("an equals sign in the third word", "a {\n.5 0 =0 .5 0 0 1\n}\nb " + body, "a none; b 2D 2", "2:6 E");
    row("the same on the header line", "a {.5 0 =0 .5 0 0 1\n}\nb " + body, "a none; b 2D 2", "1:3 E");
    row("other type", "frm:z {\n1\n}\nb " + body, "b 2D 2", "1:1 W");
    row("parameter file", "p {\nreset=1950 type=ifs ifs=a\n}\nIFS:a " + body, "a 2D 2");
    row("numbers on the header line, not needed", "a { .5 0 0 .5 0 0 .25\n" + twoRows + "}\n", "a 2D 2",
        "1:5 W");
    row("numbers on the header line, needed", "a { .5 0 0 .5\n0 0 1\n}\n", "a 2D 1", "1:5 W");
    row("on one line", "a { .5 0 0 .5 0 0 1 }\nb " + body, "a 2D 1; b 2D 2", "1:5 W");
    row("header text without semicolon", "a {Tony 23/1/2004, BRAZIL\n" + twoRows + "}\n", "a 2D 2");
    row("glued brace", "a {\n.5 0 0 .5 0 0 .25\n.5 0 0 .5 .5 0 .75}\nb " + body, "a 2D 2; b 2D 2", "3:19 W");
    row("next entry on the closing line", "a {\n" + twoRows + "} b " + body, "a 2D 2; b 2D 2");
    row("two maps on a line", "a {\n.5 0 0 .5 0 0 .25 .5 0 0 .5 .5 0 .75\n}\n", "a 2D 2");
    row("a map over two lines", "a {\n.5 0 0\n.5 0 0 .25\n.5 0 0 .5 .5 0 .75\n}\n", "a 2D 2");
    row("commas and blanks", "a {\n.5, 0, 0, .5, 0, 0, 1\n}\n", "a 2D 1", "2:1 W");
    row("commas alone", "a {\n.5,0,0,.5,0,0,1\n}\n", "a 2D 1", "2:1 W");
    row("apostrophes", "a {\n'.5' '0' '0' '.5' '0' '0' '1'\n}\n", "a 2D 1", "2:2 W");
    row("decimal commas", "a {\n0,5 0 0 0,5 0 0 1\n}\n", "a 2D 1", "2:1 W");
    row("commas that fit neither way", "a {\n0,5 0 0 0,5 0 0\n1,0 0\n}\n", "a none", "2:1 E");
    row("commas that fit both ways", "a {\n" + QByteArray("0,5 ").repeated(7) + "\n}\n", "a none", "2:1 E");
    row("six numbers", "a {\n.5 0 0 .5 0 0\n.5 0 0 .5 .5 0\n}\n", "a 2D 2", "2:1 W");
    row("six numbers, seven rows", "a {\n" + QByteArray(".5 0 0 .5 0 0\n").repeated(7) + "}\n", "a 2D 6",
        "2:1 W; 4:4 W; 5:6 W; 7:11 W; 8:13 W");
    row("3D", "a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1");
    row("3D glued, lower case", "a(3d){\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1");
    row("3D after the brace", "a { (3D)\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1");
    row("3D in a comment", "a { ; (3D)\n.5 0 0 .5 0 0 1\n}\n", "a 2D 1");
    row("3D without its mark", "a {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1", "2:1 W");
    row("3D without weights", "a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0\n}\n", "a 3D 1", "2:1 W");
    row("3D spaced", "a ( 3D ) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n", "a 3D 1", "2:1 W");
    row("many maps", "a {\n" + QByteArray(".1 0 0 .1 0 0 .015625\n").repeated(64) + "}\n", "a 2D 64",
        "1:1 W");
    row("exponents and forms", "a {\n5e-1 +0 -0 .5E0 1. 0 1e0\n}\n", "a 2D 1");
    row("fraction", "a {\n1/3 0 0 .5 0 0 1\n}\nb " + body, "a none; b 2D 2", "2:1 E");
    row("Fortran exponent", "a {\n.5 0 0 5D-1 0 0 1\n}\n", "a none", "2:8 E");
    row("infinite", "a {\n.5 0 0 .5 inf nan 1\n}\n", "a none", "2:11 E; 2:15 E");
    row("huge", "a {\n.5 0 0 .5 1e39 1e999 1\n}\n", "a none", "2:11 E; 2:16 E");
    row("huge with a negative exponent", "a {\n.5 0 0 .5 1" + QByteArray(400, '0') + "e-5 0 1\n}\n", "a none",
        "2:11 E");
    row("tiny with a positive exponent", "a {\n.5 0 0 .5 0." + QByteArray(400, '0') + "1e+10 1e-400 1\n}\n",
        "a 2D 1", "2:201 W"); // Fractint cuts the line
    row("tiny", "a {\n.5 0 0 .5 1e-999 0 1\n}\n", "a 2D 1");
    row("hexadecimal", "a {\n.5 0 0 .5 0x10 0 1\n}\n", "a none", "2:11 E");
    row("typographic minus", "a {\n\xe2\x88\x92.5 0 0 .5 0 0 1\n}\n", "a none", "2:1 E");
    row("stray letter", "a {\nc\n" + twoRows + "}\nb " + body, "a none; b 2D 2", "2:1 E");
    row("a number too many", "a {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 0 0 1 1\n}\n", "a none", "3:1 E");
    row("empty", "a {\n; .5 0 0 .5 0 0 1\n}\nb " + body, "a none; b 2D 2", "1:3 E");
    row("unclosed", "a {\n.5 0 0 .5 0 0 .25\nb " + body, "a none; b 2D 2", "1:3 E");
    row("unclosed before a brace on its own line", "a {\n.5 0 0 .5 0 0 .25\nb\n" + body, "a none; b 2D 2",
        "1:3 E; 3:1 W");
    row("unclosed at the end", "b " + body + "a {\n.5 0 0 .5 0 0 .25\n", "b 2D 2; a none", "5:3 E");
    row("two braces on a line", "a { b {\n1\n}\nc " + body, "c 2D 2", "1:1 W");
    row("same name", "Fern " + body + "fern " + body, "Fern 2D 2; fern 2D 2", "5:1 W");
    row("zero weight", "a {\n.5 0 0 .5 0 0 0\n.5 0 0 .5 0 0 1\n}\n", "a 2D 2", "2:15 W");
    row("no weight above zero", "a {\n.5 0 0 .5 0 0 0\n.5 0 0 .5 0 0 -1\n}\n", "a 2D 2", "2:15 W; 3:15 W");
    row("negative weight", "a {\n.5 0 0 .5 0 0 -.1\n.5 0 0 .5 0 0 1.1\n}\n", "a 2D 2", "2:15 W");
    row("weights beyond 1", "a {\n.5 0 0 .5 0 0 .75\n.5 0 0 .5 0 0 .75\n}\n", "a 2D 2", "2:15 W");
    row("bare", twoRows, "unnamed 2D 2");
    row("bare, glued numbers", "  0.50-10.00  0.00  0.50-10.00-20.00  1.00\r\n", "unnamed 2D 1");
    row("bare 3D", "1 0 0 0 1 0 0 0 1 0 0 0 1\n", "unnamed 3D 1", "1:1 W");
    row("byte order mark",
        "\xef\xbb\xbf"
        "a " +
            body,
        "a 2D 2", "1:1 W");
    row("^Z tail", "a " + body + "\x1a", "a 2D 2");
    row("^Z and the rest of a disk block", "a " + body + "\x1a" + QByteArray(200, '\0'), "a 2D 2");
    row("^Z before an entry", "a " + body + "\x1a\nb " + body, "a 2D 2; b 2D 2", "5:1 W");
    row("NUL in a row", QByteArray("a {\n.5 0 0 .5 0 0 1") + '\0' + " rubbish\n}\n", "a 2D 1", "2:16 W");
    row("long line", "a {\n" + QByteArray(200, ' ') + ".5 0 0 .5 0 0 1\n}\n", "a 2D 1", "2:201 W");
    row("nothing", "", "", "0:0 E");
    row("only comments", "; nothing\n", "", "0:0 E");
    row("prose", "Dear reader,\nthere is nothing here.\n", "", "0:0 E");
}

void FractintReaderTest::rules() {
    QFETCH(QByteArray, bytes);
    const FractalFile file = readChecked(bytes);
    QTEST(summary(file), "entries");
    QTEST(places(allProblems(file)), "problems");
}

void FractintReaderTest::whatEndsANameIsSaid() {
    const auto said = [](const QByteArray& name) {
        const FractalFile file = readChecked(name + " {\n.5 0 0 .5 0 0 1\n}\n");
        const auto problems = allProblems(file);
        return problems.isEmpty() ? QString() : problems.first().message;
    };
    QVERIFY(said("a b").contains(QStringLiteral("contains a space")));
    QVERIFY(said(QByteArray("a\0b", 3)).contains(QStringLiteral("contains a control character")));
    QVERIFY(said("ab").isEmpty());
}

void FractintReaderTest::coefficientsAndWeights() {
    const FractalFile file = readChecked("a {\n1 2 3 4 5 6 -.25\n}\nb {\n.1 .2 .3 .4 .5 .6\n}\n");
    const document::System2* a = document::system2(*file.entries[0].fractal);
    QVERIFY(a != nullptr);
    QCOMPARE(a->maps[0].map, ifs::affineMap(1, 2, 3, 4, 5, 6));
    QCOMPARE(a->maps[0].weight, std::optional(-0.25)); // as given; counted as switched off
    QVERIFY(a->maps[0].enabled);
    QVERIFY(a->maps[0].id != ifs::MapId::None);
    const document::System2* b = document::system2(*file.entries[1].fractal);
    QVERIFY(b != nullptr);
    QCOMPARE(b->maps[0].map, ifs::affineMap(.1, .2, .3, .4, .5, .6));
    QVERIFY(!b->maps[0].weight);
}

void FractintReaderTest::threeDimensionalRowOrder() {
    const FractalFile file = readChecked("a (3D) {\n1 2 3 4 5 6 7 8 9 10 11 12 1\n}\n");
    const auto* system = document::system3(*file.entries[0].fractal);
    QVERIFY(system != nullptr);
    const ifs::AffineMap<3>& map = system->maps[0].map;
    QCOMPARE(map.linear(0, 1), 2.0);
    QCOMPARE(map.linear(1, 0), 4.0);
    QCOMPARE(map.linear(2, 2), 9.0);
    QCOMPARE(map.translation[0], 10.0);
    QCOMPARE(map.translation[2], 12.0);
}

void FractintReaderTest::commentsBelongToTheirEntry() {
    const QByteArray text =
        "; title\n\n; about a\na { ; first\n ; one\n.5 0 0 .5 0 0 .5 ; row\n;two  \n.5 0 0 .5 0 0 .5\n}\n"
        "; about b\nb {text\n.5 0 0 .5 0 0 1\n}\n";
    const FractalFile file = readChecked(text);
    QCOMPARE(file.entries[0].fractal->headerComment, QStringLiteral("first"));
    QCOMPARE(file.entries[0].fractal->comments, (QStringList{QStringLiteral("one"), QStringLiteral("two")}));
    QCOMPARE(file.entries[1].fractal->headerComment, QStringLiteral("text"));
    QCOMPARE(file.entries[1].source->before, QByteArray("; about b\n"));
    QCOMPARE(file.entries[1].source->line, 11);
}

void FractintReaderTest::headStaysApart() {
    const FractalFile file = readChecked("; title\n\n; about a\na {\n" + twoRows + "}\n; end\n\x1a");
    QCOMPARE(file.head, QByteArray("; title\n\n"));
    QCOMPARE(file.entries[0].source->before, QByteArray("; about a\n"));
    QCOMPARE(file.tail, QByteArray("; end\n\x1a"));
    QCOMPARE(readChecked("a {\r\n.5 0 0 .5 0 0 1\r\n}\r\n").lineEnd, QByteArray("\r\n"));
}

void FractintReaderTest::namesAreDecoded() {
    QCOMPARE(readChecked("\xc3\xa9toile {\n" + twoRows + "}\n").entries[0].fractal->name,
             QString::fromUtf8("étoile"));
    QCOMPARE(readChecked("\xe9toile {\n" + twoRows + "}\n").entries[0].fractal->name,
             QString::fromUtf8("étoile"));
}

// They are relative: a file with any sum is as good as another.
void FractintReaderTest::sumsOfWeightsAreRemarks() {
    const FractalFile file = readChecked("a {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 .5 0 1\n}\n");
    const auto problems = file.entries[0].problems;
    QCOMPARE(problems.size(), 1);
    QVERIFY(problems[0].severity == Problem::Severity::Remark);
    QVERIFY(problems[0].message.startsWith(QStringLiteral("The weights sum to 2")));
    QVERIFY(!document::callsForAttention(problems));
}

void FractintReaderTest::ownLinesAreRead() {
    const FractalFile file =
        readChecked("a {\n; barycage: version 1\n; barycage: rest 0 0\n; barycage: rest 1 0\n"
                    "; barycage: rest 0 1\n; barycage: current 0 0\n; barycage: current 2 0\n"
                    "; barycage: current 0 1\n; barycage: colour-by map\n"
                    "; barycage: background #01020300\n; barycage: gamma 3.5\n"
                    "; barycage: map-colour 2 #ff000080\n; barycage: off 1 0.25\n"
                    ".5 0 0 .5 0 0 0\n.5 0 0 .5 .5 0 .75\n}\n");
    QCOMPARE(places(allProblems(file)), QByteArray()); // neither the zero nor the sum is news
    const document::Fractal& fractal = *file.entries[0].fractal;
    QVERIFY(fractal.comments.isEmpty());
    QVERIFY(document::plane(fractal)->cage.has_value());
    QCOMPARE(document::plane(fractal)->cage->current[1], ifs::Vector<2>(2, 0));
    QVERIFY(fractal.appearance.colourBy == attractor::ColourBy::Map);
    QVERIFY((fractal.appearance.background == attractor::Rgba{1, 2, 3, 0}));
    QCOMPARE(fractal.appearance.gamma, 3.5);
    const auto& maps = document::system2(fractal)->maps;
    QVERIFY((*fractal.appearance.mapColours.find(maps[1].id) == attractor::Rgba{255, 0, 0, 128}));
    QVERIFY(!maps[0].enabled);
    QCOMPARE(maps[0].weight, std::optional(0.25));
}

void FractintReaderTest::ownLinesThatAreNotUnderstood() {
    const FractalFile file =
        readChecked("a {\n; barycage: rest 0 0\n; barycage: rest 1 1\n; barycage: sparkle 7\n"
                    "; barycage: gamma -1\n; barycage: off 9\n; barycage: palette no such\n" +
                    twoRows + "}\n");
    const document::Fractal& fractal = *file.entries[0].fractal;
    QVERIFY(!document::plane(fractal)->cage);
    QCOMPARE(fractal.appearance, attractor::Appearance());
    QCOMPARE(document::system2(fractal)->maps.size(), std::size_t(2));
    QCOMPARE(places(allProblems(file)), QByteArray("2:1 W; 2:1 W; 2:1 W; 4:1 W; 5:1 W"));
}

void FractintReaderTest::unrelatedFormats_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("name");
    QTest::newRow("Racket") << QByteArray("(((3) 0 () (f affine-transformation 1 2)))")
                            << QStringLiteral("Racket");
    QTest::newRow("list of files") << QByteArray(
                                          "2 Total Anzahl IFS's\nThe Fern\nfarn.ifs\nMaple\nahorn.ifs\n")
                                   << QStringLiteral("list of other files");
    QTest::newRow("Fraktale") << QByteArray("2\n.5 0 0 .5 0 0 50\n.5 0 0 .5 .5 0 100\n1 1 0 0\n")
                              << QStringLiteral("Fraktale");
    QTest::newRow("five numbers") << QByteArray("2 400 600\n.9 .9 10 50 -2\n.2 .3 9 -9 55\n")
                                  << QStringLiteral("5 numbers");
    QTest::newRow("expressions") << QByteArray("0, 0.16*y;0.5\r\n0.5*x, y/2;0.5\r\n")
                                 << QStringLiteral("pyfractal");
    QTest::newRow("script") << QByteArray("// tree\nxform 1\ntranslate 0 1\nrotate 3\n")
                            << QStringLiteral("StyrofoamIFS");
    QTest::newRow("flame") << QByteArray("<flames>\n<flame name=\"{ }\"/>\n</flames>")
                           << QStringLiteral("flame");
    QTest::newRow("aifs") << QByteArray("@\n$dim=2\nf1=[0,0]*[.5,0,0,.5]\n") << QStringLiteral("IFStile");
    QTest::newRow("PNG") << QByteArray("\x89PNG\r\n\x1a\n") << QStringLiteral("PNG");
    QTest::newRow("UTF-16") << QByteArray("\xff\xfe"
                                          "a\0 \0{\0",
                                          8)
                            << QStringLiteral("UTF-16");
    QTest::newRow("binary") << QByteArray("\x01\x02\x03\x04 a { 1 } \x05\x06\x07\x08")
                            << QStringLiteral("binary");
    QTest::newRow("formulas") << QByteArray("m {\nz = z*z\n}\n") << QStringLiteral("formulas");
}

void FractintReaderTest::unrelatedFormats() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, name);
    const FractalFile file = readChecked(bytes);
    QVERIFY(file.entries.isEmpty());
    QCOMPARE(file.problems.size(), 1);
    QCOMPARE(file.problems[0].severity, Problem::Severity::Error);
    QCOMPARE(file.problems[0].line, 0); // of the file as a whole
    QVERIFY2(file.problems[0].message.contains(name), qPrintable(file.problems[0].message));
}

void FractintReaderTest::problemsNameTheirEntryAndSaySomething() {
    const FractalFile file = readChecked("x {\n1/3 0 0 1 0 0 1\n}\n");
    const QString text = document::toText(file.entries[0].problems.value(0), QStringLiteral("f.ifs"));
    QVERIFY2(text.startsWith(QStringLiteral("f.ifs:2:1: error: “x”: “1/3”")), qPrintable(text));
    // A page of prose does not become a page of errors.
    const FractalFile prose = readChecked("x {\n" + QByteArray("so many words\n").repeated(100) + "}\n");
    QVERIFY(prose.entries[0].problems.size() <= 11);
    QVERIFY(prose.entries[0].problems.last().message.contains(QStringLiteral("290")));
}

void FractintReaderTest::manyEntries() {
    QByteArray bytes;
    for (int i = 0; i < 20'000; ++i)
        bytes += "e" + QByteArray::number(i) + " {\n" + twoRows + "}\n";
    const FractalFile file = readChecked(bytes);
    QCOMPARE(file.entries.size(), 20'000);
    QCOMPARE(places(file.problems), QByteArray("0:0 W"));
    QCOMPARE(file.entries.last().source->line, 4 * 19'999 + 1);
}

void FractintReaderTest::hostileShapesTakeLinearTime_data() {
    QTest::addColumn<QByteArray>("bytes");
    constexpr int n = 1'000'000;
    QTest::newRow("opening braces") << QByteArray(n, '{');
    QTest::newRow("names and braces on one line") << QByteArray("a{").repeated(n);
    QTest::newRow("unclosed entries") << QByteArray("a{\n").repeated(150'000);
    QTest::newRow("closing braces") << QByteArray(n, '}');
    QTest::newRow("line ends") << "a" + QByteArray(n, '\n') + "{";
    QTest::newRow("names before blank lines") << QByteArray("a\n").repeated(n / 2) + QByteArray(n, '\n');
    QTest::newRow("one line of numbers") << "a{" + QByteArray("1 ").repeated(n) + "}";
    QTest::newRow("numbers without end") << "a {\n" + QByteArray("1 0 0 1 0 0 1\n").repeated(n / 10) + "}";
    QTest::newRow("one comment") << ";" + QByteArray(n, 'x');
    QTest::newRow("rubbish words") << "a {\n" + QByteArray("x ").repeated(n) + "}";
    QTest::newRow("commas") << "a {\n" + QByteArray(n, ',') + "\n}";
    QTest::newRow("a long name") << QByteArray(n, 'n') + " { 1 }";
}

// The time limit of the test program is the check; quadratic work would exceed it by far.
void FractintReaderTest::hostileShapesTakeLinearTime() {
    QFETCH(QByteArray, bytes);
    const FractalFile file = readChecked(bytes);
    QVERIFY(allProblems(file).size() <= file.entries.size() * 11 + 110);
}

void FractintReaderTest::randomBytesNeverLoseAnything() {
    const QByteArray seed =
        "; title\n\na { ; c\n; barycage: rest 0 0\n.5 0 0 .5 0 0 .25\n.5,0 0\n.5 .5 0 .75}\n"
        "b(3D)\n{\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\r\n\x1a";
    const QByteArray alphabet = "{};,'\n\r\t .-+0123456789eEab()\x1a\xef\xbb\xbf\xe9";
    QRandomGenerator random(20'240'501);
    for (int round = 0; round < 20'000; ++round) {
        QByteArray bytes = seed;
        for (int change = random.bounded(1, 12); change > 0; --change) {
            const auto place = random.bounded(bytes.size());
            const char c = random.bounded(10) == 0 ? static_cast<char>(random.bounded(256))
                                                   : alphabet[random.bounded(alphabet.size())];
            switch (random.bounded(3)) {
            case 0:
                bytes[place] = c;
                break;
            case 1:
                bytes.insert(place, c);
                break;
            default:
                bytes.remove(place, random.bounded(1, 4));
                break;
            }
            if (bytes.isEmpty()) bytes = seed;
        }
        const FractalFile file = io::readFractint(bytes);
        if (support::joined(file) != bytes) QFAIL(bytes.toPercentEncoding().constData());
        for (const auto& entry : file.entries) {
            const bool hasError =
                std::any_of(entry.problems.begin(), entry.problems.end(), [](const Problem& problem) {
                    return problem.severity == Problem::Severity::Error;
                });
            if (hasError != (document::dimension(*entry.fractal) == 0))
                QFAIL(bytes.toPercentEncoding().constData());
        }
    }
}

BARYCAGE_TEST(FractintReaderTest);
#include "fractint_reader_test.moc"
