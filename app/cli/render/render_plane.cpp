// SPDX-License-Identifier: MIT
#include "render/render_plane.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/messages.h"
#include "render/render_view.h"
#include "render/rest_cage.h"

#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/extent/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace cli {

namespace {

// A certified polygon around the attractor of the code.
std::vector<ifs::Vector<2>> verticesAround(const document::Fractal& code, const AskedFit<2>& asked,
                                           const std::string& text) {
    const auto vertices = document::verticesAround(code, asked.fit.choice, asked.corners);
    if (!vertices)
        throw UsageError{tr("--rest-cage %1 cannot be used here: the system has no certified attractor.")
                             .arg(QString::fromStdString(text))};
    return *vertices;
}

// The rest vertices that --rest-cage and the entry ask for.
std::vector<ifs::Vector<2>> restVertices(const document::Fractal& fractal, const RenderArguments& arguments) {
    if (!arguments.restCage) return document::effectiveCage(fractal).rest;
    const std::string& text = *arguments.restCage;
    if (text == "canonical") return document::canonicalCage(fractal).rest;
    if (const auto asked = askedFit<2>(text)) {
        document::Fractal code = fractal;
        document::plane(code)->cage.reset();
        return verticesAround(code, *asked, text);
    }
    return pointsArgument("--rest-cage", text);
}

} // namespace

void applyCage(document::Fractal& fractal, const RenderArguments& arguments) {
    if (!arguments.cage && !arguments.restCage) return;
    ifs::ControlCage<2> cage;
    cage.rest = restVertices(fractal, arguments);
    cage.current = arguments.cage ? pointsArgument("--cage", *arguments.cage) : cage.rest;
    if (cage.current.size() != cage.rest.size())
        throw UsageError{tr("The cage has %1 corners and the rest cage %2: they must have the same number.")
                             .arg(cage.current.size())
                             .arg(cage.rest.size())};
    if (!ifs::isValid(cage))
        throw UsageError{
            cage.rest.size() == 3
                ? tr("The corners of the rest cage are on one line, so they define no coordinates.")
                : tr("The rest cage must be a polygon of 3 to 64 corners that does not cross "
                     "itself.")};
    document::plane(fractal)->cage = cage;
}

namespace {

attractor::YAxis yAxisOf(const RenderArguments& arguments) {
    return arguments.yDown ? attractor::YAxis::Down : attractor::YAxis::Up;
}

// The box of all steps, or of the attractor.
ViewBox boxOf(const document::Fractal& fractal, const RenderArguments& arguments) {
    if (arguments.algorithm != attractor::Algorithm::Deterministic)
        return boxOfAttractor(fractal, yAxisOf(arguments));
    const Steps steps = arguments.steps();
    ViewBox box = boxOfIterate(fractal, steps.first);
    for (int n = steps.first + 1; n <= steps.last; ++n) {
        const ViewBox next = boxOfIterate(fractal, n);
        box.min = box.min.cwiseMin(next.min);
        box.max = box.max.cwiseMax(next.max);
    }
    return box;
}

// The box, enlarged by the overlay.
ViewBox withOverlay(ViewBox box, const document::Fractal& fractal, const io::PictureOverlay& overlay) {
    for (const ifs::Vector<2>& point : io::overlayPoints(fractal, overlay)) {
        box.min = box.min.cwiseMin(point);
        box.max = box.max.cwiseMax(point);
    }
    return box;
}

ifs::Vector<2> seenExtent(const ViewBox& box, double rotation) {
    const ifs::Vector<2> extent = box.max - box.min;
    return rotation == 0 ? extent : ifs::Vector<2>(attractor::screenTurn(rotation).cwiseAbs() * extent);
}

// A side that was left open gets the proportions of the box, but never more than a hundred times the other.
QSize completed(QSize size, const ifs::Vector<2>& extent) {
    constexpr double maxRatio = 100;
    if (!size.isEmpty()) return size;
    const double longest = std::max(extent.x(), extent.y());
    const double ratio =
        longest > 0 ? std::max(extent.x(), longest / maxRatio) / std::max(extent.y(), longest / maxRatio) : 1;
    const auto side = [](double pixels) { return int(std::clamp(std::round(pixels), 1.0, double(maxSide))); };
    if (size.width() == 0) size.setWidth(side(size.height() * ratio));
    if (size.height() == 0) size.setHeight(side(size.width() / ratio));
    return size;
}

} // namespace

attractor::Camera cameraOf(const Shown& shown, const RenderArguments& arguments, const QString& fileName) {
    const QSize& size = arguments.size;
    const attractor::YAxis yAxis = yAxisOf(arguments);
    const double rotation = attractor::rotationOf(arguments.viewRotation.value_or(0));
    if (arguments.view) {
        attractor::View view = viewArgument("--view", arguments.view->text);
        view.yAxis = yAxis;
        view.rotation = rotation;
        return attractor::cameraOf(view, {size.width(), size.height()});
    }
    if (shown.view) {
        refuseIf(size.isEmpty(), "--size with one side",
                 tr("the camera of the animation has no proportions; give both sides."));
        attractor::View view = *shown.view;
        if (arguments.viewRotation) view.rotation = rotation;
        return attractor::cameraOf(view, {size.width(), size.height()});
    }
    const bool isIterate = arguments.algorithm == attractor::Algorithm::Deterministic;
    const ViewBox plain = shown.box && !isIterate ? *shown.box : boxOf(shown.fractal, arguments);
    const ViewBox box = withOverlay(plain, shown.fractal, arguments.overlay);
    if (!box.certified)
        reportWarning(fileName, tr("No box around the picture could be certified; the view is estimated from "
                                   "the points drawn. Set it with --view."));
    attractor::Camera camera;
    camera.rotation = rotation;
    const QSize whole = completed(size, seenExtent(box, camera.rotation));
    camera.width = whole.width();
    camera.height = whole.height();
    camera.yAxis = yAxis;
    return fitted(camera, box.min, box.max, arguments.margin / 100);
}

namespace {

attractor::RenderRequest requestOf(const document::Fractal& fractal, const attractor::Camera& camera,
                                   const RenderArguments& arguments, int step) {
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    const auto pixels = std::uint64_t(camera.width) * std::uint64_t(camera.height);
    request.algorithm = arguments.algorithm;
    request.seed = arguments.seed;
    request.threads = threadsOf(arguments.threads);
    const std::uint64_t perPixel = request.algorithm == attractor::Algorithm::ChaosGame ? 2 : 100;
    request.samples = arguments.points.value_or(std::max<std::uint64_t>(perPixel * pixels, 1'000'000));
    if (request.algorithm == attractor::Algorithm::Deterministic) {
        request.iterations = step;
        request.samples = 1;
        if (!request.cage) request.cage = document::effectiveCage(fractal);
    }
    return request;
}

} // namespace

io::PlaneExport planeExportOf(const Shown& shown, const attractor::Camera& camera,
                              const RenderArguments& arguments, int step) {
    io::PlaneExport picture{shown.entry, requestOf(shown.fractal, camera, arguments, step), {}};
    picture.depth = depthOf(arguments);
    picture.file = pictureFileOf(arguments);
    picture.quality = qualityOf(arguments);
    picture.overlay = arguments.overlay;
    picture.withLegend = arguments.legend;
    if (arguments.frame) picture.explained = std::make_shared<document::Fractal>(shown.fractal);
    picture.dotsPerInch = arguments.dpi;
    return picture;
}

} // namespace cli
