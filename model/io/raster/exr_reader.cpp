// SPDX-License-Identifier: MIT
#include "io/raster/exr_reader.h"

#include "attractor/colour/srgb_transfer.h"
#include "io/raster/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <vector>

#include <ImfIO.h>
#include <ImfRgbaFile.h>

namespace io {

namespace {

constexpr std::uint64_t maxBlock = std::uint64_t{512} << 20; // bytes decompressed at a time
constexpr std::uint64_t maxAll = std::uint64_t{4} << 30;     // bytes in total

// Values of a header, read before the library, which allocates as much as they say.
struct Header {
    QRect pixels, seen; // data window and display window
    std::uint64_t channels = 0;
    std::uint64_t rowsTogether = 1;
    std::uint64_t tileWidth = 0, tileHeight = 0; // 0: no tiles
};

std::uint64_t rowsTogether(std::uint8_t compression) {
    constexpr std::uint64_t rows[]{1,  1,  1,  16, 32,
                                   16, 32, 32, 32, 256}; // none, RLE, ZIPS, ZIP, PIZ, …, DWAB
    return compression < std::size(rows) ? rows[compression] : 256;
}

// Empty when it is no rectangle, or so large that its size is no number.
QRect windowAt(const FileBytes& bytes, std::uint64_t at) {
    qint64 ends[4]{};
    for (std::uint64_t k = 0; k < 4; ++k)
        ends[k] = bytes.number<std::int32_t>(at + 4 * k).value_or(0);
    constexpr qint64 farthest = 1 << 30;
    if (std::ranges::any_of(ends, [](qint64 end) { return std::abs(end) > farthest; })) return {};
    if (ends[0] > ends[2] || ends[1] > ends[3]) return {};
    return {QPoint(int(ends[0]), int(ends[1])), QPoint(int(ends[2]), int(ends[3]))};
}

std::uint64_t channelsAt(const FileBytes& bytes, std::uint64_t at) {
    std::uint64_t count = 0;
    for (auto name = bytes.name(at); name && !name->isEmpty(); name = bytes.name(at)) {
        ++count;
        at += std::uint64_t(name->size()) + 1 + 16;
    }
    return count;
}

void take(const FileBytes& bytes, QByteArrayView name, std::uint64_t at, Header& header) {
    if (name == QByteArrayView("dataWindow")) header.pixels = windowAt(bytes, at);
    if (name == QByteArrayView("displayWindow")) header.seen = windowAt(bytes, at);
    if (name == QByteArrayView("channels")) header.channels = channelsAt(bytes, at);
    if (name == QByteArrayView("compression"))
        header.rowsTogether = rowsTogether(bytes.number<std::uint8_t>(at).value_or(255));
    if (name == QByteArrayView("tiles")) {
        header.tileWidth = bytes.number<std::uint32_t>(at).value_or(0);
        header.tileHeight = bytes.number<std::uint32_t>(at + 4).value_or(0);
    }
}

// The header of the first part; nullopt when it is damaged.
std::optional<Header> headerOf(const QByteArray& file) {
    const FileBytes bytes(file);
    Header header;
    for (std::uint64_t at = 8;;) {
        const auto name = bytes.name(at);
        if (!name) return std::nullopt;
        if (name->isEmpty()) break;
        const std::uint64_t atType = at + std::uint64_t(name->size()) + 1;
        const auto type = bytes.name(atType);
        if (!type) return std::nullopt;
        const std::uint64_t atSize = atType + std::uint64_t(type->size()) + 1;
        const auto size = bytes.number<std::uint32_t>(atSize);
        if (!size || !bytes.piece(atSize + 4, *size)) return std::nullopt;
        take(bytes, *name, atSize + 4, header);
        at = atSize + 4 + *size;
    }
    return header.pixels.isEmpty() || header.seen.isEmpty() ? std::nullopt : std::optional(header);
}

bool isWithin(const QRect& window, qint64 maxPixels) {
    return qint64(window.width()) * window.height() <= maxPixels;
}

std::uint64_t blockOf(const Header& header) {
    constexpr std::uint64_t farthest = 1 << 30; // limit of windows against overflow
    const auto width = std::max(std::uint64_t(header.pixels.width()), std::min(header.tileWidth, farthest));
    const auto rows = std::max(std::min(header.rowsTogether, std::uint64_t(header.pixels.height())),
                               std::min(header.tileHeight, farthest));
    constexpr std::uint64_t number = sizeof(float);
    if (width * rows > maxBlock) return width * rows;
    return width * rows * number * std::max<std::uint64_t>(header.channels, 4);
}

// Bytes of all channels, also those that are not read.
std::uint64_t allOf(const Header& header) {
    constexpr std::uint64_t number = sizeof(float);
    return std::uint64_t(header.pixels.width()) * std::uint64_t(header.pixels.height()) * number *
           header.channels;
}

class Stream final : public Imf::IStream {
public:
    explicit Stream(const QByteArray& bytes) : IStream(""), m_bytes(bytes) {}

    bool read(char* to, int count) override {
        const auto size = std::uint64_t(m_bytes.size());
        if (count < 0 || m_at > size || std::uint64_t(count) > size - m_at)
            throw std::runtime_error("the file ends");
        std::memcpy(to, m_bytes.constData() + m_at, std::size_t(count));
        m_at += std::uint64_t(count);
        return m_at < size;
    }
    std::uint64_t tellg() override { return m_at; }
    void seekg(std::uint64_t at) override { m_at = at; }

private:
    const QByteArray& m_bytes;
    std::uint64_t m_at = 0;
};

QRgb straight(const Imf::Rgba& pixel) {
    const float alpha = std::isfinite(float(pixel.a)) ? std::clamp(float(pixel.a), 0.0F, 1.0F) : 1;
    if (!(alpha > 0)) return 0;
    const auto code = [alpha](float light) {
        return light > 0 ? int(attractor::encoded(std::min(1.0, double(light) / double(alpha)))) : 0;
    };
    return qRgba(code(pixel.r), code(pixel.g), code(pixel.b), int(alpha * 255 + 0.5F));
}

// Null of one that has neither colours nor luminance, such as a map of depths.
QImage imageOf(Stream& stream, const Header& header, const std::stop_token& stop) {
    constexpr int noThreads = 0; // no threads but the calling one
    Imf::RgbaInputFile file(stream, noThreads);
    QImage image;
    if (!(file.channels() & Imf::WRITE_RGB) && !(file.channels() & Imf::WRITE_Y)) return image;
    image = QImage(header.seen.size(), QImage::Format_ARGB32);
    if (image.isNull()) throw std::bad_alloc();
    image.fill(Qt::transparent);
    const QRect shared = header.pixels & header.seen;
    const std::size_t width = std::size_t(header.pixels.width());
    std::vector<Imf::Rgba> row(width);
    constexpr std::size_t sameRow = 0;
    // Origin of the pixels, from which the library counts.
    file.setFrameBuffer(row.data() - header.pixels.left(), 1, sameRow);
    for (int y = shared.top(); y <= shared.bottom(); ++y) {
        if (stop.stop_requested()) throw std::runtime_error("stopped");
        file.readPixels(y);
        auto* to = reinterpret_cast<QRgb*>(image.scanLine(y - header.seen.top()));
        for (int x = shared.left(); x <= shared.right(); ++x)
            to[x - header.seen.left()] = straight(row[std::size_t(x - header.pixels.left())]);
    }
    return image;
}

} // namespace

RasterPicture readExr(const QByteArray& bytes, qint64 maxPixels, const std::stop_token& stop) {
    using enum RasterPicture::Flaw;
    const auto header = headerOf(bytes);
    if (!header) return {};
    const QSize size = header->seen.size();
    if (!isWithin(header->seen, maxPixels) || !isWithin(header->pixels, maxPixels))
        return {{}, isWithin(header->seen, maxPixels) ? header->pixels.size() : size, TooLarge};
    if (blockOf(*header) > maxBlock || allOf(*header) > maxAll) return {{}, size, Unreadable};
    try {
        Stream stream(bytes);
        return {imageOf(stream, *header, stop), size, Unreadable};
    } catch (const std::bad_alloc&) { // also thrown by the library for malformed headers
        return {{}, size, Unreadable};
    } catch (const std::exception&) {
        return {{}, size, Damaged};
    }
}

} // namespace io
