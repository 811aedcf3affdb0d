// SPDX-License-Identifier: MIT
#include "notation/rows/scanner.h"
#include "support/named_test.h"

#include <QTest>

#include <random>

using namespace notation;

namespace {

QByteArray textAt(const QByteArray& bytes, Span span) {
    return bytes.mid(span.begin, span.size());
}

const char* nameOf(BlockKind kind) {
    switch (kind) {
    case BlockKind::Entry:
        return "entry";
    case BlockKind::Unclosed:
        return "unclosed";
    case BlockKind::Unnamed:
        return "unnamed";
    case BlockKind::CommentBlock:
        return "comment";
    case BlockKind::OtherType:
        return "other";
    case BlockKind::TwoBraces:
        return "two braces";
    }
    return "";
}

// "kind <name> begin-end" of every block.
QByteArray summary(const QByteArray& bytes) {
    QByteArrayList blocks;
    Scanner scanner(bytes, lineEndByte(bytes));
    while (const auto block = scanner.next())
        blocks << nameOf(block->kind) + QByteArray(block->hasPrefix ? " ifs:<" : " <") +
                      textAt(bytes, block->name) + "> " + QByteArray::number(block->all.begin) + '-' +
                      QByteArray::number(block->all.end);
    return blocks.join("; ");
}

} // namespace

class ScannerTest : public QObject {
    Q_OBJECT

private slots:
    void blocks_data();
    void blocks();
    void bracesAreWhereTheyAre();
    void relativeBlocksBeginAtZero();
    void lineEnds();
    void blanks();
    void scanningGoesOnFromAnywhere();
    void blocksAreInOrderAndInside();
};

void ScannerTest::blocks_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const QByteArray& bytes, const char* expected) {
        QTest::newRow(name) << bytes << QByteArray(expected);
    };
    row("nothing", "", "");
    row("free text", "some words\nmore of them\n", "");
    row("comments only", "; a { 1 }\n  ; b { 2 }", "");
    row("plain", "a {\n1\n}\n", "entry <a> 0-8");
    row("two", "a {\n1\n}\nb {\n}\n", "entry <a> 0-8; entry <b> 8-14");
    row("CRLF", "a {\r\n1\r\n}\r\nb {\r\n}\r\n", "entry <a> 0-11; entry <b> 11-19");
    row("CR", "a {\r1\r}\rb {\r}\r", "entry <a> 0-8; entry <b> 8-14");
    row("no last line end", "a {\n1\n}", "entry <a> 0-7");
    row("byte order mark",
        "\xef\xbb\xbf"
        "a {\n}\n",
        "entry <\xef\xbb\xbf"
        "a> 0-9");
    row("after a heading", "A title\n\na {\n}\n", "entry <a> 9-15");
    // The name: up to a parenthesis, a semicolon or the brace, without blanks around it.
    row("glued", "a{\n}\n", "entry <a> 0-5");
    row("marker", "a (3D) {\n}\n", "entry <a> 0-11");
    row("marker glued", "a(3d){\n}\n", "entry <a> 0-9");
    row("blanks inside", "New Top Design {\n}\n", "entry <New Top Design> 0-19");
    row("odd signs",
        "!?&'^_\xe9"
        "7 {\n}\n",
        "entry <!?&'^_\xe9"
        "7> 0-13");
    row("on the closing line", "a {\n} b {\n}\n", "entry <a> 0-5; entry <b> 6-12");
    row("free text on the closing line", "a {\n} the end\nb {\n}\n", "entry <a> 0-5; entry <b> 14-20");
    row("comment on the closing line", "a {\n} ; no } end {\nb {\n}\n", "entry <a> 0-19; entry <b> 19-25");
    row("lone closing braces", "} }\na {\n}\n", "entry <a> 4-10");
    row("closing brace before the name", "x } a {\n}\n", "entry <a> 4-10");
    // The brace on the line below: only under a lone name.
    row("brace below", "a\n{\n}\n", "entry <a> 0-6");
    row("brace below, marker above", "a (3D)\n\n{\n}\n", "entry <a> 0-12");
    row("brace below, marker beside it", "a\n(3D) {\n}\n", "entry <a> 0-11");
    row("brace below a sentence", "a b\n{\n}\n", "unnamed <> 4-8");
    row("brace below a comment", "a ; c {\n{\n}\n", "entry <a> 0-12");
    row("words beside the brace below", "a\nb {\n}\n", "entry <b> 2-8");
    // Kinds.
    row("unnamed", "{\n}\n", "unnamed <> 0-4");
    row("comment block", "COMMENT {\n a { b\n}\n", "comment <COMMENT> 0-19");
    row("comment in a name", "comments {\n}\n", "entry <comments> 0-13");
    row("prefix", "IFS:a {\n}\n", "entry ifs:<a> 0-10");
    row("prefix and blanks", "ifs: a {\n}\n", "entry ifs:<a> 0-11");
    row("other types", "frm:a {\n}\nPAR:b {\n}\nlsys:c {\n}\n",
        "other <frm:a> 0-10; other <PAR:b> 10-20; other <lsys:c> 20-31");
    // Where an entry ends.
    row("brace in a comment", "a { ; }\n ; { }\n1 ; }\n}\n", "entry <a> 0-23");
    row("end of file", "a {\n1\n", "unclosed <a> 0-6");
    row("end of file in a comment", "a {\n1 ; }", "unclosed <a> 0-9");
    row("next entry", "a {\n1\nb {\n2\n}\n", "unclosed <a> 0-6; entry <b> 6-14");
    row("next entry, brace below", "a {\n1\nb\n{\n2\n}\n", "unclosed <a> 0-6; entry <b> 6-14");
    row("two braces on the first line", "a { b {\n1\n}\nc {\n}\n", "two braces <a> 0-8; entry <c> 12-18");
    row("^Z between",
        "a {\n}\n\x1a"
        "b {\n}\n",
        "entry <a> 0-6; entry <b> 7-13");
}

void ScannerTest::blocks() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, expected);
    QCOMPARE(summary(bytes), expected);
}

void ScannerTest::bracesAreWhereTheyAre() {
    const QByteArray bytes = "x\na ; {\n(3D) {\n1 ; }\n } ; end\nb { 2";
    Scanner scanner(bytes, '\n');
    const auto a = scanner.next();
    QVERIFY(a && bytes[a->open] == '{' && bytes[a->close] == '}');
    QCOMPARE(a->open, bytes.indexOf("{\n1"));
    QCOMPARE(a->close, bytes.indexOf("} ; end"));
    QCOMPARE(textAt(bytes, a->all), bytes.mid(2, 28));
    const auto b = scanner.next();
    QVERIFY(b && b->kind == BlockKind::Unclosed && bytes[b->open] == '{');
    QCOMPARE(b->close, bytes.size());
    QVERIFY(!scanner.next());
}

void ScannerTest::relativeBlocksBeginAtZero() {
    const QByteArray bytes = "head\n\nifs:name {\n1\n}\n";
    const Block block = *Scanner(bytes, '\n').next();
    const Block own = relative(block);
    const QByteArray text = textAt(bytes, block.all);
    QCOMPARE(own.all.begin, 0);
    QCOMPARE(own.all.size(), block.all.size());
    QCOMPARE(textAt(text, own.name), QByteArray("name"));
    QVERIFY(text[own.open] == '{' && text[own.close] == '}');
    Block bare;
    bare.all = {3, 9};
    bare.close = 9;
    QCOMPARE(relative(bare).open, -1); // there is no brace to move
    QCOMPARE(relative(bare).close, 6);
}

void ScannerTest::lineEnds() {
    QCOMPARE(lineEndByte("a\nb"), '\n');
    QCOMPARE(lineEndByte("a\r\nb"), '\n');
    QCOMPARE(lineEndByte("a\rb"), '\r');
    QCOMPARE(lineEndByte("ab"), '\n');
    QCOMPARE(lineEnd("ab\ncd", 0, '\n'), 2);
    QCOMPARE(lineEnd("ab\ncd", 2, '\n'), 2);
    QCOMPARE(lineEnd("ab\ncd", 3, '\n'), 5);
    QCOMPARE(lineEnd("ab\rcd", 0, '\n'), 5);
}

void ScannerTest::blanks() {
    QByteArray found;
    for (int c = 0; c < 256; ++c)
        if (isBlank(char(c))) found += char(c);
    QCOMPARE(found, QByteArray("\0\t\n\v\f\r\x1a ", 8));
}

void ScannerTest::scanningGoesOnFromAnywhere() {
    const QByteArray bytes = "a {\n}\nb {\n}\nc {\n}\n";
    Scanner scanner(bytes, '\n', 6);
    QCOMPARE(textAt(bytes, scanner.next()->name), QByteArray("b"));
    QVERIFY(!Scanner(bytes, '\n', bytes.size()).next());
}

// Whatever the bytes: blocks follow each other without overlap, and everything in them is inside.
void ScannerTest::blocksAreInOrderAndInside() {
    std::mt19937 random(11);
    const QByteArray letters = "ab{{}};\n\n\r (3D) 1.\x1a:";
    for (int trial = 0; trial < 20'000; ++trial) {
        QByteArray bytes;
        for (unsigned length = random() % 60; length > 0; --length)
            bytes += letters[qsizetype(random() % unsigned(letters.size()))];
        Scanner scanner(bytes, lineEndByte(bytes));
        qsizetype done = 0;
        while (const auto block = scanner.next()) {
            QVERIFY2(block->all.begin >= done && block->all.end > block->all.begin &&
                         block->all.end <= bytes.size(),
                     bytes.toPercentEncoding().constData());
            done = block->all.end;
            QVERIFY(block->all.begin <= block->name.begin && block->name.begin <= block->name.end &&
                    block->name.end <= block->open && bytes[block->open] == '{');
            QVERIFY(block->open < block->close && block->close <= block->all.end);
            const bool isClosed = block->kind != BlockKind::Unclosed && block->kind != BlockKind::TwoBraces;
            QVERIFY(!isClosed || bytes[block->close] == '}');
        }
    }
}

BARYCAGE_TEST(ScannerTest);
#include "scanner_test.moc"
