// SPDX-License-Identifier: MIT
#include "io/video/video_system.h"

#include "io/picture/vector/svg_system.h"

#include <QByteArrayView>
#include <QCoreApplication>
#include <QLatin1String>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <optional>

namespace io {

namespace {

constexpr qsizetype maxText = 8 * 1024 * 1024;
constexpr const char* mark = "; Barycage\n"; // mark before the text

EmbeddedSystem refusal(const char* sentence) {
    return {{}, QCoreApplication::translate("VideoSystem", sentence)};
}

// MP4: boxes within boxes, ISO/IEC 14496-12.

struct Box {
    QByteArrayView type;
    QByteArrayView contents;
};

// The box at the beginning of `bytes`, which is taken from them; nullopt where there is none.
std::optional<Box> takeBox(QByteArrayView& bytes) {
    constexpr qsizetype head = 8, longHead = 16;
    if (bytes.size() < head) return std::nullopt;
    qsizetype begin = head;
    quint64 size = qFromBigEndian<quint32>(bytes.data());
    if (size == 1) {
        if (bytes.size() < longHead) return std::nullopt;
        size = qFromBigEndian<quint64>(bytes.data() + head);
        begin = longHead;
    }
    if (size == 0) size = quint64(bytes.size());
    if (size < quint64(begin) || size > quint64(bytes.size())) return std::nullopt;
    const Box box{bytes.sliced(4, 4), bytes.sliced(begin, qsizetype(size) - begin)};
    bytes = bytes.sliced(qsizetype(size));
    return box;
}

QByteArrayView contentsOf(QByteArrayView boxes, QByteArrayView type) {
    while (const auto box = takeBox(boxes))
        if (box->type == type) return box->contents;
    return {};
}

QByteArrayView commentOfMp4(QByteArrayView file) {
    constexpr qsizetype version = 4, typeAndLanguage = 8;
    QByteArrayView meta = contentsOf(contentsOf(contentsOf(file, "moov"), "udta"), "meta");
    if (meta.size() < version) return {};
    meta = meta.sliced(version);
    const QByteArrayView data = contentsOf(contentsOf(contentsOf(meta, "ilst"), "\xa9"
                                                                                "cmt"),
                                           "data");
    return data.size() < typeAndLanguage ? QByteArrayView() : data.sliced(typeAndLanguage);
}

// WebM and MKV: elements within elements, RFC 8794 and RFC 9559.

// A number of 1 to 8 bytes, whose first one says how many; nullopt where there is none.
std::optional<quint64> takeNumber(QByteArrayView& bytes, bool keepsLength) {
    if (bytes.isEmpty() || bytes[0] == 0) return std::nullopt;
    const auto first = uchar(bytes[0]);
    qsizetype length = 1;
    while ((first & (0x100 >> length)) == 0)
        ++length;
    if (bytes.size() < length) return std::nullopt;
    quint64 number = keepsLength ? first : first & ((0x100 >> length) - 1);
    bool isUnknown = !keepsLength && number == quint64((0x100 >> length) - 1);
    for (qsizetype i = 1; i < length; ++i) {
        number = number << 8 | uchar(bytes[i]);
        isUnknown = isUnknown && uchar(bytes[i]) == 0xff;
    }
    bytes = bytes.sliced(length);
    return isUnknown ? quint64(bytes.size()) : number; // unknown size: to the end
}

struct Element {
    quint64 id = 0;
    QByteArrayView contents;
};

std::optional<Element> takeElement(QByteArrayView& bytes) {
    const auto id = takeNumber(bytes, true);
    const auto size = id ? takeNumber(bytes, false) : std::nullopt;
    if (!size || *size > quint64(bytes.size())) return std::nullopt;
    const Element element{*id, bytes.first(qsizetype(*size))};
    bytes = bytes.sliced(qsizetype(*size));
    return element;
}

QByteArrayView contentsOf(QByteArrayView elements, quint64 id) {
    while (const auto element = takeElement(elements))
        if (element->id == id) return element->contents;
    return {};
}

QByteArrayView commentIn(QByteArrayView tags) {
    constexpr quint64 tag = 0x7373, simpleTag = 0x67c8, tagName = 0x45a3, tagString = 0x4487;
    while (const auto one = takeElement(tags)) {
        if (one->id != tag) continue;
        QByteArrayView simple = one->contents;
        while (const auto pair = takeElement(simple))
            if (pair->id == simpleTag && contentsOf(pair->contents, tagName) == QByteArrayView("COMMENT"))
                return contentsOf(pair->contents, tagString);
    }
    return {};
}

QByteArrayView commentOfMatroska(QByteArrayView file) {
    constexpr quint64 segmentId = 0x18538067, tagsId = 0x1254c367;
    QByteArrayView segment = contentsOf(file, segmentId);
    while (const auto element = takeElement(segment))
        if (element->id == tagsId)
            if (const QByteArrayView comment = commentIn(element->contents); comment.startsWith(mark))
                return comment;
    return {};
}

// GIF: blocks of up to 255 bytes, GIF89a.

// The blocks of one piece of data, the empty one at its end included; nullopt where it does not end.
std::optional<QByteArray> takeBlocks(QByteArrayView& bytes, bool isKept) {
    QByteArray data;
    while (!bytes.isEmpty()) {
        const qsizetype length = uchar(bytes[0]);
        if (bytes.size() <= length) return std::nullopt;
        if (isKept && data.size() <= maxText) data += bytes.sliced(1, length);
        bytes = bytes.sliced(1 + length);
        if (length == 0) return data;
    }
    return std::nullopt;
}

qsizetype coloursOf(uchar flags) {
    return (flags & 0x80) != 0 ? qsizetype(3) << ((flags & 7) + 1) : 0;
}

// Passes over an image and its colours; false where it does not end.
bool skipImage(QByteArrayView& bytes) {
    constexpr qsizetype head = 10;
    if (bytes.size() < head) return false;
    const qsizetype data = head + coloursOf(uchar(bytes[head - 1])) + 1;
    if (bytes.size() < data) return false;
    bytes = bytes.sliced(data);
    return takeBlocks(bytes, false).has_value();
}

QByteArray commentOfGif(QByteArrayView bytes) {
    constexpr qsizetype head = 13;
    if (bytes.size() < head) return {};
    const qsizetype begin = head + coloursOf(uchar(bytes[10]));
    if (bytes.size() < begin) return {};
    bytes = bytes.sliced(begin);
    while (bytes.size() >= 2 && bytes[0] != ';') {
        if (bytes[0] == ',') {
            if (!skipImage(bytes)) return {};
            continue;
        }
        const bool isComment = uchar(bytes[1]) == 0xfe;
        if (bytes[0] != '!') return {};
        bytes = bytes.sliced(2);
        const auto data = takeBlocks(bytes, isComment);
        if (!data) return {};
        if (isComment && data->startsWith(mark)) return *data;
    }
    return {};
}

// WebP: chunks of RIFF. The XMP packet holds what an SVG picture does.
EmbeddedSystem systemOfWebP(QByteArrayView bytes) {
    constexpr qsizetype riff = 12, head = 8;
    bytes = bytes.sliced(riff);
    while (bytes.size() >= head) {
        const quint32 size = qFromLittleEndian<quint32>(bytes.data() + 4);
        if (size > quint32(bytes.size() - head)) break;
        if (bytes.startsWith("XMP ")) return readSvgSystem(bytes.sliced(head, qsizetype(size)).toByteArray());
        bytes = bytes.sliced(std::min(bytes.size(), head + qsizetype(size) + qsizetype(size % 2)));
    }
    return {};
}

// A kind of file, by its first bytes, and the text that is embedded in it.
struct Container {
    const char* name;
    bool (*begins)(const QByteArray& bytes);
    QByteArray (*text)(const QByteArray& bytes);
};

bool beginsMatroska(const QByteArray& bytes) {
    return bytes.startsWith("\x1a\x45\xdf\xa3");
}
QByteArray textOfMatroska(const QByteArray& bytes) {
    return commentOfMatroska(bytes).toByteArray();
}

constexpr std::array containers{
    Container{"mp4", [](const QByteArray& bytes) { return bytes.mid(4, 4) == "ftyp" && bytes.size() >= 16; },
              [](const QByteArray& bytes) { return commentOfMp4(bytes).toByteArray(); }},
    Container{
        "gif",
        [](const QByteArray& bytes) { return bytes.startsWith("GIF87a") || bytes.startsWith("GIF89a"); },
        [](const QByteArray& bytes) { return commentOfGif(bytes); }},
    Container{"webp",
              [](const QByteArray& bytes) {
                  constexpr int isAnimated = 2; // bit of the flags
                  return bytes.startsWith("RIFF") && bytes.mid(8, 8) == "WEBPVP8X" && bytes.size() > 20 &&
                         bytes[20] & isAnimated;
              },
              [](const QByteArray& bytes) { return systemOfWebP(bytes).text; }},
    Container{"webm",
              [](const QByteArray& bytes) {
                  constexpr qsizetype sample = 64; // bytes that identify a WebM file
                  return beginsMatroska(bytes) && bytes.left(sample).contains("webm");
              },
              textOfMatroska},
    Container{"mkv", beginsMatroska, textOfMatroska},
};

// Null for other files.
const Container* containerOf(const QByteArray& bytes) {
    const auto* found =
        std::ranges::find_if(containers, [&](const Container& each) { return each.begins(bytes); });
    return found == containers.end() ? nullptr : found;
}

} // namespace

QString looksLikeVideo(const QByteArray& bytes) {
    const Container* container = containerOf(bytes);
    return container ? QLatin1String(container->name) : QLatin1String();
}

EmbeddedSystem readVideoSystem(const QByteArray& bytes) {
    const Container* container = containerOf(bytes);
    if (!container) return refusal(QT_TRANSLATE_NOOP("VideoSystem", "The file is not a video."));
    QByteArray text = container->text(bytes);
    if (!text.startsWith(mark))
        return refusal(QT_TRANSLATE_NOOP(
            "VideoSystem", "The video contains no system: it was not written by Barycage, it is damaged, or "
                           "another program removed the text that holds it."));
    text.remove(0, qsizetype(qstrlen(mark)));
    if (text.size() > maxText)
        return refusal(QT_TRANSLATE_NOOP("VideoSystem", "The system in the video is larger than 8 MB."));
    return {text, {}};
}

} // namespace io
