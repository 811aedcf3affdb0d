// SPDX-License-Identifier: MIT
#include "io/picture/solid_picture.h"

#include "attractor/light/pixel_average.h"
#include "attractor/light/solid_light.h"
#include "attractor/render/solid_rendering.h"
#include "ifs/extent/support_function.h"
#include "io/picture/picture_writers.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace io {

namespace {

using attractor::Rgba16;

constexpr int bandRows = 64;    // rows of the picture lit and written at a time
constexpr int rowsOfLight = 13; // rows of the raster on either side that influence the light of a row

// Pixels drawn along each side of one of the picture.
int sideOf(const SolidPicture& picture) {
    const attractor::Look look = picture.appearance.look;
    const bool isNumbers = look == attractor::Look::Depth || look == attractor::Look::Normals;
    return isNumbers ? 1 : picture.supersample;
}

// The values of y between which colours by height run: those that the attractor reaches, or else those in
// view.
std::pair<double, double> heights(const attractor::SpaceRequest& request) {
    if (!request.cage)
        if (const auto support = ifs::SupportFunction<3>::of(ifs::activeMaps(request.system).maps)) {
            const ifs::Vector<3> up = ifs::Vector<3>::UnitY();
            return {-(*support)(-up).value, (*support)(up).value};
        }
    const double half = request.camera.height / 2;
    return {request.camera.target.y() - half, request.camera.target.y() + half};
}

// Rows of the picture, and the pixels drawn along each side of one of its own.
struct Rows {
    int first = 0;
    int end = 0;
    int side = 1;
};

// Some rows at a time into take(pixels), which returns a failure.
template <class Pixel, class Take>
ExportOutcome lightRows(const attractor::DepthRaster& raster, const attractor::SolidLight& light,
                        const Rows& rows, Take take, const Progress& progress, const std::stop_token& stop) {
    ExportOutcome outcome;
    const int side = rows.side, width = raster.width / side;
    std::vector<Pixel> fine(static_cast<std::size_t>(raster.width) *
                            static_cast<std::size_t>(side * bandRows));
    std::vector<Pixel> pixels(static_cast<std::size_t>(width) * bandRows);
    for (int row = rows.first; row < rows.end && !outcome.failure; row += bandRows) {
        if (stop.stop_requested()) {
            outcome.stopped = true;
            return outcome;
        }
        const int end = std::min(row + bandRows, rows.end);
        const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(end - row);
        const std::span<Pixel> out(pixels.data(), count);
        light.apply(raster, row * side, end * side, std::span<Pixel>(fine));
        attractor::averagePixels(std::span<const Pixel>(fine), side, width, out);
        outcome.failure = take(std::span<const Pixel>(out));
        if (progress)
            progress(shareOfDrawing + (1 - shareOfDrawing) * (end - rows.first) / (rows.end - rows.first));
    }
    return outcome;
}

Rows allRows(const SolidPicture& picture) {
    return {0, picture.request.camera.size.height, sideOf(picture)};
}

// The progress of some rows as that of all.
Progress partOf(const Progress& progress, const Rows& rows, int first, int end) {
    if (!progress) return {};
    return [=](double fraction) {
        progress((first - rows.first + fraction * (end - first)) / (rows.end - rows.first));
    };
}

template <class Pixel, class Take>
ExportOutcome drawRows(const SolidPicture& picture, const Rows& rows, Take take, const Progress& progress,
                       const std::stop_token& stop) {
    const int side = rows.side, together = rowsTogether(picture);
    attractor::SpaceRequest request = picture.request;
    request.camera.size.width *= side;
    request.camera.size.height *= side;
    const auto [lowest, highest] = heights(request);
    attractor::SolidView view = attractor::solidView(request.camera, lowest, highest);
    view.eyeShift = request.eyeShift;
    const attractor::SolidLight light(picture.appearance, view);
    attractor::SolidRendering rendering(std::move(request));
    ExportOutcome outcome;
    bool isCoarse = false;
    for (int first = rows.first; first < rows.end && !outcome.failure; first += together) {
        const int end = std::min(first + together, rows.end);
        const Progress part = partOf(progress, rows, first, end);
        if (!rendering.drawRows(first * side - rowsOfLight, end * side + rowsOfLight, stop)) {
            outcome.stopped = true;
            return outcome;
        }
        if (part) part(shareOfDrawing);
        outcome = lightRows<Pixel>(rendering.raster(), light, {first, end, side}, take, part, stop);
        isCoarse = isCoarse || rendering.work().isCoarse;
        outcome.note = rendering.note();
        outcome.isCoarse = isCoarse;
        if (outcome.stopped) return outcome;
    }
    return outcome;
}

template <class Pixel>
ExportOutcome drawInto(const SolidPicture& picture, const Rows& rows, std::span<Pixel> pixels,
                       const Progress& progress, const std::stop_token& stop) {
    auto at = pixels.begin();
    const auto take = [&at](std::span<const Pixel> drawn) -> Failure {
        at = std::ranges::copy(drawn, at).out;
        return std::nullopt;
    };
    return drawRows<Pixel>(picture, rows, take, progress, stop);
}

} // namespace

int rowsTogether(const SolidPicture& picture) {
    const attractor::RasterSize& size = picture.request.camera.size;
    const auto side = static_cast<std::uint64_t>(sideOf(picture));
    const std::uint64_t row =
        side * side * static_cast<std::uint64_t>(std::max(1, size.width)) * sizeof(std::uint32_t);
    const auto most = static_cast<std::uint64_t>(std::max(1, size.height));
    return static_cast<int>(
        std::clamp<std::uint64_t>(picture.bandBytes / row, std::min<std::uint64_t>(bandRows, most), most));
}

std::uint64_t memoryFor(const SolidPicture& picture) {
    const auto side = static_cast<std::uint64_t>(sideOf(picture));
    const auto width = side * static_cast<std::uint64_t>(std::max(1, picture.request.camera.size.width));
    const auto rows = side * static_cast<std::uint64_t>(rowsTogether(picture)) + 2 * rowsOfLight;
    return width * rows * sizeof(std::uint32_t) + 2 * width * side * bandRows * sizeof(Rgba16);
}

ExportOutcome writeSolid(const SolidPicture& picture, PictureWriter& writer, const Progress& progress,
                         const std::stop_token& stop) {
    const auto take = [&writer](auto rows) { return writer.writeRows(rows); };
    ExportOutcome outcome = picture.depth == PictureFormat::Depth::Bits16
                                ? drawRows<Rgba16>(picture, allRows(picture), take, progress, stop)
                                : drawRows<std::uint32_t>(picture, allRows(picture), take, progress, stop);
    if (!outcome.failure && !outcome.stopped) outcome.failure = writer.finish();
    return outcome;
}

ExportOutcome drawSolidRows(const SolidPicture& picture, int firstRow, int endRow,
                            std::span<std::uint32_t> pixels, const Progress& progress,
                            const std::stop_token& stop) {
    return drawInto(picture, {firstRow, endRow, sideOf(picture)}, pixels, progress, stop);
}

ExportOutcome drawSolidRows(const SolidPicture& picture, int firstRow, int endRow, std::span<Rgba16> pixels,
                            const Progress& progress, const std::stop_token& stop) {
    return drawInto(picture, {firstRow, endRow, sideOf(picture)}, pixels, progress, stop);
}

} // namespace io
