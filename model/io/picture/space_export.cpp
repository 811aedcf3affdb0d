// SPDX-License-Identifier: MIT
#include "io/picture/space_export.h"

#include "attractor/light/pixel_average.h"
#include "attractor/render/solid_rendering.h"
#include "io/fractint/entry_writer.h"
#include "io/overlay/picture_overlay.h"
#include "io/picture/legend_rows.h"
#include "io/picture/picture_writers.h"
#include "io/picture/solid_picture.h"
#include "io/text/number.h"

#include <QBuffer>

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace io {

namespace {

using attractor::LookInSpace;

constexpr std::size_t fewRows = 16; // rows between two checks of the stop token

template <class Writer, class Pixel>
void write(Writer& writer, std::span<const Pixel> pixels, int width, ExportOutcome& outcome,
           const Progress& progress, const std::stop_token& stop) {
    const std::size_t together = fewRows * std::size_t(width);
    for (std::size_t at = 0; at < pixels.size() && !outcome.failure; at += together) {
        if (stop.stop_requested()) {
            outcome.stopped = true;
            return;
        }
        if (progress) progress(shareOfDrawing + (1 - shareOfDrawing) * double(at) / double(pixels.size()));
        outcome.failure = writer.writeRows(pixels.subspan(at, std::min(together, pixels.size() - at)));
    }
}

// The progress of one pass, moment or band of many as that of the whole.
Progress partOf(const Progress& progress, std::size_t index, std::size_t count) {
    return [=](double fraction) {
        if (progress) progress((double(index) + fraction) / double(count));
    };
}

// RowRange of the picture, from 0.
struct RowRange {
    int first = 0;
    int end = 0;
};

SolidPicture solidOf(const SpaceExport& picture) {
    return {picture.request, picture.solid, picture.depth, picture.supersample, picture.bandBytes};
}

// Rows that are drawn together: all of a cloud.
int rowsTogether(const SpaceExport& picture) {
    const int height = std::max(1, picture.request.camera.size.height);
    return attractor::showsCloud(picture.look) ? height : rowsTogether(solidOf(picture));
}

// Draws the picture in bands; a cloud in a single one. draw(rows) returns how that ended.
template <class Draw> ExportOutcome inBands(const SpaceExport& picture, const Progress& progress, Draw draw) {
    const int height = picture.request.camera.size.height;
    const int together = std::max(1, rowsTogether(picture));
    const auto count = std::size_t((height + together - 1) / together);
    ExportOutcome all;
    for (std::size_t band = 0; band < count && !all.failure && !all.stopped; ++band) {
        const int first = int(band) * together;
        const bool wasCoarse = all.isCoarse;
        all = draw(RowRange{first, std::min(first + together, height)}, partOf(progress, band, count));
        all.isCoarse = all.isCoarse || wasCoarse;
    }
    return all;
}

ExportOutcome drawDepths(const SpaceExport& picture, QIODevice& device, const Progress& progress,
                         const std::stop_token& stop) {
    attractor::SolidRendering rendering(picture.request);
    ExportOutcome outcome;
    outcome.stopped = !rendering.drawRows(0, 0, stop); // depth range only
    if (outcome.stopped) return outcome;
    PngWriter writer(device, formatOfDepths(picture, rendering.raster()));
    const auto width = std::size_t(picture.request.camera.size.width);
    std::vector<std::uint16_t> values;
    outcome = inBands(picture, progress, [&](const RowRange& rows, const Progress& part) {
        ExportOutcome drawn;
        drawn.stopped = !rendering.drawRows(rows.first, rows.end, stop);
        drawn.note = rendering.note();
        drawn.isCoarse = rendering.work().isCoarse;
        if (drawn.stopped) return drawn;
        values.resize(width * std::size_t(rows.end - rows.first));
        const std::span keys(rendering.raster().row(rows.first), values.size());
        std::ranges::transform(keys, values.begin(), depthValue);
        write(writer, std::span<const std::uint16_t>(values), int(width), drawn, part, stop);
        return drawn;
    });
    if (!outcome.failure && !outcome.stopped) outcome.failure = writer.finish();
    return outcome;
}

constexpr std::uint64_t slice = std::uint64_t{1}
                                << 26; // complete sample sets between two updates of the progress

// The samples of one moment.
bool refineAll(attractor::CloudRendering& rendering, std::uint64_t samples, const Progress& progress,
               const std::stop_token& stop) {
    for (std::uint64_t done = 0; done < samples; done += slice) {
        if (progress) progress(double(done) / double(samples));
        if (!rendering.refine(stop, std::min(slice, samples - done))) return false;
    }
    return true;
}

// The moments of a shutter share the samples.
bool drawMoments(const SpaceExport& picture, attractor::CloudRendering& rendering, const Progress& progress,
                 const std::stop_token& stop) {
    const std::size_t count = std::max<std::size_t>(1, picture.moments.size());
    const std::uint64_t samples = std::max<std::uint64_t>(1, picture.request.samples / count);
    for (std::size_t k = 0; k < count; ++k) {
        if (k > 0) rendering.follow(picture.moments[k]);
        if (!refineAll(rendering, samples, partOf(progress, k, count), stop)) return false;
    }
    return true;
}

template <class Pixel>
ExportOutcome cloudPixels(const SpaceExport& picture, std::span<Pixel> pixels, const Progress& progress,
                          const std::stop_token& stop) {
    attractor::CloudRendering rendering = cloudRendering(picture);
    ExportOutcome outcome;
    outcome.note = rendering.note();
    outcome.stopped = !drawSamples(picture, rendering, progress, stop);
    if (picture.exposure) rendering.useExposure(*picture.exposure);
    outcome.stopped = outcome.stopped || !rendering.tone(pixels, stop);
    return outcome;
}

template <class Pixel>
ExportOutcome solidPixels(const SpaceExport& picture, const RowRange& rows, std::span<Pixel> pixels,
                          const Progress& progress, const std::stop_token& stop) {
    SolidPicture solid = solidOf(picture);
    if (picture.moments.empty()) return drawSolidRows(solid, rows.first, rows.end, pixels, progress, stop);
    ExportOutcome outcome;
    attractor::PictureAverage<Pixel> average;
    for (std::size_t k = 0; k < picture.moments.size() && !outcome.stopped; ++k) {
        solid.request = picture.moments[k];
        outcome = drawSolidRows(solid, rows.first, rows.end, pixels,
                                partOf(progress, k, picture.moments.size()), stop);
        average.add(pixels);
    }
    average.mean(pixels);
    return outcome;
}

using MakeWriter = std::function<std::unique_ptr<PictureWriter>(const PictureFormat&)>;

bool paintsMarks(const SpaceExport& picture) {
    return !picture.marks.empty() && !picture.page;
}

// Pixels of one eye.
template <class Pixel>
ExportOutcome eyePixels(const SpaceExport& picture, const RowRange& rows, std::span<Pixel> pixels,
                        const Progress& progress, const std::stop_token& stop) {
    return attractor::showsCloud(picture.look) ? cloudPixels(picture, pixels, progress, stop)
                                               : solidPixels(picture, rows, pixels, progress, stop);
}

template <class Pixel>
ExportOutcome eyePixels(const SpaceExport& picture, double eyeShift, const RowRange& rows,
                        std::span<Pixel> pixels, const Progress& progress, const std::stop_token& stop) {
    SpaceExport eye = picture;
    eye.request.eyeShift = eyeShift;
    for (attractor::SpaceRequest& moment : eye.moments)
        moment.eyeShift = eyeShift;
    return eyePixels(eye, rows, pixels, progress, stop);
}

template <class Pixel>
ExportOutcome pixelsOf(const SpaceExport& picture, const RowRange& rows, std::span<Pixel> pixels,
                       const Progress& progress, const std::stop_token& stop) {
    if (picture.stereo == Stereo::None) {
        const ExportOutcome outcome = eyePixels(picture, rows, pixels, progress, stop);
        if (paintsMarks(picture)) {
            QImage image = imageOver(pixels, picture.request.camera.size.width);
            paintOverlay(image, picture.marks, rows.first);
        }
        return outcome;
    }
    const attractor::RasterSize& size = picture.request.camera.size;
    std::vector<Pixel> left(std::size_t(size.width) * std::size_t(rows.end - rows.first)), right(left.size());
    const auto half = [&](double done) {
        return [&progress, done](double fraction) {
            if (progress) progress(done + fraction / 2);
        };
    };
    ExportOutcome outcome =
        eyePixels(picture, -attractor::stereoEye, rows, std::span<Pixel>(left), half(0), stop);
    if (outcome.failure || outcome.stopped) return outcome;
    outcome = eyePixels(picture, attractor::stereoEye, rows, std::span<Pixel>(right), half(0.5), stop);
    if (outcome.failure || outcome.stopped) return outcome;
    std::ranges::copy(joined(picture.stereo, left, right, size.width), pixels.begin());
    return outcome;
}

template <class Pixel>
ExportOutcome drawPixels(const SpaceExport& picture, const MakeWriter& makeWriter, const Progress& progress,
                         const std::stop_token& stop) {
    PictureFormat format = formatOf(picture);
    const auto width = std::size_t(format.width);
    const QImage legend = picture.legend.convertToFormat(imageFormat<Pixel>);
    format.width += legend.width();
    const std::unique_ptr<PictureWriter> writer = makeWriter(format);
    std::vector<Pixel> pixels, memory;
    ExportOutcome outcome = inBands(picture, progress, [&](const RowRange& rows, const Progress& part) {
        pixels.resize(width * std::size_t(rows.end - rows.first));
        const auto drawing = [&](double fraction) { part(shareOfDrawing * fraction); };
        ExportOutcome drawn = pixelsOf(picture, rows, std::span<Pixel>(pixels), drawing, stop);
        if (drawn.failure || drawn.stopped) return drawn;
        const auto all = withLegend<Pixel>(pixels, width, legend, rows.first, memory);
        write(*writer, all, format.width, drawn, part, stop);
        return drawn;
    });
    if (!outcome.failure && !outcome.stopped) outcome.failure = writer->finish();
    return outcome;
}

// A single moment of a solid is lit as it is written.
ExportOutcome writeSolidRows(const SpaceExport& picture, const MakeWriter& makeWriter,
                             const Progress& progress, const std::stop_token& stop) {
    return writeSolid(solidOf(picture), *makeWriter(formatOf(picture)), progress, stop);
}

ExportOutcome drawRows(const SpaceExport& picture, const MakeWriter& makeWriter, const Progress& progress,
                       const std::stop_token& stop) {
    const bool isPlain = picture.moments.empty() && picture.stereo == Stereo::None && !paintsMarks(picture) &&
                         picture.legend.isNull();
    if (!attractor::showsCloud(picture.look) && isPlain)
        return writeSolidRows(picture, makeWriter, progress, stop);
    return picture.depth == PictureFormat::Depth::Bits16
               ? drawPixels<attractor::Rgba16>(picture, makeWriter, progress, stop)
               : drawPixels<std::uint32_t>(picture, makeWriter, progress, stop);
}

} // namespace

PictureFormat formatOf(const SpaceExport& picture) {
    using enum PictureFormat::Pixels;
    PictureFormat format;
    const bool isDepth = picture.look == LookInSpace::Depth;
    const attractor::Rgba background = attractor::showsCloud(picture.look)
                                           ? picture.request.appearance.background
                                           : picture.solid.background;
    format.pixels = isDepth ? Grey : background.alpha == 255 ? Opaque : Transparent;
    format.depth = isDepth ? PictureFormat::Depth::Bits16 : picture.depth;
    format.width = picture.request.camera.size.width * picturesAcross(picture.stereo);
    format.height = picture.request.camera.size.height;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    format.quality = picture.quality;
    return format;
}

PictureFormat formatOfDepths(const SpaceExport& picture, const attractor::DepthRaster& raster) {
    PictureFormat format = formatOf(picture);
    format.texts.emplace_back("barycage:near", formatNumber(raster.near));
    format.texts.emplace_back("barycage:far", formatNumber(raster.far));
    return format;
}

std::uint16_t depthValue(std::uint32_t key) {
    constexpr std::uint64_t maxCode = 65534;
    if (key == attractor::emptyKey) return 65535;
    return std::uint16_t((attractor::depthCode(key) * maxCode + attractor::maxDepthCode / 2) /
                         attractor::maxDepthCode);
}

Failure whyImpossible(const SpaceExport& picture) {
    PictureFormat format = formatOf(picture);
    format.width += picture.legend.width();
    return whyImpossible(picture.file, format);
}

attractor::CloudRendering cloudRendering(const SpaceExport& picture) {
    attractor::SpaceRequest request = picture.moments.empty() ? picture.request : picture.moments.front();
    request.samples = std::min(picture.request.samples, slice);
    return attractor::CloudRendering(std::move(request));
}

bool drawSamples(const SpaceExport& picture, attractor::CloudRendering& rendering, const Progress& progress,
                 const std::stop_token& stop) {
    if (!picture.divided) return drawMoments(picture, rendering, progress, stop);
    const auto& passes = picture.divided->passes;
    for (std::size_t k = 0; k < passes.size(); ++k) {
        rendering.setPart(passes[k].part);
        if (!refineAll(rendering, passes[k].samples, partOf(progress, k, passes.size()), stop)) return false;
    }
    return !picture.divided->others || picture.divided->others(rendering.sums());
}

std::uint64_t memoryFor(const SpaceExport& picture) {
    const auto width = std::uint64_t(std::max(1, picture.request.camera.size.width));
    const std::uint64_t pixels = width * std::uint64_t(rowsTogether(picture));
    if (picture.look == LookInSpace::Depth) return pixels * (sizeof(std::uint32_t) + sizeof(std::uint16_t));
    const std::uint64_t stereo = picture.stereo == Stereo::None ? 0 : 4 * pixels * sizeof(attractor::Rgba16);
    // Marks and legend need the whole picture.
    const bool isWhole = paintsMarks(picture) || !picture.legend.isNull();
    const std::uint64_t marked = isWhole ? pixels * sizeof(attractor::Rgba16) : 0;
    if (!attractor::showsCloud(picture.look)) return stereo + marked + memoryFor(solidOf(picture));
    const auto side = std::uint64_t(picture.request.appearance.supersample);
    const std::uint64_t cell =
        picture.look == LookInSpace::XRay || attractor::coloursSamples(picture.request.appearance.colourBy)
            ? sizeof(attractor::ColourCell)
            : sizeof(std::uint32_t);
    return stereo + pixels * (cell * side * side * std::uint64_t(picture.request.threads) +
                              2 * sizeof(attractor::Rgba16));
}

ExportOutcome drawSpaceFile(const SpaceExport& picture, QIODevice& file, const Progress& progress,
                            std::stop_token stop) {
    ExportOutcome refused;
    refused.failure = whyImpossible(picture);
    if (refused.failure) return refused;
    if (picture.look == LookInSpace::Depth) return drawDepths(picture, file, progress, stop);
    const auto writer = [&](const PictureFormat& format) {
        return picture.page ? pageWriter({*picture.page, picture.fractal.name, picture.marks}, file, format)
                            : pictureWriter(picture.file, file, format);
    };
    return drawRows(picture, writer, progress, stop);
}

ExportOutcome drawSpaceFile(const SpaceExport& picture, QByteArray& bytes, const Progress& progress,
                            std::stop_token stop) {
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return drawSpaceFile(picture, buffer, progress, stop);
}

ExportOutcome exportSpace(const SpaceExport& picture, const QString& path, const Progress& progress,
                          std::stop_token stop) {
    return writtenWhole(path, whyImpossible(picture),
                        [&](QIODevice& file) { return drawSpaceFile(picture, file, progress, stop); });
}

ExportOutcome drawSpacePage(const SpaceExport& picture, PdfFile& file, const Progress& progress,
                            std::stop_token stop) {
    SpaceExport page = picture;
    page.page = ShapeFile::Pdf; // for marks as shapes
    const auto writer = [&](const PictureFormat& format) { return pageWriter(page.marks, file, format); };
    return drawRows(page, writer, progress, stop);
}

Picture drawSpacePicture(const SpaceExport& picture, const Progress& progress, std::stop_token stop) {
    const PictureFormat format = formatOf(picture);
    Picture drawn{QImage(format.width, format.height, QImage::Format_ARGB32_Premultiplied), {}};
    if (drawn.image.isNull()) return drawn;
    const std::span<std::uint32_t> pixels(reinterpret_cast<std::uint32_t*>(drawn.image.bits()),
                                          std::size_t(format.width) * std::size_t(format.height));
    const ExportOutcome outcome =
        pixelsOf(picture, {0, picture.request.camera.size.height}, pixels, progress, stop);
    drawn.note = outcome.note;
    if (outcome.stopped) drawn.image = {};
    return drawn;
}

std::optional<attractor::Exposure> cloudExposure(const SpaceExport& picture, const std::stop_token& stop) {
    constexpr std::uint64_t enough = 8'000'000;
    attractor::SpaceRequest request = picture.request;
    request.samples = std::min(request.samples, enough);
    attractor::CloudRendering rendering(request);
    if (!rendering.refine(stop)) return std::nullopt;
    const attractor::Exposure exposure = rendering.exposure(stop);
    return stop.stop_requested() ? std::nullopt : std::optional(exposure);
}

} // namespace io
