// SPDX-License-Identifier: MIT
#include "convert/pdf_pages.h"

#include "options/tr.h"
#include "process/messages.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/exports/export_recipe.h"
#include "io/picture/space_export.h"
#include "io/picture/vector/pdf_writer.h"

namespace cli {

namespace {

constexpr int side = 700;       // pixels of SVG, a good seven inches
constexpr int finer = 3;        // pixels of a solid per pixel of SVG
constexpr double margin = 0.05; // share of the page around the picture

io::Failure addShapes(io::PdfFile& file, const document::Fractal& fractal, const std::stop_token& stop) {
    attractor::Camera camera;
    camera.width = camera.height = side;
    if (const auto box = document::boxWithShadow(fractal, attractor::YAxis::Up))
        camera = attractor::fitted(camera, box->min, box->max);
    return io::addPage(file, {fractal, camera, {}}, stop);
}

io::Failure addSolid(io::PdfFile& file, const document::Fractal& fractal, const std::stop_token& stop) {
    if (!document::spaceSupport(fractal)) return tr("no attractor could be certified.");
    io::SpaceRecipe recipe;
    recipe.camera.size = {side, side};
    recipe.camera.orientation = attractor::orbit(30, 20); // same as in pictures
    recipe.camera = document::fittedToPicture(fractal, recipe.camera, margin);
    recipe.size = {finer * side, finer * side};
    recipe.page = io::ShapeFile::Pdf;
    recipe.dotsPerInch = finer * io::pixelsOfSvg;
    return io::drawSpacePage(io::exportOf(recipe, fractal), file, {}, stop).failure;
}

} // namespace

PdfPages pdfPages(const QList<std::shared_ptr<const document::Fractal>>& systems, const QString& inputName,
                  const std::stop_token& stop) {
    io::PdfFile file;
    PdfPages pages;
    QString title;
    bool hasSolids = false;
    for (const auto& fractal : systems) {
        const bool isSolid = document::space(*fractal) != nullptr;
        const io::Failure failure =
            isSolid ? addSolid(file, *fractal, stop) : addShapes(file, *fractal, stop);
        if (stop.stop_requested()) return {};
        if (failure) {
            reportWarning(inputName, tr("“%1” was omitted: %2").arg(printableLine(fractal->name), *failure));
            continue;
        }
        if (pages.count == 0) title = fractal->name;
        ++pages.count;
        hasSolids = hasSolids || isSolid;
    }
    if (hasSolids)
        reportWarning(inputName, tr("Solids have no shapes: their pages contain pictures in pixels."));
    pages.bytes = file.bytes(title);
    return pages;
}

} // namespace cli
