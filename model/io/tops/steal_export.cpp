// SPDX-License-Identifier: MIT
#include "io/tops/steal_export.h"

#include "document/text/text.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/png/png_writer.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace io {

namespace {

PictureFormat formatOf(const StealExport& what) {
    PictureFormat format;
    format.width = what.request.camera.width;
    format.height = what.request.camera.height;
    format.pixels = what.request.background.alpha == 255 ? PictureFormat::Pixels::Opaque
                                                         : PictureFormat::Pixels::Transparent;
    format.systemText = writeEntry(what.fractal);
    return format;
}

// A note beyond the size at which doubles have no digits left for a pixel.
attractor::RenderNote noteOf(const StealExport& what) {
    const attractor::Camera& camera = what.request.camera;
    double farthest = camera.centre.cwiseAbs().maxCoeff();
    for (const double height : what.system.around.heights)
        farthest = std::max(farthest, std::abs(height));
    return camera.pixelsPerUnit * farthest * 0x1p-50 > 0.5 ? attractor::RenderNote::TooDeep
                                                           : attractor::RenderNote::None;
}

} // namespace

attractor::Camera pictureCamera(int width, int height, const ifs::Vector<2>& min, const ifs::Vector<2>& max) {
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    return fitted(camera, min, max);
}

ExportOutcome exportStolen(const StealExport& what, const QString& path, const Progress& progress,
                           const std::stop_token& stop) {
    return writtenWhole(path, {}, [&](QIODevice& file) {
        ExportOutcome outcome{{}, false, noteOf(what)};
        PngWriter writer(file, formatOf(what));
        const double pixels = double(what.request.camera.width) * double(what.request.camera.height);
        double written = 0;
        const auto take = [&](std::span<const std::uint32_t> rows) {
            outcome.failure = writer.writeRows(rows);
            written += double(rows.size());
            if (progress) progress(written / pixels);
            return !outcome.failure;
        };
        const auto ended = attractor::steal(what.system, what.picture, what.request, take, stop);
        outcome.stopped = ended == attractor::TheftOutcome::Stopped;
        if (ended == attractor::TheftOutcome::CutShort)
            outcome.failure =
                Text::tr("An exact picture of this system would take too long. Draw it with points.");
        else if (!outcome.failure && !outcome.stopped)
            outcome.failure = writer.finish();
        return outcome;
    });
}

QImage drawStolen(const StealExport& what, const std::stop_token& stop) {
    const attractor::Camera& camera = what.request.camera;
    QImage image(camera.width, camera.height, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) return image;
    int row = 0;
    const auto take = [&](std::span<const std::uint32_t> rows) {
        std::ranges::copy(rows, reinterpret_cast<std::uint32_t*>(image.scanLine(row)));
        row += int(rows.size() / std::size_t(camera.width));
        return true;
    };
    const auto outcome = attractor::steal(what.system, what.picture, what.request, take, stop);
    return outcome == attractor::TheftOutcome::Done ? image : QImage();
}

} // namespace io
