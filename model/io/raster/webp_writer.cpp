// SPDX-License-Identifier: MIT
#include "io/raster/webp_writer.h"

#include "document/text/text.h"
#include "io/raster/pixel_rows.h"
#include "io/raster/raster_system.h"

#include <QXmlStreamWriter>

#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#include <new>

namespace io {

namespace {

// Hands what the encoder gives to a string of bytes. Nothing is thrown through the encoder, which fails
// instead.
int onBytes(const std::uint8_t* data, std::size_t size, const WebPPicture* picture) {
    try {
        static_cast<QByteArray*>(picture->custom_ptr)
            ->append(reinterpret_cast<const char*>(data), qsizetype(size));
        return 1;
    } catch (const std::bad_alloc&) {
        return 0;
    }
}

WebPConfig configOf(const PictureFormat& format) {
    WebPConfig config;
    WebPConfigInit(&config);
    if (format.quality) {
        config.quality = float(*format.quality);
        config.use_sharp_yuv = 1; // keeps the colours of thin lines
        return config;
    }
    constexpr int effort = 4; // 0 … 9: more takes much longer and saves a few per cent
    WebPConfigLosslessPreset(&config, effort);
    return config;
}

// Empty when the encoder refuses.
QByteArray encoded(const std::vector<std::uint8_t>& bytes, const PictureFormat& format) {
    WebPPicture picture;
    if (!WebPPictureInit(&picture)) return {};
    const std::unique_ptr<WebPPicture, decltype(&WebPPictureFree)> owner(&picture, WebPPictureFree);
    const WebPConfig config = configOf(format);
    QByteArray result;
    picture.use_argb = config.lossless;
    picture.width = format.width;
    picture.height = format.height;
    picture.writer = onBytes;
    picture.custom_ptr = &result;
    const bool isOpaque = format.pixels == PictureFormat::Pixels::Opaque;
    const int stride = format.width * (isOpaque ? 3 : 4);
    const bool isTaken = isOpaque ? WebPPictureImportRGB(&picture, bytes.data(), stride)
                                  : WebPPictureImportRGBA(&picture, bytes.data(), stride);
    return isTaken && WebPEncode(&config, &picture) ? result : QByteArray();
}

WebPData dataOf(const QByteArray& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())};
}

// The picture with the packet beside it; empty when that fails.
QByteArray withPacket(const QByteArray& picture, const QByteArray& packet) {
    const std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)> mux(WebPMuxNew(), WebPMuxDelete);
    const WebPData image = dataOf(picture), text = dataOf(packet);
    WebPData whole{};
    if (!mux || WebPMuxSetImage(mux.get(), &image, 0) != WEBP_MUX_OK ||
        WebPMuxSetChunk(mux.get(), "XMP ", &text, 0) != WEBP_MUX_OK ||
        WebPMuxAssemble(mux.get(), &whole) != WEBP_MUX_OK)
        return {};
    const std::unique_ptr<WebPData, decltype(&WebPDataClear)> owner(&whole, WebPDataClear);
    return {reinterpret_cast<const char*>(whole.bytes), qsizetype(whole.size)};
}

} // namespace

QByteArray xmpPacket(const QByteArray& system) {
    const QString rdf = QStringLiteral("http://www.w3.org/1999/02/22-rdf-syntax-ns#");
    const QString ours = xmpSystemNamespace();
    QByteArray packet;
    QXmlStreamWriter xml(&packet);
    xml.writeNamespace(QStringLiteral("adobe:ns:meta/"), QStringLiteral("x"));
    xml.writeStartElement(QStringLiteral("adobe:ns:meta/"), QStringLiteral("xmpmeta"));
    xml.writeNamespace(rdf, QStringLiteral("rdf"));
    xml.writeStartElement(rdf, QStringLiteral("RDF"));
    xml.writeNamespace(ours, QStringLiteral("barycage"));
    xml.writeStartElement(rdf, QStringLiteral("Description"));
    xml.writeAttribute(rdf, QStringLiteral("about"), QString());
    xml.writeTextElement(ours, QStringLiteral("system"), QString::fromUtf8(system));
    xml.writeEndDocument();
    return packet;
}

WebPWriter::WebPWriter(QIODevice& device, PictureFormat format)
    : m_device(device), m_format(std::move(format)) {
    const std::size_t channels = m_format.pixels == PictureFormat::Pixels::Opaque ? 3 : 4;
    m_bytes.reserve(std::size_t(m_format.width) * std::size_t(m_format.height) * channels);
}

void WebPWriter::fail(const QString& reason) {
    if (!m_failure) m_failure = Text::tr("The picture cannot be written: %1").arg(reason);
}

Failure WebPWriter::writeRows(std::span<const std::uint32_t> pixels) {
    const auto width = std::size_t(m_format.width);
    const bool withAlpha = m_format.pixels != PictureFormat::Pixels::Opaque;
    for (std::size_t at = 0; at + width <= pixels.size() && !m_failure; at += width) {
        const std::size_t end = m_bytes.size();
        m_bytes.resize(end + width * (withAlpha ? 4 : 3));
        putBytes(pixels.data() + at, int(width), withAlpha, m_bytes.data() + end);
    }
    return m_failure;
}

Failure WebPWriter::writeRows(std::span<const attractor::Rgba16>) {
    Q_ASSERT(false);
    return m_failure;
}

Failure WebPWriter::finish() {
    if (m_failure) return m_failure;
    QByteArray picture = encoded(m_bytes, m_format);
    if (!picture.isEmpty() && !m_format.systemText.isEmpty())
        picture = withPacket(picture, xmpPacket(m_format.systemText));
    if (picture.isEmpty())
        fail(Text::tr("the WebP encoder does not have enough memory."));
    else if (!m_device.write(picture.constData(), picture.size()))
        fail(m_device.errorString());
    m_device.rethrow();
    return m_failure;
}

} // namespace io
