// SPDX-License-Identifier: MIT
#include "io/exports/export_recipe.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/overlay/space_overlay.h"
#include "io/picture/picture_writers.h"
#include "io/picture/vector/shape_preview.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr int maxSide = 100'000;
constexpr int previewSamples = 100; // samples per pixel

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most; // false for NaN
}

bool isUsable(const attractor::Camera& camera) {
    return isWithin(camera.width, 1, maxSide) && isWithin(camera.height, 1, maxSide) &&
           std::isfinite(camera.pixelsPerUnit) && camera.pixelsPerUnit > 0 &&
           std::isfinite(camera.rotation) && camera.centre.allFinite();
}

bool isUsable(const PixelRecipe& recipe) {
    return isUsable(recipe.camera) && takes(recipe.file, recipe.depth) &&
           isWithin(recipe.samplesPerPixel, 1, 100'000) && isWithin(recipe.supersample, 1, 4) &&
           isWithin(recipe.dotsPerInch, 1, 9600);
}

bool isUsable(const ShapeRecipe& recipe) {
    return isUsable(recipe.camera) && isWithin(recipe.depth.value_or(0), 0, 200) &&
           isWithin(recipe.points, 1, double(SvgFormat::maxPoints)) && isWithin(recipe.dotsPerInch, 1, 9600);
}

bool isUsable(const SpaceRecipe& recipe) {
    return attractor::isUsable(recipe.camera) && isWithin(recipe.size.width, 1, maxSide) &&
           isWithin(recipe.size.height, 1, maxSide) && takes(recipe.file, recipe.depth) &&
           (!recipe.page ||
            (recipe.file == PictureFile::Png && recipe.depth == PictureFormat::Depth::Bits8)) &&
           isWithin(recipe.supersample, 1, 4) && isWithin(recipe.dotsPerInch, 1, 9600);
}

bool isUsable(const BodyRecipe& recipe) {
    return isWithin(recipe.longest, 1, 100'000) &&
           isWithin(recipe.resolution, 8, SolidOptions::maxResolution) && isWithin(recipe.wall, 0, 1000);
}

attractor::Camera resized(attractor::Camera camera, const QSize& size) {
    camera.pixelsPerUnit *=
        std::min(double(size.width()) / camera.width, double(size.height()) / camera.height);
    camera.width = size.width();
    camera.height = size.height();
    return camera;
}

std::optional<QImage> ifDrawn(QImage image) {
    return image.isNull() ? std::nullopt : std::optional(std::move(image));
}

std::optional<QImage> preview(PixelRecipe recipe, const document::Fractal& fractal, const QSize& pixels,
                              const std::stop_token& stop) {
    recipe.camera = resized(recipe.camera, pixels);
    recipe.samplesPerPixel = std::min(recipe.samplesPerPixel, previewSamples);
    return ifDrawn(drawPicture(exportOf(recipe, fractal), {}, stop).image);
}

std::optional<QImage> preview(const ShapeRecipe& recipe, const document::Fractal& fractal,
                              const QSize& pixels, const std::stop_token& stop) {
    ShapeRecipe shown = recipe;
    shown.camera = resized(recipe.camera, pixels);
    const SvgExport picture = exportOf(shown, fractal);
    return shapePreview(picture.fractal, picture.camera, picture.format, stop);
}

std::optional<QImage> preview(SpaceRecipe recipe, const document::Fractal& fractal, const QSize& pixels,
                              const std::stop_token& stop) {
    recipe.size = {pixels.width(), pixels.height()};
    const SpaceExport picture = exportOf(recipe, fractal);
    if (picture.look != attractor::LookInSpace::Depth)
        return ifDrawn(drawSpacePicture(picture, {}, stop).image);
    QByteArray depths;
    SpaceExport png = picture;
    png.file = PictureFile::Png;
    const ExportOutcome outcome = drawSpaceFile(png, depths, {}, stop);
    return outcome.stopped || outcome.failure ? std::nullopt : ifDrawn(QImage::fromData(depths, "PNG"));
}

std::optional<QImage> preview(const BodyRecipe&, const document::Fractal&, const QSize&,
                              const std::stop_token&) {
    return std::nullopt;
}

QStringList suffixes(const ExportRecipe& recipe) {
    if (const auto* body = std::get_if<BodyRecipe>(&recipe)) return {suffixOf(body->format)};
    const auto* shapes = std::get_if<ShapeRecipe>(&recipe);
    const ShapeFile file = shapes ? shapes->file : *std::get<SpaceRecipe>(recipe).page;
    return {QLatin1String(ifs::nameOf(file))};
}

} // namespace

bool isInSpace(const ExportRecipe& recipe) {
    return std::holds_alternative<SpaceRecipe>(recipe) || std::holds_alternative<BodyRecipe>(recipe);
}

bool isUsable(const ExportRecipe& recipe) {
    return std::visit([](const auto& one) { return isUsable(one); }, recipe);
}

bool isNamedFor(const ExportRecipe& recipe, const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (const auto* pixels = std::get_if<PixelRecipe>(&recipe)) return pictureFileOf(suffix) == pixels->file;
    if (const auto* space = std::get_if<SpaceRecipe>(&recipe); space && !space->page)
        return pictureFileOf(suffix) == space->file;
    return suffixes(recipe).contains(suffix);
}

Export exportOf(const ExportRecipe& recipe, const document::Fractal& fractal) {
    return std::visit([&](const auto& one) { return Export(exportOf(one, fractal)); }, recipe);
}

PlaneExport exportOf(const PixelRecipe& recipe, const document::Fractal& fractal) {
    PlaneExport picture{fractal, {}, recipe.dotsPerInch, recipe.cage, recipe.depth};
    picture.fractal.appearance.background.alpha = recipe.isTransparent ? 0 : 255;
    picture.fractal.appearance.supersample = recipe.supersample;
    picture.file = recipe.file;
    picture.request = document::renderRequest(picture.fractal, recipe.camera);
    picture.request.threads = threadsOfThisMachine();
    picture.request.samples = std::uint64_t(recipe.camera.width) * std::uint64_t(recipe.camera.height) *
                              std::uint64_t(recipe.samplesPerPixel);
    return picture;
}

SvgExport exportOf(const ShapeRecipe& recipe, const document::Fractal& fractal) {
    SvgExport picture{fractal, recipe.camera,
                      SvgFormat{recipe.depth, recipe.cage, recipe.style, std::uint64_t(recipe.points)},
                      recipe.file};
    picture.format.dotsPerInch = recipe.dotsPerInch;
    picture.fractal.appearance.background.alpha = recipe.isTransparent ? 0 : 255;
    return picture;
}

SpaceExport exportOf(const SpaceRecipe& recipe, const document::Fractal& fractal) {
    SpaceExport picture;
    picture.fractal = fractal;
    picture.file = recipe.file;
    picture.page = recipe.page;
    if (recipe.isTransparent) picture.fractal.appearance.background.alpha = 0;
    picture.look = fractal.inSpace.look;
    picture.solid = document::solidAppearance(picture.fractal);
    const bool isNumbers =
        picture.look == attractor::LookInSpace::Depth || picture.look == attractor::LookInSpace::Normals;
    picture.stereo = isNumbers ? Stereo::None : recipe.stereo;
    attractor::OrbitCamera camera = recipe.camera;
    camera.size = recipe.size;
    camera.size.width = std::max(1, recipe.size.width / picturesAcross(picture.stereo));
    // Keeps the visible part: a narrower picture shows more above and below.
    const double before = double(recipe.camera.size.width) / recipe.camera.size.height;
    const double after = double(camera.size.width) / camera.size.height;
    if (after < before) camera.height *= before / after;
    picture.request = document::spaceRequest(picture.fractal, camera);
    picture.request.threads = threadsOfThisMachine();
    const auto pixels = std::uint64_t(camera.size.width) * std::uint64_t(camera.size.height);
    picture.request.samples = std::max<std::uint64_t>(100 * pixels, 1'000'000);
    picture.supersample = recipe.supersample;
    picture.depth = recipe.depth;
    picture.dotsPerInch = recipe.dotsPerInch;
    PictureOverlay overlay;
    overlay.cage = overlay.isCageInked = recipe.showsCage && !isNumbers && picture.stereo == Stereo::None;
    if (overlay.cage) picture.marks = spaceOverlayMarks(picture.fractal, camera, overlay);
    return picture;
}

SolidExport exportOf(const BodyRecipe& recipe, const document::Fractal& fractal) {
    SolidExport body;
    body.fractal = fractal;
    body.options.longest = recipe.longest;
    body.options.resolution = recipe.resolution;
    body.options.wall = recipe.wall;
    body.options.fillsCavities = recipe.fillsCavities;
    body.format = recipe.format;
    return body;
}

std::optional<QImage> previewOf(const ExportRecipe& recipe, const document::Fractal& fractal,
                                const QSize& pixels, const std::stop_token& stop) {
    return std::visit([&](const auto& one) { return preview(one, fractal, pixels, stop); }, recipe);
}

} // namespace io
