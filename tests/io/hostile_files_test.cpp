// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "io/palette/palette_reader.h"
#include "io/picture/png/png_system.h"
#include "io/picture/vector/svg_system.h"
#include "support/named_test.h"
#include "support/thorough.h"

#include <QElapsedTimer>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <chrono>
#include <random>

#include <sys/resource.h>
#include <zlib.h>

using document::FractalFile;
using namespace std::chrono_literals;

// Files that cost as much as a file can. Memory is limited to 2 GB for the whole of this program, and
// whatever grows with the square of the size never ends here.
class HostileFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void hugeFiles_data();
    void hugeFiles();
    void manyMapsInEveryFormat_data();
    void manyMapsInEveryFormat();
    void manyEntriesOfOneName();
    void manyFlamesOfOneName();
    void aCompressedTextDoesNotGrowWithoutEnd();
    void aLinkIsNotUnpackedBeyondItsLimit();
    void hugePalettes();
    void nestedListsTakeNoLonger_data();
    void nestedListsTakeNoLonger();
};

namespace {

// In bytes: beyond every limit of a number of entries, rows or maps; beyond that of a text, too.
// Bytes, beyond the limit on a file.
const qsizetype huge = support::isThorough() ? 100'000'000 : 68'000'000;

constexpr qsizetype tableOrXml = 60'000'000; // bytes: below the limit on such files

// Bytes of so many pieces that every limit on entries, maps and lines is met; or as many as are asked for.
qsizetype many(const QByteArray& piece, qsizetype all = 100'000'000) {
    if (support::isThorough()) return all;
    return std::clamp<qsizetype>(1'100'000 * piece.size(), 5'000'000, 24'000'000);
}

// The same for the limits on entries and rows of tables, which are lower.
qsizetype fewer(const QByteArray& piece, qsizetype all = 100'000'000) {
    return support::isThorough() ? all : 300'000 * piece.size();
}

QByteArray filled(const QByteArray& beginning, const QByteArray& piece, qsizetype size = huge) {
    QByteArray bytes = beginning;
    bytes.reserve(size + piece.size());
    const QByteArray block = piece.repeated(std::max<qsizetype>(1, 65536 / piece.size()));
    while (bytes.size() < size)
        bytes += block;
    return bytes;
}

QByteArray noise() {
    std::mt19937_64 random(1);
    QByteArray bytes(many({}), Qt::Uninitialized);
    for (char& c : bytes)
        c = char(random());
    return bytes;
}

// Rows of hugeFiles() of which another row meets the same limit in the same reader.
bool isLikeAnother(const QByteArray& row) {
    return QByteArrayList{"an entry of wide rows", "an entry of commas",    "an entry of comments",
                          "an entry of our lines", "an entry of line ends", "a picture of text"}
        .contains(row);
}

QString everythingSaid(const FractalFile& file) {
    QStringList said;
    for (const auto& problem : file.problems)
        said << problem.message;
    for (const auto& entry : file.entries.first(std::min<qsizetype>(file.entries.size(), 10)))
        for (const auto& problem : entry.problems)
            said << problem.message;
    return said.join(u'\n');
}

} // namespace

void HostileFilesTest::initTestCase() {
#if !defined(__SANITIZE_ADDRESS__)
    const rlimit twoGigabytes{2UL << 30, 2UL << 30};
    QCOMPARE(setrlimit(RLIMIT_AS, &twoGigabytes), 0);
#endif
}

void HostileFilesTest::hugeFiles_data() {
    QTest::addColumn<QByteArray>("beginning");
    QTest::addColumn<QByteArray>("piece");
    QTest::addColumn<QByteArray>("end");
    QTest::addColumn<qsizetype>("size");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& beginning, const QByteArray& piece,
                        const QByteArray& end, const char* says, qsizetype size = 0) {
        if (isLikeAnother(name) && !support::isThorough()) return;
        QTest::newRow(name) << beginning << piece << end << (size > 0 ? size : many(piece))
                            << QString::fromUtf8(says);
    };
    row("line ends", "", "\n", "", "No iterated function system", huge);
    row("zeros", "", QByteArray(1, '\0'), "", "binary");
    row("noise", "", "", "", "binary");
    row("one word", "", "a", "", "No iterated function system");
    row("words", "", "a\n", "", "the limit is 64 MB", huge);
    row("opening braces", "", "a{", "", "No iterated function system");
    row("closing braces", "a{", "}", "", "no numbers");
    row("entries", "", "a{}\n", "", "more than 200000 entries", fewer("a{}\n"));
    row("wrong entries", "", "a{\n1\n}\n", "", "each map has 7", fewer("a{\n1\n}\n"));
    row("an entry of rows", "a {\n", ".5 0 0 .5 0 0 1\n", "}", "more than 1000000 lines");
    row("an entry of wide rows", "a {\n",
        ".5 0 0 .5 0 0 1 .5 0 0 .5 0 0 1 .5 0 0 .5 0 0 1 .5 0 0 .5 0 0 1 .5 0 0 .5 0 0 1 "
        ".5 0 0 .5 0 0 1 .5 0 0 .5 0 0 1\n",
        "}", "more than 250000 maps");
    row("an entry of one line", "a {\n", "1 ", "}", "more than 250000 maps");
    row("an entry of commas", "a {\n", "1,", "}", "more than 250000 maps");
    row("an entry of line ends", "a {\n", "\n", "}", "more than 1000000 lines");
    row("an entry of comments", "a {\n", ";\n", "}", "more than 1000000 lines");
    row("an entry of our lines", "a {\n", "; barycage: rest 0 0\n", "}", "more than 1000000 lines");
    row("a header without end", "a { ;", "x", "", "no closing");
    row("bare numbers", "", "1 ", "", "more than 250000 maps");
    row("bare lines", "", "1 2 3\n", "", "more than 1000000 lines");
    row("a table of one row", "", "1,", "", "No iterated function system", many("1,", tableOrXml));
    row("a table of rows", "", "1,0,0,1,0,0,1\n", "", "more than 250000 rows",
        fewer("1,0,0,1,0,0,1\n", tableOrXml));
    row("a table of line ends", ",", "\n", "", "No iterated function system", many("\n", tableOrXml));
    row("flames", "<flames>", "<flame name='a'/>", "", "limit for XML", huge);
    row("flames to be read", "<flames>", "<flame name='a'/>", "</flames>", "more than 200000 flames",
        many("<flame name='a'/>", tableOrXml));
    row("a video of boxes",
        QByteArray("\0\0\0\x0c"
                   "ftypisom",
                   12),
        QByteArray("\0\0\0\x08"
                   "free",
                   8),
        "", "contains no system");
    row("a video of elements", QByteArray("\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\xff", 10),
        "\x12\x54\xc3\x67\x80", "", "contains no system");
    row("a video of comments", QByteArray("GIF89a\1\0\1\0\0\0\0", 13), QByteArray("!\xfe\x01x\0", 5), "",
        "contains no system");
    row("a picture of text", "<svg><system xmlns='urn:barycage:system:1'>", "a { }\n", "", "limit for XML",
        huge);
    row("a picture to be read", "<svg><system xmlns='urn:barycage:system:1'>", "a { }\n", "</system></svg>",
        "larger than 8 MB", support::isThorough() ? tableOrXml : 24'000'000);
}

void HostileFilesTest::hugeFiles() {
    QFETCH(QByteArray, beginning);
    QFETCH(QByteArray, piece);
    QFETCH(QByteArray, end);
    QFETCH(qsizetype, size);
    QFETCH(QString, says);
    const QByteArray bytes = piece.isEmpty() ? noise() : filled(beginning, piece, size) + end;
    const FractalFile file = io::readCollection(bytes, QStringLiteral("huge.ifs")).file;
    const QString said = everythingSaid(file);
    QVERIFY2(said.contains(says), qPrintable(said.left(2000)));
}

void HostileFilesTest::manyMapsInEveryFormat_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("maps");
    const int count = 100'000;
    QTest::newRow("Fractint") << "a {\n" + QByteArray(".5 0 0 .5 0 0 1\n").repeated(count) + "}\n" << count;
    QTest::newRow("table") << QByteArray(".5,0,0,.5,0,0,1\n").repeated(count) << count;
    QTest::newRow("flame")
        << "<flame name='a'>" +
               QByteArray("<xform weight='1' linear='1' coefs='.5 0 0 .5 0 0'/>").repeated(count) + "</flame>"
        << count;
}

void HostileFilesTest::manyMapsInEveryFormat() {
    QFETCH(QByteArray, text);
    QFETCH(int, maps);
    const FractalFile file = io::readCollection(text).file;
    QCOMPARE(file.entries.size(), 1);
    const auto* system = document::system2(*file.entries.first().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t(maps));
    QVERIFY(system->maps.back().id == ifs::MapId(maps)); // each has its own
    const FractalFile back = io::readFractint(io::writeFractint(file));
    QCOMPARE(document::system2(*back.entries.first().fractal)->maps.size(), std::size_t(maps));
}

void HostileFilesTest::manyEntriesOfOneName() {
    constexpr int count = 100'000;
    const FractalFile file = io::readFractint(QByteArray("a { .5 0 0 .5 0 0 1 }\n").repeated(count));
    QCOMPARE(file.entries.size(), count);
    const io::StrictText strict = io::writeStrict(file); // which gives each a name of its own
    QCOMPARE(strict.bytes.count('{'), count);
    QVERIFY(strict.bytes.contains("a_100000 {"));
}

void HostileFilesTest::manyFlamesOfOneName() {
    constexpr int count = 100'000;
    const QByteArray flame = "<flame name='a'><xform weight='1' linear='1' coefs='.5 0 0 .5 0 0'/></flame>";
    const FractalFile file = io::readCollection("<flames>" + flame.repeated(count) + "</flames>").file;
    QCOMPARE(file.entries.size(), count);
    QCOMPARE(file.entries.last().fractal->name, QStringLiteral("a_100000"));
    // Each refused one is counted, not each is listed.
    const FractalFile refused =
        io::readCollection("<flames>" + QByteArray("<flame name='a'/>").repeated(count) + "</flames>").file;
    QVERIFY(refused.problems.size() < 200);
    QVERIFY2(everythingSaid(refused).contains(QStringLiteral("100000 flames")),
             qPrintable(everythingSaid(refused)));
}

void HostileFilesTest::aCompressedTextDoesNotGrowWithoutEnd() {
    const auto chunk = [](const QByteArray& type, const QByteArray& data) {
        QByteArray bytes(4, '\0');
        qToBigEndian(quint32(data.size()), bytes.data());
        bytes += type + data;
        QByteArray sum(4, '\0');
        const QByteArray summed = type + data;
        qToBigEndian(
            quint32(crc32(0, reinterpret_cast<const Bytef*>(summed.constData()), uInt(summed.size()))),
            sum.data());
        return bytes + sum;
    };
    const auto picture = [&](qsizetype size, const QByteArray& more = {}) {
        const QByteArray packed = qCompress(QByteArray(size, ' ')).sliced(4);
        return "\x89PNG\r\n\x1a\n" + chunk("IHDR", QByteArray("\0\0\0\1\0\0\0\1\x08\0\0\0\0", 13)) +
               chunk("iTXt", QByteArray("Barycage\0\1\0\0\0", 13) + packed) + more +
               chunk("IDAT", qCompress(QByteArray(2, '\0')).sliced(4)) + chunk("IEND", {});
    };
    QCOMPARE(io::readPngSystem(picture(1000)).text.size(), 1000);
    QVERIFY(io::readPngSystem(picture(1'000'000'000)).failure); // a megabyte of file
    // Each within its limit.
    const QByteArray text =
        chunk("iTXt", QByteArray("other\0\1\0\0\0", 10) + qCompress(QByteArray(8'000'000, ' ')).sliced(4));
    QCOMPARE(io::readPngSystem(picture(1000, text)).text.size(), 1000);
    const QByteArray many = picture(1000, text.repeated(99)); // 0.8 MB of file, 800 MB of text
    QVERIFY(many.size() < 1'000'000);
    const auto refusal = io::readPngSystem(many).failure;
    QVERIFY(refusal && refusal->contains(QStringLiteral("too much text")));
}

// Zeros, far more than there is memory for, in a link shorter than any that a text of 1 MB needs.
void HostileFilesTest::aLinkIsNotUnpackedBeyondItsLimit() {
    constexpr qsizetype piece = 16 << 20;
    QByteArray zeros(piece, '\0'), packed(1 << 20, Qt::Uninitialized);
    z_stream stream{};
    QCOMPARE(deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(zeros.data());
    stream.avail_in = uInt(piece);
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    QCOMPARE(deflate(&stream, Z_FULL_FLUSH), Z_OK); // whole blocks, which can be repeated
    packed.truncate(qsizetype(stream.total_out));
    deflateEnd(&stream);
    for (const qsizetype pieces : {60, 256}) { // 1 GB and 4 GB
        const QByteArray link =
            "barycage:" +
            packed.repeated(pieces).toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals);
        const io::Collection collection = io::readCollection(link);
        QVERIFY(collection.format == u"link" && collection.file.entries.isEmpty());
        QVERIFY2(everythingSaid(collection.file).contains(u"1 MB"),
                 qPrintable(everythingSaid(collection.file)));
    }
}

void HostileFilesTest::hugePalettes() {
    for (const char* piece : {"255 255 255\n", "a { gradient: index=0 color=1 }\n", "\n", "{"}) {
        const io::PaletteFile refused = io::readPalettes(filled("", piece), {});
        QVERIFY(refused.palettes.empty());
        QVERIFY(refused.problems.first().message.contains(QStringLiteral("16 MB")));
        const io::PaletteFile file = io::readPalettes(filled("", piece, 15'000'000), {});
        QVERIFY(file.palettes.size() <= 4000 && file.problems.size() <= 20);
    }
}

namespace {

QByteArray times(const QByteArray& piece, qsizetype count) {
    return piece.repeated(count).chopped(1); // without the last comma
}

QByteArray nested(const QByteArray& open, const QByteArray& inner, const QByteArray& close) {
    return open.repeated(60) + inner + close.repeated(60);
}

std::chrono::milliseconds timeToRead(const QByteArray& bytes) {
    QElapsedTimer timer;
    timer.start();
    io::readCollection(bytes, QStringLiteral("lists.json"));
    return std::chrono::milliseconds(timer.elapsed());
}

} // namespace

void HostileFilesTest::nestedListsTakeNoLonger_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray numbers = '[' + times("1,", 200'000) + ']';
    QTest::newRow("numbers") << nested("[", numbers, "]");
    QTest::newRow("numbers under names") << nested("{\"a\":", numbers, "}");
    QTest::newRow("weights") << nested("{\"p\":", numbers, "}");
    QTest::newRow("rows") << nested("[", '[' + times(numbers + ',', 4) + ']', "]");
    QTest::newRow("almost maps") << nested("[", '[' + times("[1,0,0,1,0,0],", 30'000) + ",7]", "]");
    QTest::newRow("almost maps under names")
        << nested("{\"x\":", '[' + times("[1,0,0,1,0,0],", 30'000) + ",7]", "}");
    QTest::newRow("matrices") << nested('{' + QByteArray("\"x\":1,").repeated(700) + "\"m\":", "[1]", "}");
    QTest::newRow("weighted lists") << '[' + times(nested("[1,", "1", "]") + ',', 1'500) + ']';
    QTest::newRow("lists around nothing") << '[' + times(nested("[", "", "]") + ',', 3'000) + ']';
    const auto repeated = [](const char* name, const char* piece, int count, const QByteArray& end = {}) {
        QTest::newRow(name) << QByteArray(piece).repeated(count) + end;
    };
    repeated("matrices without ends", "\\begin{pmatrix}", 50'000);
    repeated("matrices with open braces", "\\begin{pmatrix}{", 50'000);
    repeated("matrices inside each other", "\\begin{pmatrix}", 20'000,
             QByteArray("\\end{pmatrix}").repeated(20'000));
    repeated("points one after the other", "x=[[1,2,3,4,5,6],", 40'000);
    repeated("rows with open brackets", "\\begin{pmatrix}1\\\\[", 50'000);
    repeated("spaces with open brackets", "\\begin{pmatrix}\\hspace[", 50'000);
    repeated("environments with open braces", "\\begin{tabularx}{{", 50'000);
    repeated("words", "- ", 500'000, "1");
    repeated("cells with open brackets", "(1 2", 100'000);
    repeated("sums that end early", "1+ ", 100'000);
    QTest::newRow("links of a wiki") << "{|\n|" + QByteArray("[[").repeated(200'000);
    QTest::newRow("formulas of a wiki") << "{|\n|" + QByteArray("<math>").repeated(100'000);
}

// In proportion to the size of the file, however deep the lists.
void HostileFilesTest::nestedListsTakeNoLonger() {
    QFETCH(const QByteArray, bytes);
    const QByteArray flat = '[' + times("1,", bytes.size() / 2) + ']';
    const auto ofFlat = timeToRead(flat), ofNested = timeToRead(bytes);
    QVERIFY2(ofNested < 6 * ofFlat + 300ms,
             qPrintable(QStringLiteral("%1 ms, and %2 ms").arg(ofNested.count()).arg(ofFlat.count())));
}

BARYCAGE_TEST(HostileFilesTest);
#include "hostile_files_test.moc"
