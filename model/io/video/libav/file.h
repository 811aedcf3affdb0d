// SPDX-License-Identifier: MIT
#pragma once

#include <QIODevice>

#include <cstdint>
#include <vector>

struct AVFormatContext;
struct AVIOContext;

namespace io::libav {

// A device as FFmpeg's libraries write to it and read back from it, through any number of positions of their
// own.
class File {
public:
    // Must be open for random-access reading and writing; must outlive the file.
    explicit File(QIODevice& device);
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void serve(AVFormatContext& format); // sets the I/O of `format`, which must not outlive the file
    qint64 size() const { return m_size; }
    // The first error of a call from the libraries, which do not pass on every one; 0 for none.
    int error() const { return m_error; }

private:
    struct Cursor {
        File* file;
        qint64 position = 0;
    };
    static int read(void* cursor, unsigned char* data, int size);
    static int write(void* cursor, const unsigned char* data, int size);
    static std::int64_t seek(void* cursor, std::int64_t offset, int whence);
    AVIOContext* open(bool isWritable);
    void close(AVIOContext* context);
    int failed(int error); // records and returns the error

    QIODevice& m_device;
    qint64 m_size = 0;
    int m_error = 0;
    std::vector<AVIOContext*> m_open;
};

} // namespace io::libav
