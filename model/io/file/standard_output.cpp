// SPDX-License-Identifier: MIT
#include "io/file/standard_output.h"

#include "io/file/native_path.h"

#include <QDir>

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace io {

const QString& standardOutputPath() {
    static const QString path = QString(QChar(u'\0')) + QStringLiteral("standard output");
    return path;
}

int namelessFile() {
    const int descriptor =
        ::open(nativeName(QDir::tempPath()).constData(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    return descriptor >= 0 ? descriptor : ::memfd_create("standard output", MFD_CLOEXEC);
}

bool printFile(int descriptor) {
    if (::lseek(descriptor, 0, SEEK_SET) != 0) return false;
    std::array<char, 1 << 16> piece{};
    for (;;) {
        const ssize_t size = ::read(descriptor, piece.data(), piece.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return size == 0;
        for (ssize_t done = 0; done < size;) {
            const ssize_t written = ::write(STDOUT_FILENO, piece.data() + done, std::size_t(size - done));
            if (written < 0 && errno != EINTR) return false;
            if (written > 0) done += written;
        }
    }
}

} // namespace io
