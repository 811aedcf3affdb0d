// SPDX-License-Identifier: MIT
#include "io/raster/exr_writer.h"

#include "attractor/colour/srgb_transfer.h"
#include "document/text/text.h"
#include "io/raster/raster_system.h"

#include <exception>
#include <stdexcept>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

namespace io {

namespace {

constexpr std::size_t codes = 65536;

// A stream that reports failures by exceptions, as the library does itself and expects of streams.
class DeviceStream final : public Imf::OStream {
public:
    explicit DeviceStream(LibraryDevice& device) : OStream(""), m_device(device) {}

    void write(const char* bytes, int size) override {
        if (!m_device.write(bytes, size)) throw std::runtime_error("write");
    }
    std::uint64_t tellp() override { return std::uint64_t(m_device.position()); }
    void seekp(std::uint64_t position) override {
        if (!m_device.seek(qint64(position))) throw std::runtime_error("seek");
    }

private:
    LibraryDevice& m_device;
};

Imf::Header headerOf(PictureFile file, const PictureFormat& format) {
    const Imf::Channel channel(file == PictureFile::ExrFloat ? Imf::FLOAT : Imf::HALF);
    Imf::Header header(format.width, format.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : {"R", "G", "B"})
        header.channels().insert(name, channel);
    if (format.pixels != PictureFormat::Pixels::Opaque) header.channels().insert("A", channel);
    if (format.dotsPerInch) Imf::addXDensity(header, float(*format.dotsPerInch));
    if (!format.systemText.isEmpty())
        header.insert(exrSystemAttribute, Imf::StringAttribute(format.systemText.toStdString()));
    return header;
}

} // namespace

struct ExrWriter::State {
    State(LibraryDevice& device, PictureFile file, const PictureFormat& given)
        : stream(device),
          type(file == PictureFile::ExrFloat ? Imf::FLOAT : Imf::HALF),
          format(given),
          output(std::make_unique<Imf::OutputFile>(stream, headerOf(file, given), 0)),
          light(codes),
          row(std::size_t(given.width) * 4) {
        for (std::size_t code = 0; code < codes; ++code)
            light[code] = float(attractor::linearFromEncoded(double(code) / double(codes - 1)));
    }

    void writeRow(const attractor::Rgba16* pixels);
    template <class Number> void writeAs();

    DeviceStream stream;
    Imf::PixelType type;
    PictureFormat format;
    std::unique_ptr<Imf::OutputFile> output;
    std::vector<float> light; // linear light of each code
    std::vector<float> row;   // red, green, blue, alpha
};

template <class Number> void ExrWriter::State::writeAs() {
    std::vector<Number> numbers(row.begin(), row.end());
    constexpr std::size_t pixel = 4 * sizeof(Number);
    constexpr std::size_t rowStride = 0; // same buffer for every row
    char* first = reinterpret_cast<char*>(numbers.data());
    Imf::FrameBuffer frame;
    const char* names[]{"R", "G", "B", "A"};
    for (std::size_t i = 0; i < (format.pixels == PictureFormat::Pixels::Opaque ? 3 : 4); ++i)
        frame.insert(names[i], Imf::Slice(type, first + i * sizeof(Number), pixel, rowStride));
    output->setFrameBuffer(frame);
    output->writePixels(1);
}

void ExrWriter::State::writeRow(const attractor::Rgba16* pixels) {
    float* to = row.data();
    for (int x = 0; x < format.width; ++x) {
        const float alpha = float(pixels[x].alpha) / float(codes - 1);
        *to++ = light[pixels[x].red] * alpha;
        *to++ = light[pixels[x].green] * alpha;
        *to++ = light[pixels[x].blue] * alpha;
        *to++ = alpha;
    }
    if (type == Imf::FLOAT)
        writeAs<float>();
    else
        writeAs<half>();
}

ExrWriter::ExrWriter(QIODevice& device, PictureFile file, const PictureFormat& format) : m_device(device) {
    try {
        m_state = std::make_unique<State>(m_device, file, format);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        fail();
    }
}

ExrWriter::~ExrWriter() = default;

void ExrWriter::fail() {
    if (!m_failure) m_failure = Text::tr("The picture cannot be written: %1").arg(m_device.errorString());
    m_device.rethrow();
}

Failure ExrWriter::writeRows(std::span<const std::uint32_t>) {
    Q_ASSERT(false);
    return m_failure;
}

Failure ExrWriter::writeRows(std::span<const attractor::Rgba16> pixels) {
    if (m_failure) return m_failure;
    const auto width = std::size_t(m_state->format.width);
    try {
        for (std::size_t at = 0; at + width <= pixels.size(); at += width)
            m_state->writeRow(pixels.data() + at);
    } catch (const std::bad_alloc&) {
        fail();
        throw;
    } catch (const std::exception&) {
        fail();
    }
    return m_failure;
}

// The table of the rows is written when the library's file is destroyed, which hides exceptions.
Failure ExrWriter::finish() {
    if (m_failure) return m_failure;
    m_state->output.reset();
    if (m_device.isFailed()) fail();
    return m_failure;
}

} // namespace io
