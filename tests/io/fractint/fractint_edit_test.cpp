// SPDX-License-Identifier: MIT
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_edit.h"
#include "io/fractint/fractint_reader.h"
#include "support/named_test.h"

#include <QTest>

#include <functional>

using document::EntrySource;
using document::Fractal;
using io::fractint::editedText;

namespace {

EntrySource sourceOf(const QByteArray& text) {
    return *io::readFractint(text).entries.first().source;
}

ifs::WeightedMap<2>& mapOf(Fractal& fractal, std::size_t i) {
    return document::system2(fractal)->maps[i];
}

using Change = std::function<void(Fractal&)>;

constexpr auto solid =
    "a (3D) {\n .5 0 0  0 .5 0  0 0 .5  0 0 0  .5 ; left\n .5 0 0  0 .5 0  0 0 .5  1 0 0  .5\n}\n";

// So that every number of the map needs 17 digits.
void makeLong(ifs::WeightedMap<3>& mapOf) {
    mapOf.map.linear.fill(-1.0 / 3e-5);
    mapOf.map.translation.fill(-1.0 / 3e-6);
}

// The text as it is read again: without a remark, and what was written.
void readsAs(const QByteArray& text, const Fractal& fractal) {
    const auto read = io::readFractint(text);
    QVERIFY2(read.problems.isEmpty(), qPrintable(read.problems.value(0).message));
    QVERIFY(document::isSameSystem(*read.entries.first().fractal, fractal));
}

} // namespace

Q_DECLARE_METATYPE(Change)

class FractintEditTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsTouchedUnlessItChanged_data();
    void nothingIsTouchedUnlessItChanged();
    void edits_data();
    void edits();
    void bareFilesGetBracesWhenTheyNeedThem();
    void gluedNumbersAreWrittenAfresh();
    void kindsOfSystemsAreWrittenAfresh();
    void latin1StaysLatin1();
    void longRowsTakeTwoLines();
    void rowsOnTwoLinesAreMovedWhole();
    void longRowsAreWrittenOnTwoLines();
};

void FractintEditTest::nothingIsTouchedUnlessItChanged_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("odd spelling") << QByteArray(
        "a{;x\r\n\t+.50,0 0 5e-1 0 0  1.\r\n ; barycage: tea 1\r\n}\r\n");
    QTest::newRow("bare") << QByteArray("  0.50  0.00  0.00  0.50-10.00-20.00  1.00\n");
    QTest::newRow("unreadable") << QByteArray("a {\n1/3 x\n}\n");
}

void FractintEditTest::nothingIsTouchedUnlessItChanged() {
    QFETCH(QByteArray, text);
    const EntrySource source = sourceOf(text);
    QCOMPARE(editedText(source, source.fractal), source.text);
}

// Each: the bytes after, by hand.
void FractintEditTest::edits_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<Change>("change");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char* name, const QByteArray& before, const Change& change,
                        const QByteArray& after) { QTest::newRow(name) << before << change << after; };
    const QByteArray two = "a { ; head\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n";
    const Change setFirst = [](Fractal& f) { mapOf(f, 0).map.linear(0, 0) = .25; };
    const Change removeFirst = [](Fractal& f) {
        document::system2(f)->maps.erase(document::system2(f)->maps.begin());
    };
    const Change swapMaps = [](Fractal& f) { std::swap(mapOf(f, 0), mapOf(f, 1)); };
    const Change appendMap = [](Fractal& f) {
        ifs::append(*document::system2(f), ifs::affineMap(1, 2, 3, 4, 5, 6), 1.0);
    };
    const Change prependMap = [appendMap](Fractal& f) {
        appendMap(f);
        auto& maps = document::system2(f)->maps;
        std::rotate(maps.begin(), maps.end() - 1, maps.end());
    };
    const Change recomment = [](Fractal& f) { f.headerComment = QStringLiteral("new"); };
    row("a number", two, setFirst,
        "a { ; head\n\t0.25 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row(
        "a weight", two, [](Fractal& f) { mapOf(f, 1).weight = .5; },
        "a { ; head\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 0.5 ; right\n}\n");
    row("a map fewer", two, removeFirst, "a { ; head\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row("maps exchanged", two, swapMaps,
        "a { ; head\n\t.5 0 0 .5 1 0 .75 ; right\n\t.50 0 0 +.5  0 0 .25 ; left\n}\n");
    row("a map more", two, appendMap,
        "a { ; head\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n\t1 2 3 4 5 6 1\n}\n");
    row("a map in front", two, prependMap,
        "a { ; head\n\t1 2 3 4 5 6 1\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row(
        "the name", two, [](Fractal& f) { f.name = QStringLiteral("b c{"); },
        "b_c_ { ; head\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row(
        "a name with a marker", "ifs:a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n",
        [](Fractal& f) { f.name = QStringLiteral("b"); }, "ifs:b (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n");
    row("a header", two, recomment,
        "a { ; new\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row(
        "no header any more", two, [](Fractal& f) { f.headerComment.clear(); },
        "a {\n\t.50 0 0 +.5  0 0 .25 ; left\n\t.5 0 0 .5 1 0 .75 ; right\n}\n");
    row("a first header", "a {\n1 0 0 1 0 0 1\n}\n", recomment, "a { ; new\n1 0 0 1 0 0 1\n}\n");
    row("a header without semicolon", "a {Tony\n1 0 0 1 0 0 1\n}\n", recomment,
        "a {; new\n1 0 0 1 0 0 1\n}\n");
    row("a header on the only line", "a { 1 0 0 1 0 0 1 }\n", recomment, "a { 1 0 0 1 0 0 1 ; new\n }\n");
    const QByteArray notes = "a {\n; one\n1 0 0 1 0 0 1\n ;two\n}\n";
    row(
        "a comment", notes, [](Fractal& f) { f.comments[1] = QStringLiteral("2"); },
        "a {\n; one\n1 0 0 1 0 0 1\n ;2\n}\n");
    row(
        "a comment fewer", notes, [](Fractal& f) { f.comments.removeFirst(); },
        "a {\n1 0 0 1 0 0 1\n ;two\n}\n");
    row(
        "a comment more", notes, [](Fractal& f) { f.comments.insert(1, QStringLiteral("between")); },
        "a {\n; one\n; between\n1 0 0 1 0 0 1\n ;two\n}\n");
    row(
        "a setting", notes, [](Fractal& f) { f.appearance.gamma = 1.5; },
        "a {\n; barycage: version 1\n; barycage: gamma 1.5\n; one\n1 0 0 1 0 0 1\n ;two\n}\n");
    row(
        "a setting changed, strangers kept",
        "a {\n; barycage: tea 5\n; barycage: version 1\n; barycage: gamma 1.5\n1 0 0 1 0 0 1\n}\n",
        [](Fractal& f) { f.appearance.gamma = 2; },
        "a {\n; barycage: tea 5\n; barycage: version 1\n; barycage: gamma 2\n1 0 0 1 0 0 1\n}\n");
    row(
        "a map switched off", "a {\n.5 0 0 .5 0 0 .25\n.5 0 0 .5 1 0 .75\n}\n",
        [](Fractal& f) { mapOf(f, 0).enabled = false; },
        "a {\n; barycage: version 1\n; barycage: off 1 0.25\n.5 0 0 .5 0 0 0\n.5 0 0 .5 1 0 .75\n}\n");
    row("CRLF", "a {\r\n1 0 0 1 0 0 1\r\n}\r\n", appendMap, "a {\r\n1 0 0 1 0 0 1\r\n1 2 3 4 5 6 1\r\n}\r\n");
    row("CR", "a {\r1 0 0 1 0 0 1\r}\r", appendMap, "a {\r1 0 0 1 0 0 1\r1 2 3 4 5 6 1\r}\r");
    row("decimal commas", "a {\n0,5 0 0 0,5 0 0 1\n}\n", setFirst, "a {\n0,25 0 0 0,5 0 0 1\n}\n");
    row("two maps on a line", "a {\n1 0 0 1 0 0 1  .5 0 0 .5 0 0 1\n}\n", removeFirst,
        "a {\n.5 0 0 .5 0 0 1\n}\n");
    row("two maps on a line exchanged", "a {\n1 0 0 1 0 0 1  .5 0 0 .5 0 0 1\n}\n", swapMaps,
        "a {\n.5 0 0 .5 0 0 1  1 0 0 1 0 0 1\n}\n");
    row("a map over two lines", "a {\n1 0 0 1\n 0 0 1\n}\n", setFirst, "a {\n0.25 0 0 1\n 0 0 1\n}\n");
    row(
        "weights where there are none", "a {\n.5 0 0 .5 0 0\n.5 0 0 .5 1 0\n}\n",
        [](Fractal& f) { mapOf(f, 0).weight = mapOf(f, 1).weight = 1; },
        "a {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 1 0 1\n}\n");
}

void FractintEditTest::edits() {
    QFETCH(QByteArray, before);
    QFETCH(Change, change);
    QFETCH(QByteArray, after);
    const EntrySource source = sourceOf(before);
    Fractal fractal = source.fractal;
    change(fractal);
    QCOMPARE(editedText(source, fractal), after);
}

void FractintEditTest::bareFilesGetBracesWhenTheyNeedThem() {
    const EntrySource bare = sourceOf(".5 0 0 .5 0 0 1\n.5 0 0 .5 1 0 1\n");
    QVERIFY(io::fractint::isBare(bare));
    Fractal fractal = bare.fractal;
    mapOf(fractal, 1).map.translation.x() = 2;
    QCOMPARE(editedText(bare, fractal), QByteArray(".5 0 0 .5 0 0 1\n.5 0 0 .5 2 0 1\n"));
    fractal.name = QStringLiteral("named");
    QCOMPARE(editedText(bare, fractal), QByteArray("named {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 2 0 1\n}\n"));
    const EntrySource braced = io::fractint::withBraces(bare);
    QVERIFY(!io::fractint::isBare(braced));
    QVERIFY(braced.text.endsWith(".5 0 0 .5 1 0 1\n}\n"));
}

// They are understood without braces only.
void FractintEditTest::gluedNumbersAreWrittenAfresh() {
    const EntrySource bare = sourceOf("0.50 0.00 0.00 0.50-10.00-20.00 1.00\n");
    const EntrySource braced = io::fractint::withBraces(bare);
    const auto back = io::readFractint(braced.text);
    QCOMPARE(back.entries.size(), 1);
    QVERIFY(document::isSameSystem(*back.entries.first().fractal, bare.fractal));
    QVERIFY(!braced.text.contains("0.50-10"));
}

void FractintEditTest::kindsOfSystemsAreWrittenAfresh() {
    const EntrySource source = sourceOf("a { ; kept\n1 0 0 1 0 0 1\n}\n");
    Fractal fractal = source.fractal;
    document::System3 space;
    ifs::append(space, ifs::AffineMap<3>{}, 1.0);
    fractal.shape = document::Shape<3>{space};
    const QByteArray text = editedText(source, fractal);
    const auto back = io::readFractint(text);
    QVERIFY(document::isSameSystem(*back.entries.first().fractal, fractal));
    QCOMPARE(back.entries.first().fractal->headerComment, QStringLiteral("kept"));
}

void FractintEditTest::latin1StaysLatin1() {
    const EntrySource source = sourceOf("a { ; caf\xe9\n; na\xefve\n1 0 0 1 0 0 1\n}\n");
    Fractal fractal = source.fractal;
    fractal.comments[0] = QStringLiteral("Straße");
    QCOMPARE(editedText(source, fractal), QByteArray("a { ; caf\xe9\n; Stra\xdf"
                                                     "e\n1 0 0 1 0 0 1\n}\n"));
}

// Fractint reads 200 bytes of a line.
void FractintEditTest::longRowsTakeTwoLines() {
    const EntrySource source = sourceOf(solid);
    Fractal changed = source.fractal;
    makeLong(document::system3(changed)->maps[0]);
    QByteArray text = editedText(source, changed);
    QByteArrayList lines = text.split('\n');
    QCOMPARE(lines.size(), 6);
    QCOMPARE(lines[1].simplified().count(' '), 6);
    QVERIFY(lines[2].startsWith("  -") && lines[2].endsWith(" .5 ; left"));
    QCOMPARE(lines[3], source.text.split('\n')[2]);
    readsAs(text, changed);

    ifs::append(*document::system3(changed), document::system3(changed)->maps[0].map, 0.5);
    text = editedText(source, changed);
    lines = text.split('\n');
    QCOMPARE(lines.size(), 8);
    QVERIFY(lines[4].size() < 200 && lines[5].startsWith("  -"));
    readsAs(text, changed);

    const EntrySource unmarked = sourceOf(QByteArray(solid).replace(" (3D)", ""));
    changed = unmarked.fractal;
    makeLong(document::system3(changed)->maps[0]);
    lines = editedText(unmarked, changed).split('\n');
    QCOMPARE(lines.size(), 5); // the thirteen numbers of each line tell the dimension
    QCOMPARE(lines[2], unmarked.text.split('\n')[2]);
}

void FractintEditTest::rowsOnTwoLinesAreMovedWhole() {
    const EntrySource plain = sourceOf(solid);
    Fractal changed = plain.fractal;
    makeLong(document::system3(changed)->maps[0]);
    const EntrySource source = sourceOf(editedText(plain, changed));
    const QByteArrayList lines = source.text.split('\n');

    Fractal swapped = source.fractal;
    std::swap(document::system3(swapped)->maps[0], document::system3(swapped)->maps[1]);
    QCOMPARE(editedText(source, swapped),
             (QByteArrayList{lines[0], lines[3], lines[1], lines[2], lines[4], {}}.join('\n')));
    Fractal without = source.fractal;
    document::system3(without)->maps.erase(document::system3(without)->maps.begin());
    QCOMPARE(editedText(source, without), (QByteArrayList{lines[0], lines[3], lines[4], {}}.join('\n')));
}

void FractintEditTest::longRowsAreWrittenOnTwoLines() {
    Fractal fractal = sourceOf(solid).fractal;
    for (auto& mapOf : document::system3(fractal)->maps)
        makeLong(mapOf);
    const QByteArray text = io::writeEntry(fractal, "\n");
    for (const QByteArray& line : text.split('\n'))
        QVERIFY(line.size() <= 200);
    readsAs(text, fractal);
}

BARYCAGE_TEST(FractintEditTest);
#include "fractint_edit_test.moc"
