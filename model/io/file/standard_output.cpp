// SPDX-License-Identifier: MIT
#include "io/file/standard_output.h"

#include "document/text/text.h"
#include "io/file/native_path.h"

#include <QDir>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

namespace io {

const QString& standardOutputPath() {
    static const QString path = QString(QChar(u'\0')) + QStringLiteral("standard output");
    return path;
}

QString cannotPrint(int error) {
    return Text::tr("Standard output cannot be written to: %1.")
        .arg(QString::fromLocal8Bit(std::strerror(error)));
}

int namelessFile() {
    const int descriptor =
        ::open(nativeName(QDir::tempPath()).constData(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    return descriptor >= 0 ? descriptor : ::memfd_create("standard output", MFD_CLOEXEC);
}

bool printBytes(const char* data, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
        const ssize_t written = ::write(STDOUT_FILENO, data + done, size - done);
        if (written >= 0) {
            done += std::size_t(written);
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) { // full pipe
            pollfd output{STDOUT_FILENO, POLLOUT, 0};
            if (::poll(&output, 1, -1) < 0 && errno != EINTR) return false;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

bool printFile(int descriptor) {
    if (::lseek(descriptor, 0, SEEK_SET) != 0) return false;
    std::array<char, 1 << 16> piece{};
    for (;;) {
        const ssize_t size = ::read(descriptor, piece.data(), piece.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return size == 0;
        if (!printBytes(piece.data(), std::size_t(size))) return false;
    }
}

} // namespace io
