// SPDX-License-Identifier: MIT
#pragma once

#include "io/video/libav/library.h"

#include <memory>

// Owning pointers for the objects of FFmpeg's libraries.
namespace io::libav {

struct Free {
    void operator()(AVFormatContext* context) const { library().avformat_free_context(context); }
    void operator()(AVCodecContext* context) const { library().avcodec_free_context(&context); }
    void operator()(AVFilterGraph* graph) const { library().avfilter_graph_free(&graph); }
    void operator()(AVFrame* frame) const { library().av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { library().av_packet_free(&packet); }
    void operator()(SwsContext* context) const { library().sws_freeContext(context); }
};
template <class Thing> using Pointer = std::unique_ptr<Thing, Free>;

using Frame = Pointer<AVFrame>;

// A frame with memory of its own; null when there is none.
inline Frame newFrame(AVPixelFormat format, int width, int height) {
    Frame frame(library().av_frame_alloc());
    if (!frame) return frame;
    frame->format = format;
    frame->width = width;
    frame->height = height;
    if (library().av_frame_get_buffer(frame.get(), 0) < 0) frame.reset();
    return frame;
}

} // namespace io::libav
