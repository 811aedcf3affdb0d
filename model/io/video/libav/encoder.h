// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"
#include "io/video/format/video_settings.h"
#include "io/video/libav/file.h"
#include "io/video/libav/pointers.h"

#include <QIODevice>

#include <optional>

namespace io::libav {

// The comment of a video that carries this text.
QByteArray commentOf(const QByteArray& systemText);

// Says that the encoder of the format is missing; nullopt: it is there.
Failure encoderObstacle(VideoFormat format);

// An encoder of one stream of pictures into one file. Failures carry the words of the libraries.
class Encoder {
public:
    Encoder(QIODevice& device, const VideoSettings& settings);

    const Failure& failure() const { return m_failure; }
    qint64 size() const { return m_file.size(); } // bytes written so far
    std::int64_t pictures() const { return m_pictures; }

    // The next picture: AV_PIX_FMT_BGRA with straight alpha, or AV_PIX_FMT_PAL8 for a GIF.
    void add(AVFrame& picture);
    void finish();

private:
    void open(const VideoSettings& settings);
    void openEncoder(const VideoSettings& settings);
    void openFile(const VideoSettings& settings);
    Frame converted(AVFrame& picture);
    void encode(AVFrame* picture); // nullptr: flush
    bool isDone(int result);       // false after a failure, which it records
    // The start of a picture, in the ticks of a GIF or WebP: rounded each by itself, so that no error adds
    // up.
    std::int64_t ticksBefore(std::int64_t picture) const;

    File m_file;
    Pointer<AVFormatContext> m_format;
    Pointer<AVCodecContext> m_encoder;
    Pointer<SwsContext> m_colours;
    Pointer<AVPacket> m_packet;
    AVStream* m_stream = nullptr;
    std::int64_t m_pictures = 0;
    VideoFormat m_kind;
    animation::FrameRate m_rate;
    Failure m_failure;
};

} // namespace io::libav
