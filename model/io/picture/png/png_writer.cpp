// SPDX-License-Identifier: MIT
#include "io/picture/png/png_writer.h"

#include "document/text/text.h"
#include "io/picture/png/png_system.h"
#include "io/raster/library_device.h"
#include "io/raster/pixel_rows.h"

#include <png.h>

#include <cmath>
#include <vector>

namespace io {

// libpng leaves by longjmp when something fails: the functions that call it hold no object with a destructor.
struct PngWriter::State {
    State(QIODevice& to, const PictureFormat& given) : device(to), format(given) {
        const size_t channels = grey() ? 1 : transparent() ? 4 : 3;
        row.resize(size_t(format.width) * channels * (deep() ? 2 : 1));
    }

    png_structp png = nullptr;
    png_infop info = nullptr;
    LibraryDevice device;
    PictureFormat format;
    std::vector<png_byte> row;
    Failure failure;

    ~State() { png_destroy_write_struct(&png, &info); }

    void fail() {
        if (!failure) failure = Text::tr("The picture cannot be written: %1").arg(device.errorString());
        device.rethrow();
    }

    bool start();
    bool writeHeader();
    bool writeRow();
    bool finish();
    void encode(const std::uint32_t* pixels);
    void encode(const attractor::Rgba16* pixels);
    void encode(const std::uint16_t* values);
    template <class Pixel> Failure writeRows(std::span<const Pixel> pixels);
    bool transparent() const { return format.pixels == PictureFormat::Pixels::Transparent; }
    bool grey() const { return format.pixels == PictureFormat::Pixels::Grey; }
    bool deep() const { return format.depth == PictureFormat::Depth::Bits16; }
};

namespace {

// The two that libpng calls; neither may return after an error.
[[noreturn]] void onWriteError(png_structp png, png_const_charp) {
    png_longjmp(png, 1);
}

void onWriteWarning(png_structp, png_const_charp) {}

void onWrite(png_structp png, png_bytep data, png_size_t size) {
    if (!static_cast<LibraryDevice*>(png_get_io_ptr(png))->write(data, qint64(size))) png_error(png, "write");
}

void onFlush(png_structp) {}

} // namespace

bool PngWriter::State::start() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onWriteError, onWriteWarning);
    info = png ? png_create_info_struct(png) : nullptr;
    if (!info) return false;
    png_set_write_fn(png, &device, onWrite, onFlush);
    return writeHeader();
}

bool PngWriter::State::writeHeader() {
    if (setjmp(png_jmpbuf(png))) return false;
    const int colour = grey()          ? PNG_COLOR_TYPE_GRAY
                       : transparent() ? PNG_COLOR_TYPE_RGB_ALPHA
                                       : PNG_COLOR_TYPE_RGB;
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Unfiltered: few palette colours and noise, whose differences have more values than they have.
    if (!deep()) {
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
        png_set_compression_level(png, 1); // fast; higher levels give the same size
    }
    png_set_IHDR(png, info, png_uint_32(format.width), png_uint_32(format.height), deep() ? 16 : 8, colour,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!grey()) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (format.dotsPerInch) {
        const auto perMetre = png_uint_32(std::lround(*format.dotsPerInch / 0.0254));
        png_set_pHYs(png, info, perMetre, perMetre, PNG_RESOLUTION_METER);
    }
    if (!format.systemText.isEmpty()) {
        png_text text{};
        text.compression = PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(pngSystemKeyword);
        text.text = format.systemText.data();
        text.itxt_length = size_t(format.systemText.size());
        png_set_text(png, info, &text, 1);
    }
    for (auto& [keyword, value] : format.texts) {
        png_text text{};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = keyword.data();
        text.text = value.data();
        text.text_length = size_t(value.size());
        png_set_text(png, info, &text, 1);
    }
    png_write_info(png, info);
    return true;
}

void PngWriter::State::encode(const std::uint32_t* pixels) {
    putBytes(pixels, format.width, transparent(), row.data());
}

void PngWriter::State::encode(const attractor::Rgba16* pixels) {
    png_byte* to = row.data();
    const auto put = [&to](std::uint16_t channel) {
        *to++ = png_byte(channel >> 8);
        *to++ = png_byte(channel & 255);
    };
    for (int x = 0; x < format.width; ++x) {
        put(pixels[x].red);
        put(pixels[x].green);
        put(pixels[x].blue);
        if (transparent()) put(pixels[x].alpha);
    }
}

void PngWriter::State::encode(const std::uint16_t* values) {
    png_byte* to = row.data();
    for (int x = 0; x < format.width; ++x) {
        *to++ = png_byte(values[x] >> 8);
        *to++ = png_byte(values[x] & 255);
    }
}

template <class Pixel> Failure PngWriter::State::writeRows(std::span<const Pixel> pixels) {
    const auto width = size_t(format.width);
    for (size_t at = 0; at + width <= pixels.size() && !failure; at += width) {
        encode(pixels.data() + at);
        if (!writeRow()) fail();
    }
    return failure;
}

bool PngWriter::State::writeRow() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_row(png, row.data());
    return true;
}

bool PngWriter::State::finish() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_end(png, nullptr);
    return true;
}

PngWriter::PngWriter(QIODevice& device, const PictureFormat& format)
    : m_state(std::make_unique<State>(device, format)) {
    if (!m_state->start()) m_state->fail();
}

PngWriter::~PngWriter() = default;

Failure PngWriter::writeRows(std::span<const std::uint32_t> pixels) {
    Q_ASSERT(!m_state->deep());
    return m_state->writeRows(pixels);
}

Failure PngWriter::writeRows(std::span<const attractor::Rgba16> pixels) {
    Q_ASSERT(m_state->deep());
    return m_state->writeRows(pixels);
}

Failure PngWriter::writeRows(std::span<const std::uint16_t> values) {
    Q_ASSERT(m_state->deep() && m_state->grey());
    return m_state->writeRows(values);
}

Failure PngWriter::finish() {
    if (!m_state->failure && !m_state->finish()) m_state->fail();
    return m_state->failure;
}

} // namespace io
