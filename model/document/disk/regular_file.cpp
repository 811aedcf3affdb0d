// SPDX-License-Identifier: MIT
#include "document/disk/regular_file.h"

#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace document {

using enum Opened::State;

#ifdef Q_OS_UNIX

namespace {

Opened closed(int error) {
    return {Closed, qt_error_string(error)};
}

} // namespace

// Opening alone wakes some devices, so the type is checked before, too.
Opened openRegular(QFile& file, const QByteArray& name) {
    struct stat status {};
    if (::stat(name.constData(), &status) != 0) return closed(errno);
    if (S_ISDIR(status.st_mode)) return closed(EISDIR);
    if (!S_ISREG(status.st_mode)) return {NotRegular};
    constexpr int flags = O_RDONLY | O_CLOEXEC | O_NOCTTY;
    int descriptor = ::open(name.constData(), flags | O_NONBLOCK);
    if (descriptor < 0 && errno == EWOULDBLOCK) // another program must release the file first
        descriptor = ::open(name.constData(), flags);
    if (descriptor < 0) return closed(errno);
    const int error = ::fstat(descriptor, &status) == 0 ? 0 : errno;
    if (error != 0 || !S_ISREG(status.st_mode)) {
        ::close(descriptor);
        return error != 0 ? closed(error) : Opened{NotRegular};
    }
    ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    if (file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) return {};
    ::close(descriptor);
    return {Closed, file.errorString()};
}

#else

Opened openRegular(QFile& file, const QByteArray& name) {
    file.setFileName(QFile::decodeName(name));
    if (QFileInfo::exists(file.fileName()) && !QFileInfo(file).isFile()) return {NotRegular};
    if (file.open(QIODevice::ReadOnly)) return {};
    return {Closed, file.errorString()};
}

#endif

} // namespace document
