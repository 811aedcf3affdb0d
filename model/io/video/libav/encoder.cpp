// SPDX-License-Identifier: MIT
#include "io/video/libav/encoder.h"
#include "document/text/text.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace io::libav {

namespace {

// A fixed number, because what encoders write depends on it.
constexpr int threads = 4;

struct Option {
    const char* name;
    const char* value;
};

// Encoding of a format.
struct Recipe {
    const char* muxer;
    const char* encoder;
    AVPixelFormat opaque;
    AVPixelFormat transparent;
    std::vector<Option> options{};     // options of the encoder
    std::vector<Option> fileOptions{}; // options of the muxer
};

Recipe recipeOf(const VideoSettings& settings) {
    switch (settings.format) {
    case VideoFormat::Mp4: // without mbtree, with which x264 reads uninitialised memory, and bytes vary
        return {"mp4",
                "libx264",
                AV_PIX_FMT_YUV420P,
                AV_PIX_FMT_YUV420P,
                {{"preset", "superfast"}, {"crf", "11"}, {"mbtree", "0"}},
                {{"movflags", "+faststart"}}};
    case VideoFormat::WebM:
        // No hidden frames, which are incompatible with transparency.
        return {"webm",
                "libvpx-vp9",
                AV_PIX_FMT_YUV420P,
                AV_PIX_FMT_YUVA420P,
                {{"crf", "10"},
                 {"deadline", "good"},
                 {"cpu-used", "4"},
                 {"auto-alt-ref", settings.isTransparent ? "0" : "1"}}};
    case VideoFormat::Mkv:
        return {"matroska",
                "ffv1",
                AV_PIX_FMT_BGR0,
                AV_PIX_FMT_BGRA,
                {{"level", "3"}, {"slices", "4"}, {"slicecrc", "1"}, {"g", "1"}}};
    case VideoFormat::Gif:
        return {"gif",           "gif", AV_PIX_FMT_PAL8,
                AV_PIX_FMT_PAL8, {},    {{"loop", settings.repeats ? "0" : "-1"}}};
    case VideoFormat::WebP: // lossless, because lossy WebP has a quarter of the colours
        return {"webp",
                "libwebp_anim",
                AV_PIX_FMT_BGRA,
                AV_PIX_FMT_BGRA,
                {{"lossless", "1"}, {"quality", "50"}},
                {{"loop", settings.repeats ? "0" : "1"}}};
    case VideoFormat::Apng:
        return {"apng",          "apng",           AV_PIX_FMT_RGB24,
                AV_PIX_FMT_RGBA, {{"pred", "up"}}, {{"plays", settings.repeats ? "0" : "1"}}};
    }
    return {};
}

// Options of an encoder or a muxer; the library leaves those that it does not take in the dictionary.
class Options {
public:
    explicit Options(const std::vector<Option>& options) {
        for (const Option& option : options)
            library().av_dict_set(&m_dictionary, option.name, option.value, 0);
    }
    ~Options() { library().av_dict_free(&m_dictionary); }
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    AVDictionary** get() { return &m_dictionary; }

private:
    AVDictionary* m_dictionary = nullptr;
};

bool isRgb(AVPixelFormat format) {
    return format != AV_PIX_FMT_YUV420P && format != AV_PIX_FMT_YUVA420P;
}

void describeColours(AVCodecContext& encoder) {
    if (encoder.pix_fmt == AV_PIX_FMT_PAL8) return;
    const bool rgb = isRgb(encoder.pix_fmt);
    encoder.color_range = rgb ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    encoder.colorspace = rgb ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
    encoder.color_primaries = AVCOL_PRI_BT709;
    encoder.color_trc = rgb ? AVCOL_TRC_IEC61966_2_1 : AVCOL_TRC_BT709;
}

bool copiesRows(AVPixelFormat format) {
    return format == AV_PIX_FMT_BGRA || format == AV_PIX_FMT_BGR0;
}

Pointer<SwsContext> conversion(int width, int height, AVPixelFormat to) {
    constexpr int flags = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT;
    Pointer<SwsContext> context(library().sws_getContext(width, height, AV_PIX_FMT_BGRA, width, height, to,
                                                         flags, nullptr, nullptr, nullptr));
    if (!context) return context;
    constexpr int one = 1 << 16;
    const int* bt709 = library().sws_getCoefficients(SWS_CS_ITU709);
    library().sws_setColorspaceDetails(context.get(), bt709, 1, bt709, isRgb(to) ? 1 : 0, 0, one, one);
    return context;
}

int ticksPerSecond(VideoFormat format) {
    return format == VideoFormat::Gif ? 100 : 1000;
}

std::uint32_t littleEndian(std::span<const std::uint8_t> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
        value = value << 8U | bytes[i];
    return value;
}

// Sets the duration of the last picture of an animated WebP, so that all of them take `total` milliseconds:
// its encoder gives it the mean of the others. In a still picture there is nothing to set.
void setDuration(std::span<std::uint8_t> file, std::int64_t total) {
    constexpr std::size_t header = 12, chunkHeader = 8, durationAt = 12, durationSize = 3;
    std::span<std::uint8_t> last;
    std::int64_t before = 0, present = 0;
    for (std::size_t at = header; at + chunkHeader <= file.size();) {
        const std::size_t size = littleEndian(file.subspan(at + 4, 4));
        const bool isFrame = std::memcmp(&file[at], "ANMF", 4) == 0;
        if (isFrame && at + chunkHeader + durationAt + durationSize <= file.size()) {
            last = file.subspan(at + chunkHeader + durationAt, durationSize);
            before += present;
            present = littleEndian(last);
        }
        at += chunkHeader + size + size % 2;
    }
    const std::int64_t duration = total - before;
    if (duration < 0) return;
    for (std::size_t i = 0; i < last.size(); ++i)
        last[i] = std::uint8_t(duration >> (8 * i));
}

} // namespace

QByteArray commentOf(const QByteArray& systemText) {
    return "; Barycage\n" + systemText;
}

Failure encoderObstacle(VideoFormat format) {
    const QString error = isInstalled() ? QString() : loadingError();
    // What the loader says of both kinds of memory.
    if (error.contains(QStringLiteral("failed to map")) || error.contains(QStringLiteral("cannot allocate")))
        return Text::tr("There is not enough memory for the video.");
    if (!error.isEmpty())
        return Text::tr("FFmpeg's libraries cannot be loaded, so no videos can be written: %1.").arg(error);
    if (!isInstalled())
        return Text::tr("FFmpeg's libraries are not installed on this machine, so no videos can be written. "
                        "Install them, or write the frames as PNG pictures instead.");
    VideoSettings settings;
    settings.format = format;
    const Recipe recipe = recipeOf(settings);
    if (library().avcodec_find_encoder_by_name(recipe.encoder) != nullptr &&
        library().av_guess_format(recipe.muxer, nullptr, nullptr) != nullptr)
        return std::nullopt;
    return Text::tr("FFmpeg's libraries on this machine cannot write %1 files: the encoder "
                    "%2 is missing. Choose another format.")
        .arg(u'.' + videoSuffix(format), QLatin1String(recipe.encoder));
}

Encoder::Encoder(QIODevice& device, const VideoSettings& settings)
    : m_file(device), m_kind(settings.format), m_rate(settings.rate) {
    library().av_log_set_level(AV_LOG_QUIET); // failures are reported by failure()
    open(settings);
}

bool Encoder::isDone(int result) {
    if (result >= 0) return true;
    if (m_failure) return false;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    library().av_strerror(result, text.data(), text.size());
    if (result == AVERROR(ENOMEM))
        m_failure = Text::tr("There is not enough memory for the video.");
    else if (result == AVERROR_EXTERNAL) // all that encoders say when they get no memory
        m_failure =
            Text::tr("The encoder of the video does not work. There may not be enough memory for it.");
    else
        m_failure = Text::tr("The video cannot be written: %1.").arg(QString::fromUtf8(text.data()));
    return false;
}

void Encoder::open(const VideoSettings& settings) {
    m_packet.reset(library().av_packet_alloc());
    AVFormatContext* format = nullptr;
    const Recipe recipe = recipeOf(settings);
    const int made = library().avformat_alloc_output_context2(&format, nullptr, recipe.muxer, nullptr);
    m_format.reset(format);
    if (!isDone(m_packet ? made : AVERROR(ENOMEM))) return;
    openEncoder(settings);
    if (!m_failure) openFile(settings);
}

void Encoder::openEncoder(const VideoSettings& settings) {
    const Recipe recipe = recipeOf(settings);
    const AVCodec* codec = library().avcodec_find_encoder_by_name(recipe.encoder);
    m_encoder.reset(codec != nullptr ? library().avcodec_alloc_context3(codec) : nullptr);
    if (!isDone(m_encoder ? 0 : AVERROR_ENCODER_NOT_FOUND)) return;
    m_encoder->width = settings.width;
    m_encoder->height = settings.height;
    m_encoder->pix_fmt = settings.isTransparent ? recipe.transparent : recipe.opaque;
    m_encoder->time_base = {settings.rate.seconds, settings.rate.frames};
    if (m_kind == VideoFormat::WebP) m_encoder->time_base = {1, ticksPerSecond(m_kind)};
    m_encoder->framerate = {settings.rate.frames, settings.rate.seconds};
    m_encoder->sample_aspect_ratio = {1, 1};
    m_encoder->bit_rate = 0; // constant quality
    m_encoder->thread_count = threads;
    m_encoder->flags |= AV_CODEC_FLAG_BITEXACT;
    if ((m_format->oformat->flags & AVFMT_GLOBALHEADER) != 0) m_encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    describeColours(*m_encoder);
    Options options(recipe.options);
    if (!isDone(library().avcodec_open2(m_encoder.get(), codec, options.get()))) return;
    if (isRgb(m_encoder->pix_fmt) && copiesRows(m_encoder->pix_fmt)) return;
    if (m_encoder->pix_fmt == AV_PIX_FMT_PAL8) return;
    m_colours = conversion(settings.width, settings.height, m_encoder->pix_fmt);
    isDone(m_colours ? 0 : AVERROR(ENOMEM));
}

void Encoder::openFile(const VideoSettings& settings) {
    m_stream = library().avformat_new_stream(m_format.get(), nullptr);
    if (!isDone(m_stream != nullptr ? 0 : AVERROR(ENOMEM))) return;
    if (!isDone(library().avcodec_parameters_from_context(m_stream->codecpar, m_encoder.get()))) return;
    m_stream->time_base = m_encoder->time_base;
    m_stream->avg_frame_rate = m_stream->r_frame_rate = m_encoder->framerate;
    if (settings.format == VideoFormat::WebM && settings.isTransparent)
        library().av_dict_set(&m_stream->metadata, "alpha_mode", "1", 0);
    if (!settings.title.isEmpty())
        library().av_dict_set(&m_format->metadata, "title", settings.title.toUtf8().constData(), 0);
    if (!settings.systemText.isEmpty())
        library().av_dict_set(&m_format->metadata, "comment", commentOf(settings.systemText).constData(), 0);
    m_format->flags |= AVFMT_FLAG_BITEXACT;
    m_file.serve(*m_format);
    if (!isDone(m_format->pb != nullptr ? 0 : AVERROR(ENOMEM))) return;
    Options options(recipeOf(settings).fileOptions);
    isDone(library().avformat_write_header(m_format.get(), options.get()));
}

Frame Encoder::converted(AVFrame& picture) {
    if (picture.format == AV_PIX_FMT_PAL8) return Frame(library().av_frame_clone(&picture));
    Frame frame = newFrame(m_encoder->pix_fmt, picture.width, picture.height);
    if (!frame) return frame;
    if (m_colours) {
        library().sws_scale(m_colours.get(), picture.data, picture.linesize, 0, picture.height, frame->data,
                            frame->linesize);
    } else {
        for (int row = 0; row < picture.height; ++row)
            std::memcpy(frame->data[0] + std::ptrdiff_t(row) * frame->linesize[0],
                        picture.data[0] + std::ptrdiff_t(row) * picture.linesize[0],
                        std::size_t(picture.width) * 4);
    }
    frame->color_range = m_encoder->color_range;
    frame->colorspace = m_encoder->colorspace;
    frame->color_primaries = m_encoder->color_primaries;
    frame->color_trc = m_encoder->color_trc;
    return frame;
}

void Encoder::add(AVFrame& picture) {
    if (m_failure) return;
    const Frame frame = converted(picture);
    if (!isDone(frame ? 0 : AVERROR(ENOMEM))) return;
    frame->pts = m_kind == VideoFormat::WebP ? ticksBefore(m_pictures) : m_pictures;
    ++m_pictures;
    encode(frame.get());
}

std::int64_t Encoder::ticksBefore(std::int64_t picture) const {
    const std::int64_t ticks = 2 * picture * m_rate.seconds * ticksPerSecond(m_kind);
    return (ticks + m_rate.frames) / (2 * std::int64_t(m_rate.frames));
}

void Encoder::encode(AVFrame* picture) {
    if (!isDone(library().avcodec_send_frame(m_encoder.get(), picture))) return;
    while (!m_failure) {
        const int result = library().avcodec_receive_packet(m_encoder.get(), m_packet.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
        if (!isDone(result)) return;
        if (m_packet->duration == 0) m_packet->duration = 1;
        if (m_kind == VideoFormat::WebP) {
            if (!isDone(library().av_packet_make_writable(m_packet.get()))) return;
            const std::span bytes(m_packet->data, std::size_t(m_packet->size));
            setDuration(bytes, ticksBefore(m_pictures));
        }
        library().av_packet_rescale_ts(m_packet.get(), m_encoder->time_base, m_stream->time_base);
        m_packet->stream_index = m_stream->index;
        isDone(library().av_interleaved_write_frame(m_format.get(), m_packet.get()));
    }
}

void Encoder::finish() {
    if (!m_failure) encode(nullptr);
    // Explicit end: without it, the last picture would be shown as long as the previous one.
    if (!m_failure && m_kind == VideoFormat::Gif && m_pictures > 0)
        isDone(library().av_opt_set_int(m_format->priv_data, "final_delay",
                                        ticksBefore(m_pictures) - ticksBefore(m_pictures - 1), 0));
    if (!m_failure) isDone(library().av_write_trailer(m_format.get()));
    if (m_failure) return;
    library().avio_flush(m_format->pb);
    if (isDone(m_format->pb->error)) isDone(m_file.error());
}

} // namespace io::libav
