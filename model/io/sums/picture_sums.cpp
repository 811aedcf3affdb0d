// SPDX-License-Identifier: MIT
#include "io/sums/picture_sums.h"

#include "io/sums/picture_request.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace io {

namespace {

using attractor::BandedRendering;
using attractor::CellKind;
using attractor::CellRegion;
using attractor::CellSums;
using attractor::CellWindow;
using attractor::DividedPicture;
using attractor::PicturePart;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

// Whether the same unit may be in both.
bool overlap(const SumShare& a, const SumShare& b) {
    if (a.pass != b.pass || a.endRow <= b.firstRow || b.endRow <= a.firstRow) return false;
    const std::uint64_t common = std::gcd(a.part.count, b.part.count);
    return a.part.index % common == b.part.index % common;
}

bool isPrefix(const std::vector<std::uint64_t>& shorter, const std::vector<std::uint64_t>& longer) {
    return shorter.size() <= longer.size() && std::equal(shorter.begin(), shorter.end(), longer.begin());
}

int sideOf(const PngExport& picture) {
    return std::clamp(picture.request.appearance.supersample, 1, 4);
}

SumHeader headerOf(const PictureSums& sums) {
    const attractor::RenderRequest& request = sums.picture.request;
    SumHeader header;
    header.request = pictureRequest(sums.picture);
    header.kind = coloursSamples(request.appearance.colourBy) ? CellKind::Colour : CellKind::Count;
    header.columns = request.camera.width * sideOf(sums.picture);
    header.rows = request.camera.height * sideOf(sums.picture);
    header.passes = sums.passes;
    if (sums.files) header.shares = sums.files->header().shares;
    header.shares.insert(header.shares.end(), sums.drawn.begin(), sums.drawn.end());
    return header;
}

DividedPicture dividedPicture(const PictureSums& sums) {
    DividedPicture divided;
    for (const std::uint64_t samples : sums.passes)
        divided.passes.push_back({samples, {0, 0}});
    for (const SumShare& share : sums.drawn)
        divided.passes[share.pass].part = share.part;
    if (sums.files) divided.others = [files = sums.files](CellSums& cells) { return files->addTo(cells); };
    return divided;
}

// The tiles of one row of tiles, from the sums of rows of cells that come one after the other.
class TileRow {
public:
    TileRow(const SumHeader& header, int row)
        : m_grid(header),
          m_first(std::uint32_t(row / TileGrid::tileRows) * m_grid.across()),
          m_values(TileGrid::valuesPerCell(header.kind)),
          m_tiles(m_grid.across()) {}

    // Of all columns.
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

// Whole rows of tiles: rows of pixels from `first` on whose number is a multiple of 16 begin and end them.
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

// Draws the rows band by band, each of whole rows of tiles. False when stopped or a file fails.
bool drawTiles(const PictureSums& sums, SumWriter& writer, const Progress& progress,
               const std::stop_token& stop) {
    const SumHeader header = headerOf(sums);
    const int firstRow = sums.drawn.front().firstRow;
    const int endRow = sums.drawn.front().endRow;
    BandedRendering rendering(sums.picture.request);
    rendering.divide(dividedPicture(sums));
    constexpr int step = TileGrid::tileRows;
    const int most = std::max(
        step, BandedRendering::rowsWithin(sums.picture.request, sums.picture.bandBytes) / step * step);
    for (int first = firstRow; first < endRow;) {
        const int end = std::min(endRow, (first + most) / step * step);
        const auto told = [&](double share) {
            if (progress) progress((first - firstRow + share * (end - first)) / (endRow - firstRow));
        };
        const CellSums* cells = rendering.sums(first, end - first, stop, told);
        if (cells == nullptr) return false;
        writeTiles(*cells, header, writer);
        first = end;
    }
    return true;
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
    if (!m_failure) m_failure = Text::tr("“%1”: %2").arg(part.path, *part.reader->failure());
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

bool SumFiles::writeTo(SumWriter& writer, const Progress& progress, const std::stop_token& stop) {
    std::vector<std::map<std::uint32_t, qint64>::const_iterator> next;
    for (const Part& part : m_parts)
        next.push_back(part.reader->tiles().begin());
    const std::uint32_t count = TileGrid(m_header).count();
    while (!stop.stop_requested()) {
        std::uint32_t number = count;
        for (std::size_t i = 0; i < m_parts.size(); ++i)
            if (next[i] != m_parts[i].reader->tiles().end()) number = std::min(number, next[i]->first);
        if (number == count) return true;
        std::optional<SumTile> sum;
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            if (next[i] == m_parts[i].reader->tiles().end() || next[i]->first != number) continue;
            auto tile = m_parts[i].reader->read(number);
            if (!tile) return failed(m_parts[i]);
            if (sum)
                *sum += *tile;
            else
                sum = std::move(tile);
            ++next[i];
        }
        writer.write(*sum);
        if (progress) progress(double(number) / count);
    }
    return false;
}

LoadedSums sumsIn(const std::shared_ptr<SumFiles>& files, int threads) {
    LoadedSums loaded;
    PictureSums& sums = loaded.sums;
    const SumHeader& header = files->header();
    const auto picture = pictureOf(header.request);
    if (picture) sums.picture = *picture;
    sums.picture.request.threads = threads;
    sums.picture.request.samples = header.passes.front();
    sums.passes = header.passes;
    sums.files = files;
    const SumHeader own = headerOf(sums);
    if (!picture || own.columns != header.columns || own.rows != header.rows || own.kind != header.kind)
        loaded.failure =
            Text::tr("“%1” was written by another version of the program, which may draw other pixels.")
                .arg(files->name());
    return loaded;
}

PictureSums partOf(const PngExport& picture, int firstRow, int endRow, const PicturePart& part) {
    PictureSums sums;
    sums.picture = pictureOf(pictureRequest(picture)).value_or(picture);
    sums.picture.request.threads = picture.request.threads;
    sums.picture.request.samples = picture.request.samples;
    sums.passes = {picture.request.samples};
    sums.drawn = {{firstRow, endRow, 0, part}};
    return sums;
}

void addPass(PictureSums& sums, std::uint64_t samples) {
    sums.drawn = {{0, sums.picture.request.camera.height, sums.passes.size(), {}}};
    sums.passes.push_back(samples);
}

ExportOutcome exportSums(const PictureSums& sums, const QString& path, const Progress& progress,
                         std::stop_token stop) {
    ExportOutcome outcome;
    NewFile file(path);
    outcome.failure = file.failure();
    if (outcome.failure) return outcome;
    SumWriter writer(file, headerOf(sums));
    const bool done = sums.drawn.empty() ? sums.files->writeTo(writer, progress, stop)
                                         : drawTiles(sums, writer, progress, stop);
    if (sums.files) outcome.failure = sums.files->failure();
    outcome.stopped = !done && !outcome.failure;
    if (!done) return outcome;
    writer.finish();
    outcome.failure = file.failure() ? file.failure() : file.commit();
    return outcome;
}

Failure incompleteness(const PictureSums& sums) {
    const BandedRendering rendering(sums.picture.request);
    const std::span<const std::uint64_t> passes = sums.passes;
    const double all = double(rendering.units(passes)) * sums.picture.request.camera.height;
    double there = 0;
    for (const SumShare& share : headerOf(sums).shares) {
        const std::uint64_t first = rendering.units(passes.first(share.pass));
        const std::uint64_t end = rendering.units(passes.first(share.pass + 1));
        const std::uint64_t units = share.part.unitsBefore(end) - share.part.unitsBefore(first);
        there += double(units) * (share.endRow - share.firstRow);
    }
    if (there >= all) return {};
    return Text::tr("The picture is incomplete: only %1 % of it is present. Add the files of the other "
                    "parts, or merge to a .sum file.")
        .arg(std::min(99.9, std::floor(1000 * there / all) / 10));
}

ExportOutcome exportPicture(const PictureSums& sums, const QString& path, const Progress& progress,
                            std::stop_token stop) {
    ExportOutcome outcome;
    outcome.failure = incompleteness(sums);
    if (outcome.failure) return outcome;
    PngExport picture = sums.picture;
    picture.divided = dividedPicture(sums);
    outcome = exportPng(picture, path, progress, stop);
    if (sums.files && sums.files->failure()) outcome = {sums.files->failure(), false, outcome.note};
    return outcome;
}

} // namespace io
