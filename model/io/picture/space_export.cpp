// SPDX-License-Identifier: MIT
#include "io/picture/space_export.h"

#include "attractor/render/cloud_rendering.h"
#include "attractor/render/solid_rendering.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/solid_picture.h"
#include "io/text/number.h"

#include <QBuffer>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace io {

namespace {

constexpr double shareOfDrawing = 0.8;   // of the progress; the rest is compression
constexpr std::size_t rowsTogether = 16; // between two looks at the stop token

PngFormat formatOf(const SpaceExport& picture) {
    PngFormat format;
    format.width = picture.request.camera.size.width * (picture.stereo == Stereo::SideBySide ? 2 : 1);
    format.height = picture.request.camera.size.height;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    return format;
}

template <class Pixel>
void write(PngWriter& writer, const std::vector<Pixel>& pixels, int width, ExportOutcome& outcome,
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
    PngFormat format = formatOf(picture);
    format.pixels = PngFormat::Pixels::Grey;
    format.depth = PngFormat::Depth::Bits16;
    format.texts.emplace_back("barycage:near", formatNumber(raster.near));
    format.texts.emplace_back("barycage:far", formatNumber(raster.far));
    PngWriter writer(device, format);
    write(writer, values, format.width, outcome, progress, stop);
    return outcome;
}

PngFormat colourFormat(const SpaceExport& picture) {
    const attractor::Rgba& background = attractor::showsCloud(picture.look)
                                            ? picture.request.appearance.background
                                            : picture.solid.background;
    PngFormat format = formatOf(picture);
    format.pixels = background.alpha == 255 ? PngFormat::Pixels::Opaque : PngFormat::Pixels::Transparent;
    format.depth = picture.depth;
    return format;
}

SolidPicture solidOf(const SpaceExport& picture) {
    return {picture.request, picture.solid, picture.depth, picture.supersample};
}

// Into `pixels`, as many as the picture has.
template <class Pixel>
ExportOutcome cloudPixels(const SpaceExport& picture, std::vector<Pixel>& pixels, const Progress& progress,
                          const std::stop_token& stop) {
    constexpr std::uint64_t slice = std::uint64_t{1} << 26; // whole sample sets
    const std::uint64_t samples = picture.request.samples;
    attractor::SpaceRequest request = picture.request;
    request.samples = std::min(samples, slice);
    attractor::CloudRendering rendering(request);
    ExportOutcome outcome;
    outcome.note = rendering.note();
    for (std::uint64_t done = 0; done < samples && !outcome.stopped; done += slice) {
        if (progress) progress(shareOfDrawing * double(done) / double(samples));
        outcome.stopped = !rendering.refine(stop, std::min(slice, samples - done));
    }
    const attractor::RasterSize& size = request.camera.size;
    pixels.resize(std::size_t(size.width) * std::size_t(size.height));
    outcome.stopped = outcome.stopped || !rendering.tone(pixels, stop);
    return outcome;
}

template <class Pixel>
ExportOutcome solidPixels(const SpaceExport& picture, std::vector<Pixel>& pixels, const Progress& progress,
                          const std::stop_token& stop) {
    pixels.clear();
    const auto keep = [&](std::span<const Pixel> rows) {
        pixels.insert(pixels.end(), rows.begin(), rows.end());
        return Failure();
    };
    RowSink sink;
    if constexpr (std::is_same_v<Pixel, std::uint32_t>)
        sink.narrow = keep;
    else
        sink.wide = keep;
    return drawSolid(solidOf(picture), sink, progress, stop);
}

// What one eye sees.
template <class Pixel>
ExportOutcome pixelsOf(const SpaceExport& picture, std::vector<Pixel>& pixels, const Progress& progress,
                       const std::stop_token& stop) {
    return attractor::showsCloud(picture.look) ? cloudPixels(picture, pixels, progress, stop)
                                               : solidPixels(picture, pixels, progress, stop);
}

template <class Pixel>
ExportOutcome drawStereo(const SpaceExport& picture, std::vector<Pixel>& pixels, const Progress& progress,
                         const std::stop_token& stop) {
    std::vector<Pixel> left, right;
    SpaceExport eye = picture;
    eye.request.eyeShift = -attractor::stereoEye;
    const auto half = [&](double done) {
        return [&progress, done](double fraction) {
            if (progress) progress(done + fraction / 2);
        };
    };
    ExportOutcome outcome = pixelsOf(eye, left, half(0), stop);
    if (outcome.failure || outcome.stopped) return outcome;
    eye.request.eyeShift = attractor::stereoEye;
    outcome = pixelsOf(eye, right, half(0.5), stop);
    if (outcome.failure || outcome.stopped) return outcome;
    pixels = joined(picture.stereo, left, right, picture.request.camera.size.width);
    return outcome;
}

template <class Pixel>
ExportOutcome drawColours(const SpaceExport& picture, QIODevice& device, const Progress& progress,
                          const std::stop_token& stop) {
    const bool isStereo = picture.stereo != Stereo::None;
    const PngFormat format = colourFormat(picture);
    if (!isStereo && !attractor::showsCloud(picture.look)) {
        PngWriter writer(device, format);
        return writeSolid(solidOf(picture), writer, progress, stop);
    }
    std::vector<Pixel> pixels;
    ExportOutcome outcome =
        isStereo ? drawStereo(picture, pixels, progress, stop) : cloudPixels(picture, pixels, progress, stop);
    if (outcome.failure || outcome.stopped) return outcome;
    PngWriter writer(device, format);
    write(writer, pixels, format.width, outcome, progress, stop);
    return outcome;
}

} // namespace

std::uint64_t memoryFor(const SpaceExport& picture) {
    const auto pixels = std::uint64_t(std::max(1, picture.request.camera.size.width)) *
                        std::uint64_t(std::max(1, picture.request.camera.size.height));
    if (picture.look == attractor::LookInSpace::Depth)
        return pixels * (sizeof(std::uint32_t) + 2 * sizeof(std::uint16_t));
    const std::uint64_t stereo = picture.stereo == Stereo::None ? 0 : 4 * pixels * sizeof(attractor::Rgba16);
    if (!attractor::showsCloud(picture.look)) return stereo + memoryFor(solidOf(picture));
    const auto side = std::uint64_t(picture.request.appearance.supersample);
    const std::uint64_t cell = picture.look == attractor::LookInSpace::XRay ||
                                       attractor::coloursSamples(picture.request.appearance.colourBy)
                                   ? sizeof(attractor::ColourCell)
                                   : sizeof(std::uint32_t);
    return stereo + pixels * (cell * side * side * std::uint64_t(picture.request.threads) +
                              2 * sizeof(attractor::Rgba16));
}

ExportOutcome drawSpacePng(const SpaceExport& picture, QByteArray& png, const Progress& progress,
                           std::stop_token stop) {
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (picture.look == attractor::LookInSpace::Depth) return drawDepths(picture, buffer, progress, stop);
    return picture.depth == PngFormat::Depth::Bits16
               ? drawColours<attractor::Rgba16>(picture, buffer, progress, stop)
               : drawColours<std::uint32_t>(picture, buffer, progress, stop);
}

} // namespace io
