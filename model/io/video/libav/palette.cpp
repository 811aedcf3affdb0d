// SPDX-License-Identifier: MIT
#include "io/video/libav/palette.h"

#include <string>

namespace io::libav {

namespace {

std::string source(const char* name, int width, int height) {
    return "buffer@" + std::string(name) + "=video_size=" + std::to_string(width) + "x" +
           std::to_string(height) + ":pix_fmt=bgra:time_base=1/1";
}

// Null when it cannot be made.
Pointer<AVFilterGraph> graphOf(const std::string& description) {
    Pointer<AVFilterGraph> graph(library().avfilter_graph_alloc());
    if (!graph) return graph;
    graph->nb_threads = 1;
    AVFilterInOut* inputs = nullptr;
    AVFilterInOut* outputs = nullptr;
    const bool isMade =
        library().avfilter_graph_parse2(graph.get(), description.c_str(), &inputs, &outputs) >= 0 &&
        library().avfilter_graph_config(graph.get(), nullptr) >= 0;
    library().avfilter_inout_free(&inputs);
    library().avfilter_inout_free(&outputs);
    if (!isMade) graph.reset();
    return graph;
}

// The end where there is no picture.
bool send(AVFilterGraph* graph, const char* name, const AVFrame* picture, int time) {
    AVFilterContext* input = graph != nullptr ? library().avfilter_graph_get_filter(graph, name) : nullptr;
    if (input == nullptr) return false;
    if (picture == nullptr) return library().av_buffersrc_close(input, time, 0) >= 0;
    const Frame frame(library().av_frame_clone(picture));
    if (!frame) return false;
    frame->pts = time;
    return library().av_buffersrc_add_frame(input, frame.get()) >= 0;
}

Frame receive(AVFilterGraph* graph) {
    AVFilterContext* output =
        graph != nullptr ? library().avfilter_graph_get_filter(graph, "buffersink@out") : nullptr;
    Frame frame(output != nullptr ? library().av_frame_alloc() : nullptr);
    if (frame && library().av_buffersink_get_frame(output, frame.get()) < 0) frame.reset();
    return frame;
}

} // namespace

PaletteMaker::PaletteMaker(int width, int height, bool isTransparent)
    : m_graph(graphOf(source("in", width, height) + ",palettegen=stats_mode=full:reserve_transparent=" +
                      (isTransparent ? "1" : "0") + ",buffersink@out")) {}

bool PaletteMaker::add(const Frame& picture) {
    return send(m_graph.get(), "buffer@in", picture.get(), m_pictures++);
}

Frame PaletteMaker::finish() {
    if (!send(m_graph.get(), "buffer@in", nullptr, m_pictures)) return {};
    return receive(m_graph.get());
}

PaletteMap::PaletteMap(int width, int height, const Frame& palette)
    : m_graph(graphOf(source("in", width, height) + "[pictures];" +
                      source("palette", palette->width, palette->height) +
                      "[palette];[pictures][palette]paletteuse=dither=bayer:bayer_scale=3,buffersink@out")) {
    if (!send(m_graph.get(), "buffer@palette", palette.get(), 0) ||
        !send(m_graph.get(), "buffer@palette", nullptr, 1))
        m_graph.reset();
}

Frame PaletteMap::apply(const Frame& picture) {
    if (!send(m_graph.get(), "buffer@in", picture.get(), m_pictures++)) return {};
    return receive(m_graph.get());
}

} // namespace io::libav
