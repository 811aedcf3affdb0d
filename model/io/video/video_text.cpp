// SPDX-License-Identifier: MIT
#include "io/video/video_text.h"

#include "io/picture/png/png_system.h"
#include "io/picture/vector/svg_system.h"

#include <QtEndian>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace io {

namespace {

QByteArray read(QIODevice& device, qint64 at, qint64 size) {
    return device.seek(at) ? device.read(size) : QByteArray();
}

bool write(QIODevice& device, qint64 at, const QByteArray& bytes) {
    return device.seek(at) && device.write(bytes) == bytes.size();
}

// Inserts bytes; those behind are moved, the last first.
bool insert(QIODevice& device, qint64 size, qint64 at, const QByteArray& bytes) {
    constexpr qint64 piece = 1 << 20;
    for (qint64 end = size; end > at;) {
        const qint64 begin = std::max(at, end - piece);
        const QByteArray moved = read(device, begin, end - begin);
        if (moved.size() != end - begin || !write(device, begin + bytes.size(), moved)) return false;
        end = begin;
    }
    return write(device, at, bytes);
}

QByteArray bigEndian(quint32 number) {
    QByteArray bytes(4, '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

QByteArray littleEndian(quint32 number) {
    QByteArray bytes(4, '\0');
    qToLittleEndian(number, bytes.data());
    return bytes;
}

// Behind all pictures: FFmpeg looks for several of them at the beginning alone.
bool addToApng(QIODevice& device, qint64 size, const QByteArray& text) {
    constexpr qint64 lastChunk = 12;
    if (!looksLikePng(read(device, 0, 8)) || read(device, size - 8, 4) != "IEND") return false;
    const QByteArray data = "iTXt" + QByteArray(pngSystemKeyword) + QByteArray(5, '\0') + text;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(data.constData()), uInt(data.size()));
    return insert(device, size, size - lastChunk,
                  bigEndian(quint32(data.size() - 4)) + data + bigEndian(quint32(sum)));
}

// Adds the text before the last byte.
bool addToGif(QIODevice& device, qint64 size, const QByteArray& text) {
    constexpr qsizetype block = 255;
    if (read(device, size - 1, 1) != ";") return false;
    QByteArray comment("\x21\xfe", 2);
    for (qsizetype at = 0; at < text.size(); at += block) {
        const QByteArray piece = text.mid(at, block);
        comment += char(uchar(piece.size())) + piece;
    }
    return write(device, size - 1, comment + '\0' + ';');
}

// Behind all else; the file and its first chunk say that it is there.
bool addToWebP(QIODevice& device, qint64 size, const QByteArray& text) {
    constexpr char hasXmp = 0x04;
    constexpr qint64 flagsAt = 20;
    const QByteArray head = read(device, 0, flagsAt + 1);
    if (head.size() <= flagsAt || head.mid(8, 8) != "WEBPVP8X" || size % 2 != 0) return false;
    QByteArray packet = "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
                        "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description "
                        "rdf:about=\"\"><system xmlns=\"" +
                        svgSystemNamespace().toUtf8() + "\">" +
                        QString::fromUtf8(text).toHtmlEscaped().toUtf8() +
                        "</system></rdf:Description></rdf:RDF></x:xmpmeta>";
    const qsizetype length = packet.size();
    if (length % 2 != 0) packet += '\0';
    return write(device, size, "XMP " + littleEndian(quint32(length)) + packet) &&
           write(device, flagsAt, QByteArray(1, char(head[flagsAt] | hasXmp))) &&
           write(device, 4, littleEndian(quint32(size + 8 + packet.size() - 8)));
}

QByteArray chunk(const char* name, const QByteArray& data) {
    return name + littleEndian(quint32(data.size())) + data;
}

QByteArray threeBytes(quint32 number) {
    return littleEndian(number).first(3);
}

using Adder = bool (*)(QIODevice& device, qint64 size, const QByteArray& text);

// Null where the encoder writes the text itself.
Adder adderOf(VideoFormat format) {
    static constexpr std::array adders{std::pair{VideoFormat::Gif, &addToGif},
                                       std::pair{VideoFormat::WebP, &addToWebP},
                                       std::pair{VideoFormat::Apng, &addToApng}};
    const auto* found = std::ranges::find(adders, format, &std::pair<VideoFormat, Adder>::first);
    return found == adders.end() ? nullptr : found->second;
}

} // namespace

std::optional<qint64> animatedWebP(QIODevice& device, qint64 size, const VideoSettings& settings,
                                   std::int64_t pictures) {
    constexpr qint64 riff = 12;
    constexpr std::int64_t longest = (1 << 24) - 1; // milliseconds
    constexpr char moves = 0x02, hasAlpha = 0x10, isNotBlended = 0x02;
    const QByteArray head = read(device, 0, riff + 8);
    if (head.mid(8).startsWith("WEBPVP8X")) return size;
    if (!head.mid(8).startsWith("WEBPVP8L") || size % 2 != 0) return std::nullopt;
    const QByteArray sides =
        threeBytes(quint32(settings.width - 1)) + threeBytes(quint32(settings.height - 1));
    const std::int64_t lasts =
        std::min(longest, pictures * 1000 * settings.rate.seconds / settings.rate.frames);
    const char flags = settings.isTransparent ? char(moves | hasAlpha) : moves;
    const QByteArray frame =
        QByteArray(6, '\0') + sides + threeBytes(quint32(lasts)) + QByteArray(1, isNotBlended);
    QByteArray start = chunk("VP8X", flags + QByteArray(3, '\0') + sides) +
                       chunk("ANIM", QByteArray(4, '\0') + char(settings.repeats ? 0 : 1) + '\0') + "ANMF" +
                       littleEndian(quint32(frame.size() + size - riff)) + frame;
    const qint64 whole = size + start.size();
    const bool isMoved =
        insert(device, size, riff, start) && write(device, 4, littleEndian(quint32(whole - 8)));
    return isMoved ? std::optional(whole) : std::nullopt;
}

bool hasTextAdded(VideoFormat format) {
    return adderOf(format) != nullptr;
}

bool addVideoText(QIODevice& device, qint64 size, VideoFormat format, const QByteArray& text) {
    const auto add = adderOf(format);
    return add != nullptr && add(device, size, text);
}

} // namespace io
