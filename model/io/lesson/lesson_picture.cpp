// SPDX-License-Identifier: MIT
#include "io/lesson/lesson_picture.h"

#include "attractor/render/renderer.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/exports/export_recipe.h"
#include "io/overlay/space_overlay.h"
#include "io/picture/plane_export.h"
#include "io/picture/space_export.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace io {

namespace {

using document::LessonConstruction;
using document::LessonState;

constexpr std::uint64_t samplesOfPixel = 40;
constexpr double margin = 0.05;             // of the picture
constexpr double playedSeconds = 20;        // of a chaos game that runs: a picture stands still
constexpr std::uint64_t fewPoints = 50'000; // that are drawn as dots
constexpr int dotsInWidth = 300;            // of the picture

PictureOverlay overlayOf(const LessonState& state) {
    PictureOverlay overlay;
    const bool showsMaps = state.tool == document::LessonTool::Maps;
    overlay.cage = overlay.isCageInked = state.showsCage;
    overlay.showsRest = false; // as on the canvas
    overlay.maps = state.showsCage && showsMaps;
    overlay.numbers = state.showsMapNumbers || overlay.maps;
    overlay.hull = state.outlines.contains(document::Outline::Hull);
    overlay.fixedPoints = state.outlines.contains(document::Outline::FixedPoints);
    return overlay;
}

attractor::Camera cameraInPlane(const document::Fractal& fractal, const LessonState& state,
                                const PictureOverlay& overlay, const QSize& size) {
    if (const auto* area = std::get_if<document::LessonArea>(&state.view))
        return document::cameraOf(*area, {size.width(), size.height()});
    attractor::Camera camera;
    camera.width = size.width();
    camera.height = size.height();
    if (const auto* fit = std::get_if<document::LessonFit>(&state.view)) {
        camera.yAxis = fit->yAxis;
        camera.rotation = fit->rotation;
    }
    std::vector<ifs::Vector<2>> points = overlayPoints(fractal, overlay);
    if (const auto box = document::boxWithShadow(fractal, camera.yAxis)) {
        points.push_back(box->min);
        points.push_back(box->max);
    }
    if (points.empty()) return camera;
    ifs::Vector<2> low = points.front(), high = points.front();
    for (const auto& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return fitted(camera, low, high, margin);
}

std::uint64_t playedPoints(const LessonConstruction& construction) {
    const double played = double(construction.points) + construction.speed * playedSeconds;
    return std::uint64_t(std::min(played, double(document::maxLessonPoints)));
}

// The side of a point of the attractor, in pixels of the picture: a single one is lost in a large picture.
int dotOf(const LessonConstruction& construction, const QSize& size) {
    const bool areDots =
        construction.mode == LessonConstruction::Mode::ChaosGame && playedPoints(construction) <= fewPoints;
    return areDots ? std::max(1, size.width() / dotsInWidth) : 1;
}

attractor::RenderRequest requestOf(const document::Fractal& fractal, const LessonState& state,
                                   const attractor::Camera& camera) {
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    request.threads = threadsOfThisMachine();
    request.samples = samplesOfPixel * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    const LessonConstruction& construction = state.construction;
    if (construction.mode == LessonConstruction::Mode::Density) return request;
    if (!attractor::coloursSamples(request.appearance.colourBy))
        request.appearance.colourBy = attractor::ColourBy::Map;
    if (construction.mode == LessonConstruction::Mode::Steps) {
        request.algorithm = attractor::Algorithm::Deterministic;
        request.iterations = construction.iterations;
        request.cage = document::effectiveCage(fractal);
    } else {
        request.algorithm = attractor::Algorithm::ChaosGame;
        request.samples = playedPoints(construction);
    }
    return request;
}

QImage inPlane(const document::Fractal& fractal, const LessonState& state, const QSize& size,
               const std::stop_token& stop) {
    const PictureOverlay overlay = overlayOf(state);
    const attractor::Camera camera = cameraInPlane(fractal, state, overlay, size);
    const attractor::Camera coarse =
        cameraInPlane(fractal, state, overlay, size / dotOf(state.construction, size));
    attractor::Rendering rendering(requestOf(fractal, state, coarse));
    if (!rendering.refine(stop)) return {};
    attractor::Frame frame = rendering.frame({}, stop);
    if (stop.stop_requested()) return {};
    QImage picture = QImage(reinterpret_cast<const uchar*>(frame.pixels.data()), coarse.width, coarse.height,
                            QImage::Format_ARGB32_Premultiplied)
                         .copy()
                         .scaled(size);
    OverlayMarks marks = overlayMarks(fractal, camera, overlay);
    if (overlay.cage)
        std::ranges::move(cornerMarks(fractal, camera, fractal.appearance.background),
                          std::back_inserter(marks));
    paintOverlay(picture, marks, 0);
    return picture;
}

QImage inSpace(const document::Fractal& fractal, const LessonState& state, const QSize& size,
               const std::stop_token& stop) {
    const PictureOverlay overlay = overlayOf(state);
    attractor::OrbitCamera camera;
    const auto* orbit = std::get_if<document::LessonOrbit>(&state.view);
    if (orbit)
        camera = orbit->camera;
    else
        camera.orientation = attractor::orbit(30, 20);
    camera.size = {size.width(), size.height()};
    if (!orbit || orbit->isFitted) {
        const auto marked = document::reachOfVertices(spaceOverlayPoints(fractal, overlay));
        const auto reach = [&](const ifs::Vector<3>& u) {
            const double solid = document::extentAlong(fractal, u).high;
            return overlay.cage ? std::max(solid, marked(u)) : solid;
        };
        camera = attractor::fitted(camera, reach, margin);
    }
    SpaceRecipe recipe;
    recipe.camera = camera;
    recipe.size = {size.width(), size.height()};
    QImage picture = drawSpacePicture(exportOf(recipe, fractal), {}, stop).image;
    if (picture.isNull() || stop.stop_requested()) return {};
    paintOverlay(picture, spaceOverlayMarks(fractal, camera, overlay), 0);
    return picture;
}

} // namespace

QImage lessonPicture(const document::Fractal& fractal, const LessonState& state, const QSize& size,
                     const std::stop_token& stop) {
    if (document::plane(fractal)) return inPlane(fractal, state, size, stop);
    return document::space(fractal) ? inSpace(fractal, state, size, stop) : QImage();
}

} // namespace io
