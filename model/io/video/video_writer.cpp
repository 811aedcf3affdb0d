// SPDX-License-Identifier: MIT
#include "io/video/video_writer.h"

#include <QCoreApplication>

#ifdef BARYCAGE_VIDEO
#include "io/video/frame_spool.h"
#include "io/video/libav/encoder.h"
#include "io/video/libav/palette.h"
#include "io/video/video_text.h"

#include <algorithm>
#include <functional>
#include <future>
#include <numeric>
#include <system_error>
#endif

namespace io {

namespace {

struct VideoTexts {
    Q_DECLARE_TR_FUNCTIONS(VideoWriter)
};

} // namespace

#ifdef BARYCAGE_VIDEO

namespace {

constexpr QRgb opaque = 0xff000000U;

bool isOpaque(const QRgb* pixels, int count) {
    return (std::accumulate(pixels, pixels + count, opaque, std::bit_and()) & opaque) == opaque;
}

// The picture with straight alpha, as PNG pictures have it: the same numbers whether it was drawn or read.
QImage straight(const QImage& image) {
    if (image.format() != QImage::Format_ARGB32_Premultiplied)
        return image.convertToFormat(QImage::Format_ARGB32);
    QImage result(image.size(), QImage::Format_ARGB32);
    if (result.isNull()) return result;
    for (int y = 0; y < result.height(); ++y) {
        const auto* from = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
        if (isOpaque(from, image.width()))
            std::copy_n(from, image.width(), to);
        else
            std::transform(from, from + image.width(), to, [](QRgb pixel) { return qUnpremultiply(pixel); });
    }
    return result;
}

// Straight alpha in BGRA, with sides that are even if they have to be; null when there is no memory.
libav::Frame pictureOf(const QImage& image, const VideoSettings& settings) {
    const VideoFormatFacts& facts = factsOf(settings.format);
    const int width = image.width() + (facts.needsEvenSides ? image.width() % 2 : 0);
    const int height = image.height() + (facts.needsEvenSides ? image.height() % 2 : 0);
    libav::Frame frame = libav::newFrame(AV_PIX_FMT_BGRA, width, height);
    if (!frame) return frame;
    for (int y = 0; y < height; ++y) {
        const auto* from =
            reinterpret_cast<const QRgb*>(image.constScanLine(std::min(y, image.height() - 1)));
        auto* row = reinterpret_cast<QRgb*>(frame->data[0] + std::ptrdiff_t(y) * frame->linesize[0]);
        const auto shown = [&](QRgb pixel) {
            return !facts.storesAlpha       ? qPremultiply(pixel) | opaque
                   : settings.isTransparent ? pixel
                                            : pixel | opaque;
        };
        if (isOpaque(from, image.width()))
            std::copy_n(from, image.width(), row);
        else
            std::transform(from, from + image.width(), row, shown);
        if (width > image.width()) row[width - 1] = row[width - 2];
    }
    return frame;
}

VideoSettings encoded(VideoSettings settings) {
    if (!factsOf(settings.format).needsEvenSides) return settings;
    settings.width += settings.width % 2;
    settings.height += settings.height % 2;
    return settings;
}

// State between two checks of the stop token.
struct Course {
    const VideoWriter::Progress& progress;
    const std::stop_token& stop;

    bool goesOn(double fraction) const {
        if (progress) progress(fraction);
        return !stop.stop_requested();
    }
};

} // namespace

struct VideoWriter::State {
    State(const QString& path, const VideoSettings& wanted) : settings(wanted), file(path) {
        failure = videoObstacle(settings);
        if (!failure) failure = file.failure();
        if (failure) return;
        encoder = std::make_unique<libav::Encoder>(file, encoded(settings));
        takeFailure();
        if (factsOf(settings.format).isPaletted) spool = std::make_unique<FrameSpool>();
    }

    void takeFailure() {
        if (!failure) failure = file.failure() ? file.failure() : encoder->failure();
    }

    // Waits for the frame being encoded; everything else runs in one thread at a time.
    void await() {
        if (pending.valid()) pending.get();
    }
    // Encodes the frame while the caller draws the next one.
    void begin(const QImage& frame) {
        await();
        if (failure) return;
        try {
            pending = std::async(std::launch::async, [this, frame] { take(frame); });
        } catch (const std::system_error&) { // no thread available
            take(frame);
        }
    }
    void take(const QImage& frame) {
        const QImage picture = straight(frame);
        if (picture.isNull())
            failure = VideoTexts::tr("There is not enough memory for a frame of the video.");
        else if (spool)
            failure = spool->add(picture);
        else
            add(picture);
    }

    void add(const QImage& image) {
        const libav::Frame picture = pictureOf(image, settings);
        if (picture)
            encoder->add(*picture);
        else
            failure = VideoTexts::tr("There is not enough memory for a frame of the video.");
        takeFailure();
    }

    void addAllInOnePalette(const Course& course);
    libav::Frame paletteOfAll(const Course& course);
    void finish(const Course& course);

    VideoSettings settings;
    NewFile file;
    Failure failure;
    std::unique_ptr<libav::Encoder> encoder;
    std::unique_ptr<FrameSpool> spool; // GIF only
    std::future<void> pending;         // last member: uses all others
};

// Null after a failure, which is remembered, or when stopped.
libav::Frame VideoWriter::State::paletteOfAll(const Course& course) {
    libav::PaletteMaker maker(settings.width, settings.height, settings.isTransparent);
    for (int index = 0; index < spool->count(); ++index) {
        if (!course.goesOn(0.3 * index / spool->count())) return {};
        const QImage image = spool->read(index);
        const libav::Frame picture = image.isNull() ? nullptr : pictureOf(image, settings);
        if (picture && maker.add(picture)) continue;
        failure = VideoTexts::tr("There is not enough memory for the palette of the GIF.");
        return {};
    }
    libav::Frame palette = maker.finish();
    if (!palette) failure = VideoTexts::tr("There is not enough memory for the palette of the GIF.");
    return palette;
}

void VideoWriter::State::addAllInOnePalette(const Course& course) {
    const libav::Frame palette = paletteOfAll(course);
    if (!palette) return;
    libav::PaletteMap map(settings.width, settings.height, palette);
    for (int index = 0; index < spool->count() && !failure; ++index) {
        if (!course.goesOn(0.3 + 0.7 * index / spool->count())) return;
        const QImage image = spool->read(index);
        const libav::Frame picture = image.isNull() ? nullptr : pictureOf(image, settings);
        const libav::Frame mapped = picture ? map.apply(picture) : nullptr;
        if (mapped)
            encoder->add(*mapped);
        else
            failure = VideoTexts::tr("A frame of the GIF cannot be created.");
        takeFailure();
    }
}

void VideoWriter::State::finish(const Course& course) {
    if (spool && !failure) addAllInOnePalette(course);
    if (failure || course.stop.stop_requested()) return;
    encoder->finish();
    takeFailure();
    if (failure || course.stop.stop_requested()) return;
    std::optional<qint64> size = encoder->size();
    if (settings.format == VideoFormat::WebP) size = animatedWebP(file, *size, settings, encoder->pictures());
    const bool isAdded =
        size && (!hasTextAdded(settings.format) || settings.systemText.isEmpty() ||
                 addVideoText(file, *size, settings.format, libav::commentOf(settings.systemText)));
    if (!isAdded)
        failure =
            file.failure() ? file.failure() : VideoTexts::tr("The animation cannot be stored in the video.");
    if (!failure) failure = file.commit();
}

Failure videoObstacle(const VideoSettings& settings) {
    if (const Failure missing = libav::encoderObstacle(settings.format)) return missing;
    const VideoFormatFacts& facts = factsOf(settings.format);
    const int side = std::max(settings.width, settings.height);
    if (side > facts.maxSide)
        return VideoTexts::tr("A side of %1 pixels is too long for this format; the limit is %2.")
            .arg(side)
            .arg(facts.maxSide);
    if (facts.maxRate && settings.rate.frames > std::int64_t(*facts.maxRate) * settings.rate.seconds)
        return VideoTexts::tr("This format shows at most %1 frames per second. Choose a lower rate.")
            .arg(*facts.maxRate);
    return std::nullopt;
}

VideoWriter::VideoWriter(const QString& path, const VideoSettings& settings)
    : m_state(std::make_unique<State>(path, settings)) {}

Failure VideoWriter::writeFrame(const QImage& frame) {
    m_state->begin(frame);
    return m_state->pending.valid() ? std::nullopt : m_state->failure;
}

Failure VideoWriter::finish(const Progress& progress, const std::stop_token& stop) {
    m_state->await();
    if (!m_state->failure) m_state->finish({progress, stop});
    return m_state->failure;
}

const Failure& VideoWriter::failure() const {
    m_state->await();
    return m_state->failure;
}

#else

struct VideoWriter::State {
    Failure failure;
};

Failure videoObstacle(const VideoSettings&) {
    return VideoTexts::tr("This build of Barycage does not include FFmpeg's libraries and cannot write "
                          "videos. Write the frames as "
                          "PNG pictures instead.");
}

VideoWriter::VideoWriter(const QString&, const VideoSettings& settings)
    : m_state(std::make_unique<State>(State{videoObstacle(settings)})) {}

Failure VideoWriter::writeFrame(const QImage&) {
    return m_state->failure;
}

Failure VideoWriter::finish(const Progress&, const std::stop_token&) {
    return m_state->failure;
}

const Failure& VideoWriter::failure() const {
    return m_state->failure;
}

#endif

VideoWriter::~VideoWriter() = default;

} // namespace io
