// SPDX-License-Identifier: MIT
#include "io/sums/sum_file.h"
#include "document/text/text.h"

#include <QtEndian>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace io {

namespace {

const QByteArray magic = QByteArrayLiteral("BaryCSum");
constexpr int version = 1;
constexpr std::uint32_t end = 0xFFFFFFFF; // end mark in place of a tile number
constexpr std::uint32_t maxHeader = 256U << 20;
// Bytes of a block: 4096 cells of four numbers of ten bytes, with reserve.
constexpr std::uint32_t maxTile = 1U << 20;
constexpr std::size_t maxLines = 1U << 14; // passes or shares
constexpr std::int64_t maxCells = std::int64_t{1} << 40;

// The checksum of a block and the number of its tile; that of the header is 0.
std::uint32_t checksum(const QByteArray& block, std::uint32_t tile = 0) {
    const auto number = qToLittleEndian(tile);
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(&number), sizeof number);
    return std::uint32_t(::crc32(sum, reinterpret_cast<const Bytef*>(block.constData()), uInt(block.size())));
}

constexpr std::size_t maxNumber = 10; // bytes of a variable number

// Seven bits a byte, the low ones first; the high bit says that more follow. Returns where the next one goes.
std::uint8_t* putVariable(std::uint8_t* to, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        *to++ = std::uint8_t(0x80 | (value & 0x7F));
    *to++ = std::uint8_t(value);
    return to;
}

class VariableReader {
public:
    explicit VariableReader(std::span<const std::uint8_t> bytes)
        : m_at(bytes.data()), m_end(bytes.data() + bytes.size()) {}

    std::optional<std::uint64_t> next() {
        if (m_at != m_end && *m_at < 0x80) return *m_at++; // fast path for small numbers
        std::uint64_t value = 0;
        for (int shift = 0; m_at != m_end && shift < 64; shift += 7) {
            const std::uint8_t byte = *m_at++;
            if (shift == 63 && byte > 1) return std::nullopt;
            value |= std::uint64_t(byte & 0x7F) << shift;
            if (byte < 0x80) return value;
        }
        return std::nullopt;
    }
    bool atEnd() const { return m_at == m_end; }

private:
    const std::uint8_t* m_at;
    const std::uint8_t* m_end;
};

// Returns true if codes for single bytes would save less than a quarter.
bool isNoise(std::span<const std::uint8_t> bytes) {
    constexpr double bitsOfNoise = 6; // bits per byte
    std::array<std::size_t, 256> counts{};
    for (const std::uint8_t byte : bytes)
        ++counts[byte];
    const auto all = double(bytes.size());
    double bits = 0;
    for (const std::size_t count : counts)
        if (count > 0) bits += double(count) * std::log2(all / double(count));
    return bits > bitsOfNoise * all;
}

// Zeros are counted: a 0 is followed by how many more there are.
QByteArray packed(const std::vector<std::uint64_t>& values, Packing packing) {
    std::vector<std::uint8_t> bytes(maxNumber * (values.size() + 1));
    std::uint8_t* to = bytes.data();
    for (std::size_t i = 0; i < values.size(); ++i) {
        to = putVariable(to, values[i]);
        if (values[i] != 0) continue;
        const std::size_t first = i;
        while (i + 1 < values.size() && values[i + 1] == 0)
            ++i;
        to = putVariable(to, i - first);
    }
    const auto count = uLong(to - bytes.data());
    const bool isPlain = packing == Packing::Fast && isNoise(std::span(bytes).first(count));
    uLongf size = ::compressBound(count);
    QByteArray result(qsizetype(size), Qt::Uninitialized);
    ::compress2(reinterpret_cast<Bytef*>(result.data()), &size, bytes.data(), count,
                isPlain ? Z_NO_COMPRESSION : Z_BEST_SPEED);
    result.truncate(qsizetype(size));
    return result;
}

std::optional<std::vector<std::uint64_t>> unpacked(const QByteArray& block, std::size_t count) {
    std::vector<std::uint8_t> bytes(maxNumber * (count + 1));
    uLongf size = uLongf(bytes.size());
    if (::uncompress(bytes.data(), &size, reinterpret_cast<const Bytef*>(block.constData()),
                     uLong(block.size())) != Z_OK)
        return std::nullopt;
    VariableReader reader{std::span(bytes).first(size)};
    std::vector<std::uint64_t> values(count);
    for (std::size_t at = 0; at < count;) {
        const auto value = reader.next();
        if (!value) return std::nullopt;
        values[at++] = *value;
        if (*value != 0) continue;
        const auto more = reader.next();
        if (!more || *more > count - at) return std::nullopt;
        at += std::size_t(*more);
    }
    if (!reader.atEnd()) return std::nullopt;
    return values;
}

QByteArray bytesOf(std::uint32_t number) {
    const auto bytes = qToLittleEndian(number);
    return QByteArray(reinterpret_cast<const char*>(&bytes), sizeof bytes);
}

QByteArray line(const char* key, std::initializer_list<std::uint64_t> numbers) {
    QByteArray text(key);
    for (const std::uint64_t number : numbers)
        text += ' ' + QByteArray::number(qulonglong(number));
    return text + '\n';
}

QByteArray headerText(const SumHeader& header) {
    QByteArray text = line("version", {version});
    text += line(header.kind == attractor::CellKind::Colour ? "colours" : "counts",
                 {std::uint64_t(header.columns), std::uint64_t(header.rows)});
    for (const std::uint64_t samples : header.passes)
        text += line("pass", {samples});
    for (const SumShare& share : header.shares)
        text += line("share", {std::uint64_t(share.firstRow), std::uint64_t(share.endRow), share.pass,
                               share.part.index, share.part.count});
    return text + "request\n" + header.request;
}

// The numbers behind the key; nullopt unless they are as many.
std::optional<std::vector<std::uint64_t>> numbersOf(const QList<QByteArray>& words, int count) {
    std::vector<std::uint64_t> numbers;
    for (const QByteArray& word : words.mid(1)) {
        bool isNumber = false;
        numbers.push_back(word.toULongLong(&isNumber));
        if (!isNumber) return std::nullopt;
    }
    return numbers.size() == std::size_t(count) ? std::optional(numbers) : std::nullopt;
}

bool isSound(const SumHeader& header) {
    if (header.columns < 1 || header.rows < 1) return false;
    if (std::int64_t(header.columns) * header.rows > maxCells) return false;
    if (header.passes.empty() || header.passes.size() > maxLines || header.shares.size() > maxLines)
        return false;
    if (std::ranges::any_of(header.passes, [](std::uint64_t samples) { return samples == 0; })) return false;
    return std::ranges::all_of(header.shares, [&](const SumShare& share) {
        return share.firstRow >= 0 && share.firstRow < share.endRow && share.endRow <= header.rows &&
               share.pass < header.passes.size() && share.part.count > 0 &&
               share.part.index < share.part.count;
    });
}

bool readLine(const QByteArray& text, SumHeader& header) {
    constexpr std::uint64_t maxSide = std::uint64_t{1} << 30;
    const QList<QByteArray> words = text.split(' ');
    const QByteArray& key = words.first();
    if (key == "version") return numbersOf(words, 1) == std::vector<std::uint64_t>{version};
    if (key == "counts" || key == "colours") {
        const auto size = numbersOf(words, 2);
        if (!size || size->at(0) > maxSide || size->at(1) > maxSide) return false;
        header.kind = key == "counts" ? attractor::CellKind::Count : attractor::CellKind::Colour;
        header.columns = int(size->at(0));
        header.rows = int(size->at(1));
        return true;
    }
    if (key == "pass") {
        const auto samples = numbersOf(words, 1);
        if (samples) header.passes.push_back(samples->front());
        return samples.has_value();
    }
    const auto share = key == "share" ? numbersOf(words, 5) : std::nullopt;
    if (!share || share->at(0) > maxSide || share->at(1) > maxSide) return false;
    header.shares.push_back(
        {int(share->at(0)), int(share->at(1)), std::size_t(share->at(2)), {share->at(3), share->at(4)}});
    return true;
}

std::optional<SumHeader> headerFrom(const QByteArray& text) {
    SumHeader header;
    for (qsizetype at = 0; at < text.size();) {
        const qsizetype lineEnd = text.indexOf('\n', at);
        if (lineEnd < 0) return std::nullopt;
        const QByteArray words = text.mid(at, lineEnd - at);
        at = lineEnd + 1;
        if (words == "request") {
            header.request = text.mid(at);
            return isSound(header) ? std::optional(header) : std::nullopt;
        }
        if (!readLine(words, header)) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace

SumTile& SumTile::operator+=(const SumTile& other) {
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += other.values[i];
    return *this;
}

attractor::CellRegion TileGrid::region(std::uint32_t tile) const {
    const int column = int(tile % across()) * tileColumns;
    const int row = int(tile / across()) * tileRows;
    return {column, std::min(m_columns, column + tileColumns), row, std::min(m_rows, row + tileRows)};
}

std::size_t TileGrid::valuesIn(std::uint32_t tile) const {
    const attractor::CellRegion cells = region(tile);
    return std::size_t(cells.endColumn - cells.firstColumn) * std::size_t(cells.endRow - cells.firstRow) *
           m_values;
}

QByteArray storedTile(const SumTile& tile, Packing packing) {
    if (std::ranges::all_of(tile.values, [](std::uint64_t value) { return value == 0; })) return {};
    const QByteArray block = packed(tile.values, packing);
    return bytesOf(tile.number) + bytesOf(std::uint32_t(block.size())) + block +
           bytesOf(checksum(block, tile.number));
}

std::optional<SumTile> tileIn(const TileGrid& grid, std::uint32_t number, const QByteArray& block) {
    auto values = unpacked(block, grid.valuesIn(number));
    if (!values) return std::nullopt;
    return SumTile{number, *std::move(values)};
}

SumWriter::SumWriter(QIODevice& device, const SumHeader& header) : m_device(device) {
    const QByteArray text = headerText(header);
    m_device.write(magic + bytesOf(std::uint32_t(text.size())) + text + bytesOf(checksum(text)));
}

void SumWriter::write(const SumTile& tile) {
    writeStored(storedTile(tile, Packing::Small));
}

void SumWriter::writeStored(const QByteArray& tile) {
    if (tile.isEmpty()) return;
    m_device.write(tile);
    ++m_count;
}

void SumWriter::finish() {
    m_device.write(bytesOf(end) + bytesOf(m_count));
}

SumReader::SumReader(QIODevice& device) : m_device(device) {
    if (m_device.read(magic.size()) != magic)
        m_failure = Text::tr("This is not a file of sums.");
    else if (!readHeader() || !readTiles())
        fail();
}

void SumReader::fail() {
    if (!m_failure) m_failure = Text::tr("The file of sums is damaged or incomplete.");
}

std::optional<std::uint32_t> SumReader::number() {
    std::uint32_t bytes = 0;
    if (m_device.read(reinterpret_cast<char*>(&bytes), sizeof bytes) != sizeof bytes) return std::nullopt;
    return qFromLittleEndian(bytes);
}

// A size, as many bytes, and their checksum.
std::optional<QByteArray> SumReader::block(std::uint32_t maxSize, std::uint32_t tile) {
    const auto size = number();
    if (!size || *size > maxSize) return std::nullopt;
    QByteArray bytes = m_device.read(*size);
    if (bytes.size() != qsizetype(*size) || number() != checksum(bytes, tile)) return std::nullopt;
    return bytes;
}

bool SumReader::readHeader() {
    const auto text = block(maxHeader);
    auto header = text ? headerFrom(*text) : std::nullopt;
    if (!header) return false;
    m_header = *std::move(header);
    return true;
}

bool SumReader::readTiles() {
    const TileGrid grid(m_header);
    while (true) {
        const auto tile = number();
        if (!tile) return false;
        if (*tile == end) return number() == m_tiles.size() && m_device.atEnd();
        if (*tile >= grid.count() || (!m_tiles.empty() && *tile <= m_tiles.rbegin()->first)) return false;
        m_tiles.emplace(*tile, m_device.pos());
        if (!block(maxTile, *tile)) return false;
    }
}

std::optional<QByteArray> SumReader::readBlock(std::uint32_t number) {
    const auto found = m_tiles.find(number);
    if (found == m_tiles.end()) return std::nullopt;
    auto bytes = m_device.seek(found->second) ? block(maxTile, number) : std::nullopt;
    if (!bytes) fail();
    return bytes;
}

std::optional<SumTile> SumReader::read(std::uint32_t number) {
    const auto bytes = readBlock(number);
    if (!bytes) return std::nullopt;
    auto tile = tileIn(TileGrid(m_header), number, *bytes);
    if (!tile) fail();
    return tile;
}

} // namespace io
