// SPDX-License-Identifier: MIT
#include "render/render_space.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/messages.h"
#include "process/output.h"
#include "render/rest_cage.h"
#include "render/solid_options.h"

#include "attractor/samples/prepared_space.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "io/overlay/map_legend.h"
#include "io/overlay/space_overlay.h"
#include "io/picture/picture_writers.h"
#include "io/picture/space_export.h"
#include "io/report/figure_error.h"
#include "io/text/number.h"

#include <algorithm>
#include <cmath>

namespace cli {

namespace {

using attractor::LookInSpace;
using Corners = std::vector<ifs::Vector<3>>;

constexpr std::uint64_t maxBytes = std::uint64_t{4} << 30; // memory for one picture

QString quoted(const std::string& text) {
    return QString::fromStdString(text);
}

// |⟨n, x⟩ − t| ≤ w, or without w the half-space ⟨n, x⟩ ≤ t.
std::optional<attractor::SpaceClip> clipOf(const document::Fractal& fractal, const RenderArguments& options) {
    if (!options.slice) return fractal.inSpace.clip;
    const std::vector<double>& given = options.slice->values;
    attractor::SpaceClip clip;
    if (given.size() == 4 || given.size() == 5) {
        clip.normal = {given[0], given[1], given[2]};
        clip.highest = given[3];
        if (given.size() == 5) {
            clip.lowest = given[3] - given[4];
            clip.highest = given[3] + given[4];
        }
        if (isUsable(clip)) return clip;
    }
    throw UsageError{
        tr("--slice “%1” is not valid: it must be a normal that is not zero, an offset and a half "
           "width of at least 0, such as 1,1,1,1.5,0.01; without the half width, everything up "
           "to the offset is kept.")
            .arg(quoted(options.slice->text))};
}

void refuseNumbers(const RenderArguments& options) {
    const QString reason = tr("--look depth shows depths, without samples and colours.");
    options.given.refuse(Samples | Colours | Tone | Cells, reason);
    options.given.refuse({"--background"}, reason);
    refuseIf(options.bits && !is16Bit(options), "--bits", tr("--look depth has 16 bits."));
}

void refuseUnsupported(const RenderArguments& options, LookInSpace look) {
    const QString plane = tr("it applies only to entries in the plane.");
    options.given.refuse(InPlane, plane);
    refuseIf(options.algorithm != attractor::Algorithm::Density, "--algorithm", plane);
    if (look == LookInSpace::Depth || look == LookInSpace::Normals) {
        options.given.refuse({"--legend"},
                             tr("--look depth and normals show data, which has no letters beside it."));
        options.given.refuse({"--stereo"},
                             tr("--look depth and normals show data, which cannot be seen in stereo."));
        options.given.refuse({"--overlay"},
                             tr("--look depth and normals show data, which nothing can be drawn over."));
    }
    if (options.stereo != attractor::Stereo::None)
        options.given.refuse({"--overlay"}, tr("nothing can be drawn over a picture in stereo."));
    refuseIf(options.colour && look == LookInSpace::XRay, "--colour",
             tr("--look x-ray shows the mean depth with the palette."));
    if (look == LookInSpace::Depth || attractor::showsCloud(look))
        options.given.refuse(Light, tr("it applies only to solids: --look stone or ink."));
    if (look == LookInSpace::Depth) refuseNumbers(options);
}

// The format in which the picture is embedded; nullopt if it is not embedded.
std::optional<io::ShapeFile> pageOf(const RenderArguments& options) {
    return ifs::named<io::ShapeFile>(suffixOf(options).toStdString());
}

void refuseUnsupportedFile(const RenderArguments& options, LookInSpace look) {
    const QString suffix = suffixOf(options);
    if (look == LookInSpace::Depth && suffix != u"sum" && io::pictureFileOf(suffix) != io::PictureFile::Png)
        throw UsageError{
            tr("--look depth can be drawn only as .png, and “%1” is not.").arg(fileNameOf(options.output))};
    refuseIf(pageOf(options) && is16Bit(options), "--bits 16",
             tr("a picture in .svg and .pdf has 8 bits per channel."));
}

attractor::Orientation orientationOf(const RenderArguments& options) {
    if (!options.orbit) return attractor::orbit(30, 20);
    const std::vector<double>& angles = options.orbit->values;
    return attractor::orbit(angles[0], angles[1], angles.size() == 3 ? angles[2] : 0);
}

Corners cornersArgument(const char* option, const std::string& text) {
    Corners corners;
    for (const QString& part : quoted(text).simplified().split(u' ', Qt::SkipEmptyParts)) {
        const auto xyz = numbers(part);
        if (xyz.size() != 3) {
            corners.clear();
            break;
        }
        corners.emplace_back(xyz[0], xyz[1], xyz[2]);
    }
    if (corners.size() < 4)
        throw UsageError{tr("%1 “%2” is not valid: it must be at least four points in space, such as "
                            "\"0,0,0 1,0,0 0,1,0 0,0,1\".")
                             .arg(QLatin1String(option), quoted(text))};
    return corners;
}

Corners restOf(const RenderArguments& options, const document::System3& system,
               const ifs::SupportFunction<3>* support) {
    const std::string text = options.restCage.value_or("canonical");
    const auto asked = askedFit<3>(text);
    if (text != "canonical" && !asked) return cornersArgument("--rest-cage", text);
    if (support == nullptr)
        throw UsageError{tr("--rest-cage %1 cannot be used here: the system has no certified attractor.")
                             .arg(quoted(text))};
    return asked ? document::verticesAround(system, *support, asked->fit.choice, asked->corners)
                 : document::verticesAround(system, *support, document::SpacePolyhedron::Simplex);
}

// The stored one where none is asked for.
std::optional<ifs::ControlCage<3>> cageOf(const RenderArguments& options, const document::Shape<3>& shape,
                                          const ifs::SupportFunction<3>* support) {
    const std::optional<ifs::ControlCage<3>>& stored = shape.cage;
    if (!options.cage && !options.restCage) return stored;
    ifs::ControlCage<3> cage;
    cage.rest = stored && !options.restCage ? stored->rest : restOf(options, shape.system, support);
    cage.current = options.cage ? cornersArgument("--cage", *options.cage) : cage.rest;
    if (cage.current.size() != cage.rest.size())
        throw UsageError{tr("The cage has %1 corners and the rest cage %2: they must have the same number.")
                             .arg(cage.current.size())
                             .arg(cage.rest.size())};
    if (!ifs::isValid(cage))
        throw UsageError{
            cage.rest.size() == 4
                ? tr("The corners of the rest cage are in one plane, so they define no coordinates.")
                : tr("The points of a rest cage in space must be the corners of a convex polyhedron.")};
    return cage;
}

// The camera of the keys, changed by options, before it goes round.
attractor::OrbitCamera cameraAtRest(const Shown& shown, const RenderArguments& options) {
    attractor::OrbitCamera camera = shown.camera.value_or(attractor::OrbitCamera());
    const QSize size = sizeArgument("--size", sizeText(options.size));
    camera.size = {size.width(), size.height()};
    const int across = picturesAcross(options.stereo);
    if (size.width() % across != 0)
        throw UsageError{tr("--stereo %1 needs an even width, for two pictures of the same size.")
                             .arg(QLatin1String(ifs::nameOf(options.stereo)))};
    camera.size.width /= across;
    if (!shown.camera || options.orbit) camera.orientation = orientationOf(options);
    return camera;
}

document::Fractal placedIn(document::Fractal fractal, const std::optional<ifs::ControlCage<3>>& cage) {
    document::space(fractal)->cage = cage;
    return fractal;
}

// The camera fitted to the picture together with its overlay.
attractor::OrbitCamera fittedWithMarks(const attractor::OrbitCamera& camera, const Shown& shown,
                                       const document::Fractal& placed,
                                       const std::vector<ifs::Vector<3>>& points, double margin) {
    const auto marks = io::supportBefore(shown.orbit, document::reachOfVertices(points));
    const auto reach = [&](const ifs::Vector<3>& u) {
        return std::max(shown.support ? shown.support(u) : document::extentAlong(placed, u).high, marks(u));
    };
    return io::cameraOfFrame(camera, shown.orbit, reach, margin);
}

void warnOfWideAngle(double angle, const QString& fileName) {
    constexpr double wide = 150;
    if (angle > wide)
        reportWarning(fileName,
                      tr("With an angle of view of %1 degrees, nearly all of the picture shows what "
                         "is beside the camera, and what is in front of it is tiny.")
                          .arg(angle));
}

attractor::OrbitCamera cameraOf(const Shown& shown, const RenderArguments& options,
                                const attractor::PreparedSpace& system,
                                const ifs::SupportFunction<3>* support,
                                const std::optional<ifs::ControlCage<3>>& stored, const QString& fileName) {
    const ifs::AffineMap<3> cage = stored ? ifs::displayMap(*stored) : ifs::AffineMap<3>();
    const bool isBent = stored && ifs::bends(*stored);
    attractor::OrbitCamera camera = cameraAtRest(shown, options);
    if (options.perspective) {
        camera.projection = attractor::OrbitCamera::Projection::Perspective;
        camera.fieldOfView = *options.perspective;
        warnOfWideAngle(*options.perspective, fileName);
    }
    if (options.view) {
        const std::vector<double>& view = options.view->values;
        if (view.size() != 4 || !(view[3] > 0))
            throw UsageError{tr("--view “%1” is not valid: in space it must be the target and a positive "
                                "height, such as \"0,1.5,0,10\".")
                                 .arg(quoted(options.view->text))};
        camera.target = {view[0], view[1], view[2]};
        camera.height = view[3];
        return animation::orbited(camera, shown.orbit);
    }
    if (shown.camera) return animation::orbited(camera, shown.orbit);
    const double margin = options.margin / 100;
    const document::Fractal placed = placedIn(shown.fractal, stored);
    const auto marked = io::spaceOverlayPoints(placed, options.overlay);
    if (support != nullptr && !marked.empty()) return fittedWithMarks(camera, shown, placed, marked, margin);
    if (shown.support) return io::cameraOfFrame(camera, shown.orbit, shown.support, margin);
    if (support != nullptr && !document::space(shown.fractal)->moved.empty()) {
        const auto reach = [&](const ifs::Vector<3>& u) { return document::extentAlong(placed, u).high; };
        return attractor::fitted(camera, reach, margin);
    }
    if (isBent) return attractor::fitted(camera, document::reachOfVertices(stored->current), margin);
    if (support != nullptr) return attractor::fitted(camera, *support, cage, margin);
    reportWarning(fileName, tr("No box around the picture could be certified; the view is estimated from "
                               "the points drawn. Set it with --view."));
    const auto ofBox = [&](const ifs::Vector<3>& u) {
        const ifs::Vector<3> inner = cage.linear.transpose() * u;
        return u.dot(cage(system.centre)) + inner.cwiseAbs().dot(system.halfExtent);
    };
    return attractor::fitted(camera, ofBox, margin);
}

// The request for an entry that includes the options.
attractor::SpaceRequest requestOf(const Shown& shown, const document::Fractal& fractal,
                                  const RenderArguments& options, const QString& fileName) {
    attractor::SpaceRequest request = document::spaceRequest(fractal, {});
    request.seed = options.seed;
    request.threads = threadsOf(options.threads);
    const attractor::PreparedSpace system = attractor::preparedSpace(request.system);
    const auto support = system.isCertified ? ifs::SupportFunction<3>::of(system.maps) : std::nullopt;
    request.cage = cageOf(options, *document::space(fractal), support ? &*support : nullptr);
    request.camera = cameraOf(shown, options, system, support ? &*support : nullptr, request.cage, fileName);
    const auto pixels = std::uint64_t(request.camera.size.width) * std::uint64_t(request.camera.size.height);
    request.samples = options.points.value_or(std::max<std::uint64_t>(100 * pixels, 1'000'000));
    return request;
}

io::OverlayMarks marksOf(const io::SpaceExport& picture, const RenderArguments& options) {
    const io::PictureOverlay& overlay = options.overlay;
    const document::Fractal placed = placedIn(picture.fractal, picture.request.cage);
    if (overlay.hull && !document::spaceSupport(placed))
        throw UsageError{tr("--overlay hull cannot be used here: the system has no certified attractor.")};
    if (overlay.hull && picture.request.cage && ifs::bends(*picture.request.cage))
        throw UsageError{tr("--overlay hull cannot be used here: the cage bends the picture.")};
    return io::spaceOverlayMarks(placed, picture.request.camera, overlay);
}

void warnOfEmptySlice(const io::SpaceExport& picture, const QString& fileName) {
    const document::Fractal placed = placedIn(picture.fractal, picture.request.cage);
    const attractor::SpaceClip& clip = *picture.request.clip;
    const double length = clip.normal.stableNorm();
    if (!document::spaceSupport(placed)) return; // extent not certain
    const document::Extent extent = document::extentAlong(placed, clip.normal / length);
    const double noise = 1e-9 * (extent.high - extent.low);
    if (clip.lowest > (extent.high + noise) * length || clip.highest < (extent.low - noise) * length)
        reportWarning(fileName,
                      tr("The slice misses the attractor, so the picture is empty: along its normal, "
                         "the attractor extends from %1 to %2.")
                          .arg(io::withoutNoise(extent.low, noise) * length, 0, 'g', 6)
                          .arg(io::withoutNoise(extent.high, noise) * length, 0, 'g', 6));
}

} // namespace

void refuseSpaceOptions(const RenderArguments& options) {
    options.given.refuse(InSpace, tr("it applies only to entries in space."));
}

io::SpaceExport spaceExportOf(const Shown& shown, const RenderArguments& options, const QString& fileName) {
    io::SpaceExport picture;
    document::Fractal& fractal = picture.fractal;
    fractal = shown.fractal;
    picture.look = fractal.inSpace.look = options.look.value_or(fractal.inSpace.look);
    fractal.inSpace.clip = clipOf(fractal, options);
    refuseUnsupportedFile(options, picture.look);
    picture.stereo = options.stereo;
    refuseUnsupported(options, picture.look);
    if (picture.look == LookInSpace::Depth || attractor::showsCloud(picture.look)) {
        applyAppearance(fractal.appearance, options);
    } else {
        applySolidOptions(fractal, options);
        picture.solid = solidAppearance(fractal, options);
        if (options.supersample) picture.supersample = *options.supersample;
    }
    picture.depth = depthOf(options);
    picture.page = pageOf(options);
    const bool isForCompositing = picture.look == LookInSpace::Normals && !options.bits && !picture.page;
    if (isForCompositing && io::takes(pictureFileOf(options), io::PictureFormat::Depth::Bits16))
        picture.depth = io::PictureFormat::Depth::Bits16;
    picture.file = pictureFileOf(options);
    picture.quality = qualityOf(options);
    picture.dotsPerInch = options.dpi;
    picture.request = requestOf(shown, fractal, options, fileName);
    if (options.slice) warnOfEmptySlice(picture, fileName);
    if (options.legend) picture.legend = io::mapLegend(fractal, picture.request.camera.size.height);
    if (options.overlay != io::PictureOverlay()) picture.marks = marksOf(picture, options);
    fractal = options.frame ? shown.entry : placedIn(fractal, picture.request.cage);
    if (io::memoryFor(picture) > maxBytes)
        throw UsageError{
            tr("--size %1 needs more than 4 GB of memory in space.").arg(quoted(sizeText(options.size)))};
    return picture;
}

} // namespace cli
