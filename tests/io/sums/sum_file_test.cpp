// SPDX-License-Identifier: MIT
#include "io/sums/sum_file.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QTest>

#include <random>

using namespace io;
using attractor::CellKind;

class SumFileTest : public QObject {
    Q_OBJECT

private slots:
    void tilesCoverThePicture();
    void readsBackWhatWasWritten_data();
    void readsBackWhatWasWritten();
    void noiseIsNotCompressedInHaste();
    void zerosTakeNoRoom();
    void refusesEveryDamage();
};

namespace {

SumHeader header(CellKind kind = CellKind::Count) {
    SumHeader result;
    result.request = "pixels 1\nentry\nx { }\n";
    result.kind = kind;
    result.columns = 700;
    result.rows = 50;
    result.passes = {1'000'000, 18'446'744'073'709'551'615U};
    result.shares = {{0, 50, 0, {2, 3}}, {10, 20, 1, {0, 1}}};
    return result;
}

// Of small, large and vanishing numbers.
SumTile tileOf(const SumHeader& of, std::uint32_t number) {
    std::mt19937_64 random(number);
    SumTile tile{number, std::vector<std::uint64_t>(TileGrid(of).valuesIn(number))};
    for (std::uint64_t& value : tile.values)
        if (random() % 3 == 0) value = random() >> (random() % 64);
    return tile;
}

QByteArray fileOf(const SumHeader& of, std::initializer_list<std::uint32_t> tiles) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    SumWriter writer(buffer, of);
    for (const std::uint32_t number : tiles)
        writer.write(tileOf(of, number));
    writer.finish();
    return buffer.data();
}

} // namespace

void SumFileTest::tilesCoverThePicture() {
    const TileGrid grid(header());
    std::vector<int> covered(700 * 50);
    for (std::uint32_t tile = 0; tile < grid.count(); ++tile) {
        const attractor::CellRegion cells = grid.region(tile);
        std::size_t count = 0;
        for (int row = cells.firstRow; row < cells.endRow; ++row)
            for (int column = cells.firstColumn; column < cells.endColumn; ++column, ++count)
                ++covered[std::size_t(row) * 700 + std::size_t(column)];
        QCOMPARE(grid.valuesIn(tile), count);
    }
    QVERIFY(std::ranges::all_of(covered, [](int times) { return times == 1; }));
}

void SumFileTest::readsBackWhatWasWritten_data() {
    QTest::addColumn<CellKind>("kind");
    QTest::newRow("counts") << CellKind::Count;
    QTest::newRow("colours") << CellKind::Colour;
}

void SumFileTest::readsBackWhatWasWritten() {
    QFETCH(const CellKind, kind);
    const SumHeader of = header(kind);
    QBuffer buffer;
    buffer.setData(fileOf(of, {0, 3, 11}));
    buffer.open(QIODevice::ReadOnly);
    SumReader reader(buffer);
    QVERIFY(!reader.failure());
    QCOMPARE(reader.header().request, of.request);
    QVERIFY(reader.header().kind == kind);
    QCOMPARE(reader.header().columns, of.columns);
    QCOMPARE(reader.header().rows, of.rows);
    QCOMPARE(reader.header().passes, of.passes);
    QVERIFY(reader.header().shares == of.shares);
    QCOMPARE(reader.tiles().size(), std::size_t(3));
    for (const std::uint32_t number : {11U, 0U, 3U})
        QCOMPARE(reader.read(number)->values, tileOf(of, number).values);
    QVERIFY(!reader.read(1));
    QVERIFY(!reader.failure());
}

// What cannot be made much smaller is stored as it is, and reads back all the same.
void SumFileTest::noiseIsNotCompressedInHaste() {
    const SumHeader of = header();
    const TileGrid grid(of);
    std::mt19937_64 random(3);
    SumTile noise{1, std::vector<std::uint64_t>(grid.valuesIn(1))}, even = noise;
    for (std::uint64_t& value : noise.values)
        value = 1 + random() % 120;
    for (std::uint64_t& value : even.values)
        value = 1 + random() % 4;
    constexpr qsizetype around = 12; // number, length and checksum
    for (const SumTile& tile : {noise, even}) {
        const QByteArray small = storedTile(tile, Packing::Small), fast = storedTile(tile, Packing::Fast);
        QVERIFY(small.size() < qsizetype(tile.values.size()));
        const bool isNoise = tile.values == noise.values;
        QCOMPARE(fast == small, !isNoise);
        QVERIFY(fast.size() < qsizetype(tile.values.size()) + 40);
        for (const QByteArray& stored : {small, fast}) {
            const QByteArray block = stored.mid(8, stored.size() - around);
            QCOMPARE(tileIn(grid, 1, block)->values, tile.values);
            QVERIFY(!tileIn(grid, 2, block)); // which has fewer cells
        }
    }
}

void SumFileTest::zerosTakeNoRoom() {
    const SumHeader of = header();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    SumWriter writer(buffer, of);
    writer.write({4, std::vector<std::uint64_t>(TileGrid(of).valuesIn(4))});
    writer.finish();
    QCOMPARE(buffer.data(), fileOf(of, {}));
}

// Each byte changed, and each prefix: refused, or the same as before.
void SumFileTest::refusesEveryDamage() {
    SumHeader of = header();
    of.columns = 40;
    of.rows = 3;
    of.shares = {{0, 3, 0, {2, 3}}, {1, 2, 1, {0, 1}}};
    const QByteArray sound = fileOf(of, {0});
    const auto refused = [](const QByteArray& bytes) {
        QBuffer buffer;
        buffer.setData(bytes);
        buffer.open(QIODevice::ReadOnly);
        const SumReader reader(buffer);
        return reader.failure().has_value();
    };
    QVERIFY(!refused(sound));
    for (qsizetype i = 0; i < sound.size(); ++i) {
        QVERIFY(refused(sound.left(i)));
        for (const char change : {1, 16, 127}) {
            QByteArray bytes = sound;
            bytes[i] = char(bytes[i] ^ change);
            QVERIFY2(refused(bytes), qPrintable(QString::number(i)));
        }
    }
    QVERIFY(refused(sound + '\0'));
}

BARYCAGE_TEST(SumFileTest, QCoreApplication);
#include "sum_file_test.moc"
