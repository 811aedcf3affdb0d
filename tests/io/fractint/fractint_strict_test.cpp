// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_strict.h"

#include "io/fractint/fractint_reader.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using document::Entry;
using document::FractalFile;

class FractintStrictTest : public QObject {
    Q_OBJECT

private slots:
    void everyReaderTakesIt();
    void keepsComments();
    void saysWhatGoes();
    void limits();
    void keepsWeightsThatFit();
    void wrapsLongComments();
    void keepsEveryMapThatTakesPart();
};

void FractintStrictTest::everyReaderTakesIt() {
    FractalFile file = io::readFractint(
        "New Top Design { ; h\xc3\xa9\n; about\n.5,0,0,.5,0,0,1\n.5,0,0,.5,0,0,1\n.1 0 0 .1 0 0 0\n}\n"
        "new_Top_Design {\n.5 0 0 .5 0 0\n}\nbroken {\nx\n}\n");
    const io::StrictText strict = io::writeStrict(file);
    QCOMPARE(strict.bytes,
             QByteArray("; about\nNew_Top_Design { ; he\n  0.5 0 0 0.5 0 0 0.5\n  0.5 0 0 0.5 0 0 0.5\n}\n"
                        "\nnew_Top_Design_2 {\n  0.5 0 0 0.5 0 0 1\n}\n"));
    QCOMPARE(strict.problems.size(), 4); // a map left out, two names changed, an entry left out
    QCOMPARE(io::writeStrict(file, {file.entries[1].id}).bytes,
             QByteArray("new_Top_Design {\n  0.5 0 0 0.5 0 0 1\n}\n"));
    const FractalFile reread = io::readFractint(strict.bytes);
    for (const Entry& entry : reread.entries)
        QVERIFY(entry.problems.isEmpty());
}

void FractintStrictTest::keepsComments() {
    const io::StrictText strict = io::writeStrict(
        io::readFractint("\xef\xbb\xbf; a book of leaves\n by hand\n\n; above\r\nleaf { ; maple\n"
                         "  ; inside\n .5 0 0 .5 0 0 .5 ; the stem\n .5 0 0 .5 1 0 .5\n} ; behind\n"
                         "; between\n\ncomment {\n ; in a block\n}\n"
                         "twig {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n; the end\n\x1a"));
    QCOMPARE(strict.bytes,
             QByteArray(
                 "; a book of leaves\n; by hand\n\n; above\n; inside\n; the stem\n; behind\nleaf { ; maple\n"
                 "  0.5 0 0 0.5 0 0 0.5\n  0.5 0 0 0.5 1 0 0.5\n}\n\n; between\n"
                 "twig {\n  0.5 0 0 0.5 0 0 0.5\n  0.5 0 0 0.5 1 0 0.5\n}\n\n; the end\n"));
    QCOMPARE(strict.problems.size(), 1); // the lines of the block
    QVERIFY(strict.problems[0].message.startsWith(QLatin1String("Omitted lines of blocks")));
    QVERIFY(strict.problems[0].message.endsWith(QLatin1String(": 3.")));
    // Nothing more is lost a second time.
    const io::StrictText again = io::writeStrict(io::readFractint(strict.bytes));
    QCOMPARE(again.bytes, strict.bytes);
    QVERIFY(again.problems.isEmpty());
}

void FractintStrictTest::saysWhatGoes() {
    const QByteArray rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    const QByteArray cage = "; barycage: rest 0 0\n; barycage: rest 1 0\n; barycage: rest 0 1\n"
                            "; barycage: current 1 2\n; barycage: current 2 2\n; barycage: current 1 3\n";
    const io::StrictText strict = io::writeStrict(io::readFractint(
        "moved {\n" + cage + rows + "coloured {\n; barycage: gamma 3\n" + rows + "plain {\n" + rows));
    QVERIFY(!strict.bytes.contains("barycage"));
    QCOMPARE(strict.problems.size(), 2);
    QCOMPARE(strict.problems[0].entry, QStringLiteral("moved"));
    QVERIFY(strict.problems[0].message.contains(QLatin1String("cage")));
    QCOMPARE(strict.problems[1].entry, QStringLiteral("coloured"));

    QByteArray cageInSpace;
    for (const char* vertex : {"rest 0 0 0", "rest 1 0 0", "rest 0 1 0", "rest 0 0 1", "current 0 0 0",
                               "current 1 0 0", "current 0 1 0", "current 0 0 2"})
        cageInSpace += QByteArray("; barycage: ") + vertex + '\n';
    const io::StrictText space = io::writeStrict(
        io::readFractint("solid (3D) {\n" + cageInSpace +
                         " .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 1 0 0 .5\n}\n"));
    QVERIFY(!space.bytes.contains("barycage"));
    QCOMPARE(space.problems.size(), 1);
    QVERIFY(space.problems[0].message.contains(QLatin1String("different picture")));
}

void FractintStrictTest::limits() {
    QByteArray rows;
    for (int i = 0; i < 64; ++i)
        rows += ".123456789012345 0 0 .1 0 0 " + QByteArray::number(i + 1) + '\n';
    const QByteArray space = "s (3D) {\n" + QByteArray("-1.2345678901234567e-101 ").repeated(12) + " 3\n}\n";
    // Each row has room for all of its digits, but not under those of the other.
    const QByteArray number = "-1.2345678901234567e-101 ";
    const QByteArray turned =
        "t (3D) {\n" + (number + "0 ").repeated(6) + " 1\n" + ("0 " + number).repeated(6) + " 1\n}\n";
    const io::StrictText strict = io::writeStrict(io::readFractint("a {\n" + rows + "}\n" + space + turned));
    QCOMPARE(strict.problems.size(), 1);
    QCOMPARE(strict.bytes.count(number.trimmed()), 24);
    for (const QByteArray& line : strict.bytes.split('\n'))
        QVERIFY(line.size() < 200);
    double sum = 0;
    const FractalFile reread = io::readFractint(strict.bytes);
    for (const auto& map : document::system2(*reread.entries[0].fractal)->maps) {
        QVERIFY(*map.weight > 0);
        sum += *map.weight;
    }
    QVERIFY(std::abs(sum - 1) < 1e-12);
    QCOMPARE(document::system3(*reread.entries[1].fractal)->maps.size(), std::size_t(1));
}

void FractintStrictTest::keepsWeightsThatFit() {
    const auto weights = [](const QByteArrayList& given) {
        QByteArray text = "a {\n";
        for (const QByteArray& weight : given)
            text += ".5 0 0 .5 0 0 " + weight + '\n';
        QByteArrayList written;
        for (const QByteArray& line : io::writeStrict(io::readFractint(text + "}\n")).bytes.split('\n'))
            if (line.startsWith(' ')) written << line.sliced(line.lastIndexOf(' ') + 1);
        return written;
    };
    QCOMPARE(weights({".3", ".3", ".3", ".1"}), (QByteArrayList{"0.3", "0.3", "0.3", "0.1"}));
    QCOMPARE(weights({".33", ".33", ".34"}), (QByteArrayList{"0.33", "0.33", "0.34"}));
    QCOMPARE(weights({"1", "3"}), (QByteArrayList{"0.25", "0.75"}));
}

// Fractint cuts lines at 200 bytes; no word of a comment is lost there.
void FractintStrictTest::wrapsLongComments() {
    QByteArray words;
    for (int i = 0; i < 100; ++i)
        words += " word" + QByteArray::number(i);
    const QByteArray single(450, 'x');
    // The line breaks after 197 bytes, before what is no line of ours.
    const QByteArray own = QByteArray(197, 'y') + " barycage: gamma 3";
    const io::StrictText strict =
        io::writeStrict(io::readFractint("a { ;" + words + "\n;" + words + "\n; " + single + "\n; " + own +
                                         "\n.5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n}\n"));
    QVERIFY(strict.problems.isEmpty());
    for (const QByteArray& line : strict.bytes.split('\n'))
        QVERIFY(line.size() < 200);
    for (int i = 0; i < 100; ++i)
        QCOMPARE((' ' + strict.bytes.simplified() + ' ').count(" word" + QByteArray::number(i) + ' '), 2);
    QCOMPARE(strict.bytes.count('x'), single.size());
    QVERIFY2(strict.bytes.contains("\n; barycage  gamma 3\n"), strict.bytes.constData());
    QVERIFY(strict.bytes.contains("\na { ; word0 word1 "));
    QCOMPARE(io::writeStrict(io::readFractint(strict.bytes)).bytes, strict.bytes);
}

// Some old readers stop at a weight that is 0 in single precision.
void FractintStrictTest::keepsEveryMapThatTakesPart() {
    const io::StrictText strict = io::writeStrict(
        io::readFractint("a {\n.5 0 0 .5 0 0 1e-300\n.5 0 0 .5 1 0 3e38\n.5 0 0 .5 2 0 1e38\n}\n"));
    QVERIFY(strict.problems.isEmpty());
    const FractalFile reread = io::readFractint(strict.bytes);
    const auto* system = document::system2(*reread.entries.value(0).fractal);
    QVERIFY(system && system->maps.size() == 3);
    for (const auto& map : system->maps)
        QVERIFY(float(*map.weight) > 0);
}

BARYCAGE_TEST(FractintStrictTest);
#include "fractint_strict_test.moc"
