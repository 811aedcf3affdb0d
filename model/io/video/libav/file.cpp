// SPDX-License-Identifier: MIT
#include "io/video/libav/file.h"

#include "io/video/libav/library.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace io::libav {

namespace {

constexpr int bufferSize = 1 << 16;

} // namespace

File::File(QIODevice& device) : m_device(device) {}

File::~File() {
    while (!m_open.empty())
        close(m_open.back());
}

int File::failed(int error) {
    if (m_error == 0) m_error = error;
    return error;
}

int File::read(void* cursor, unsigned char* data, int size) {
    auto& at = *static_cast<Cursor*>(cursor);
    QIODevice& device = at.file->m_device;
    const qint64 count = device.seek(at.position) ? device.read(reinterpret_cast<char*>(data), size) : -1;
    const bool isCutShort = count == 0 && at.position < at.file->m_size;
    if (count < 0 || isCutShort) return at.file->failed(AVERROR(EIO));
    at.position += count;
    return count > 0 ? int(count) : AVERROR_EOF;
}

int File::write(void* cursor, const unsigned char* data, int size) {
    auto& at = *static_cast<Cursor*>(cursor);
    QIODevice& device = at.file->m_device;
    if (!device.seek(at.position) || device.write(reinterpret_cast<const char*>(data), size) != size)
        return at.file->failed(AVERROR(EIO));
    at.position += size;
    at.file->m_size = std::max(at.file->m_size, at.position);
    return size;
}

std::int64_t File::seek(void* cursor, std::int64_t offset, int whence) {
    auto& at = *static_cast<Cursor*>(cursor);
    const qint64 size = at.file->m_size;
    if ((whence & AVSEEK_SIZE) != 0) return size;
    const int from = whence & ~AVSEEK_FORCE;
    const qint64 wanted = offset + (from == SEEK_CUR ? at.position : from == SEEK_END ? size : 0);
    if (wanted < 0) return at.file->failed(AVERROR(EINVAL));
    at.position = wanted;
    return wanted;
}

AVIOContext* File::open(bool isWritable) {
    auto cursor = std::make_unique<Cursor>(Cursor{this});
    auto* buffer = static_cast<unsigned char*>(library().av_malloc(bufferSize));
    if (buffer == nullptr) return nullptr;
#if LIBAVFORMAT_VERSION_MAJOR >= 61
    const auto writer = &File::write;
#else
    const auto writer = [](void* at, std::uint8_t* data, int size) { return write(at, data, size); };
#endif
    AVIOContext* context = library().avio_alloc_context(buffer, bufferSize, isWritable ? 1 : 0, cursor.get(),
                                                        &File::read, writer, &File::seek);
    if (context == nullptr) {
        library().av_free(buffer);
        return nullptr;
    }
    cursor.release(); // NOLINT(bugprone-unused-return-value): close() frees it
    m_open.push_back(context);
    return context;
}

void File::close(AVIOContext* context) {
    std::erase(m_open, context);
    delete static_cast<Cursor*>(context->opaque);
    library().av_freep(&context->buffer);
    library().avio_context_free(&context);
}

// Hands the file to the muxer. A muxer that moves the beginning behind reads what it has written.
void File::serve(AVFormatContext& format) {
    format.opaque = this;
    format.pb = open(true);
    format.flags |= AVFMT_FLAG_CUSTOM_IO;
    format.io_open = [](AVFormatContext* asking, AVIOContext** context, const char*, int, AVDictionary**) {
        auto* file = static_cast<File*>(asking->opaque);
        *context = file->open(false);
        return *context == nullptr ? file->failed(AVERROR(ENOMEM)) : 0;
    };
    format.io_close2 = [](AVFormatContext* asking, AVIOContext* context) {
        static_cast<File*>(asking->opaque)->close(context);
        return 0;
    };
}

} // namespace io::libav
