// SPDX-License-Identifier: MIT
#include "io/sums/picture_sums.h"

#include "io/sums/picture_request.h"
#include "io/sums/sum_writing.h"

#include <algorithm>
#include <span>

namespace io {

namespace {

using attractor::BandedRendering;
using attractor::CellKind;
using attractor::CellSums;
using attractor::PicturePart;

int sideOf(const PlaneExport& picture) {
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

// Draws the rows band by band, each of whole rows of tiles. False when stopped or a file fails.
bool drawTiles(const PictureSums& sums, SumWriter& writer, const Progress& progress,
               const std::stop_token& stop) {
    const SumHeader header = headerOf(sums);
    const int firstRow = sums.drawn.front().firstRow;
    const int endRow = sums.drawn.front().endRow;
    BandedRendering rendering(sums.picture.request);
    rendering.divide(dividedPicture(sums.passes, sums.drawn, sums.files));
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

LoadedSums sumsIn(const std::shared_ptr<SumFiles>& files, int threads) {
    LoadedSums loaded;
    PictureSums& sums = loaded.sums;
    const bool isAsked = takeFiles(sums, pictureOf(files->header().request), files, threads);
    if (!isAsked || !haveSameCells(headerOf(sums), files->header()))
        loaded.failure = otherPixels(files->name());
    return loaded;
}

PictureSums partOf(const PlaneExport& picture, int firstRow, int endRow, const PicturePart& part) {
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
    const auto fill = [&](SumWriter& writer) {
        return sums.drawn.empty() ? sums.files->writeTo(writer, sums.picture.request.threads, progress, stop)
                                  : drawTiles(sums, writer, progress, stop);
    };
    return writeSums(headerOf(sums), sums.files, fill, path);
}

Failure incompleteness(const PictureSums& sums) {
    const BandedRendering rendering(sums.picture.request);
    return missingIn(headerOf(sums), sums.picture.request.camera.height,
                     [&](std::span<const std::uint64_t> passes) { return rendering.units(passes); });
}

ExportOutcome exportPicture(const PictureSums& sums, const QString& path, const Progress& progress,
                            std::stop_token stop) {
    ExportOutcome outcome;
    outcome.failure = incompleteness(sums);
    if (outcome.failure) return outcome;
    PlaneExport picture = sums.picture;
    picture.divided = dividedPicture(sums.passes, sums.drawn, sums.files);
    outcome = exportPlane(picture, path, progress, stop);
    if (sums.files && sums.files->failure()) outcome = {sums.files->failure(), false, outcome.note};
    return outcome;
}

} // namespace io
