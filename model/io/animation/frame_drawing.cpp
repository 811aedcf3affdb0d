// SPDX-License-Identifier: MIT
#include "io/animation/frame_drawing.h"

#include "attractor/shutter/motion_steps.h"
#include "io/fractint/entry_writer.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

namespace io {

namespace {

constexpr int looks = 8; // at how far things move while the shutter is open

PictureFormat formatOf(const PngExport& picture) {
    const attractor::RenderRequest& request = picture.request;
    PictureFormat format;
    format.width = request.camera.width;
    format.height = request.camera.height;
    if (request.appearance.background.alpha < 255) format.pixels = PictureFormat::Pixels::Transparent;
    format.depth = picture.depth;
    format.dotsPerInch = picture.dotsPerInch;
    format.systemText = writeEntry(picture.fractal);
    format.texts = picture.texts;
    return format;
}

// Whether its pixels may wait in memory.
bool isLight(const PictureFormat& format) {
    constexpr std::int64_t most = std::int64_t{1} << 24;
    return format.depth == PictureFormat::Depth::Bits8 && std::int64_t(format.width) * format.height <= most;
}

// Into the file, which is whole then.
Failure encoded(NewFile& file, const PictureFormat& format, const QImage& image) {
    PngWriter writer(file, format);
    writer.writeRows({reinterpret_cast<const std::uint32_t*>(image.constBits()),
                      std::size_t(image.width()) * std::size_t(image.height())});
    const Failure failure = writer.finish();
    if (file.failure()) return file.failure();
    return failure ? failure : file.commit();
}

} // namespace

FrameDrawing::FrameDrawing(std::unique_ptr<FrameSource> source, const FrameOptions& options)
    : m_source(std::move(source)),
      m_options(options),
      m_facts(*document::animationFacts(m_source->entry())),
      m_pilots(document::exposurePilots(m_source->entry())) {}

// None where the shutter shows the moment alone, or nothing moves as far as a pixel.
template <class Request, class RequestAt>
std::vector<Request> FrameDrawing::momentsOf(int frame, RequestAt requestAt) const {
    if (m_options.shutter == 0) return {};
    std::vector<attractor::TrackedPoints> tracked;
    for (const animation::Moment& moment : document::shutterEdges(m_facts, frame, m_options.shutter, looks))
        tracked.push_back(attractor::trackedPoints(requestAt(moment)));
    const int steps = attractor::stepsFor(tracked);
    if (steps == 1) return {};
    std::vector<Request> requests;
    for (const animation::Moment& moment : document::shutterMiddles(m_facts, frame, m_options.shutter, steps))
        requests.push_back(requestAt(moment));
    return requests;
}

PngExport FrameDrawing::planeFrame(int frame, const std::stop_token& stop) {
    PngExport picture = m_source->planeAt(animation::moment(frame));
    picture.exposure = exposureAt(frame, stop);
    picture.moments = momentsOf<attractor::RenderRequest>(frame, [&](const animation::Moment& moment) {
        attractor::RenderRequest request = m_source->planeAt(moment).request;
        request.appearance = picture.request.appearance;
        return request;
    });
    return picture;
}

SpaceExport FrameDrawing::spaceFrame(int frame, const std::stop_token& stop) {
    SpaceExport picture = m_source->spaceAt(animation::moment(frame));
    if (attractor::showsCloud(picture.look)) picture.exposure = exposureAt(frame, stop);
    picture.moments = momentsOf<attractor::SpaceRequest>(frame, [&](const animation::Moment& moment) {
        attractor::SpaceRequest request = picture.request; // its look
        const attractor::SpaceRequest then = m_source->spaceAt(moment).request;
        request.system = then.system;
        request.cage = then.cage;
        request.camera = then.camera;
        return request;
    });
    return picture;
}

std::optional<attractor::Exposure> FrameDrawing::pilot(std::size_t index, const std::stop_token& stop) {
    if (const auto known = m_exposures.find(index); known != m_exposures.end()) return known->second;
    const animation::Moment& moment = m_pilots[index];
    const auto measured =
        isPlane() ? attractor::BandedRendering(m_source->planeAt(moment).request).measuredExposure(stop)
                  : cloudExposure(m_source->spaceAt(moment), stop);
    if (measured) m_exposures.emplace(index, *measured);
    return measured;
}

std::optional<attractor::Exposure> FrameDrawing::exposureAt(int frame, const std::stop_token& stop) {
    if (m_options.exposing == Exposing::Each) return std::nullopt;
    const animation::Moment moment =
        m_options.exposing == Exposing::Fixed
            ? animation::moment(0)
            : animation::folded(animation::moment(frame), m_facts.loop, m_facts.length);
    const document::BetweenPilots between = document::betweenPilots(m_pilots, moment);
    const auto before = pilot(between.before, stop);
    const auto after = before ? pilot(between.after, stop) : std::nullopt;
    return after ? std::optional(document::interpolated(*before, *after, between.share)) : std::nullopt;
}

ExportOutcome FrameDrawing::writePng(int frame, const QString& path, const QByteArray& hash,
                                     const Progress& progress, const std::stop_token& stop) {
    if (isPlane()) {
        PngExport picture = planeFrame(frame, stop);
        picture.texts = {{frameRequestKeyword, hash}};
        if (isLight(formatOf(picture)))
            return encodeLater(
                path, formatOf(picture), [&] { return drawPicture(picture, progress, stop); }, stop);
        const Failure before = startOf(path);
        return before ? ExportOutcome{before} : exportPng(picture, path, progress, stop);
    }
    SpaceExport picture = spaceFrame(frame, stop);
    picture.texts = {{frameRequestKeyword, hash}};
    if (isLight(formatOf(picture)))
        return encodeLater(
            path, formatOf(picture), [&] { return drawSpacePicture(picture, progress, stop); }, stop);
    ExportOutcome outcome;
    outcome.failure = startOf(path);
    if (outcome.failure) return outcome;
    QByteArray png;
    outcome = drawSpacePng(picture, png, progress, stop);
    if (!outcome.failure && !outcome.stopped) outcome.failure = saveFile(path, png);
    return outcome;
}

Failure FrameDrawing::finish() {
    return m_written.valid() ? m_written.get() : std::nullopt;
}

// The failure of the picture before, or else what is written next is this one.
Failure FrameDrawing::startOf(const QString& path) {
    Failure before = finish();
    if (!before) m_path = path;
    return before;
}

ExportOutcome FrameDrawing::encodeLater(const QString& path, const PictureFormat& format,
                                        const std::function<Picture()>& draw, const std::stop_token& stop) {
    const auto file = std::make_shared<NewFile>(path);
    const Picture picture = file->failure() ? Picture() : draw();
    ExportOutcome outcome;
    outcome.note = picture.note;
    outcome.failure = startOf(path);
    if (!outcome.failure) outcome.failure = file->failure();
    if (outcome.failure) return outcome;
    outcome.stopped = picture.image.isNull() && stop.stop_requested();
    if (outcome.stopped) return outcome;
    if (picture.image.isNull()) throw std::bad_alloc();
    const auto encode = [file, format, image = picture.image] { return encoded(*file, format, image); };
    try {
        m_written = std::async(std::launch::async, encode);
    } catch (const std::system_error&) { // no thread is to be had
        outcome.failure = encode();
    }
    return outcome;
}

Picture FrameDrawing::draw(int frame, const Progress& progress, const std::stop_token& stop) {
    Picture picture;
    if (isPlane()) {
        picture = drawPicture(planeFrame(frame, stop), progress, stop);
    } else {
        const SpaceExport wanted = spaceFrame(frame, stop);
        picture = drawSpacePicture(wanted, progress, stop);
    }
    if (picture.image.isNull() && !stop.stop_requested()) throw std::bad_alloc();
    return picture;
}

bool FrameDrawing::isTransparent(int frame) const {
    const animation::Moment moment = animation::moment(frame);
    if (isPlane()) return m_source->planeAt(moment).request.appearance.background.alpha < 255;
    const SpaceExport picture = m_source->spaceAt(moment);
    return (attractor::showsCloud(picture.look) ? picture.request.appearance.background
                                                : picture.solid.background)
               .alpha < 255;
}

bool FrameDrawing::isTransparent(const std::vector<int>& frames) const {
    const auto* solid = document::space(m_source->entry());
    const bool isSteady = solid && solid->animation->look.empty(); // and a frame in space takes its time
    const std::size_t looked = isSteady ? std::min<std::size_t>(frames.size(), 1) : frames.size();
    return std::any_of(frames.begin(), frames.begin() + std::ptrdiff_t(looked),
                       [this](int frame) { return isTransparent(frame); });
}

} // namespace io
