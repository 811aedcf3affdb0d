// SPDX-License-Identifier: MIT
#include "io/picture/png/png_system.h"
#include "document/text/text.h"

#include <QtEndian>

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

namespace io {

namespace {

constexpr png_size_t maxText = 8 * 1024 * 1024;
// Bytes of all chunks; a text is held packed, unpacked and copied.
constexpr png_size_t maxMemory = 5 * maxText;
constexpr png_size_t sizeRoom = 32; // bytes before each block, for its size; keeps the block aligned

struct Source {
    const char* next;
    const char* end;
};

[[noreturn]] void onError(png_structp png, png_const_charp) {
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

// Memory in use: many chunks may each be within their limit.
struct Memory {
    png_size_t used = 0;
    bool isExceeded = false;
};

// libpng asks for as much as a chunk says it is long, before it looks whether there is so much.
png_voidp onAllocate(png_structp png, png_alloc_size_t size) {
    auto* memory = static_cast<Memory*>(png_get_mem_ptr(png));
    if (size > maxText + 65536) return nullptr;
    if (memory->used + size > maxMemory) {
        memory->isExceeded = true;
        return nullptr;
    }
    auto* block = static_cast<char*>(std::malloc(size + sizeRoom));
    if (!block) return nullptr;
    std::memcpy(block, &size, sizeof size);
    memory->used += size;
    return block + sizeRoom;
}

void onFree(png_structp png, png_voidp data) {
    if (!data) return;
    char* block = static_cast<char*>(data) - sizeRoom;
    png_alloc_size_t size = 0;
    std::memcpy(&size, block, sizeof size);
    static_cast<Memory*>(png_get_mem_ptr(png))->used -= size;
    std::free(block);
}

void onRead(png_structp png, png_bytep data, png_size_t size) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (png_size_t(source->end - source->next) < size) png_error(png, "end of file");
    std::memcpy(data, source->next, size);
    source->next += size;
}

// Everything before the pixels; libpng leaves by longjmp, so no object with a destructor lives here.
bool readChunks(png_structp png, png_infop info, Source* source) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, source, onRead);
    png_set_chunk_malloc_max(png, maxText); // also limits the size of a decompressed text
    png_set_chunk_cache_max(png, 100);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(png, info);
    return true;
}

EmbeddedSystem systemAmong(png_structp png, png_infop info) {
    png_textp texts = nullptr;
    const int count = png_get_text(png, info, &texts, nullptr);
    const png_textp end = texts + count;
    const png_textp found = std::find_if(
        texts, end, [](const png_text& text) { return std::strcmp(text.key, pngSystemKeyword) == 0; });
    if (found == end)
        return {{},
                Text::tr("The picture contains no system: it was not written by Barycage, "
                         "or another program removed the text that holds it.")};
    const png_size_t size = std::strlen(found->text);
    if (size > maxText) return {{}, Text::tr("The system in the picture is larger than 8 MB.")};
    return {QByteArray(found->text, qsizetype(size)), {}};
}

// Behind the pixels, where an animation has it: as this program writes it, uncompressed and whole.
std::optional<QByteArray> textBehindPixels(const QByteArray& bytes) {
    // Length of the signature; length, name and checksum of a chunk.
    constexpr qsizetype signature = 8, around = 12;
    const QByteArray keyword = QByteArray(pngSystemKeyword) + QByteArray(5, '\0');
    bool areBehind = false;
    for (qsizetype at = signature; at + around <= bytes.size();) {
        const auto length = qsizetype(qFromBigEndian<quint32>(bytes.constData() + at));
        const QByteArrayView chunk = QByteArrayView(bytes).sliced(at + 4);
        if (length > chunk.size() - 8) break;
        areBehind = areBehind || chunk.startsWith("IDAT");
        const QByteArrayView data = chunk.sliced(4, length);
        if (areBehind && chunk.startsWith("iTXt") && data.startsWith(keyword) &&
            png_size_t(length) <= maxText &&
            crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), uInt(length + 4)) ==
                qFromBigEndian<quint32>(chunk.data() + 4 + length))
            return data.sliced(keyword.size()).toByteArray();
        at += length + around;
    }
    return std::nullopt;
}

} // namespace

bool looksLikePng(const QByteArray& bytes) {
    return bytes.startsWith("\x89PNG\r\n\x1a\n");
}

EmbeddedSystem readPngSystem(const QByteArray& bytes) {
    Memory memory;
    png_structp png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning, &memory,
                                               onAllocate, onFree);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    Source source{bytes.constData(), bytes.constData() + bytes.size()};
    EmbeddedSystem result;
    const bool isRead = info && readChunks(png, info, &source);
    if (memory.isExceeded)
        result.failure = Text::tr("The picture contains too much text: the limit is 40 MB in total.");
    else if (!isRead)
        result.failure = Text::tr("The file is not a PNG picture, or it is damaged.");
    else
        result = systemAmong(png, info);
    if (isRead && result.failure)
        if (auto text = textBehindPixels(bytes)) result = {*std::move(text), {}};
    png_destroy_read_struct(&png, &info, nullptr);
    return result;
}

} // namespace io
