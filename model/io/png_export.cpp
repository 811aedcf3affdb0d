// SPDX-License-Identifier: MIT
#include "io/png_export.h"

#include "io/fractint_writer.h"
#include "io/png_writer.h"

#include <QCoreApplication>
#include <QSaveFile>

#include <algorithm>
#include <cstring>
#include <thread>

namespace io {

namespace {

constexpr int bandHeight = 64;
constexpr double shareOfDrawing = 0.8; // of the progress; the rest is compression

// Pass after pass, so that there is progress to tell. The passes depend on the number of samples alone.
bool refineFully(attractor::Rendering& rendering, const attractor::RenderRequest& request,
                 const Progress& progress, const std::stop_token& stop) {
    constexpr std::uint64_t smallestPass = 4'000'000;
    const std::uint64_t pass = std::max(smallestPass, request.samples / 64 + 1);
    const bool once = request.algorithm == attractor::Algorithm::Deterministic;
    for (std::uint64_t done = 0; done < request.samples;) {
        const std::uint64_t now = once ? request.samples : std::min(pass, request.samples - done);
        if (!rendering.refine(stop, now) || stop.stop_requested()) return false;
        done += now;
        if (progress) progress(double(done) / double(request.samples));
    }
    return true;
}

QImage imageOf(const attractor::Frame& frame) {
    QImage image(frame.camera.width, frame.camera.height, QImage::Format_ARGB32_Premultiplied);
    if (!image.isNull())
        std::memcpy(image.bits(), frame.pixels.data(), frame.pixels.size() * sizeof(std::uint32_t));
    return image;
}

PngFormat formatOf(const PngExport& picture) {
    PngFormat format;
    format.width = picture.request.camera.width;
    format.height = picture.request.camera.height;
    format.pixels = picture.request.appearance.background.alpha == 255 ? PngFormat::Pixels::Opaque
                                                                       : PngFormat::Pixels::Transparent;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    return format;
}

QString cannotWrite(const QString& path, const QString& reason) {
    return QCoreApplication::translate("PngExport", "%1 cannot be written: %2").arg(path, reason);
}

ExportOutcome writeImage(const QImage& image, const PngExport& picture, const QString& path,
                         const Progress& progress, const std::stop_token& stop) {
    ExportOutcome outcome;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        outcome.failure = cannotWrite(path, file.errorString());
        return outcome;
    }
    PngWriter writer(file, formatOf(picture));
    const auto width = std::size_t(image.width());
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(image.constBits());
    for (int y = 0; y < image.height() && !outcome.failure; y += bandHeight) {
        if (stop.stop_requested()) {
            outcome.stopped = true; // the file destroys itself
            return outcome;
        }
        const int rows = std::min(bandHeight, image.height() - y);
        outcome.failure = writer.writeRows({pixels + width * std::size_t(y), width * std::size_t(rows)});
        if (progress) progress(shareOfDrawing + (1 - shareOfDrawing) * (y + rows) / image.height());
    }
    outcome.failure = writer.finish();
    if (!outcome.failure && !file.commit()) outcome.failure = cannotWrite(path, file.errorString());
    return outcome;
}

} // namespace

Picture drawPicture(const PngExport& picture, const Progress& progress, std::stop_token stop) {
    attractor::Rendering rendering(picture.request);
    if (!refineFully(rendering, picture.request, progress, stop)) return {};
    const attractor::Frame frame = rendering.frame();
    Picture drawn{imageOf(frame), frame.note};
    if (picture.cage == CageVisibility::Shown)
        paintCage(drawn.image, picture.fractal, picture.request.camera);
    return drawn;
}

ExportOutcome exportPng(const PngExport& picture, const QString& path, const Progress& progress,
                        std::stop_token stop) {
    const Progress drawing =
        progress ? Progress([&](double fraction) { progress(shareOfDrawing * fraction); }) : Progress();
    const Picture drawn = drawPicture(picture, drawing, stop);
    ExportOutcome outcome;
    if (stop.stop_requested())
        outcome.stopped = true;
    else if (drawn.image.isNull())
        outcome.failure =
            cannotWrite(path, QCoreApplication::translate("PngExport", "the picture is too large."));
    else
        outcome = writeImage(drawn.image, picture, path, progress, stop);
    outcome.note = drawn.note;
    return outcome;
}

std::uint64_t memoryFor(const attractor::RenderRequest& request) {
    const auto pixels = std::uint64_t(request.camera.width) * std::uint64_t(request.camera.height);
    const auto supersample = std::uint64_t(std::max(1, request.appearance.supersample));
    const bool coloured = request.appearance.colourBy == attractor::ColourBy::Map ||
                          request.appearance.colourBy == attractor::ColourBy::Address;
    const std::uint64_t cell = coloured ? 16 : 4; // per thread
    return pixels *
           (supersample * supersample * cell * std::uint64_t(request.threads) + 2 * sizeof(std::uint32_t));
}

int threadsOfThisMachine() {
    return int(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace io
