// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_entry.h"
#include "support/named_test.h"

#include <QTest>

using namespace io::fractint;

namespace {

ParsedEntry entryOf(const QByteArray& text) {
    const char end = lineEndByte(text);
    return parseEntry(text, relative(*Scanner(text, end).next()), end);
}

ParsedEntry bareEntryOf(const QByteArray& text) {
    Block block;
    block.all = {0, text.size()};
    block.close = text.size();
    return parseEntry(text, block, lineEndByte(text));
}

QByteArray at(const QByteArray& text, Span span) {
    return text.mid(span.begin, span.size());
}

} // namespace

class FractintEntryTest : public QObject {
    Q_OBJECT

private slots:
    void numbersStandWhereTheyAre();
    void coefficientsGoRowByRow();
    void spatialCoefficientsGoRowByRow();
    void commentsHaveTheirPlaces();
    void headers_data();
    void headers();
    void bareFilesComeApart();
    void carriageReturnsEndLines();
    void problemsAreRelativeToTheText();
    void problemsAreLimited();
    void limits();
    void textIsDecoded();
};

void FractintEntryTest::numbersStandWhereTheyAre() {
    const QByteArray text = "a { ; head\n ; note 1\n .5 0 0\n+.5 0 0 2.5e-1 ; tail 9\n\n 1,2 }";
    const QByteArray fitting = QByteArray(text).replace(" 1,2 ", "");
    const Layout layout = entryOf(fitting).layout;
    QCOMPARE(layout.rowLength, 7);
    QByteArrayList tokens;
    QList<int> lines;
    for (const Token& token : layout.numbers) {
        tokens << at(fitting, token.span);
        lines << token.line;
    }
    QCOMPARE(tokens.join(' '), QByteArray(".5 0 0 +.5 0 0 2.5e-1"));
    QCOMPARE(lines, (QList<int>{2, 2, 2, 3, 3, 3, 3}));
    QCOMPARE(layout.numbers[6].value, .25);
    // With one comma, the number of numbers fits neither reading.
    QCOMPARE(entryOf(text).layout.rowLength, 0);
}

void FractintEntryTest::coefficientsGoRowByRow() {
    const auto system = *document::system2(entryOf("a {\n1 2 3 4 5 6 7\n}").fractal);
    QVERIFY(system.maps[0].map == ifs::affineMap(1, 2, 3, 4, 5, 6));
    const ifs::Vector<2> image = system.maps[0].map({10, 100}); // x' = ax + by + e, y' = cx + dy + f
    QCOMPARE(image.x(), 215.);
    QCOMPARE(image.y(), 436.);
    QVERIFY(system.maps[0].weight == 7.);
    const auto six = *document::system2(entryOf("a {\n1 2 3 4 5 6\n}").fractal);
    QVERIFY(!six.maps[0].weight);
}

void FractintEntryTest::spatialCoefficientsGoRowByRow() {
    const auto parsed = entryOf("a (3D) {\n1 2 3 4 5 6 7 8 9 10 11 12 .5\n}");
    const auto system = *document::system3(parsed.fractal);
    QVERIFY(system.maps[0].map.linear == (ifs::Matrix<3>() << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished());
    QVERIFY(system.maps[0].map.translation == ifs::Vector<3>(10, 11, 12));
    QVERIFY(system.maps[0].weight == .5);
}

void FractintEntryTest::commentsHaveTheirPlaces() {
    const QByteArray text =
        "a {  ;  head \n; one\n1 0 0 1 0 0 1 ; beside a map\n  ; barycage: gamma 1.5\n;barycage: tea 5\n;\n}";
    const ParsedEntry entry = entryOf(text);
    QCOMPARE(entry.fractal.headerComment, QStringLiteral("head"));
    QCOMPARE(at(text, entry.layout.headerComment), QByteArray("head"));
    QCOMPARE(entry.fractal.comments, (QStringList{QStringLiteral("one"), QString()}));
    QCOMPARE(entry.fractal.appearance.gamma, 1.5);
    const auto& comments = entry.layout.comments;
    QCOMPARE(comments.size(), 4u);
    QCOMPARE(at(text, comments[0].line), QByteArray("; one\n"));
    QCOMPARE(at(text, comments[0].text), QByteArray("one"));
    QVERIFY(!comments[0].isOwn && comments[1].isOwn && comments[1].isUnderstood);
    QVERIFY(comments[2].isOwn && !comments[2].isUnderstood && !comments[3].isOwn);
    QCOMPARE(entry.problems.size(), 1);
    QCOMPARE(entry.problems[0].line, 5);
}

void FractintEntryTest::headers_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("comment");
    QTest::addColumn<int>("maps");
    QTest::addColumn<bool>("isSpatial");
    const auto row = [](const char* name, const char* text, const char* comment, int maps, bool isSpatial) {
        QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(comment) << maps << isSpatial;
    };
    row("nothing", "a {\n1 0 0 1 0 0 1\n}", "", 1, false);
    row("words without a semicolon", "a {Tony 23/1/2004\n1 0 0 1 0 0 1\n}", "Tony 23/1/2004", 1, false);
    row("numbers the body needs", "a { 1 0 0 1 ; x\n0 0 1\n}", "x", 1, false);
    row("numbers nobody needs", "a { 1 0 0 1\n1 0 0 1 0 0 1\n}", "1 0 0 1", 1, false);
    row("all on one line", "a { 1 0 0 1 0 0 1 }", "", 1, false);
    row("all on one line, commented", "a { 1 0 0 1 0 0 1 ; }\n}", "}", 1, false);
    row("marked", "a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}", "", 1, true);
    row("marked behind the brace", "a { (3d) x\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}", "x", 1, true);
    row("marked in the name", "3dfern(3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}", "", 1, true);
    row("marked in the comment", "a { ; (3D)\n1 0 0 1 0 0 1\n}", "(3D)", 1, false);
}

void FractintEntryTest::headers() {
    QFETCH(QByteArray, text);
    QFETCH(QString, comment);
    QFETCH(int, maps);
    QFETCH(bool, isSpatial);
    const ParsedEntry entry = entryOf(text);
    QCOMPARE(entry.fractal.headerComment, comment);
    const auto* plane = document::system2(entry.fractal);
    const auto* space = document::system3(entry.fractal);
    QVERIFY(isSpatial ? space && int(space->maps.size()) == maps : plane && int(plane->maps.size()) == maps);
    QVERIFY(entry.layout.headerEnd <= entry.layout.block.close);
    QVERIFY(entry.layout.bodyBegin <= entry.layout.block.close);
}

// "%6.2f" of the editor of Fractint 10–18 left no blank in front of a minus sign.
void FractintEntryTest::bareFilesComeApart() {
    const QByteArray text = "  0.50  0.00  0.00  0.50-10.00-20.00  0.50\n 0.50 0 0 .5 1e-2+3 .50\n";
    const ParsedEntry entry = bareEntryOf(text);
    const auto system = *document::system2(entry.fractal);
    QVERIFY(system.maps[0].map == ifs::affineMap(.5, 0, 0, .5, -10, -20));
    QVERIFY(system.maps[1].map == ifs::affineMap(.5, 0, 0, .5, 1e-2, 3)); // an exponent stays in one piece
    QCOMPARE(entry.fractal.name, QStringLiteral("unnamed"));
    QVERIFY(entry.problems.isEmpty());
    // In an entry with braces, two numbers in one token are no number.
    QCOMPARE(entryOf("a {\n" + text + "}").layout.rowLength, 0);
}

void FractintEntryTest::carriageReturnsEndLines() {
    for (const char* lineEnd : {"\n", "\r\n", "\r"}) {
        const QByteArray text =
            QByteArray("a { ; head\n; note\n1 0 0 1 0 0 1 ; 2\n1 0 0 1 5 0 1\n}").replace("\n", lineEnd);
        const ParsedEntry entry = entryOf(text);
        QCOMPARE(document::system2(entry.fractal)->maps.size(), 2u);
        QCOMPARE(entry.fractal.headerComment, QStringLiteral("head"));
        QCOMPARE(entry.fractal.comments, QStringList{QStringLiteral("note")});
        QCOMPARE(entry.layout.numbers[7].line, 3);
    }
}

void FractintEntryTest::problemsAreRelativeToTheText() {
    const ParsedEntry entry = entryOf("a {\n1 0 0 1 0 0 1\n  1 0 0 1/3 0 0 1\n}");
    QCOMPARE(entry.problems.size(), 1);
    QCOMPARE(entry.problems[0].entry, QStringLiteral("a"));
    QCOMPARE(entry.problems[0].line, 3);
    QCOMPARE(entry.problems[0].column, 9);
    QVERIFY(entry.problems[0].severity == document::Problem::Severity::Error);
    QVERIFY(entry.problems[0].message.contains(QStringLiteral("1/3")));
    QVERIFY(document::dimension(entry.fractal) == 0);
}

void FractintEntryTest::problemsAreLimited() {
    const ParsedEntry entry = entryOf("a {\n" + QByteArray("x ").repeated(35) + "\n}");
    QCOMPARE(entry.problems.size(), maxProblems + 1);
    QVERIFY(entry.problems.last().message.contains(QStringLiteral("25")));
}

void FractintEntryTest::limits() {
    const QByteArray map = "1 0 0 1 0 0 1\n";
    const auto maps = [](const ParsedEntry& entry) {
        const auto* plane = document::system2(entry.fractal);
        return plane ? plane->maps.size() : 0;
    };
    QCOMPARE(maps(entryOf("a {\n" + map.repeated(qsizetype(maxMaps)) + "}")), maxMaps);
    QCOMPARE(maps(entryOf("a {\n" + map.repeated(qsizetype(maxMaps) + 1) + "}")), 0u);
    const ParsedEntry long1 = entryOf("a {\n" + map + QByteArray("\n").repeated(qsizetype(maxLines)) + "}");
    QCOMPARE(maps(long1), 0u);
    QCOMPARE(long1.problems.size(), 1);
}

void FractintEntryTest::textIsDecoded() {
    QCOMPARE(decoded("caf\xc3\xa9"), QStringLiteral("café"));
    QCOMPARE(decoded("caf\xe9"), QStringLiteral("café"));
    QCOMPARE(decoded(""), QString());
    QCOMPARE(entryOf("\xe9t\xe9 {\n}").fractal.name, QStringLiteral("été"));
}

BARYCAGE_TEST(FractintEntryTest);
#include "fractint_entry_test.moc"
