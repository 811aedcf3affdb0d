// SPDX-License-Identifier: MIT
#include "io/sums/space_sums.h"

#include "attractor/render/solid_rendering.h"
#include "document/text/text.h"
#include "io/picture/picture_writers.h"
#include "io/picture/solid_picture.h"
#include "io/sums/picture_request.h"
#include "io/sums/sum_writing.h"

#include <algorithm>
#include <span>

namespace io {

namespace {

using attractor::CellKind;
using attractor::CellSums;
using attractor::LookInSpace;
using attractor::Rgba16;

constexpr std::uint64_t maxBytes = std::uint64_t{4} << 30; // memory for one picture
constexpr int bandRows = 16 * TileGrid::tileRows;          // rows of a solid drawn or combined at a time

bool isCloud(const SpaceSums& sums) {
    return attractor::showsCloud(sums.picture.look);
}

bool isDeep(const SpaceSums& sums) {
    return sums.picture.depth == PictureFormat::Depth::Bits16;
}

CellKind kindOf(const SpaceExport& picture) {
    if (picture.look == LookInSpace::Depth) return CellKind::Count;
    if (!attractor::showsCloud(picture.look) || picture.look == LookInSpace::XRay) return CellKind::Colour;
    return coloursSamples(picture.request.appearance.colourBy) ? CellKind::Colour : CellKind::Count;
}

SumHeader headerOf(const SpaceSums& sums) {
    const SpaceExport& picture = sums.picture;
    const int side = isCloud(sums) ? std::clamp(picture.request.appearance.supersample, 1, 4) : 1;
    SumHeader header;
    header.request = pictureRequest(picture);
    header.kind = kindOf(picture);
    header.columns = picture.request.camera.size.width * side;
    header.rows = picture.request.camera.size.height * side;
    header.passes = sums.passes;
    if (sums.files) header.shares = sums.files->header().shares;
    header.shares.insert(header.shares.end(), sums.drawn.begin(), sums.drawn.end());
    return header;
}

// Counts the rows of a cloud, at once. False when stopped or a file fails.
bool countRows(const SpaceSums& sums, SumWriter& writer, const Progress& progress,
               const std::stop_token& stop) {
    SpaceExport picture = sums.picture;
    picture.divided = dividedPicture(sums.passes, sums.drawn, sums.files);
    attractor::CloudRendering rendering = cloudRendering(picture);
    rendering.keepRows(sums.drawn.front().firstRow, sums.drawn.front().endRow);
    if (!drawSamples(picture, rendering, progress, stop)) return false;
    writeTiles(rendering.sums(), headerOf(sums), writer);
    return true;
}

// A pixel as the sums of a cell. No two bands have the same one, so that adding up puts them together.
CellSums::Sum sumOf(std::uint32_t pixel) {
    return {pixel >> 24, (pixel >> 16) & 0xFF, (pixel >> 8) & 0xFF, pixel & 0xFF};
}
CellSums::Sum sumOf(const Rgba16& pixel) {
    return {pixel.alpha, pixel.red, pixel.green, pixel.blue};
}
void setPixel(const CellSums::Sum& sum, std::uint32_t& pixel) {
    pixel = std::uint32_t(sum.samples << 24 | sum.red << 16 | sum.green << 8 | sum.blue);
}
void setPixel(const CellSums::Sum& sum, Rgba16& pixel) {
    pixel = {std::uint16_t(sum.red), std::uint16_t(sum.green), std::uint16_t(sum.blue),
             std::uint16_t(sum.samples)};
}

template <class Pixel>
bool pixelSums(const SpaceSums& sums, int firstRow, int endRow, CellSums& cells,
               const std::stop_token& stop) {
    const SpaceExport& picture = sums.picture;
    const auto width = std::size_t(picture.request.camera.size.width);
    std::vector<Pixel> pixels(width * std::size_t(endRow - firstRow));
    const SolidPicture solid{picture.request, picture.solid, picture.depth, picture.supersample};
    if (drawSolidRows(solid, firstRow, endRow, std::span<Pixel>(pixels), {}, stop).stopped) return false;
    std::vector<CellSums::Sum> row(width);
    for (int y = firstRow; y < endRow; ++y) {
        const auto from = pixels.begin() + std::ptrdiff_t(width) * (y - firstRow);
        std::transform(from, from + std::ptrdiff_t(width), row.begin(),
                       [](const Pixel& pixel) { return sumOf(pixel); });
        cells.addSums(y - firstRow, 0, row);
    }
    return true;
}

// Sums of depths: an empty pixel is 0, and a pixel of value v is 65535 − v.
constexpr std::uint64_t emptyDepth = 65535;

bool depthSums(attractor::SolidRendering& rendering, int firstRow, int endRow, CellSums& cells,
               const std::stop_token& stop) {
    if (!rendering.drawRows(firstRow, endRow, stop)) return false;
    const attractor::DepthRaster& raster = rendering.raster();
    const auto width = std::size_t(raster.width);
    std::vector<std::uint64_t> row(width);
    for (int y = firstRow; y < endRow; ++y) {
        const std::span keys(raster.row(y), width);
        std::ranges::transform(keys, row.begin(),
                               [](std::uint32_t key) { return emptyDepth - depthValue(key); });
        cells.addSamples(y - firstRow, 0, row);
    }
    return true;
}

// Draws the rows of a solid, some whole rows of tiles at a time. False when stopped.
bool drawRows(const SpaceSums& sums, SumWriter& writer, const Progress& progress,
              const std::stop_token& stop) {
    const SumHeader header = headerOf(sums);
    const auto [firstRow, endRow] = std::pair(sums.drawn.front().firstRow, sums.drawn.front().endRow);
    attractor::SolidRendering depths(sums.picture.request);
    CellSums cells;
    for (int first = firstRow; first < endRow;) {
        if (progress) progress(double(first - firstRow) / (endRow - firstRow));
        const int end = std::min(endRow, (first / bandRows + 1) * bandRows);
        cells.reset(header.kind, {header.columns, first, end}, 1);
        const bool isDrawn = sums.picture.look == LookInSpace::Depth
                                 ? depthSums(depths, first, end, cells, stop)
                             : isDeep(sums) ? pixelSums<Rgba16>(sums, first, end, cells, stop)
                                            : pixelSums<std::uint32_t>(sums, first, end, cells, stop);
        if (!isDrawn) return false;
        writeTiles(cells, header, writer);
        first = end;
    }
    return true;
}

template <class Pixel> Failure writeRow(const CellSums& cells, int row, PictureWriter& writer) {
    std::vector<CellSums::Sum> sums;
    std::vector<Pixel> pixels(std::size_t(cells.window().width));
    if (cells.sumsOfRow(row, sums))
        for (std::size_t x = 0; x < pixels.size(); ++x)
            setPixel(sums[x], pixels[x]);
    return writer.writeRows(std::span<const Pixel>(pixels));
}

Failure writeDepths(const CellSums& cells, int row, PngWriter& writer) {
    std::vector<std::uint64_t> sums(std::size_t(cells.window().width));
    if (!cells.samplesOfRow(row, sums)) sums.assign(std::size_t(cells.window().width), 0);
    std::vector<std::uint16_t> values(sums.size());
    std::ranges::transform(sums, values.begin(),
                           [](std::uint64_t sum) { return std::uint16_t(emptyDepth - sum); });
    return writer.writeRows(values);
}

// The bands of a solid, from its files. write(cells, row of the cells) returns a failure.
template <class Write>
ExportOutcome putTogether(const SpaceSums& sums, Write write, const Progress& progress,
                          const std::stop_token& stop) {
    const SumHeader header = headerOf(sums);
    ExportOutcome outcome;
    CellSums cells;
    for (int first = 0; first < header.rows && !outcome.failure; first += bandRows) {
        if (progress) progress(double(first) / header.rows);
        outcome.stopped = stop.stop_requested();
        if (outcome.stopped) return outcome;
        const int end = std::min(header.rows, first + bandRows);
        cells.reset(header.kind, {header.columns, first, end}, 1);
        if (!sums.files->addTo(cells)) outcome.failure = sums.files->failure();
        for (int row = 0; row < end - first && !outcome.failure; ++row)
            outcome.failure = write(cells, row);
    }
    return outcome;
}

ExportOutcome writeSolid(const SpaceSums& sums, QIODevice& file, const Progress& progress,
                         const std::stop_token& stop) {
    ExportOutcome outcome;
    if (sums.picture.look == LookInSpace::Depth) {
        attractor::SolidRendering rendering(sums.picture.request);
        rendering.drawRows(0, 0, stop); // depth range only
        PngWriter writer(file, formatOfDepths(sums.picture, rendering.raster()));
        const auto write = [&](const CellSums& cells, int row) { return writeDepths(cells, row, writer); };
        outcome = putTogether(sums, write, progress, stop);
        if (!outcome.failure && !outcome.stopped) outcome.failure = writer.finish();
        return outcome;
    }
    const auto writer = pictureWriter(sums.picture.file, file, formatOf(sums.picture));
    const auto write = [&](const CellSums& cells, int row) {
        return isDeep(sums) ? writeRow<Rgba16>(cells, row, *writer)
                            : writeRow<std::uint32_t>(cells, row, *writer);
    };
    outcome = putTogether(sums, write, progress, stop);
    if (!outcome.failure && !outcome.stopped) outcome.failure = writer->finish();
    return outcome;
}

} // namespace

bool areOfSpace(const SumFiles& files) {
    return isOfSpace(files.header().request);
}

LoadedSpaceSums spaceSumsIn(const std::shared_ptr<SumFiles>& files, int threads) {
    LoadedSpaceSums loaded;
    SpaceSums& sums = loaded.sums;
    const bool isAsked = takeFiles(sums, spacePictureOf(files->header().request), files, threads);
    if (!isAsked || !haveSameCells(headerOf(sums), files->header()))
        loaded.failure = otherPixels(files->name());
    else if (memoryFor(sums.picture) > maxBytes)
        loaded.failure =
            Text::tr("The picture in “%1” needs more than 4 GB of memory in space.").arg(files->name());
    return loaded;
}

SpaceSums partOf(const SpaceExport& picture, int firstRow, int endRow, const attractor::PicturePart& part) {
    SpaceSums sums;
    sums.picture = spacePictureOf(pictureRequest(picture)).value_or(picture);
    sums.picture.request.threads = picture.request.threads;
    sums.picture.request.samples = picture.request.samples;
    sums.passes = {isCloud(sums) ? picture.request.samples : 1};
    sums.drawn = {{firstRow, endRow, 0, part}};
    return sums;
}

void addPass(SpaceSums& sums, std::uint64_t samples) {
    sums.drawn = {{0, sums.picture.request.camera.size.height, sums.passes.size(), {}}};
    sums.passes.push_back(samples);
}

ExportOutcome exportSums(const SpaceSums& sums, const QString& path, const Progress& progress,
                         std::stop_token stop) {
    const auto fill = [&](SumWriter& writer) {
        if (sums.drawn.empty())
            return sums.files->writeTo(writer, sums.picture.request.threads, progress, stop);
        return isCloud(sums) ? countRows(sums, writer, progress, stop)
                             : drawRows(sums, writer, progress, stop);
    };
    return writeSums(headerOf(sums), sums.files, fill, path);
}

Failure incompleteness(const SpaceSums& sums) {
    return missingIn(
        headerOf(sums), sums.picture.request.camera.size.height, [&](std::span<const std::uint64_t> passes) {
            return isCloud(sums) ? attractor::CloudRendering::units(passes) : std::uint64_t(passes.size());
        });
}

ExportOutcome exportPicture(const SpaceSums& sums, const QString& path, const Progress& progress,
                            std::stop_token stop) {
    return writtenWhole(path, incompleteness(sums), [&](QIODevice& file) {
        ExportOutcome outcome;
        if (isCloud(sums)) {
            SpaceExport picture = sums.picture;
            picture.divided = dividedPicture(sums.passes, sums.drawn, sums.files);
            outcome = drawSpaceFile(picture, file, progress, stop);
        } else {
            outcome = writeSolid(sums, file, progress, stop);
        }
        if (sums.files && sums.files->failure()) outcome = {sums.files->failure(), false, outcome.note};
        return outcome;
    });
}

} // namespace io
