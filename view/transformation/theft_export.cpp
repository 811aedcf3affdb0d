// SPDX-License-Identifier: MIT
#include "transformation/theft_export.h"

#include "document/text/text.h"
#include "document/tops/laid_picture.h"
#include "io/tops/steal_export.h"

#include <algorithm>
#include <new>
#include <variant>

namespace view {

namespace {

constexpr std::uint64_t pointsPerPixel = 100;

// Or why there is none.
std::variant<io::StealExport, io::ExportOutcome>
prepared(const document::TheftJob& job, const attractor::Camera& camera, const std::stop_token& stop) {
    const document::CouplingOutcome coupling =
        document::coupled(*job.from.fractal, *job.to.fractal, job.order);
    if (!coupling.entries)
        return io::ExportOutcome{Text::tr("There is no fractal transformation between these entries."),
                                 false};
    attractor::DeferredTheft there(io::threadsOfThisMachine());
    const auto laid = document::laid(*coupling.entries, job.picture, job.mode, job.view, there, stop);
    if (!laid) return io::ExportOutcome{std::nullopt, true};
    attractor::TheftRequest request;
    request.camera = camera;
    request.toPicture = laid->toPicture;
    const auto pixels = std::uint64_t(camera.width) * std::uint64_t(camera.height);
    request.points =
        std::clamp<std::uint64_t>(pointsPerPixel * pixels, 1'000'000, attractor::KeyTops::maxPoints);
    request.threads = io::threadsOfThisMachine();
    request.background = job.from.fractal->appearance.background;
    return io::StealExport{*job.from.fractal, coupling.entries->system(), *laid->picture, request};
}

} // namespace

io::ExportOutcome exportStolenPicture(const document::TheftJob& job, const attractor::Camera& camera,
                                      const QString& path, const io::Progress& progress,
                                      const std::stop_token& stop) {
    try {
        const auto what = prepared(job, camera, stop);
        if (const auto* outcome = std::get_if<io::ExportOutcome>(&what)) return *outcome;
        return io::exportStolen(std::get<io::StealExport>(what), path, progress, stop);
    } catch (const std::bad_alloc&) {
        return {Text::tr("There is not enough memory for this picture. Reduce its size.")};
    }
}

std::optional<QImage> stolenPicture(const document::TheftJob& job, const attractor::Camera& camera,
                                    const std::stop_token& stop) {
    const auto what = prepared(job, camera, stop);
    const auto* ready = std::get_if<io::StealExport>(&what);
    if (!ready) return std::nullopt;
    QImage drawn = io::drawStolen(*ready, stop);
    return drawn.isNull() ? std::nullopt : std::optional(std::move(drawn));
}

} // namespace view
