// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/folds/picture_part.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QIODevice>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace io {

// Units of one pass that were counted, in some rows.
struct SumShare {
    int firstRow = 0; // row of pixels
    int endRow = 0;
    std::size_t pass = 0;
    attractor::PicturePart part; // share whose units count from the first pass on

    friend bool operator==(const SumShare&, const SumShare&) = default;
};

struct SumHeader {
    QByteArray request; // pictureRequest()
    attractor::CellKind kind = attractor::CellKind::Count;
    int columns = 0; // number of cells of the whole picture
    int rows = 0;
    std::vector<std::uint64_t> passes; // samples of each pass
    std::vector<SumShare> shares;      // shares contained in the sums
};

// The sums of 256 × 16 cells, fewer at the right and lower edge, row by row: the samples of each cell, with
// CellKind::Colour followed by its red, green and blue.
struct SumTile {
    std::uint32_t number = 0; // index, row by row from the top left corner of the whole picture
    std::vector<std::uint64_t> values;

    SumTile& operator+=(const SumTile& other); // requires the same number
};

// Positions of tiles, in cells.
class TileGrid {
public:
    static constexpr int tileColumns = 256;
    static constexpr int tileRows = 16;

    explicit TileGrid(const SumHeader& header)
        : m_columns(header.columns), m_rows(header.rows), m_values(valuesPerCell(header.kind)) {}

    static std::size_t valuesPerCell(attractor::CellKind kind) {
        return kind == attractor::CellKind::Colour ? 4 : 1;
    }
    std::uint32_t across() const { return std::uint32_t(m_columns - 1) / tileColumns + 1; }
    std::uint32_t count() const { return across() * (std::uint32_t(m_rows - 1) / tileRows + 1); }
    attractor::CellRegion region(std::uint32_t tile) const;
    std::size_t valuesIn(std::uint32_t tile) const;

private:
    int m_columns;
    int m_rows;
    std::size_t m_values;
};

// Effort of compression. Fast leaves numbers that are mostly noise as they are; packing them would take
// longer than all else.
enum class Packing { Small, Fast };
// A tile as a file has it; empty where it is left out. Any thread.
QByteArray storedTile(const SumTile& tile, Packing packing);
// Decodes the block of a tile; nullopt for invalid bytes.
std::optional<SumTile> tileIn(const TileGrid& grid, std::uint32_t number, const QByteArray& block);

// Writes a file of sums (docs/formats.md). Tiles come in rising order, those of zeros alone are left out. Any
// failure of the device is the device's to remember.
class SumWriter {
public:
    SumWriter(QIODevice& device, const SumHeader& header); // `device` must outlive the writer
    void write(const SumTile& tile);
    void writeStored(const QByteArray& tile); // text from storedTile()
    void finish();

private:
    QIODevice& m_device;
    std::uint32_t m_count = 0;
};

// Reads one. Hostile bytes are refused with a sentence.
class SumReader {
public:
    // Reads and checks all of the file. The device is open, random access, and outlives the reader.
    explicit SumReader(QIODevice& device);

    const Failure& failure() const { return m_failure; } // first failure
    const SumHeader& header() const { return m_header; }
    // Offsets of the tiles that the file holds.
    const std::map<std::uint32_t, qint64>& tiles() const { return m_tiles; }
    std::optional<SumTile> read(std::uint32_t number);         // nullopt: not in the file, or a failure
    std::optional<QByteArray> readBlock(std::uint32_t number); // nullopt likewise; block for tileIn()

private:
    bool readHeader();
    bool readTiles();
    std::optional<std::uint32_t> number();
    std::optional<QByteArray> block(std::uint32_t maxSize, std::uint32_t tile = 0);
    void fail();

    QIODevice& m_device;
    SumHeader m_header;
    std::map<std::uint32_t, qint64> m_tiles;
    Failure m_failure;
};

} // namespace io
