// SPDX-License-Identifier: MIT
#include "io/export_job.h"

#include "document/text/text.h"
#include "io/file/background.h"

#include <functional>
#include <new>

namespace io {

namespace {

ExportOutcome exportSvg(const SvgExport& what, const QString& path, const Progress& progress,
                        const std::stop_token& stop) {
    ExportOutcome outcome;
    QByteArray bytes;
    if (what.file == ShapeFile::Pdf) {
        PdfPicture picture = pdfPicture({{what.fractal, what.camera, what.format}}, stop);
        bytes = std::move(picture.bytes);
        outcome.failure = std::move(picture.failure);
    } else {
        SvgPicture picture = svgPicture(what.fractal, what.camera, what.format, stop);
        bytes = std::move(picture.bytes);
        outcome.failure = std::move(picture.plan.failure);
    }
    outcome.stopped = stop.stop_requested();
    if (!outcome.failure && !outcome.stopped) outcome.failure = saveFile(path, bytes);
    if (progress) progress(1);
    return outcome;
}

QFuture<QImage> drawnBeside(const std::function<QImage(const Progress&, const std::stop_token&)>& draw) {
    return inBackground<QImage>([draw](QPromise<QImage>& promise) {
        constexpr int whole = 100;
        promise.setProgressRange(0, whole);
        std::stop_source stop;
        const auto progress = [&](double share) {
            promise.setProgressValue(int(share * whole));
            if (promise.isCanceled()) stop.request_stop();
        };
        try {
            promise.addResult(draw(progress, stop.get_token()));
        } catch (const std::bad_alloc&) {
            promise.addResult(QImage());
        }
    });
}

} // namespace

ExportOutcome exportTo(const Export& what, const QString& path, const Progress& progress,
                       std::stop_token stop) {
    try {
        if (const auto* png = std::get_if<PlaneExport>(&what)) return exportPlane(*png, path, progress, stop);
        if (const auto* cloud = std::get_if<PointCloud>(&what))
            return exportPoints(*cloud, path, progress, stop);
        if (const auto* strip = std::get_if<PictureStrip>(&what))
            return exportStrip(*strip, path, progress, stop);
        if (const auto* solid = std::get_if<SolidExport>(&what))
            return exportSolid(*solid, path, progress, stop);
        if (const auto* space = std::get_if<SpaceExport>(&what))
            return exportSpace(*space, path, progress, stop);
        if (const auto* animation = std::get_if<AnimationExport>(&what))
            return exportAnimation(*animation, path, progress, stop);
        return exportSvg(std::get<SvgExport>(what), path, progress, stop);
    } catch (const std::bad_alloc&) {
        ExportOutcome outcome;
        outcome.isShortOfMemory = true;
        outcome.failure =
            Text::tr("There is not enough memory for this picture. Reduce its size or the supersampling.");
        return outcome;
    }
}

QFuture<QImage> drawBeside(const PlaneExport& what) {
    return drawnBeside([what](const Progress& progress, const std::stop_token& stop) {
        return drawPicture(what, progress, stop).image;
    });
}

QFuture<QImage> drawBeside(const SpaceExport& what) {
    return drawnBeside([what](const Progress& progress, const std::stop_token& stop) {
        return drawSpacePicture(what, progress, stop).image;
    });
}

} // namespace io
