// SPDX-License-Identifier: MIT
#include "io/picture/picture_strip.h"

#include "io/fractint/entry_writer.h"

#include <algorithm>
#include <new>

namespace io {

namespace {

struct Strip {
    std::vector<QImage> images;
    int width = 0;
    int height = 0;
};

void writeRows(PngWriter& writer, const Strip& strip, ExportOutcome& outcome, const std::stop_token& stop) {
    std::vector<std::uint32_t> row;
    row.reserve(std::size_t(strip.width));
    for (int y = 0; y < strip.height && !outcome.failure; ++y) {
        if (stop.stop_requested()) {
            outcome.stopped = true;
            return;
        }
        row.clear();
        for (const QImage& image : strip.images) {
            const auto* pixels = reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
            row.insert(row.end(), pixels, pixels + image.width());
        }
        outcome.failure = writer.writeRows(std::span<const std::uint32_t>(row));
    }
    if (!outcome.failure) outcome.failure = writer.finish();
}

} // namespace

ExportOutcome exportStrip(const std::vector<PngExport>& pictures, const QString& path,
                          const Progress& progress, std::stop_token stop) {
    ExportOutcome outcome;
    NewFile file(path);
    outcome.failure = file.failure();
    if (outcome.failure) return outcome;
    Strip strip;
    for (const PngExport& picture : pictures) {
        const auto share = [&](double fraction) {
            if (progress) progress((double(strip.images.size()) + fraction) / double(pictures.size()));
        };
        Picture drawn = drawPicture(picture, share, stop);
        outcome.stopped = stop.stop_requested();
        if (outcome.stopped) return outcome;
        if (drawn.image.isNull()) throw std::bad_alloc();
        strip.width += drawn.image.width();
        strip.height = drawn.image.height();
        outcome.note = std::max(outcome.note, drawn.note);
        strip.images.push_back(std::move(drawn.image));
    }
    PngFormat format;
    format.width = strip.width;
    format.height = strip.height;
    const bool isOpaque = pictures.front().request.appearance.background.alpha == 255;
    format.pixels = isOpaque ? PngFormat::Pixels::Opaque : PngFormat::Pixels::Transparent;
    format.dotsPerInch = pictures.front().dotsPerInch;
    format.systemText = writeEntry(pictures.front().fractal);
    PngWriter writer(file, format);
    writeRows(writer, strip, outcome, stop);
    if (file.failure())
        outcome.failure = file.failure();
    else if (!outcome.failure && !outcome.stopped)
        outcome.failure = file.commit();
    return outcome;
}

} // namespace io
