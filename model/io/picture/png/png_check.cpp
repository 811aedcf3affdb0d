// SPDX-License-Identifier: MIT
#include "io/picture/png/png_check.h"

#include "document/disk/regular_file.h"
#include "document/text/text.h"
#include "io/file/native_path.h"

#include <QFile>
#include <QtEndian>

#include <zlib.h>

#include <algorithm>

namespace io {

namespace {

constexpr quint32 maxLength = 0x7fffffff; // bytes of a chunk
constexpr qint64 piece = 1 << 20;
constexpr qsizetype maxKeptText = 8 << 20;            // bytes of text that are kept
constexpr char palette = 1, colours = 2, opacity = 4; // bits of the colour type

struct Chunk {
    QByteArray type;
    QByteArray data; // contents of IHDR and tEXt; empty for other chunks
};

std::optional<quint32> readNumber(QIODevice& file) {
    const QByteArray bytes = file.read(4);
    return bytes.size() == 4 ? std::optional(qFromBigEndian<quint32>(bytes.constData())) : std::nullopt;
}

quint32 checksum(quint32 sum, const QByteArray& bytes) {
    return quint32(crc32(sum, reinterpret_cast<const Bytef*>(bytes.constData()), uInt(bytes.size())));
}

// nullopt unless it is all there and as it was written.
std::optional<Chunk> readChunk(QIODevice& file) {
    const auto length = readNumber(file);
    Chunk chunk{file.read(4), {}};
    if (!length || *length > maxLength || chunk.type.size() != 4) return std::nullopt;
    quint32 sum = checksum(0, chunk.type);
    for (qint64 left = *length; left > 0;) {
        const QByteArray bytes = file.read(std::min(left, piece));
        if (bytes.isEmpty()) return std::nullopt;
        sum = checksum(sum, bytes);
        left -= bytes.size();
        const bool isKept = chunk.type == "tEXt" || chunk.type == "IHDR";
        if (isKept && chunk.data.size() < maxKeptText) chunk.data += bytes;
    }
    return readNumber(file) == sum ? std::optional(chunk) : std::nullopt;
}

// False when it makes no sense.
bool takeHeader(const QByteArray& header, CheckedPng& found, char* kind) {
    constexpr qsizetype size = 13, heightAt = 4, depthAt = 8, coloursAt = 9;
    if (header.size() != size) return false;
    const auto side = [&](qsizetype at) { return qFromBigEndian<quint32>(header.constData() + at); };
    if (side(0) == 0 || side(0) > maxLength || side(heightAt) == 0 || side(heightAt) > maxLength)
        return false;
    found.size = {int(side(0)), int(side(heightAt))};
    found.bitsPerChannel = header[depthAt];
    *kind = header[coloursAt];
    found.hasOpacity = (*kind & opacity) != 0;
    return true;
}

CheckedPng damaged(const QString& sentence) {
    CheckedPng found;
    found.damage = sentence;
    return found;
}

CheckedPng checked(QFile& file) {
    if (file.read(8) != QByteArray("\x89PNG\r\n\x1a\n", 8))
        return damaged(Text::tr("The file is not a PNG picture."));
    const auto incomplete = [] {
        return damaged(Text::tr("The picture is damaged or incomplete. Draw it again."));
    };
    CheckedPng found;
    qsizetype remembered = 0;
    bool hasPixels = false;
    char kind = 0;
    for (bool isFirst = true;; isFirst = false) {
        const auto chunk = readChunk(file);
        if (!chunk || isFirst != (chunk->type == "IHDR")) return incomplete();
        if (isFirst && !takeHeader(chunk->data, found, &kind)) return incomplete();
        const bool isOneColour =
            (kind & palette) == 0 && ((kind & colours) != 0 || found.bitsPerChannel == 16);
        if (chunk->type == "tRNS" && isOneColour) found.hasOpacity = true;
        if (chunk->type == "IEND") break;
        hasPixels = hasPixels || chunk->type == "IDAT";
        remembered += chunk->data.size();
        const qsizetype end = chunk->data.indexOf('\0');
        if (end > 0 && chunk->data.startsWith("barycage:") && remembered <= maxKeptText)
            found.texts[chunk->data.first(end)] = chunk->data.sliced(end + 1);
    }
    return hasPixels && file.atEnd() ? found : incomplete();
}

} // namespace

CheckedPng checkedPng(const QString& path) {
    QFile file;
    const document::Opened opened = document::openRegular(file, nativeName(path));
    CheckedPng found = opened.isOpen() ? checked(file) : damaged(Text::tr("The picture cannot be opened."));
    const bool isReadingFailed = opened.isOpen() && file.error() != QFileDevice::NoError;
    if (isReadingFailed) found = damaged(Text::tr("“%1” cannot be read: %2.").arg(path, file.errorString()));
    found.isUnreadable = isReadingFailed || opened.state == document::Opened::State::Closed;
    return found;
}

QSize pngSize(const QByteArray& bytes) {
    constexpr qsizetype headerAt = 16, headerSize = 13;
    CheckedPng found;
    char kind = 0;
    if (!bytes.startsWith("\x89PNG\r\n\x1a\n")) return {};
    takeHeader(bytes.mid(headerAt, headerSize), found, &kind);
    return found.size;
}

std::optional<QByteArray> textOfCompletePng(const QString& path, const QByteArray& keyword) {
    const CheckedPng found = checkedPng(path);
    const auto text = found.texts.find(keyword);
    return text == found.texts.end() ? std::nullopt : std::optional(text->second);
}

} // namespace io
