// SPDX-License-Identifier: MIT
#include "io/raster/jpeg_writer.h"

#include "document/text/text.h"
#include "io/raster/library_device.h"
#include "io/raster/pixel_rows.h"
#include "io/raster/raster_system.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>

namespace io {

namespace {

constexpr int usualQuality = 92;
constexpr qsizetype maxComment = 65533; // bytes

} // namespace

// libjpeg leaves by longjmp when something fails: the functions that call it hold no object with a
// destructor.
struct JpegWriter::State {
    State(QIODevice& to, const PictureFormat& given)
        : device(to), format(given), row(std::size_t(given.width) * 3) {}

    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_destination_mgr destination{};
    std::jmp_buf exit{};
    std::array<JOCTET, 65536> buffer{};
    LibraryDevice device;
    PictureFormat format;
    std::vector<JSAMPLE> row;
    Failure failure;

    ~State() { jpeg_destroy_compress(&jpeg); }

    void fail() {
        if (!failure) failure = Text::tr("The picture cannot be written: %1").arg(device.errorString());
        device.rethrow();
    }

    bool start();
    bool writeComments();
    bool writeRow();
    bool finish();
    bool flush(std::size_t size) { return device.write(buffer.data(), qint64(size)); }
    void rewind() {
        destination.next_output_byte = buffer.data();
        destination.free_in_buffer = buffer.size();
    }
};

bool JpegWriter::State::start() {
    jpeg.err = jpeg_std_error(&errors);
    jpeg.client_data = this;
    errors.error_exit = [](j_common_ptr common) {
        std::longjmp(static_cast<JpegWriter::State*>(common->client_data)->exit, 1);
    };
    errors.output_message = [](j_common_ptr) {};
    if (setjmp(exit)) return false;
    jpeg_create_compress(&jpeg);
    jpeg.dest = &destination;
    destination.init_destination = [](j_compress_ptr to) {
        static_cast<JpegWriter::State*>(to->client_data)->rewind();
    };
    destination.empty_output_buffer = [](j_compress_ptr to) -> boolean {
        auto* state = static_cast<JpegWriter::State*>(to->client_data);
        if (!state->flush(state->buffer.size())) std::longjmp(state->exit, 1);
        state->rewind();
        return TRUE;
    };
    destination.term_destination = [](j_compress_ptr to) {
        auto* state = static_cast<JpegWriter::State*>(to->client_data);
        if (!state->flush(state->buffer.size() - state->destination.free_in_buffer))
            std::longjmp(state->exit, 1);
    };
    jpeg.image_width = JDIMENSION(format.width);
    jpeg.image_height = JDIMENSION(format.height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, format.quality.value_or(usualQuality), TRUE);
    jpeg.comp_info[0].h_samp_factor = 1;
    jpeg.comp_info[0].v_samp_factor = 1;
    jpeg.optimize_coding = FALSE; // would hold the whole picture
    if (format.dotsPerInch) {
        jpeg.density_unit = 1; // dots per inch
        jpeg.X_density = jpeg.Y_density = UINT16(std::clamp(*format.dotsPerInch + 0.5, 1.0, 65535.0));
    }
    jpeg_start_compress(&jpeg, TRUE);
    return true;
}

bool JpegWriter::State::writeComments() {
    if (setjmp(exit)) return false;
    const auto mark = qsizetype(std::strlen(systemMark));
    const char* text = format.systemText.constData();
    for (qsizetype at = 0; at < format.systemText.size();) {
        const qsizetype size = std::min(maxComment - mark, format.systemText.size() - at);
        jpeg_write_m_header(&jpeg, JPEG_COM, unsigned(mark + size));
        for (qsizetype i = 0; i < mark; ++i)
            jpeg_write_m_byte(&jpeg, systemMark[i]);
        for (qsizetype i = 0; i < size; ++i)
            jpeg_write_m_byte(&jpeg, static_cast<unsigned char>(text[at + i]));
        at += size;
    }
    return true;
}

bool JpegWriter::State::writeRow() {
    if (setjmp(exit)) return false;
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&jpeg, &pointer, 1);
    return true;
}

bool JpegWriter::State::finish() {
    if (setjmp(exit)) return false;
    jpeg_finish_compress(&jpeg);
    return true;
}

JpegWriter::JpegWriter(QIODevice& device, const PictureFormat& format)
    : m_state(std::make_unique<State>(device, format)) {
    if (!m_state->start() || !m_state->writeComments()) m_state->fail();
}

JpegWriter::~JpegWriter() = default;

Failure JpegWriter::writeRows(std::span<const std::uint32_t> pixels) {
    const auto width = std::size_t(m_state->format.width);
    for (std::size_t at = 0; at + width <= pixels.size() && !m_state->failure; at += width) {
        putBytes(pixels.data() + at, int(width), false, m_state->row.data());
        if (!m_state->writeRow()) m_state->fail();
    }
    return m_state->failure;
}

Failure JpegWriter::writeRows(std::span<const attractor::Rgba16>) {
    Q_ASSERT(false);
    return m_state->failure;
}

Failure JpegWriter::finish() {
    if (!m_state->failure && !m_state->finish()) m_state->fail();
    return m_state->failure;
}

} // namespace io
