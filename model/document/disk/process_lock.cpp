// SPDX-License-Identifier: MIT
#include "document/disk/process_lock.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace document {

namespace {

// Whether some process has the lock file open as its own. The number of the process in it does not tell: in a
// container the next start may have the same.
bool isHeld(const QString& lockFile) {
#ifdef Q_OS_UNIX
    const int file = ::open(QFile::encodeName(lockFile).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return errno != ENOENT;
    const bool free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file); // and with it the lock
    return !free;
#else
    return QFileInfo::exists(lockFile);
#endif
}

} // namespace

QString lockFileOf(const QString& path) {
    return path + QStringLiteral(".lock");
}

// The owner's process keeps the lock for as long as it lives; its age says nothing. One that is only just
// being made is nobody's for a moment. What is no file was never a lock.
std::unique_ptr<QLockFile> processLock(const QString& path) {
    constexpr int justNow = 2; // seconds
    const QFileInfo left(lockFileOf(path));
    const bool isOld = left.lastModified().secsTo(QDateTime::currentDateTime()) > justNow;
    if (left.exists() && (!left.isFile() || (isOld && !isHeld(left.filePath()))))
        QFile::remove(left.filePath());
    auto made = std::make_unique<QLockFile>(lockFileOf(path));
    made->setStaleLockTime(0);
    if (!made->tryLock(0)) return nullptr;
    QFile::setPermissions(lockFileOf(path), QFile::ReadOwner | QFile::WriteOwner);
    return made;
}

void makePrivateFolder(const QString& folder) {
    QDir().mkpath(folder);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

} // namespace document
