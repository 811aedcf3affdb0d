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

constexpr int shutterProbes = 8; // moments within the open shutter at which motion is measured

PictureFormat formatOf(const PlaneExport& picture) {
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

// Returns true if the pixels are few enough to wait in memory.
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

// The moments of an open shutter; none where it shows the frame alone, or nothing moves as far as a pixel.
template <class Request, class RequestAt>
std::vector<Request> FrameDrawing::momentsOf(int frame, RequestAt requestAt) const {
    if (m_options.shutter == 0) return {};
    std::vector<attractor::TrackedPoints> tracked;
    for (const animation::Moment& moment :
         document::shutterEdges(m_facts, frame, m_options.shutter, shutterProbes))
        tracked.push_back(attractor::trackedPoints(requestAt(moment)));
    const int steps = attractor::stepsFor(tracked);
    if (steps == 1) return {};
    std::vector<Request> requests;
    for (const animation::Moment& moment : document::shutterMiddles(m_facts, frame, m_options.shutter, steps))
        requests.push_back(requestAt(moment));
    return requests;
}

PlaneExport FrameDrawing::planeFrame(int frame, const std::stop_token& stop) {
    PlaneExport picture = m_source->planeAt(animation::moment(frame));
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
        attractor::SpaceRequest request = picture.request; // request with the look of the picture
        const attractor::SpaceRequest then = m_source->spaceAt(moment).request;
        request.system = then.system;
        request.cage = then.cage;
        request.camera = then.camera;
        return request;
    });
    return picture;
}

int FrameDrawing::threads() const {
    const animation::Moment moment = animation::moment(0);
    return isPlane() ? m_source->planeAt(moment).request.threads : m_source->spaceAt(moment).request.threads;
}

FrameDrawing::Measuring FrameDrawing::measuringOf(std::size_t pilot, int threads,
                                                  const std::stop_token& stop) const {
    if (isPlane()) {
        attractor::RenderRequest request = m_source->planeAt(m_pilots[pilot]).request;
        request.threads = threads;
        return [=] { return attractor::BandedRendering(request).measuredExposure(stop); };
    }
    SpaceExport picture = m_source->spaceAt(m_pilots[pilot]);
    picture.request.threads = threads;
    return [=] { return cloudExposure(picture, stop); };
}

// Two at a time where there are threads for it: a pilot is many small pictures, which two threads draw hardly
// faster than one. After the first frame, the next frames are likely to want the pilot that follows, too.
void FrameDrawing::measurePilots(const document::BetweenPilots& between, const std::stop_token& stop) {
    const bool isFirst = m_exposures.empty();
    std::vector<std::size_t> wanted;
    for (const std::size_t pilot : {between.before, between.after})
        if (!m_exposures.contains(pilot) && std::ranges::find(wanted, pilot) == wanted.end())
            wanted.push_back(pilot);
    if (wanted.empty()) return;
    const int all = threads();
    const std::size_t next = between.after + 1;
    if (all > 1 && !isFirst && wanted.size() == 1 && next < m_pilots.size() && !m_exposures.contains(next))
        wanted.push_back(next);
    const bool isOne = wanted.size() == 1 || all == 1;
    std::vector<Measuring> work;
    for (const std::size_t pilot : wanted)
        work.push_back(measuringOf(pilot, isOne ? all : all / 2, stop));
    std::future<std::optional<attractor::Exposure>> second;
    try {
        if (!isOne) second = std::async(std::launch::async, work.back());
    } catch (const std::system_error&) { // no thread available: sequential
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (const auto measured = i == 1 && second.valid() ? second.get() : work[i]())
            m_exposures.emplace(wanted[i], *measured);
}

std::optional<attractor::Exposure> FrameDrawing::exposureAt(int frame, const std::stop_token& stop) {
    if (m_options.exposing == Exposing::Each) return std::nullopt;
    const animation::Moment moment =
        m_options.exposing == Exposing::Fixed
            ? animation::moment(0)
            : animation::folded(animation::moment(frame), m_facts.loop, m_facts.length);
    const document::BetweenPilots between = document::betweenPilots(m_pilots, moment);
    measurePilots(between, stop);
    const auto before = m_exposures.find(between.before), after = m_exposures.find(between.after);
    if (before == m_exposures.end() || after == m_exposures.end()) return std::nullopt;
    return document::interpolated(before->second, after->second, between.share);
}

ExportOutcome FrameDrawing::writePng(int frame, const QString& path, const FrameHashes& hashes,
                                     const Progress& progress, const std::stop_token& stop) {
    const std::vector<std::pair<QByteArray, QByteArray>> texts{
        {frameRequestKeyword, hashes.frame},
        {animationRequestKeyword, hashes.animation},
        {frameNumberKeyword, QByteArray::number(frame + 1)}};
    if (isPlane()) {
        PlaneExport picture = planeFrame(frame, stop);
        picture.texts = texts;
        if (isLight(formatOf(picture)))
            return encodeLater(
                path, formatOf(picture), [&] { return drawPicture(picture, progress, stop); }, stop);
        const Failure before = startOf(path);
        return before ? ExportOutcome{before} : exportPlane(picture, path, progress, stop);
    }
    SpaceExport picture = spaceFrame(frame, stop);
    picture.texts = texts;
    if (isLight(formatOf(picture)))
        return encodeLater(
            path, formatOf(picture), [&] { return drawSpacePicture(picture, progress, stop); }, stop);
    ExportOutcome outcome;
    outcome.failure = startOf(path);
    if (outcome.failure) return outcome;
    return exportSpace(picture, path, progress, stop);
}

Failure FrameDrawing::finish() {
    return m_written.valid() ? m_written.get() : std::nullopt;
}

// Begins a picture; returns the failure of the one before.
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
    } catch (const std::system_error&) { // no thread available
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
    const bool isSteady = solid && solid->animation->look.empty(); // constant look; frames in space are slow
    const std::size_t looked = isSteady ? std::min<std::size_t>(frames.size(), 1) : frames.size();
    return std::any_of(frames.begin(), frames.begin() + std::ptrdiff_t(looked),
                       [this](int frame) { return isTransparent(frame); });
}

} // namespace io
