// SPDX-License-Identifier: MIT
#include "transformation/theft_export.h"

#include "document/tops/laid_picture.h"
#include "io/file/background.h"
#include "io/tops/steal_export.h"
#include "widgets/wait_for.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stop_token>

namespace view {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

constexpr std::uint64_t pointsPerPixel = 100;

attractor::Camera enlarged(attractor::Camera camera, int longerSide) {
    const double factor = double(longerSide) / std::max({camera.width, camera.height, 1});
    camera.width = std::max(1, int(std::lround(camera.width * factor)));
    camera.height = std::max(1, int(std::lround(camera.height * factor)));
    camera.pixelsPerUnit *= factor;
    return camera;
}

io::ExportOutcome drawn(const document::TheftJob& job, int longerSide, const QString& path,
                        const std::function<void(double)>& progress, const std::stop_token& stop) {
    const document::CouplingOutcome coupling =
        document::coupled(*job.from.fractal, *job.to.fractal, job.order);
    if (!coupling.entries)
        return {Text::tr("There is no fractal transformation between these entries."), false};
    attractor::DeferredTheft there(io::threadsOfThisMachine());
    const auto laid = document::laid(*coupling.entries, job.picture, job.mode, job.view, there, stop);
    if (!laid) return {std::nullopt, true};
    attractor::TheftRequest request;
    request.camera = enlarged(job.from.camera, longerSide);
    request.toPicture = laid->toPicture;
    const auto pixels = std::uint64_t(request.camera.width) * std::uint64_t(request.camera.height);
    request.points =
        std::clamp<std::uint64_t>(pointsPerPixel * pixels, 1'000'000, attractor::KeyTops::maxPoints);
    request.threads = io::threadsOfThisMachine();
    request.background = job.from.fractal->appearance.background;
    return io::exportStolen({*job.from.fractal, coupling.entries->system(), *laid->picture, request}, path,
                            progress, stop);
}

} // namespace

io::Failure exportStolenPicture(const document::TheftJob& job, int longerSide, const QString& path,
                                QWidget* window) {
    const QFuture<io::ExportOutcome> work =
        io::inBackground<io::ExportOutcome>([=](QPromise<io::ExportOutcome>& promise) {
            std::stop_source stop;
            promise.setProgressRange(0, 1000);
            const auto progress = [&](double fraction) {
                promise.setProgressValue(int(fraction * 1000));
                if (promise.isCanceled()) stop.request_stop();
            };
            promise.addResult(drawn(job, longerSide, path, progress, stop.get_token()));
        });
    if (!waitFor(QFuture<void>(work), Text::tr("Exporting the picture…"), window)) return std::nullopt;
    return work.result().failure;
}

} // namespace view
