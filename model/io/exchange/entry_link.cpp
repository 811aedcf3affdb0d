// SPDX-License-Identifier: MIT
#include "io/exchange/entry_link.h"

#include "document/text/text.h"
#include "io/fractint/entry_writer.h"

#include <algorithm>
#include <new>
#include <optional>

#include <zlib.h>

namespace io {

namespace {

constexpr QByteArrayView scheme = "barycage:";
constexpr int withoutHeader = -15; // window bits of zlib; negative for a raw stream
// Characters: more than any text within the limit needs, even where it cannot be compressed.
constexpr qsizetype maxPacked = 2 * maxLinkedText;
constexpr qsizetype longestAddress = 4096;

Bytef* bytesOf(QByteArray& bytes) {
    return reinterpret_cast<Bytef*>(bytes.data());
}

QByteArray deflated(QByteArray text) {
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, withoutHeader, MAX_MEM_LEVEL,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    QByteArray packed(qsizetype(deflateBound(&stream, uLong(text.size()))), Qt::Uninitialized);
    stream.next_in = bytesOf(text);
    stream.avail_in = uInt(text.size());
    stream.next_out = bytesOf(packed);
    stream.avail_out = uInt(packed.size());
    deflate(&stream, Z_FINISH);
    packed.truncate(packed.size() - qsizetype(stream.avail_out));
    deflateEnd(&stream);
    return packed;
}

enum class Unpacked { Whole, CutOff, Damaged, TooLarge };

// Unpacks no more than the limit and one byte.
Unpacked unpack(QByteArray packed, QByteArray& text) {
    z_stream stream{};
    if (inflateInit2(&stream, withoutHeader) != Z_OK) throw std::bad_alloc();
    text = QByteArray(maxLinkedText + 1, Qt::Uninitialized);
    stream.next_in = bytesOf(packed);
    stream.avail_in = uInt(packed.size());
    stream.next_out = bytesOf(text);
    stream.avail_out = uInt(text.size());
    const int result = inflate(&stream, Z_FINISH);
    text.truncate(text.size() - qsizetype(stream.avail_out));
    const bool isLarge = stream.avail_out == 0;
    const bool isRead = stream.avail_in == 0;
    inflateEnd(&stream);
    if (isLarge) return Unpacked::TooLarge;
    if (result == Z_STREAM_END) return isRead ? Unpacked::Whole : Unpacked::Damaged;
    return result == Z_BUF_ERROR && isRead ? Unpacked::CutOff : Unpacked::Damaged;
}

bool isOfBase64(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}
bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

// The text behind the mark. nullopt without one, and for text with blanks or braces, as entries have.
std::optional<QByteArrayView> dataOf(QByteArrayView text) {
    text = text.trimmed();
    if (text.startsWith(scheme)) {
        QByteArrayView data = text.sliced(scheme.size());
        if (data.startsWith('#')) data = data.sliced(1);
        const auto isOther = [](char c) { return c == ' ' || c == '\t' || c == '{'; };
        return data.isEmpty() || std::ranges::any_of(data, isOther) ? std::nullopt : std::optional(data);
    }
    const QByteArrayView head = text.first(std::min(text.size(), longestAddress));
    const qsizetype slashes = head.indexOf("://"), mark = head.indexOf('#');
    if (slashes <= 0 || mark < slashes) return std::nullopt;
    const auto isOfAddress = [](char c) {
        return static_cast<unsigned char>(c) > ' ' && c != '{' && c != '"';
    };
    const QByteArrayView data = text.sliced(mark + 1);
    const auto isOfData = [](char c) { return isOfBase64(c) || isLineEnd(c); };
    if (data.isEmpty() || !std::ranges::all_of(head.first(mark), isOfAddress) ||
        !std::ranges::all_of(data, isOfData))
        return std::nullopt;
    return data;
}

Failure tooLarge() {
    return Text::tr("The link holds more than 1 MB of text, which is the limit.");
}
Failure damaged() {
    return Text::tr("This link is damaged, or it holds no fractal.");
}

} // namespace

QString linkObstacle(const document::Fractal& fractal) {
    if (document::dimension(fractal) == 0) return Text::tr("This entry is not an iterated function system.");
    return {};
}

WrittenLink linkOf(const document::Fractal& fractal) {
    const QByteArray text = writeEntry(fractal);
    if (text.size() > maxLinkedText) return {{}, tooLarge()};
    return {scheme.toByteArray() +
                deflated(text).toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals),
            {}};
}

bool looksLikeLink(QByteArrayView text) {
    return dataOf(text).has_value();
}

EmbeddedSystem readLink(QByteArrayView link) {
    const auto data = dataOf(link);
    if (!data) return {{}, damaged()};
    if (data->size() > maxPacked) return {{}, tooLarge()};
    QByteArray characters = data->toByteArray();
    characters.removeIf(isLineEnd);
    if (!std::ranges::all_of(characters, isOfBase64)) return {{}, damaged()};
    QByteArray text;
    switch (unpack(QByteArray::fromBase64(characters, QByteArray::Base64UrlEncoding), text)) {
    case Unpacked::Whole:
        return {text, {}};
    case Unpacked::CutOff:
        return {{}, Text::tr("This link was cut off: its end is missing. Copy all of it.")};
    case Unpacked::TooLarge:
        return {{}, tooLarge()};
    case Unpacked::Damaged:
        break;
    }
    return {{}, damaged()};
}

} // namespace io
