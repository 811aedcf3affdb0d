// SPDX-License-Identifier: MIT
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavformat/avformat.h>
#include <libavutil/frame.h>
#include <libavutil/log.h>
#include <libavutil/mem.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

// FFmpeg's libraries, loaded when a video is first written. Linked as usual, they and what they need would
// make every start of a program several times as long. docs/decisions/0013-videos.md.
namespace io::libav {

#define BARYCAGE_LIBAV_FUNCTIONS(use)                                                                        \
    use(util, av_dict_free) use(util, av_dict_set) use(util, av_frame_alloc) use(util, av_frame_clone)       \
        use(util, av_frame_free) use(util, av_frame_get_buffer) use(util, av_free) use(util, av_freep) use(  \
            util, av_log_set_level) use(util, av_malloc) use(util, av_opt_set_int) use(util, av_strerror)    \
            use(codec, av_packet_alloc) use(codec, av_packet_free) use(codec, av_packet_make_writable)       \
                use(codec, av_packet_rescale_ts) use(codec, avcodec_alloc_context3) use(                     \
                    codec, avcodec_find_encoder_by_name) use(codec, avcodec_free_context)                    \
                    use(codec, avcodec_open2) use(codec, avcodec_parameters_from_context) use(               \
                        codec, avcodec_receive_packet) use(codec, avcodec_send_frame)                        \
                        use(format, av_guess_format) use(format, av_interleaved_write_frame) use(            \
                            format, av_write_trailer) use(format, avformat_alloc_output_context2)            \
                            use(format, avformat_free_context) use(format, avformat_new_stream) use(         \
                                format, avformat_write_header) use(format, avio_alloc_context)               \
                                use(format, avio_context_free) use(format, avio_flush) use(                  \
                                    filter, av_buffersink_get_frame) use(filter, av_buffersrc_add_frame)     \
                                    use(filter, av_buffersrc_close) use(filter, avfilter_graph_alloc)        \
                                        use(filter, avfilter_graph_config) use(filter, avfilter_graph_free)  \
                                            use(filter, avfilter_graph_get_filter)                           \
                                                use(filter, avfilter_graph_parse2)                           \
                                                    use(filter, avfilter_inout_free)                         \
                                                        use(scale, sws_freeContext)                          \
                                                            use(scale, sws_getCoefficients)                  \
                                                                use(scale, sws_getContext)                   \
                                                                    use(scale, sws_scale)                    \
                                                                        use(scale, sws_setColorspaceDetails)

// The functions, by their own names.
struct Library {
#define BARYCAGE_LIBAV_MEMBER(library, name) decltype(&::name) name = nullptr;
    BARYCAGE_LIBAV_FUNCTIONS(BARYCAGE_LIBAV_MEMBER)
#undef BARYCAGE_LIBAV_MEMBER
};

QString loadingError();   // reason why an installed library cannot be used; empty: one is missing
bool isInstalled();       // true if all are there in the versions used at compilation
const Library& library(); // requires isInstalled()

} // namespace io::libav
