// SPDX-License-Identifier: MIT
#include "io/picture/png_check.h"

#include <QCoreApplication>
#include <QFile>
#include <QtEndian>

#include <zlib.h>

#include <algorithm>

namespace io {

namespace {

constexpr quint32 maxLength = 0x7fffffff; // of a chunk
constexpr qint64 piece = 1 << 20;
constexpr qsizetype maxText = 8 << 20; // what is remembered of a chunk

struct Chunk {
    QByteArray type;
    QByteArray data; // of tEXt; of others nothing
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
        if (chunk.type == "tEXt" && chunk.data.size() < maxText) chunk.data += bytes;
    }
    return readNumber(file) == sum ? std::optional(chunk) : std::nullopt;
}

enum class State { NotOpen, NotPng, Damaged, Complete };

struct Checked {
    State state = State::Damaged;
    std::optional<QByteArray> text; // with the keyword
};

Checked check(const QString& path, const QByteArray& keyword) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {State::NotOpen, {}};
    if (file.read(8) != QByteArray("\x89PNG\r\n\x1a\n", 8)) return {State::NotPng, {}};
    Checked found;
    bool hasPixels = false;
    for (bool isFirst = true;; isFirst = false) {
        const auto chunk = readChunk(file);
        if (!chunk || isFirst != (chunk->type == "IHDR")) return {};
        if (chunk->type == "IEND") break;
        hasPixels = hasPixels || chunk->type == "IDAT";
        if (chunk->type == "tEXt" && chunk->data.startsWith(keyword + '\0'))
            found.text = chunk->data.sliced(keyword.size() + 1);
    }
    if (hasPixels && file.atEnd()) found.state = State::Complete;
    return found;
}

} // namespace

std::optional<QByteArray> textOfCompletePng(const QString& path, const QByteArray& keyword) {
    const Checked found = check(path, keyword);
    return found.state == State::Complete ? found.text : std::nullopt;
}

std::optional<QString> pngDamage(const QString& path) {
    switch (check(path, {}).state) {
    case State::NotOpen:
        return QCoreApplication::translate("PngSystem", "The picture cannot be opened.");
    case State::NotPng:
        return QCoreApplication::translate("PngSystem", "The file is not a PNG picture.");
    case State::Damaged:
        return QCoreApplication::translate("PngSystem",
                                           "The picture is damaged or incomplete. Draw it again.");
    case State::Complete:
        break;
    }
    return std::nullopt;
}

} // namespace io
