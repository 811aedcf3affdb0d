// SPDX-License-Identifier: MIT
#include "io/picture/png_export.h"

#include "io/fractint/entry_writer.h"

#include <algorithm>
#include <span>
#include <thread>
#include <vector>

namespace io {

namespace {

using attractor::Rgba16;

constexpr double shareOfDrawing = 0.8; // of the progress; the rest is compression

enum class Drawn { All, Stopped, Refused };

QImage imageOver(std::span<std::uint32_t> pixels, int width) {
    return {reinterpret_cast<uchar*>(pixels.data()), width, int(pixels.size() / std::size_t(width)),
            qsizetype(width) * 4, QImage::Format_ARGB32_Premultiplied};
}

QImage imageOver(std::span<Rgba16> pixels, int width) {
    return {reinterpret_cast<uchar*>(pixels.data()), width, int(pixels.size() / std::size_t(width)),
            qsizetype(width) * 8, QImage::Format_RGBA64};
}

// Band after band, from the top: into what room(first row, rows) gives, then take(pixels).
template <class Pixel, class Room, class Take>
Drawn drawBands(const PngExport& picture, Room room, Take take, const Progress& progress,
                const std::stop_token& stop, attractor::RenderNote& note) {
    const attractor::Camera& camera = picture.request.camera;
    attractor::BandedRendering rendering(picture.request);
    if (picture.divided) rendering.divide(*picture.divided);
    if (!picture.moments.empty()) rendering.openShutter(picture.moments);
    if (picture.exposure) rendering.useExposure(*picture.exposure);
    note = rendering.note();
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
            paintCage(image, picture.fractal, camera, first);
        }
        const auto writing = [&](double fraction) { told(shareOfDrawing + (1 - shareOfDrawing) * fraction); };
        const Drawn taken = take(pixels, writing);
        if (taken != Drawn::All) return taken;
    }
    return Drawn::All;
}

PngFormat formatOf(const PngExport& picture) {
    PngFormat format;
    format.width = picture.request.camera.width;
    format.height = picture.request.camera.height;
    format.pixels = picture.request.appearance.background.alpha == 255 ? PngFormat::Pixels::Opaque
                                                                       : PngFormat::Pixels::Transparent;
    format.depth = picture.depth;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    return format;
}

template <class Pixel>
ExportOutcome drawInto(QIODevice& file, const PngExport& picture, const Progress& progress,
                       const std::stop_token& stop) {
    ExportOutcome outcome;
    PngWriter writer(file, formatOf(picture));
    const auto width = std::size_t(picture.request.camera.width);
    std::vector<Pixel> memory;
    const auto room = [&](int, int rows) {
        memory.resize(width * std::size_t(rows));
        return std::span(memory);
    };
    const auto take = [&](std::span<const Pixel> pixels, const Progress& writing) {
        constexpr std::size_t few = 16; // rows between two looks at the stop token
        for (std::size_t at = 0; at < pixels.size(); at += few * width) {
            if (stop.stop_requested()) return Drawn::Stopped;
            outcome.failure = writer.writeRows(pixels.subspan(at, std::min(few * width, pixels.size() - at)));
            if (outcome.failure) return Drawn::Refused;
            writing(double(at) / double(pixels.size()));
        }
        return Drawn::All;
    };
    const Drawn drawn = drawBands<Pixel>(picture, room, take, progress, stop, outcome.note);
    outcome.stopped = drawn == Drawn::Stopped;
    if (drawn == Drawn::All) outcome.failure = writer.finish();
    return outcome;
}

} // namespace

Picture drawPicture(const PngExport& picture, const Progress& progress, std::stop_token stop) {
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

ExportOutcome exportPng(const PngExport& picture, const QString& path, const Progress& progress,
                        std::stop_token stop) {
    ExportOutcome outcome;
    NewFile file(path);
    outcome.failure = file.failure();
    if (outcome.failure) return outcome;
    outcome = picture.depth == PngFormat::Depth::Bits16
                  ? drawInto<Rgba16>(file, picture, progress, stop)
                  : drawInto<std::uint32_t>(file, picture, progress, stop);
    if (file.failure())
        outcome.failure = file.failure();
    else if (!outcome.failure && !outcome.stopped)
        outcome.failure = file.commit();
    return outcome;
}

std::uint64_t memoryFor(const PngExport& picture) {
    const std::size_t pixel =
        picture.depth == PngFormat::Depth::Bits16 ? sizeof(Rgba16) : sizeof(std::uint32_t);
    const auto rows =
        std::uint64_t(attractor::BandedRendering::rowsWithin(picture.request, picture.bandBytes));
    return rows * (attractor::BandedRendering::bytesPerRow(picture.request) +
                   std::uint64_t(std::max(1, picture.request.camera.width)) * pixel);
}

int threadsOfThisMachine() {
    return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace io
