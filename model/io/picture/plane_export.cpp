// SPDX-License-Identifier: MIT
#include "io/picture/plane_export.h"

#include "io/fractint/entry_writer.h"
#include "io/overlay/map_legend.h"
#include "io/picture/legend_rows.h"
#include "io/picture/picture_writers.h"

#include <algorithm>
#include <memory>
#include <span>
#include <thread>
#include <vector>

namespace io {

namespace {

using attractor::Rgba16;

enum class Drawn { All, Stopped, Refused };

const document::Fractal& explained(const PlaneExport& picture) {
    return picture.explained ? *picture.explained : picture.fractal;
}

// Band after band, from the top: into what room(first row, rows) gives, then take(pixels).
template <class Pixel, class Room, class Take>
Drawn drawBands(const PlaneExport& picture, Room room, Take take, const Progress& progress,
                const std::stop_token& stop, attractor::RenderNote& note) {
    const attractor::Camera& camera = picture.request.camera;
    attractor::BandedRendering rendering(picture.request);
    if (picture.divided) rendering.divide(*picture.divided);
    if (!picture.moments.empty()) rendering.openShutter(picture.moments);
    if (picture.exposure) rendering.useExposure(*picture.exposure);
    note = rendering.note();
    const OverlayMarks overlay = picture.overlay == PictureOverlay()
                                     ? OverlayMarks()
                                     : overlayMarks(explained(picture), camera, picture.overlay);
    const int most = attractor::BandedRendering::rowsWithin(picture.request, picture.bandBytes);
    for (int first = 0; first < camera.height; first += most) {
        const int rows = std::min(most, camera.height - first);
        const auto told = [&](double share) {
            if (progress) progress((first + share * rows) / camera.height);
        };
        const auto drawing = [&](double fraction) { told(shareOfDrawing * fraction); };
        const std::span<Pixel> pixels = room(first, rows);
        if (!rendering.band(first, rows, pixels, stop, drawing)) return Drawn::Stopped;
        if (picture.cage == CageVisibility::Shown) {
            QImage image = imageOver(pixels, camera.width);
            paintCage(image, picture.fractal, camera, picture.fractal.appearance.background, first);
        }
        if (!overlay.empty()) {
            QImage image = imageOver(pixels, camera.width);
            paintOverlay(image, overlay, first);
        }
        const auto writing = [&](double fraction) { told(shareOfDrawing + (1 - shareOfDrawing) * fraction); };
        const Drawn taken = take(pixels, writing);
        if (taken != Drawn::All) return taken;
    }
    return Drawn::All;
}

PictureFormat formatOf(const PlaneExport& picture, const QImage& legend = {}) {
    PictureFormat format;
    format.width = picture.request.camera.width + legend.width();
    format.height = picture.request.camera.height;
    format.pixels = picture.request.appearance.background.alpha == 255 ? PictureFormat::Pixels::Opaque
                                                                       : PictureFormat::Pixels::Transparent;
    format.depth = picture.depth;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    format.quality = picture.quality;
    return format;
}

QImage legendOf(const PlaneExport& picture, QImage::Format format) {
    if (!picture.withLegend) return {};
    return mapLegend(explained(picture), picture.request.camera.height).convertToFormat(format);
}

template <class Pixel>
ExportOutcome drawInto(QIODevice& file, const PlaneExport& picture, const Progress& progress,
                       const std::stop_token& stop) {
    ExportOutcome outcome;
    const QImage legend = legendOf(picture, imageFormat<Pixel>);
    const std::unique_ptr<PictureWriter> writer =
        pictureWriter(picture.file, file, formatOf(picture, legend));
    const auto width = std::size_t(picture.request.camera.width);
    std::vector<Pixel> memory, whole;
    int row = 0;
    const auto room = [&](int, int rows) {
        memory.resize(width * std::size_t(rows));
        return std::span(memory);
    };
    const auto take = [&](std::span<const Pixel> pixels, const Progress& writing) {
        constexpr std::size_t few = 16; // rows between two checks of the stop token
        for (std::size_t at = 0; at < pixels.size(); at += few * width) {
            if (stop.stop_requested()) return Drawn::Stopped;
            const auto rows = pixels.subspan(at, std::min(few * width, pixels.size() - at));
            outcome.failure = writer->writeRows(withLegend<Pixel>(rows, width, legend, row, whole));
            row += int(rows.size() / width);
            if (outcome.failure) return Drawn::Refused;
            writing(double(at) / double(pixels.size()));
        }
        return Drawn::All;
    };
    const Drawn drawn = drawBands<Pixel>(picture, room, take, progress, stop, outcome.note);
    outcome.stopped = drawn == Drawn::Stopped;
    if (drawn == Drawn::All) outcome.failure = writer->finish();
    return outcome;
}

} // namespace

Picture drawPicture(const PlaneExport& picture, const Progress& progress, std::stop_token stop) {
    const attractor::Camera& camera = picture.request.camera;
    Picture drawn{QImage(camera.width, camera.height, QImage::Format_ARGB32_Premultiplied), {}};
    if (drawn.image.isNull()) return drawn;
    const auto room = [&](int first, int rows) {
        return std::span(reinterpret_cast<std::uint32_t*>(drawn.image.scanLine(first)),
                         std::size_t(camera.width) * std::size_t(rows));
    };
    const auto take = [](std::span<std::uint32_t>, const Progress&) { return Drawn::All; };
    if (drawBands<std::uint32_t>(picture, room, take, progress, stop, drawn.note) != Drawn::All)
        drawn.image = {};
    return drawn;
}

ExportOutcome exportPlane(const PlaneExport& picture, const QString& path, const Progress& progress,
                          std::stop_token stop) {
    return writtenWhole(path, whyImpossible(picture), [&](QIODevice& file) {
        return picture.depth == PictureFormat::Depth::Bits16
                   ? drawInto<Rgba16>(file, picture, progress, stop)
                   : drawInto<std::uint32_t>(file, picture, progress, stop);
    });
}

Failure whyImpossible(const PlaneExport& picture) {
    return whyImpossible(picture.file, formatOf(picture, legendOf(picture, QImage::Format_RGB32)));
}

std::uint64_t memoryFor(const PlaneExport& picture) {
    const std::size_t pixel =
        picture.depth == PictureFormat::Depth::Bits16 ? sizeof(Rgba16) : sizeof(std::uint32_t);
    const auto rows =
        std::uint64_t(attractor::BandedRendering::rowsWithin(picture.request, picture.bandBytes));
    const auto width = std::uint64_t(std::max(1, picture.request.camera.width));
    const std::uint64_t whole = // WebP holds the picture, and its encoder as much again
        picture.file == PictureFile::WebP
            ? 3 * width * std::uint64_t(std::max(1, picture.request.camera.height)) * sizeof(std::uint32_t)
            : 0;
    return whole + rows * (attractor::BandedRendering::bytesPerRow(picture.request) + width * pixel);
}

int threadsOfThisMachine() {
    return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace io
