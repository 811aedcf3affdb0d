// SPDX-License-Identifier: MIT
#include "io/picture/space_export.h"

#include "attractor/render/cloud_rendering.h"
#include "attractor/render/solid_rendering.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/picture_writers.h"
#include "io/picture/solid_picture.h"
#include "io/text/number.h"

#include <QBuffer>

#include <algorithm>
#include <memory>
#include <vector>

namespace io {

namespace {

constexpr double shareOfDrawing = 0.8;   // of the progress; the rest is compression
constexpr std::size_t rowsTogether = 16; // between two looks at the stop token

PictureFormat formatOf(const SpaceExport& picture) {
    using enum PictureFormat::Pixels;
    PictureFormat format;
    const attractor::Rgba background =
        picture.look == SpaceLook::Solid ? picture.solid.background : picture.request.appearance.background;
    format.pixels = picture.look == SpaceLook::Depth ? Grey : background.alpha == 255 ? Opaque : Transparent;
    format.depth = picture.look == SpaceLook::Depth ? PictureFormat::Depth::Bits16 : picture.depth;
    format.width = picture.request.camera.size.width;
    format.height = picture.request.camera.size.height;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    format.quality = picture.quality;
    return format;
}

template <class Writer, class Pixel>
void write(Writer& writer, const std::vector<Pixel>& pixels, int width, ExportOutcome& outcome,
           const Progress& progress, const std::stop_token& stop) {
    const std::size_t together = rowsTogether * std::size_t(width);
    for (std::size_t at = 0; at < pixels.size() && !outcome.failure; at += together) {
        if (stop.stop_requested()) {
            outcome.stopped = true;
            return;
        }
        if (progress) progress(shareOfDrawing + (1 - shareOfDrawing) * double(at) / double(pixels.size()));
        outcome.failure =
            writer.writeRows(std::span(pixels).subspan(at, std::min(together, pixels.size() - at)));
    }
    if (!outcome.failure) outcome.failure = writer.finish();
}

ExportOutcome drawDepths(const SpaceExport& picture, QIODevice& device, const Progress& progress,
                         const std::stop_token& stop) {
    attractor::SolidRendering rendering(picture.request);
    ExportOutcome outcome;
    outcome.stopped = !rendering.draw(stop);
    outcome.note = rendering.note();
    if (outcome.stopped) return outcome;
    const attractor::DepthRaster& raster = rendering.raster();
    std::vector<std::uint16_t> values(raster.keys.size());
    std::ranges::transform(raster.keys, values.begin(), [](std::uint32_t key) {
        constexpr std::uint64_t most = 65534;
        if (key == attractor::emptyKey) return std::uint16_t(65535);
        return std::uint16_t((attractor::depthCode(key) * most + attractor::maxDepthCode / 2) /
                             attractor::maxDepthCode);
    });
    PictureFormat format = formatOf(picture);
    format.texts.emplace_back("barycage:near", formatNumber(raster.near));
    format.texts.emplace_back("barycage:far", formatNumber(raster.far));
    PngWriter writer(device, format);
    write(writer, values, format.width, outcome, progress, stop);
    return outcome;
}

template <class Pixel>
ExportOutcome drawCloud(const SpaceExport& picture, QIODevice& device, const Progress& progress,
                        const std::stop_token& stop) {
    constexpr std::uint64_t slice = std::uint64_t{1} << 26; // whole sample sets
    const std::uint64_t samples = picture.request.samples;
    attractor::SpaceRequest request = picture.request;
    request.samples = std::min(samples, slice);
    attractor::CloudRendering rendering(request);
    ExportOutcome outcome;
    outcome.note = rendering.note();
    const PictureFormat format = formatOf(picture);
    for (std::uint64_t done = 0; done < samples && !outcome.stopped; done += slice) {
        if (progress) progress(shareOfDrawing * double(done) / double(samples));
        outcome.stopped = !rendering.refine(stop, std::min(slice, samples - done));
    }
    std::vector<Pixel> pixels(std::size_t(format.width) * std::size_t(format.height));
    outcome.stopped = outcome.stopped || !rendering.tone(pixels, stop);
    if (outcome.stopped) return outcome;
    const std::unique_ptr<PictureWriter> writer = pictureWriter(picture.file, device, format);
    write(*writer, pixels, format.width, outcome, progress, stop);
    return outcome;
}

SolidPicture solidOf(const SpaceExport& picture) {
    return {picture.request, picture.solid, picture.depth, picture.supersample};
}

ExportOutcome drawSolid(const SpaceExport& picture, QIODevice& device, const Progress& progress,
                        const std::stop_token& stop) {
    const PictureFormat format = formatOf(picture);
    const std::unique_ptr<PictureWriter> writer = pictureWriter(picture.file, device, format);
    return writeSolid(solidOf(picture), *writer, progress, stop);
}

} // namespace

std::uint64_t memoryFor(const SpaceExport& picture) {
    const auto pixels = std::uint64_t(std::max(1, picture.request.camera.size.width)) *
                        std::uint64_t(std::max(1, picture.request.camera.size.height));
    if (picture.look == SpaceLook::Depth) return pixels * (sizeof(std::uint32_t) + 2 * sizeof(std::uint16_t));
    if (picture.look == SpaceLook::Solid) return memoryFor(solidOf(picture));
    const auto side = std::uint64_t(picture.request.appearance.supersample);
    const std::uint64_t cell = attractor::coloursSamples(picture.request.appearance.colourBy)
                                   ? sizeof(attractor::ColourCell)
                                   : sizeof(std::uint32_t);
    return pixels *
           (cell * side * side * std::uint64_t(picture.request.threads) + 2 * sizeof(attractor::Rgba16));
}

ExportOutcome drawSpacePng(const SpaceExport& picture, QByteArray& bytes, const Progress& progress,
                           std::stop_token stop) {
    ExportOutcome refused;
    refused.failure = whyImpossible(picture.file, formatOf(picture));
    if (refused.failure) return refused;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (picture.look == SpaceLook::Depth) return drawDepths(picture, buffer, progress, stop);
    if (picture.look == SpaceLook::Solid) return drawSolid(picture, buffer, progress, stop);
    return picture.depth == PngFormat::Depth::Bits16
               ? drawCloud<attractor::Rgba16>(picture, buffer, progress, stop)
               : drawCloud<std::uint32_t>(picture, buffer, progress, stop);
}

} // namespace io
