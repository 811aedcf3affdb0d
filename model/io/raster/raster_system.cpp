// SPDX-License-Identifier: MIT
#include "io/raster/raster_system.h"

#include "document/text/text.h"
#include "io/raster/file_bytes.h"
#include "io/text/xml_text.h"

#include <QXmlStreamReader>

#include <cstdint>
#include <cstring>
#include <optional>

namespace io {

namespace {

constexpr qsizetype maxText = 8 * 1024 * 1024;

// Text found in a picture: nullopt for one that is damaged before the text.
using EmbeddedText = std::optional<QByteArray>;

// The comments that begin with the mark, up to the pixels.
EmbeddedText jpegText(const QByteArray& picture) {
    constexpr std::uint8_t beginOfPixels = 0xda, endOfPicture = 0xd9, comment = 0xfe;
    const FileBytes bytes(picture, true);
    QByteArray text;
    for (std::uint64_t at = 2;;) {
        if (bytes.number<std::uint8_t>(at) != 0xff) return std::nullopt;
        const auto marker = bytes.number<std::uint8_t>(at + 1);
        if (marker == 0xff) { // fill bytes
            ++at;
            continue;
        }
        if (marker == beginOfPixels || marker == endOfPicture) return text;
        const auto size = bytes.number<std::uint16_t>(at + 2);
        if (!size || *size < 2) return std::nullopt;
        const auto data = bytes.piece(at + 4, *size - 2U);
        if (!data) return std::nullopt;
        if (marker == comment && data->startsWith(systemMark) && text.size() <= maxText)
            text += data->sliced(qsizetype(std::strlen(systemMark)));
        at += 2U + *size;
    }
}

EmbeddedText systemOfXmp(QByteArrayView packet) {
    const XmlText xmp = xmlText(packet.toByteArray());
    if (xmp.failure) return std::nullopt;
    QXmlStreamReader xml(xmp.text);
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isDTD()) return std::nullopt;
        if (xml.isStartElement() && xml.name() == u"system" && xml.namespaceUri() == xmpSystemNamespace())
            return xml.readElementText(QXmlStreamReader::SkipChildElements).toUtf8();
    }
    return xml.hasError() ? EmbeddedText() : QByteArray();
}

EmbeddedText webpText(const QByteArray& picture) {
    const FileBytes bytes(picture);
    for (std::uint64_t at = 12; at < std::uint64_t(picture.size());) {
        const auto kind = bytes.piece(at, 4);
        const auto size = bytes.number<std::uint32_t>(at + 4);
        const auto data = size ? bytes.piece(at + 8, *size) : std::nullopt;
        if (!data) return std::nullopt;
        if (*kind == QByteArrayView("XMP ")) {
            if (*size > 2 * maxText) return std::nullopt; // allows for escapes such as &lt;
            return systemOfXmp(*data);
        }
        at += 8U + std::uint64_t(*size) + (*size & 1U);
    }
    return QByteArray();
}

// ImageDescription of the first picture. `Offset` is what the file counts in: 32 bits, or 64 of a BigTIFF.
template <class Offset, class Count>
EmbeddedText tiffText(const FileBytes& bytes, std::uint64_t placeOfDirectory) {
    constexpr std::uint16_t description = 270, ascii = 2;
    constexpr std::uint64_t entrySize = 4 + 2 * sizeof(Offset);
    const auto directory = bytes.number<Offset>(placeOfDirectory);
    const auto count = directory ? bytes.number<Count>(*directory) : std::nullopt;
    if (!count) return std::nullopt;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const std::uint64_t at = *directory + sizeof(Count) + i * entrySize;
        const auto tag = bytes.number<std::uint16_t>(at);
        const auto type = bytes.number<std::uint16_t>(at + 2);
        const auto size = bytes.number<Offset>(at + 4);
        if (!tag || !type || !size) return std::nullopt;
        if (tag != description || type != ascii) continue;
        const auto place = bytes.number<Offset>(at + 4 + sizeof(Offset));
        if (!place) return std::nullopt;
        const auto text = bytes.piece(*size <= sizeof(Offset) ? at + 4 + sizeof(Offset) : *place, *size);
        if (!text) return std::nullopt;
        if (!text->startsWith(systemMark)) return QByteArray();
        const QByteArrayView system = text->sliced(qsizetype(std::strlen(systemMark)));
        const qsizetype end = system.indexOf('\0');
        return (end < 0 ? system : system.first(end)).toByteArray();
    }
    return QByteArray();
}

EmbeddedText tiffText(const QByteArray& picture) {
    constexpr std::uint16_t big = 43;
    const FileBytes bytes(picture, picture.startsWith("MM"));
    return bytes.number<std::uint16_t>(2) == big ? tiffText<std::uint64_t, std::uint64_t>(bytes, 8)
                                                 : tiffText<std::uint32_t, std::uint16_t>(bytes, 4);
}

// The attributes of the first part.
EmbeddedText exrText(const QByteArray& picture) {
    const FileBytes bytes(picture);
    for (std::uint64_t at = 8;;) {
        const auto name = bytes.name(at);
        if (!name) return std::nullopt;
        if (name->isEmpty()) return QByteArray();
        const std::uint64_t atType = at + std::uint64_t(name->size()) + 1;
        const auto type = bytes.name(atType);
        if (!type) return std::nullopt;
        const std::uint64_t atSize = atType + std::uint64_t(type->size()) + 1;
        const auto size = bytes.number<std::uint32_t>(atSize);
        const auto data = size ? bytes.piece(atSize + 4, *size) : std::nullopt;
        if (!data) return std::nullopt;
        if (*name == QByteArrayView(exrSystemAttribute) && *type == QByteArrayView("string"))
            return data->toByteArray();
        at = atSize + 4 + *size;
    }
}

EmbeddedText textIn(const QByteArray& picture) {
    const QString format = rasterFormat(picture);
    if (format == u"jpeg") return jpegText(picture);
    if (format == u"webp") return webpText(picture);
    if (format == u"tiff") return tiffText(picture);
    return exrText(picture);
}

EmbeddedSystem refusal(const QString& sentence) {
    return {{}, sentence};
}

} // namespace

QString xmpSystemNamespace() {
    return QStringLiteral("urn:barycage:system:1");
}

QString rasterFormat(const QByteArray& bytes) {
    const QByteArray start = bytes.first(std::min<qsizetype>(bytes.size(), 12));
    if (start.startsWith("\xff\xd8\xff")) return QStringLiteral("jpeg");
    if (start.startsWith("RIFF") && start.endsWith("WEBP")) return QStringLiteral("webp");
    for (const QByteArrayView magic : {QByteArrayView("II*\0", 4), QByteArrayView("MM\0*", 4),
                                       QByteArrayView("II+\0", 4), QByteArrayView("MM\0+", 4)})
        if (start.startsWith(magic)) return QStringLiteral("tiff");
    if (start.startsWith("\x76\x2f\x31\x01")) return QStringLiteral("exr");
    return {};
}

EmbeddedSystem readRasterSystem(const QByteArray& bytes) {
    const EmbeddedText text = textIn(bytes);
    if (!text) return refusal(Text::tr("The picture is damaged, or its text cannot be read."));
    if (text->size() > maxText) return refusal(Text::tr("The system in the picture is larger than 8 MB."));
    if (text->isEmpty())
        return refusal(Text::tr("The picture contains no system: it was not written by Barycage, or another "
                                "program removed the text that holds it."));
    return {*text, {}};
}

} // namespace io
