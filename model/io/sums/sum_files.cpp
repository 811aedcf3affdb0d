// SPDX-License-Identifier: MIT
#include "io/sums/sum_files.h"

#include "attractor/threads/job_shares.h"
#include "attractor/threads/workers.h"
#include "document/text/text.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

namespace io {

namespace {

using attractor::CellKind;
using attractor::CellRegion;
using attractor::CellSums;
using attractor::CellWindow;

// Returns true if the same unit may be in both.
bool overlap(const SumShare& a, const SumShare& b) {
    if (a.pass != b.pass || a.endRow <= b.firstRow || b.endRow <= a.firstRow) return false;
    const std::uint64_t common = std::gcd(a.part.count, b.part.count);
    return a.part.index % common == b.part.index % common;
}

bool isPrefix(const std::vector<std::uint64_t>& shorter, const std::vector<std::uint64_t>& longer) {
    return shorter.size() <= longer.size() && std::equal(shorter.begin(), shorter.end(), longer.begin());
}

} // namespace

SumFiles::SumFiles(const QStringList& paths) {
    for (const QString& path : paths)
        if (!open(path)) return;
}

bool SumFiles::open(const QString& path) {
    Part part{path, std::make_unique<QFile>(path), nullptr};
    if (!part.file->open(QIODevice::ReadOnly)) {
        m_failure = Text::tr("“%1” cannot be read: %2.").arg(path, part.file->errorString());
        m_isUnreadable = true;
        return false;
    }
    part.reader = std::make_unique<SumReader>(*part.file);
    if (part.reader->failure()) return failed(part);
    const SumHeader& header = part.reader->header();
    m_failure = m_parts.empty() ? Failure() : misfit(path, header);
    if (m_failure) return false;
    if (m_parts.empty()) m_header = {header.request, header.kind, header.columns, header.rows, {}, {}};
    if (header.passes.size() > m_header.passes.size()) m_header.passes = header.passes;
    m_header.shares.insert(m_header.shares.end(), header.shares.begin(), header.shares.end());
    m_names.insert(m_names.end(), header.shares.size(), path);
    m_parts.push_back(std::move(part));
    return true;
}

bool SumFiles::failed(const Part& part) {
    if (m_failure) return false;
    m_isUnreadable = part.file->error() != QFileDevice::NoError;
    m_failure = m_isUnreadable ? Text::tr("“%1” cannot be read: %2.").arg(part.path, part.file->errorString())
                               : Text::tr("“%1”: %2").arg(part.path, *part.reader->failure());
    return false;
}

Failure SumFiles::misfit(const QString& name, const SumHeader& other) const {
    if (other.request != m_header.request || other.kind != m_header.kind ||
        other.columns != m_header.columns || other.rows != m_header.rows)
        return Text::tr("“%1” belongs to another picture: the entry, the view, the size, the seed or the "
                        "format differs.")
            .arg(name);
    if (!isPrefix(other.passes, m_header.passes) && !isPrefix(m_header.passes, other.passes))
        return Text::
            tr("“%1” belongs to a picture with a different number of points, so the sums cannot be combined.")
                .arg(name);
    for (const SumShare& share : other.shares)
        for (std::size_t i = 0; i < m_header.shares.size(); ++i)
            if (overlap(share, m_header.shares[i]))
                return Text::tr("“%1” and “%2” hold the same part of the picture, which would be "
                                "counted twice.")
                    .arg(m_names[i], name);
    return {};
}

bool SumFiles::addTo(CellSums& sums) {
    const CellWindow& window = sums.window();
    const TileGrid grid(m_header);
    const std::uint32_t first = std::uint32_t(window.firstRow / TileGrid::tileRows) * grid.across();
    const std::uint32_t last = std::uint32_t((window.endRow - 1) / TileGrid::tileRows + 1) * grid.across();
    for (Part& part : m_parts) {
        const auto& tiles = part.reader->tiles();
        for (auto at = tiles.lower_bound(first); at != tiles.end() && at->first < last; ++at) {
            const auto tile = part.reader->read(at->first);
            if (!tile) return failed(part);
            const CellRegion cells = grid.region(tile->number);
            const auto width = std::size_t(cells.endColumn - cells.firstColumn);
            for (int row = std::max(cells.firstRow, window.firstRow);
                 row < std::min(cells.endRow, window.endRow); ++row) {
                const std::size_t start = std::size_t(row - cells.firstRow) * width;
                if (m_header.kind == CellKind::Count) {
                    sums.addSamples(row - window.firstRow, cells.firstColumn,
                                    std::span(tile->values).subspan(start, width));
                    continue;
                }
                std::vector<CellSums::Sum> values(width);
                for (std::size_t x = 0; x < width; ++x) {
                    const std::uint64_t* const cell = tile->values.data() + 4 * (start + x);
                    values[x] = {cell[0], cell[1], cell[2], cell[3]};
                }
                sums.addSums(row - window.firstRow, cells.firstColumn, values);
            }
        }
    }
    return true;
}

// The blocks of the tile. False on a failure.
bool SumFiles::collect(Merged& merged) {
    for (Part& part : m_parts) {
        if (!part.reader->tiles().contains(merged.number)) continue;
        auto block = part.reader->readBlock(merged.number);
        if (!block) return failed(part);
        merged.blocks.emplace_back(&part, *std::move(block));
    }
    return true;
}

// Thread-safe.
void SumFiles::add(Merged& merged) const {
    const TileGrid grid(m_header);
    std::optional<SumTile> sum;
    for (const auto& [part, block] : merged.blocks) {
        auto tile = tileIn(grid, merged.number, block);
        if (!tile) {
            merged.damaged = part;
            return;
        }
        if (sum)
            *sum += *tile;
        else
            sum = std::move(tile);
    }
    merged.stored = storedTile(*sum, Packing::Fast);
}

// Reads and writes files in this thread; all threads add up the contents of tiles.
bool SumFiles::writeTo(SumWriter& writer, int threads, const Progress& progress,
                       const std::stop_token& stop) {
    std::set<std::uint32_t> numbers;
    for (const Part& part : m_parts)
        for (const auto& [number, place] : part.reader->tiles())
            numbers.insert(number);
    attractor::Workers workers(std::size_t(std::clamp(threads, 1, 256)));
    const std::size_t together = 4 * workers.size();
    attractor::JobShares shares;
    std::vector<Merged> tiles;
    for (auto next = numbers.begin(); next != numbers.end();) {
        if (stop.stop_requested()) return false;
        if (progress) progress(double(*next) / double(TileGrid(m_header).count()));
        for (tiles.clear(); next != numbers.end() && tiles.size() < together; ++next) {
            tiles.push_back({*next, {}});
            if (!collect(tiles.back())) return false;
        }
        shares.reset(tiles.size(), workers);
        shares.run(workers, {}, [&](std::size_t job, std::size_t) { add(tiles[job]); });
        for (const Merged& tile : tiles) {
            if (tile.damaged) {
                tile.damaged->reader->read(tile.number); // records the failure
                return failed(*tile.damaged);
            }
            writer.writeStored(tile.stored);
        }
    }
    return true;
}

} // namespace io
