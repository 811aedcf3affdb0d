// SPDX-License-Identifier: MIT
#include "io/animation/animation_export.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "io/animation/frames_view.h"
#include "io/animation/request_text.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/png/png_check.h"
#include "io/text/number.h"
#include "io/video/video_writer.h"

#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

namespace io {

namespace {

constexpr std::uint64_t samplesPerPixel = 100;
constexpr std::uint64_t minSamples = 1'000'000;
constexpr double shareOfFrames = 0.9; // share of the frames in the progress of a video; the rest is finishing

// The entry as it is, in the view of its camera keys or else of all frames.
class PlainFrames : public FrameSource {
public:
    explicit PlainFrames(const AnimationExport& what) : m_what(what) {
        if (hasCameraKeys(what.entry)) return;
        if (document::plane(what.entry))
            m_box = boxOfFrames(what.entry);
        else
            m_support = supportOfFrames(what.entry);
    }

    const document::Fractal& entry() const override { return m_what.entry; }

    PlaneExport planeAt(const animation::Moment& moment) const override {
        const document::AnimatedFrame frame = document::frameAt(m_what.entry, moment);
        const attractor::RasterSize size{m_what.size.width(), m_what.size.height()};
        attractor::Camera camera;
        camera.width = size.width;
        camera.height = size.height;
        camera = frame.view ? attractor::cameraOf(*frame.view, size) : fitted(camera, m_box->min, m_box->max);
        PlaneExport picture{m_what.entry, document::renderRequest(frame.fractal, camera), {}};
        picture.request.samples = samples();
        picture.request.seed = 1;
        picture.request.threads = threadsOfThisMachine();
        return picture;
    }

    SpaceExport spaceAt(const animation::Moment& moment) const override {
        const document::AnimatedFrame frame = document::frameAt(m_what.entry, moment);
        attractor::OrbitCamera camera = frame.camera.value_or(attractor::OrbitCamera());
        camera.size = {m_what.size.width(), m_what.size.height()};
        if (!frame.camera) camera.orientation = attractor::orbit(30, 20);
        camera = m_support ? cameraOfFrame(camera, frame.orbit, m_support)
                           : animation::orbited(camera, frame.orbit);
        SpaceExport picture;
        picture.fractal = m_what.entry;
        picture.look = frame.fractal.inSpace.look;
        picture.solid = document::solidAppearance(frame.fractal);
        picture.request = document::spaceRequest(frame.fractal, camera);
        if (m_what.supersample) picture.supersample = *m_what.supersample;
        picture.request.samples = samples();
        picture.request.seed = 1;
        picture.request.threads = threadsOfThisMachine();
        return picture;
    }

private:
    std::uint64_t samples() const {
        const auto pixels = std::uint64_t(m_what.size.width()) * std::uint64_t(m_what.size.height());
        return m_what.points.value_or(std::max(samplesPerPixel * pixels, minSamples));
    }

    const AnimationExport& m_what;
    std::optional<ViewBox> m_box;
    attractor::Support m_support;
};

// The hash of the same options on the command line; without a frame, the hash shared by all frames.
QByteArray requestHash(const AnimationExport& what, std::optional<int> frame) {
    FrameRequestText text;
    text.addFrame(frame);
    text.addCount("width", std::uint64_t(what.size.width()));
    text.addCount("height", std::uint64_t(what.size.height()));
    text.addCount("seed", 1);
    if (what.points) text.addCount("points", *what.points);
    if (what.supersample) text.addCount("supersample", std::uint64_t(*what.supersample));
    if (what.frames.shutter > 0) text.addCount("shutter", std::uint64_t(what.frames.shutter));
    text.add("exposure", ifs::nameOf(what.frames.exposing));
    return text.hash(what.entry);
}

bool isDone(const QString& file, const QByteArray& hash) {
    return textOfCompletePng(file, frameRequestKeyword) == hash;
}

VideoSettings settingsOf(const AnimationExport& what) {
    const document::AnimationFacts facts = *document::animationFacts(what.entry);
    VideoSettings settings;
    settings.format = *what.format;
    settings.width = what.size.width();
    settings.height = what.size.height();
    settings.rate = facts.rate;
    settings.repeats = facts.loop != animation::Loop::Off;
    settings.systemText = writeEntry(what.entry);
    settings.title = what.entry.name;
    return settings;
}

// The progress of one frame of many as that of the whole.
Progress partOf(const Progress& progress, int index, int count, double share) {
    return [=](double fraction) {
        if (progress) progress(share * (index + fraction) / count);
    };
}

ExportOutcome writePictures(const AnimationExport& what, const QString& path, const Progress& progress,
                            const std::stop_token& stop) {
    FrameDrawing drawing(std::make_unique<PlainFrames>(what), what.frames);
    const int count = what.last - what.first + 1;
    const QByteArray animation = requestHash(what, std::nullopt);
    ExportOutcome all;
    for (int index = 0; index < count; ++index) {
        const int frame = what.first + index;
        const QString file = framePath(path, frame, what.last);
        const FrameHashes hashes{requestHash(what, frame), animation};
        if (isDone(file, hashes.frame)) continue;
        const ExportOutcome one =
            drawing.writePng(frame, file, hashes, partOf(progress, index, count, 1), stop);
        if (all.note == attractor::RenderNote::None) all.note = one.note;
        all.failure = one.failure;
        all.stopped = one.stopped || stop.stop_requested();
        if (all.failure || all.stopped) return all;
    }
    all.failure = drawing.finish();
    return all;
}

ExportOutcome writeVideo(const AnimationExport& what, const QString& path, const Progress& progress,
                         const std::stop_token& stop) {
    FrameDrawing drawing(std::make_unique<PlainFrames>(what), what.frames);
    const int count = what.last - what.first + 1;
    std::vector<int> frames;
    for (int frame = what.first; frame <= what.last; ++frame)
        frames.push_back(frame);
    VideoSettings settings = settingsOf(what);
    settings.isTransparent = drawing.isTransparent(frames);
    ExportOutcome outcome;
    VideoWriter writer(path, settings);
    outcome.failure = writer.failure();
    for (int index = 0; index < count && !outcome.failure; ++index) {
        const Picture picture =
            drawing.draw(frames[std::size_t(index)], partOf(progress, index, count, shareOfFrames), stop);
        outcome.stopped = stop.stop_requested();
        if (outcome.stopped) return outcome;
        if (outcome.note == attractor::RenderNote::None) outcome.note = picture.note;
        outcome.failure = writer.writeFrame(picture.image);
    }
    if (outcome.failure) return outcome;
    outcome.failure = writer.finish(
        [&](double fraction) {
            if (progress) progress(shareOfFrames + (1 - shareOfFrames) * fraction);
        },
        stop);
    outcome.stopped = !outcome.failure && stop.stop_requested();
    return outcome;
}

} // namespace

QStringList options(const AnimationExport& what) {
    QStringList list{QStringLiteral("--size"),
                     QStringLiteral("%1x%2").arg(what.size.width()).arg(what.size.height())};
    if (what.points) list << QStringLiteral("--points") << QString::number(*what.points);
    if (what.supersample) list << QStringLiteral("--supersample") << QString::number(*what.supersample);
    if (what.frames.shutter > 0)
        list << QStringLiteral("--shutter")
             << QString::fromLatin1(formatNumber(what.frames.shutter / 1000.0));
    if (what.frames.exposing != Exposing::Smooth)
        list << QStringLiteral("--exposure") << QLatin1String(ifs::nameOf(what.frames.exposing));
    if (what.first > 0 || what.last + 1 < frameCount(what.entry))
        list << QStringLiteral("--frames") << QStringLiteral("%1-%2").arg(what.first + 1).arg(what.last + 1);
    return list;
}

int frameCount(const document::Fractal& entry) {
    const document::AnimationFacts facts = *document::animationFacts(entry);
    return animation::frameCount(facts.loop, facts.length);
}

QString framePath(const QString& path, int frame, int last) {
    const QFileInfo file(path);
    const qsizetype digits = std::max<qsizetype>(4, QString::number(last + 1).size());
    const QString number = QString::number(frame + 1).rightJustified(digits, u'0');
    return path.chopped(file.suffix().size()) + number + u'.' + file.suffix();
}

AnimationExport withViewKeyed(AnimationExport what) {
    auto* shape = document::space(what.entry);
    if (shape && what.seenFrom) {
        attractor::OrbitCamera camera = *what.seenFrom;
        camera.size = {what.size.width(), what.size.height()};
        camera = cameraOfFrames(what.entry, camera);
        camera.size = {};
        shape->animation->camera = {{0, camera, {}}};
    }
    what.seenFrom.reset();
    return what;
}

QStringList replacedFiles(const AnimationExport& unkeyed, const QString& path) {
    const AnimationExport what = withViewKeyed(unkeyed);
    QStringList files;
    for (int frame = what.first; frame <= what.last; ++frame) {
        const QString file = framePath(path, frame, what.last);
        if (QFileInfo::exists(file) && !isDone(file, requestHash(what, frame))) files << file;
    }
    return files;
}

Failure animationObstacle(const AnimationExport& what) {
    return what.format ? videoObstacle(settingsOf(what)) : Failure();
}

FramePreviews::FramePreviews(AnimationExport what, const QSize& pixels) : m_what(std::move(what)) {
    constexpr std::uint64_t perPixel = 40;
    m_what.size = pixels;
    m_what.points = perPixel * std::uint64_t(pixels.width()) * std::uint64_t(pixels.height());
}

FramePreviews::~FramePreviews() = default;

std::optional<QImage> FramePreviews::draw(int frame, const std::stop_token& stop) {
    if (m_what.size.isEmpty()) return std::nullopt;
    try {
        if (!m_drawing) {
            m_what = withViewKeyed(std::move(m_what));
            m_drawing = std::make_unique<FrameDrawing>(std::make_unique<PlainFrames>(m_what),
                                                       FrameOptions{0, Exposing::Each});
        }
        const QImage image = m_drawing->draw(frame, {}, stop).image;
        return image.isNull() || stop.stop_requested() ? std::nullopt : std::optional(image);
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

std::optional<QImage> framePreview(AnimationExport what, int frame, const QSize& pixels,
                                   const std::stop_token& stop) {
    return FramePreviews(std::move(what), pixels).draw(frame, stop);
}

ExportOutcome exportAnimation(const AnimationExport& what, const QString& path, const Progress& progress,
                              const std::stop_token& stop) {
    const AnimationExport keyed = withViewKeyed(what);
    return what.format ? writeVideo(keyed, path, progress, stop) : writePictures(keyed, path, progress, stop);
}

} // namespace io
