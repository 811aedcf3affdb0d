// SPDX-License-Identifier: MIT
#include "io/picture/picture_strip.h"

#include "io/fractint/entry_writer.h"
#include "io/picture/picture_writers.h"

#include <algorithm>
#include <memory>
#include <new>

namespace io {

namespace {

PictureFormat formatOf(const std::vector<PlaneExport>& pictures) {
    const PlaneExport& first = pictures.front();
    PictureFormat format;
    for (const PlaneExport& picture : pictures)
        format.width += picture.request.camera.width;
    format.height = first.request.camera.height;
    const bool isOpaque = first.request.appearance.background.alpha == 255;
    format.pixels = isOpaque ? PictureFormat::Pixels::Opaque : PictureFormat::Pixels::Transparent;
    format.dotsPerInch = first.dotsPerInch;
    format.systemText = writeEntry(first.fractal);
    format.quality = first.quality;
    return format;
}

void writeRows(PictureWriter& writer, const std::vector<QImage>& images, int width, ExportOutcome& outcome,
               const std::stop_token& stop) {
    std::vector<std::uint32_t> row;
    row.reserve(std::size_t(width));
    for (int y = 0; y < images.front().height() && !outcome.failure; ++y) {
        if (stop.stop_requested()) {
            outcome.stopped = true;
            return;
        }
        row.clear();
        for (const QImage& image : images) {
            const auto* pixels = reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
            row.insert(row.end(), pixels, pixels + image.width());
        }
        outcome.failure = writer.writeRows(std::span<const std::uint32_t>(row));
    }
    if (!outcome.failure) outcome.failure = writer.finish();
}

} // namespace

ExportOutcome exportStrip(const std::vector<PlaneExport>& pictures, const QString& path,
                          const Progress& progress, std::stop_token stop) {
    const PictureFile kind = pictures.front().file;
    const PictureFormat format = formatOf(pictures);
    return writtenWhole(path, whyImpossible(kind, format), [&](QIODevice& file) {
        ExportOutcome outcome;
        std::vector<QImage> images;
        for (const PlaneExport& picture : pictures) {
            const auto share = [&](double fraction) {
                if (progress) progress((double(images.size()) + fraction) / double(pictures.size()));
            };
            Picture drawn = drawPicture(picture, share, stop);
            outcome.stopped = stop.stop_requested();
            if (outcome.stopped) return outcome;
            if (drawn.image.isNull()) throw std::bad_alloc();
            outcome.note = std::max(outcome.note, drawn.note);
            images.push_back(std::move(drawn.image));
        }
        const std::unique_ptr<PictureWriter> writer = pictureWriter(kind, file, format);
        writeRows(*writer, images, format.width, outcome, stop);
        return outcome;
    });
}

} // namespace io
