// SPDX-License-Identifier: MIT
#include "document/disk/process_lock.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSysInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace document {

namespace {

std::unique_ptr<QLockFile> lockByName(const QString& name) {
    auto made = std::make_unique<QLockFile>(name);
    made->setStaleLockTime(0);
    return made->tryLock(0) ? std::move(made) : nullptr;
}

#ifdef Q_OS_UNIX

enum class Locking { Done, Held, Again, Impossible };

// Returns true if the open file still has the name.
bool hasName(int file, const char* name) {
    struct stat open {
    }, named{};
    return ::fstat(file, &open) == 0 && ::lstat(name, &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

// A name that is no file was never a lock.
Locking removed(const char* name) {
    return ::unlink(name) == 0 || errno == ENOENT ? Locking::Again : Locking::Held;
}

// The system gives the lock up with the process, however that ends. Neither the number of the process in the
// file nor the time of the file says anything: in a container the next start may have the same number, and
// clocks are set back.
Locking lock(const char* name, int& file) {
    file = ::open(name, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600);
    if (file < 0) return errno == ELOOP || errno == ENXIO ? removed(name) : Locking::Held;
    struct stat status {};
    const bool isFile = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    if (isFile && ::flock(file, LOCK_EX | LOCK_NB) == 0 && hasName(file, name)) return Locking::Done;
    const int error = errno;
    const bool isGone = isFile && !hasName(file, name); // true if its owner has released it
    ::close(file);
    if (!isFile) return removed(name);
    if (isGone) return Locking::Again;
    return error == EWOULDBLOCK || error == EINTR ? Locking::Held : Locking::Impossible;
}

// Writes the owner as QLockFile does, for versions that ask by name.
void sign(int file) {
    const QByteArray owner = QByteArray::number(QCoreApplication::applicationPid()) + '\n' +
                             QCoreApplication::applicationName().toUtf8() + '\n' +
                             QSysInfo::machineHostName().toUtf8() + '\n' + QSysInfo::machineUniqueId() +
                             '\n' + QSysInfo::bootUniqueId() + '\n';
    if (::ftruncate(file, 0) != 0 || ::pwrite(file, owner.constData(), std::size_t(owner.size()), 0) < 0)
        return; // harmless: this version does not read the text
}

#endif

} // namespace

QString lockFileOf(const QString& path) {
    return path + QStringLiteral(".lock");
}

ProcessLock::~ProcessLock() {
#ifdef Q_OS_UNIX
    if (m_file < 0) return;
    const QByteArray name = QFile::encodeName(m_path);
    if (hasName(m_file, name.constData())) ::unlink(name.constData()); // before another process can lock it
    ::close(m_file);
#endif
}

std::unique_ptr<ProcessLock> processLock(const QString& path) {
    std::unique_ptr<ProcessLock> made(new ProcessLock);
    made->m_path = lockFileOf(path);
#ifdef Q_OS_UNIX
    constexpr int tries = 5; // others may release it at the same moment
    const QByteArray name = QFile::encodeName(made->m_path);
    for (int i = 0; i < tries; ++i) {
        int file = -1;
        switch (lock(name.constData(), file)) {
        case Locking::Done:
            made->m_file = file;
            sign(file);
            return made;
        case Locking::Held:
            return nullptr;
        case Locking::Again:
            continue;
        case Locking::Impossible:
            made->m_byName = lockByName(made->m_path);
            return made->m_byName ? std::move(made) : nullptr;
        }
    }
    return nullptr;
#else
    made->m_byName = lockByName(made->m_path);
    return made->m_byName ? std::move(made) : nullptr;
#endif
}

void makePrivateFolder(const QString& folder) {
    constexpr auto owner = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
    const QString above = QFileInfo(folder).absolutePath();
    if (!QFileInfo::exists(above) && above != folder) makePrivateFolder(above);
    QDir().mkdir(folder, owner);
    QFile::setPermissions(folder, owner);
}

} // namespace document
