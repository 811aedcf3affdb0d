// SPDX-License-Identifier: MIT
#include "io/raster/tiff_writer.h"

#include "document/text/text.h"
#include "io/raster/library_device.h"
#include "io/raster/pixel_rows.h"
#include "io/raster/raster_system.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <tiffio.h>

namespace io {

struct TiffWriter::State {
    State(QIODevice& to, const PictureFormat& given)
        : device(to), format(given), row(std::size_t(given.width) * 4) {}

    TIFF* tiff = nullptr;
    LibraryDevice device;
    toff_t size = 0; // size of the file so far
    PictureFormat format;
    std::vector<std::uint16_t> row; // either depth
    std::uint32_t rows = 0;         // rows written
    Failure failure;

    ~State() { close(); }

    bool isDeep() const { return format.depth == PictureFormat::Depth::Bits16; }
    bool withAlpha() const { return format.pixels != PictureFormat::Pixels::Opaque; }
    void open();
    void close() {
        if (tiff) TIFFClose(std::exchange(tiff, nullptr));
    }
    bool finish() {
        const bool isWritten = TIFFWriteDirectory(tiff) == 1;
        close(); // reports no error
        return isWritten && !device.isFailed();
    }
    bool writeTags();
    bool writeRow() { return TIFFWriteScanline(tiff, row.data(), rows++, 0) == 1 && !device.isFailed(); }
    void fail() {
        if (!failure) failure = Text::tr("The picture cannot be written: %1").arg(device.errorString());
        device.rethrow();
    }
};

namespace {

constexpr std::uint64_t bigTiff = std::uint64_t{3} << 30; // bytes of pixels; classic TIFF files end at 4 GB

} // namespace

void TiffWriter::State::open() {
    const std::uint64_t bytes = std::uint64_t(format.width) * std::uint64_t(format.height) *
                                (withAlpha() ? 4 : 3) * (isDeep() ? 2 : 1);
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    // Receives errors that are reported nowhere else, such as those of a closed file.
    const auto onError = [](TIFF*, void* state, const char*, const char*, va_list) {
        static_cast<State*>(state)->device.fail();
        return 1;
    };
    const auto onWarning = [](TIFF*, void*, const char*, const char*, va_list) { return 1; };
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), onError, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), onWarning, nullptr);
    const auto read = [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; };
    const auto write = [](thandle_t handle, void* data, tmsize_t count) -> tmsize_t {
        auto* state = static_cast<State*>(handle);
        if (!state->device.write(data, count)) return -1;
        state->size = std::max(state->size, toff_t(state->device.position()));
        return count;
    };
    const auto seek = [](thandle_t handle, toff_t offset, int whence) -> toff_t {
        auto* state = static_cast<State*>(handle);
        const toff_t from = whence == SEEK_SET   ? 0
                            : whence == SEEK_END ? state->size
                                                 : toff_t(state->device.position());
        return state->device.seek(qint64(from + offset)) ? from + offset : toff_t(-1);
    };
    const auto close = [](thandle_t) { return 0; };
    const auto sizeOf = [](thandle_t handle) { return static_cast<State*>(handle)->size; };
    tiff = TIFFClientOpenExt("", bytes >= bigTiff ? "w8" : "w", this, read, write, seek, close, sizeOf,
                             nullptr, nullptr, options.get());
}

bool TiffWriter::State::writeTags() {
    constexpr std::uint16_t alpha[]{EXTRASAMPLE_UNASSALPHA};
    bool isSet = TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, std::uint32_t(format.width)) &&
                 TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, std::uint32_t(format.height)) &&
                 TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, withAlpha() ? 4 : 3) &&
                 TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, isDeep() ? 16 : 8) &&
                 TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB) &&
                 TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) &&
                 TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) &&
                 TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) &&
                 TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL) &&
                 TIFFSetField(tiff, TIFFTAG_SOFTWARE, "Barycage") &&
                 TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    if (withAlpha()) isSet = isSet && TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, alpha);
    if (!format.systemText.isEmpty())
        isSet = isSet &&
                TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, (systemMark + format.systemText).constData());
    if (format.dotsPerInch)
        isSet = isSet && TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH) &&
                TIFFSetField(tiff, TIFFTAG_XRESOLUTION, *format.dotsPerInch) &&
                TIFFSetField(tiff, TIFFTAG_YRESOLUTION, *format.dotsPerInch);
    return isSet;
}

TiffWriter::TiffWriter(QIODevice& device, const PictureFormat& format)
    : m_state(std::make_unique<State>(device, format)) {
    m_state->open();
    if (!m_state->tiff || !m_state->writeTags() || m_state->device.isFailed()) m_state->fail();
}

TiffWriter::~TiffWriter() = default;

Failure TiffWriter::writeRows(std::span<const std::uint32_t> pixels) {
    Q_ASSERT(!m_state->isDeep());
    const auto width = std::size_t(m_state->format.width);
    auto* bytes = reinterpret_cast<std::uint8_t*>(m_state->row.data());
    for (std::size_t at = 0; at + width <= pixels.size() && !m_state->failure; at += width) {
        putBytes(pixels.data() + at, int(width), m_state->withAlpha(), bytes);
        if (!m_state->writeRow()) m_state->fail();
    }
    return m_state->failure;
}

Failure TiffWriter::writeRows(std::span<const attractor::Rgba16> pixels) {
    Q_ASSERT(m_state->isDeep());
    const auto width = std::size_t(m_state->format.width);
    for (std::size_t at = 0; at + width <= pixels.size() && !m_state->failure; at += width) {
        putWords(pixels.data() + at, int(width), m_state->withAlpha(), m_state->row.data());
        if (!m_state->writeRow()) m_state->fail();
    }
    return m_state->failure;
}

Failure TiffWriter::finish() {
    if (!m_state->failure && !m_state->finish()) m_state->fail();
    return m_state->failure;
}

} // namespace io
