// SPDX-License-Identifier: MIT
#include "io/sums/sum_writing.h"
#include "document/text/text.h"

#include <algorithm>
#include <cmath>

namespace io {

namespace {

using attractor::CellKind;
using attractor::CellRegion;
using attractor::CellSums;
using attractor::CellWindow;

// The tiles of one row of tiles, from the sums of rows of cells that come one after the other.
class TileRow {
public:
    TileRow(const SumHeader& header, int row)
        : m_grid(header),
          m_first(std::uint32_t(row / TileGrid::tileRows) * m_grid.across()),
          m_values(TileGrid::valuesPerCell(header.kind)),
          m_tiles(m_grid.across()) {}

    // Adds the values of all columns.
    void add(int row, std::span<const std::uint64_t> values) {
        for (std::size_t t = 0; t < m_tiles.size(); ++t) {
            const std::uint32_t number = m_first + std::uint32_t(t);
            const CellRegion cells = m_grid.region(number);
            const auto part = values.subspan(std::size_t(cells.firstColumn) * m_values,
                                             std::size_t(cells.endColumn - cells.firstColumn) * m_values);
            if (std::ranges::all_of(part, [](std::uint64_t value) { return value == 0; })) continue;
            SumTile& tile = m_tiles[t];
            tile.number = number;
            tile.values.resize(m_grid.valuesIn(number));
            std::ranges::copy(part, tile.values.begin() +
                                        std::ptrdiff_t(row - cells.firstRow) * std::ptrdiff_t(part.size()));
        }
    }
    void writeTo(SumWriter& writer) const {
        for (const SumTile& tile : m_tiles)
            if (!tile.values.empty()) writer.write(tile);
    }

private:
    TileGrid m_grid;
    std::uint32_t m_first;
    std::size_t m_values;
    std::vector<SumTile> m_tiles;
};

bool valuesOfRow(const CellSums& sums, int row, std::vector<std::uint64_t>& values) {
    if (sums.kind() == CellKind::Count) return sums.samplesOfRow(row, values);
    std::vector<CellSums::Sum> row4;
    if (!sums.sumsOfRow(row, row4)) return false;
    values.clear();
    for (const CellSums::Sum& sum : row4)
        values.insert(values.end(), {sum.samples, sum.red, sum.green, sum.blue});
    return true;
}

} // namespace

void writeTiles(const CellSums& sums, const SumHeader& header, SumWriter& writer) {
    const CellWindow& window = sums.window();
    std::vector<std::uint64_t> values;
    for (int row = window.firstRow; row < window.endRow;) {
        const int end = std::min(window.endRow, (row / TileGrid::tileRows + 1) * TileGrid::tileRows);
        TileRow tiles(header, row);
        for (; row < end; ++row)
            if (valuesOfRow(sums, row - window.firstRow, values)) tiles.add(row, values);
        tiles.writeTo(writer);
    }
}

ExportOutcome writeSums(const SumHeader& header, const std::shared_ptr<SumFiles>& files,
                        const std::function<bool(SumWriter&)>& fill, const QString& path) {
    ExportOutcome outcome;
    NewFile file(path);
    outcome.failure = file.failure();
    if (outcome.failure) return outcome;
    SumWriter writer(file, header);
    const bool done = fill(writer);
    if (files) outcome.failure = files->failure();
    outcome.stopped = !done && !outcome.failure;
    if (!done) return outcome;
    writer.finish();
    outcome.failure = file.failure() ? file.failure() : file.commit();
    return outcome;
}

attractor::DividedPicture dividedPicture(const std::vector<std::uint64_t>& passes,
                                         const std::vector<SumShare>& drawn,
                                         const std::shared_ptr<SumFiles>& files) {
    attractor::DividedPicture divided;
    for (const std::uint64_t samples : passes)
        divided.passes.push_back({samples, {0, 0}});
    for (const SumShare& share : drawn)
        divided.passes[share.pass].part = share.part;
    if (files) divided.others = [files](CellSums& cells) { return files->addTo(cells); };
    return divided;
}

QString otherPixels(const QString& name) {
    return Text::tr("“%1” was written by another version of the program, which may draw other pixels.")
        .arg(name);
}

bool haveSameCells(const SumHeader& a, const SumHeader& b) {
    return a.columns == b.columns && a.rows == b.rows && a.kind == b.kind;
}

Failure missingIn(const SumHeader& header, int rows,
                  const std::function<std::uint64_t(std::span<const std::uint64_t> passes)>& units) {
    const std::span<const std::uint64_t> passes = header.passes;
    const double all = double(units(passes)) * rows;
    double there = 0;
    for (const SumShare& share : header.shares) {
        const std::uint64_t first = units(passes.first(share.pass));
        const std::uint64_t end = units(passes.first(share.pass + 1));
        const std::uint64_t held = share.part.unitsBefore(end) - share.part.unitsBefore(first);
        there += double(held) * (share.endRow - share.firstRow);
    }
    if (there >= all) return {};
    return Text::tr("The picture is incomplete: only %1 % of it is present. Add the files of the other "
                    "parts, or merge to a .sum file.")
        .arg(std::min(99.9, std::floor(1000 * there / all) / 10));
}

} // namespace io
