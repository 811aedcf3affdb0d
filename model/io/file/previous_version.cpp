// SPDX-License-Identifier: MIT
#include "io/file/previous_version.h"

#include "io/file/native_path.h"
#include "io/file/save_file.h"

#include <QCryptographicHash>
#include <QRandomGenerator>

#include <algorithm>
#include <filesystem>
#include <system_error>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace io {

namespace fs = std::filesystem;

namespace {

QByteArray digestOfVersion(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

#ifdef Q_OS_UNIX

bool writeAllTo(int file, const QByteArray& bytes) {
    for (qsizetype done = 0; done < bytes.size();) {
        const ssize_t count = ::write(file, bytes.constData() + done, std::size_t(bytes.size() - done));
        if (count < 0 && errno != EINTR) return false;
        done += std::max<ssize_t>(count, 0);
    }
    return true;
}

// Copies so that others who may not read the file can read the copy at no moment.
bool copyAs(const QByteArray& name, const QByteArray& path, const QByteArray& bytes) {
    struct stat old {};
    if (::stat(path.constData(), &old) != 0) return false;
    const int file = ::open(name.constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) return false;
    const bool isDone =
        writeAllTo(file, bytes) && ::fchmod(file, old.st_mode & 0777) == 0 && ::fsync(file) == 0;
    ::close(file);
    if (!isDone) ::unlink(name.constData());
    return isDone;
}

// The file itself gets a second name, and keeps that one when its first goes to the new file. A link, or a
// file system without such names, takes a copy.
bool keepAs(const QByteArray& name, const QByteArray& path, const QByteArray& bytes) {
    struct stat status {};
    const bool isFile = ::lstat(path.constData(), &status) == 0 && S_ISREG(status.st_mode);
    return (isFile && ::link(path.constData(), name.constData()) == 0) || copyAs(name, path, bytes);
}

// The version that has the name stays until the other one is there.
bool keepInPlaceOf(const QByteArray& name, const QByteArray& path, const QByteArray& bytes) {
    const QByteArray folder = path.left(path.lastIndexOf('/') + 1);
    const QByteArray other =
        folder + ".barycage-" + QByteArray::number(QRandomGenerator::system()->generate64(), 36);
    if (!keepAs(other, path, bytes)) return false;
    if (::rename(other.constData(), name.constData()) == 0) return true;
    ::unlink(other.constData());
    return false;
}

#else

bool keepAs(const QByteArray& name, const QByteArray&, const QByteArray& bytes) {
    return !saveFile(pathOf(name), bytes);
}
bool keepInPlaceOf(const QByteArray& name, const QByteArray& path, const QByteArray& bytes) {
    return keepAs(name, path, bytes);
}

#endif

} // namespace

QString previousVersionOf(const QString& path) {
    return path + u'~';
}

KeptVersion keepPreviousVersion(const QString& path, const QByteArray& own) {
    const QByteArray from = nativeName(path), name = nativeName(previousVersionOf(path));
    std::error_code error;
    if (!fs::is_regular_file(from.toStdString(), error)) return {};
    const Loaded now = loadFile(path);
    if (now.failure) return {Keeping::Refused, {}};
    const fs::file_status there = fs::symlink_status(name.toStdString(), error);
    const QByteArray digest = digestOfVersion(now.bytes);
    if (fs::exists(there)) {
        const Loaded kept = fs::is_regular_file(there) ? loadFile(previousVersionOf(path)) : Loaded();
        if (!fs::is_regular_file(there) || kept.failure) return {Keeping::Foreign, {}};
        const QByteArray other = digestOfVersion(kept.bytes);
        if (other == digest) return {Keeping::Kept, digest}; // kept by a save that was cancelled
        if (other != own) return {Keeping::Foreign, {}};
    }
    const bool isKept =
        fs::exists(there) ? keepInPlaceOf(name, from, now.bytes) : keepAs(name, from, now.bytes);
    return isKept ? KeptVersion{Keeping::Kept, digest} : KeptVersion{Keeping::Refused, {}};
}

} // namespace io
