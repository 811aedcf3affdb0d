// SPDX-License-Identifier: MIT
#include "io/exchange/entry_link.h"

#include "io/collection_reader.h"
#include "io/fractint/entry_writer.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QTest>

#include <zlib.h>

using namespace Qt::StringLiterals;

// Entries in links: app/web/page/link.js reads and writes the same, for tests/web/page_test.mjs.
class EntryLinkTest : public QObject {
    Q_OBJECT

private slots:
    void entriesComeBackAsTheyWere();
    void addressesOfPagesAreRead_data();
    void addressesOfPagesAreRead();
    void otherTextsAreNoLinks_data();
    void otherTextsAreNoLinks();
    void whereverItIsCutOffItSaysSo();
    void damageIsSaid_data();
    void damageIsSaid();
    void whatUnpacksToTooMuchIsRefused();
    void entriesTooLongForALinkAreRefused();
};

namespace {

QByteArray packed(QByteArray text) {
    QByteArray bytes(qsizetype(compressBound(uLong(text.size()))) + 64, Qt::Uninitialized);
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(text.data());
    stream.avail_in = uInt(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = uInt(bytes.size());
    deflate(&stream, Z_FINISH);
    bytes.truncate(qsizetype(stream.total_out));
    deflateEnd(&stream);
    return bytes;
}

QByteArray inBase64(const QByteArray& bytes) {
    return bytes.toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals);
}

constexpr auto triangle = "triangle {\n  .5 0 0 .5 0 0\n  .5 0 0 .5 .5 0\n  .5 0 0 .5 .25 .5\n}\n";

QByteArray link() {
    return "barycage:" + inBase64(packed(triangle));
}

QString failureOf(const QByteArray& text) {
    return io::readLink(text).failure.value_or(QString());
}

QString namesIn(const QByteArray& text) {
    const io::Collection collection = io::readCollection(text);
    QStringList names{collection.format};
    for (const document::Entry& entry : collection.file.entries)
        names << entry.fractal->name;
    return names.join(u' ');
}

} // namespace

void EntryLinkTest::entriesComeBackAsTheyWere() {
    int count = 0;
    for (const char* file : {"paper", "linked", "space_sponges"}) {
        QFile collection(support::sourcePath(u"ifs_library/%1.ifs"_s.arg(QLatin1String(file))));
        QVERIFY(collection.open(QIODevice::ReadOnly));
        const io::Collection read = io::readCollection(collection.readAll());
        for (const document::Entry& entry : read.file.entries) {
            const io::WrittenLink written = io::linkOf(*entry.fractal);
            QVERIFY(!written.failure);
            QVERIFY(written.link.startsWith("barycage:"));
            QVERIFY(io::looksLikeLink(written.link));
            QCOMPARE(io::readLink(written.link).text, io::writeEntry(*entry.fractal));
            QCOMPARE(namesIn(written.link), u"link "_s + entry.fractal->name);
            ++count;
        }
    }
    QVERIFY(count > 20);
}

void EntryLinkTest::addressesOfPagesAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    const QByteArray data = inBase64(packed(triangle));
    QTest::newRow("of the program") << "barycage:" + data;
    QTest::newRow("of the program, with a mark") << "barycage:#" + data;
    QTest::newRow("of a page") << "https://example.org/figures/maple.html?a=b#" + data;
    QTest::newRow("of a file") << "file:///home/somebody/maple.html#" + data;
    QTest::newRow("between blanks") << " \n barycage:" + data + "\r\n";
    QTest::newRow("broken by a mail program")
        << "https://example.org/maple.html#" + data.first(20) + "\r\n" + data.sliced(20);
}

void EntryLinkTest::addressesOfPagesAreRead() {
    QFETCH(QByteArray, text);
    QCOMPARE(failureOf(text), QString());
    QCOMPARE(io::readLink(text).text, QByteArray(triangle));
    QCOMPARE(namesIn(text), u"link triangle"_s);
}

void EntryLinkTest::otherTextsAreNoLinks_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("a collection") << QByteArray(triangle);
    QTest::newRow("an entry whose name begins so") << QByteArray("barycage:a {\n .5 0 0 .5 0 0 1\n}\n");
    QTest::newRow("a comment of ours") << QByteArray("barycage: rest 0 0");
    QTest::newRow("the scheme alone") << QByteArray("barycage:");
    QTest::newRow("an address without a mark") << QByteArray("https://example.org/maple.html");
    QTest::newRow("a mark that is no data") << QByteArray("https://example.org/#/way/of/some/page");
    QTest::newRow("a sentence") << QByteArray("see https://example.org/maple.html#abcd");
}

void EntryLinkTest::otherTextsAreNoLinks() {
    QFETCH(QByteArray, text);
    QVERIFY(!io::looksLikeLink(text));
    QVERIFY(io::readCollection(text).format != u"link");
}

void EntryLinkTest::whereverItIsCutOffItSaysSo() {
    const QByteArray whole = link();
    const qsizetype begin = QByteArray("barycage:").size();
    for (qsizetype size = begin + 3; size < whole.size() - 1; ++size) {
        const QString said = failureOf(whole.first(size));
        QVERIFY2(said.contains(u"cut off"), qPrintable(u"%1: %2"_s.arg(size).arg(said)));
    }
    const io::Collection collection = io::readCollection(whole.first(40));
    QCOMPARE(collection.file.entries.size(), 0);
    QCOMPARE(collection.file.problems.size(), 1);
}

void EntryLinkTest::damageIsSaid_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("other letters") << link() + "!";
    QTest::newRow("more behind its end") << link() + "AAAA";
    QTest::newRow("no deflated text") << QByteArray("barycage:") + inBase64(QByteArray(40, '\xff'));
}

void EntryLinkTest::damageIsSaid() {
    QFETCH(QByteArray, text);
    QCOMPARE(failureOf(text), u"This link is damaged, or it holds no fractal."_s);
    QVERIFY(io::readLink(text).text.isEmpty());
}

void EntryLinkTest::whatUnpacksToTooMuchIsRefused() {
    const auto of = [](qsizetype size) { return "barycage:" + inBase64(packed(QByteArray(size, ' '))); };
    QCOMPARE(io::readLink(of(io::maxLinkedText)).text.size(), io::maxLinkedText);
    QVERIFY(failureOf(of(io::maxLinkedText + 1)).contains(u"1 MB"));
    QVERIFY(failureOf("barycage:" + QByteArray(3 * io::maxLinkedText, 'A')).contains(u"1 MB"));
}

void EntryLinkTest::entriesTooLongForALinkAreRefused() {
    document::Fractal fractal;
    document::Shape<2> shape;
    for (int i = 0; i < 30'000; ++i)
        ifs::append(shape.system,
                    ifs::AffineMap<2>{ifs::Matrix<2>::Identity() / 3.0, {1.0 / (i + 3), 1.0 / 7}});
    fractal.shape = shape;
    QCOMPARE(io::linkObstacle(fractal), QString());
    const io::WrittenLink written = io::linkOf(fractal);
    QVERIFY(written.link.isEmpty());
    QVERIFY(written.failure.value_or(QString()).contains(u"1 MB"));
    fractal.shape = std::monostate();
    QVERIFY(!io::linkObstacle(fractal).isEmpty());
}

BARYCAGE_TEST(EntryLinkTest);
#include "entry_link_test.moc"
