// SPDX-License-Identifier: MIT
#include "frame_drawing.h"

#include "arguments.h"
#include "frame_request.h"
#include "render_plane.h"
#include "render_space.h"
#include "usage_error.h"

#include "attractor/shutter/motion_steps.h"
#include "document/fractal_geometry.h"
#include "io/export_job.h"

#include <QCoreApplication>

#include <new>
#include <utility>

namespace cli {

namespace {

constexpr int looks = 8; // at how far things move while the shutter is open

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

bool showsNumbers(const io::SpaceExport& picture) {
    return picture.look == attractor::LookInSpace::Depth || picture.look == attractor::LookInSpace::Normals;
}

} // namespace

FrameDrawing::FrameDrawing(const document::Fractal& entry, const RenderArguments& options,
                           const QString& name)
    : m_options(options),
      m_entry(entry),
      m_name(name),
      m_frames(entry, options),
      m_facts(*document::animationFacts(entry)),
      m_pilots(document::exposurePilots(entry)) {
    if (options.shutter) m_shutter = shutterArgument("--shutter", *options.shutter);
    m_exposing = options.exposure == "fixed"    ? Exposing::Fixed
                 : options.exposure == "smooth" ? Exposing::Smooth
                                                : Exposing::Each;
}

io::PngExport FrameDrawing::planeAt(const animation::Moment& moment) const {
    const Shown shown = m_frames.at(moment);
    io::PngExport picture = pngOf(shown, cameraOf(shown, m_options, m_name), m_options, 0);
    picture.fractal = m_entry;
    return picture;
}

io::SpaceExport FrameDrawing::spaceAt(const animation::Moment& moment) const {
    io::SpaceExport picture = spaceExportOf(m_frames.at(moment), m_options, m_name);
    picture.fractal = m_entry;
    return picture;
}

// None where the shutter shows the moment alone, or nothing moves as far as a pixel.
template <class Request, class RequestAt>
std::vector<Request> FrameDrawing::momentsOf(int frame, RequestAt requestAt) const {
    if (m_shutter == 0) return {};
    std::vector<attractor::TrackedPoints> tracked;
    for (const animation::Moment& moment : document::shutterEdges(m_facts, frame, m_shutter, looks))
        tracked.push_back(attractor::trackedPoints(requestAt(moment)));
    const int steps = attractor::stepsFor(tracked);
    if (steps == 1) return {};
    std::vector<Request> requests;
    for (const animation::Moment& moment : document::shutterMiddles(m_facts, frame, m_shutter, steps))
        requests.push_back(requestAt(moment));
    return requests;
}

io::PngExport FrameDrawing::planeFrame(int frame, const std::stop_token& stop) {
    io::PngExport picture = planeAt(animation::moment(frame));
    picture.exposure = exposureAt(frame, stop);
    const attractor::RenderRequest& still = picture.request;
    picture.moments = momentsOf<attractor::RenderRequest>(frame, [&](const animation::Moment& moment) {
        const Shown shown = m_frames.at(moment);
        attractor::RenderRequest request = document::renderRequest(
            shown.fractal, shown.view ? cameraOf(shown, m_options, m_name) : still.camera);
        request.appearance = still.appearance;
        request.samples = still.samples;
        request.seed = still.seed;
        request.threads = still.threads;
        return request;
    });
    return picture;
}

io::SpaceExport FrameDrawing::spaceFrame(int frame, const std::stop_token& stop) {
    io::SpaceExport picture = spaceAt(animation::moment(frame));
    if (m_shutter > 0 && showsNumbers(picture))
        throw UsageError{tr("--shutter cannot be used here: depths and normals are numbers, which do not add "
                            "up like light.")};
    if (attractor::showsCloud(picture.look)) picture.exposure = exposureAt(frame, stop);
    picture.moments = momentsOf<attractor::SpaceRequest>(frame, [&](const animation::Moment& moment) {
        attractor::SpaceRequest request = spaceAt(moment).request;
        request.appearance = picture.request.appearance;
        return request;
    });
    return picture;
}

std::optional<attractor::Exposure> FrameDrawing::pilot(std::size_t index, const std::stop_token& stop) {
    if (const auto known = m_exposures.find(index); known != m_exposures.end()) return known->second;
    const animation::Moment& moment = m_pilots[index];
    const auto measured = isPlane()
                              ? attractor::BandedRendering(planeAt(moment).request).measuredExposure(stop)
                              : io::cloudExposure(spaceAt(moment), stop);
    if (measured) m_exposures.emplace(index, *measured);
    return measured;
}

std::optional<attractor::Exposure> FrameDrawing::exposureAt(int frame, const std::stop_token& stop) {
    if (m_exposing == Exposing::Each) return std::nullopt;
    const animation::Moment moment =
        m_exposing == Exposing::Fixed
            ? animation::moment(0)
            : animation::folded(animation::moment(frame), m_facts.loop, m_facts.length);
    const document::BetweenPilots between = document::betweenPilots(m_pilots, moment);
    const auto before = pilot(between.before, stop);
    const auto after = before ? pilot(between.after, stop) : std::nullopt;
    return after ? std::optional(document::interpolated(*before, *after, between.share)) : std::nullopt;
}

io::ExportOutcome FrameDrawing::writePng(int frame, const QString& path, const QByteArray& hash,
                                         const io::Progress& progress, const std::stop_token& stop) {
    if (isPlane()) {
        io::PngExport picture = planeFrame(frame, stop);
        picture.texts = {{requestKeyword, hash}};
        return io::exportTo(picture, path, progress, stop);
    }
    io::SpaceExport picture = spaceFrame(frame, stop);
    picture.texts = {{requestKeyword, hash}};
    QByteArray png;
    io::ExportOutcome outcome = io::drawSpacePng(picture, png, progress, stop);
    if (!outcome.failure && !outcome.stopped) outcome.failure = io::saveFile(path, png);
    return outcome;
}

io::Picture FrameDrawing::draw(int frame, const io::Progress& progress, const std::stop_token& stop) {
    io::Picture picture;
    if (isPlane()) {
        picture = io::drawPicture(planeFrame(frame, stop), progress, stop);
    } else {
        const io::SpaceExport wanted = spaceFrame(frame, stop);
        if (wanted.look == attractor::LookInSpace::Depth)
            throw UsageError{
                tr("--look depth cannot be used here: depths are numbers of 16 bits, which a video "
                   "does not store. Write the frames as NAME.####.png.")};
        picture = io::drawSpacePicture(wanted, progress, stop);
    }
    if (picture.image.isNull() && !stop.stop_requested()) throw std::bad_alloc();
    return picture;
}

bool FrameDrawing::isTransparent(int frame) const {
    const animation::Moment moment = animation::moment(frame);
    if (isPlane()) return m_frames.at(moment).fractal.appearance.background.alpha < 255;
    const io::SpaceExport picture = spaceAt(moment);
    return (attractor::showsCloud(picture.look) ? picture.request.appearance.background
                                                : picture.solid.background)
               .alpha < 255;
}

} // namespace cli
