// SPDX-License-Identifier: MIT
#include "io/save_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QSaveFile>

#include <algorithm>
#include <filesystem>
#include <system_error>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#ifdef Q_OS_LINUX
#include <sys/xattr.h>
#endif

namespace io {

namespace {

namespace fs = std::filesystem;

constexpr qint64 largestFile = 256LL * 1024 * 1024;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

QString shown(const QString& path) {
    return QDir::toNativeSeparators(path);
}

// A name whose bytes Qt could not read.
bool isLost(const QString& path) {
    return path.contains(QChar::ReplacementCharacter) && !QFileInfo::exists(path);
}

QString notUtf8(const QString& path) {
    return Text::tr("The name “%1” is not UTF-8. Please rename the file, or lead to it by a link.")
        .arg(shown(path));
}

// The file that `path` leads to through symbolic links; a dangling link leads to the file it names. Step by
// step as the system does it: "..", after a link to a folder, is not the folder that the link lies in. Names
// stay bytes on the way: not all of them are UTF-8. What a device or a pipe is called leads nowhere.
fs::path target(const QString& path) {
    constexpr int mostLinks = 40; // as many as the kernel follows
    std::error_code error;
    const fs::path given(QFile::encodeName(path).toStdString());
    const fs::file_status end = fs::status(given, error);
    if (fs::exists(end) && !fs::is_regular_file(end)) return given;
    fs::path at = given;
    for (int i = 0; i < mostLinks && fs::is_symlink(fs::symlink_status(at, error)); ++i) {
        const fs::path folder = fs::canonical(at.has_parent_path() ? at.parent_path() : ".", error);
        if (error) return given;
        const fs::path link = fs::read_symlink(at, error);
        if (error) return given;
        at = folder / link; // or `link`, if it begins at the root
    }
    return at;
}

QString nameOf(const fs::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.string()));
}

bool isWritable(const fs::path& file) {
#ifdef Q_OS_UNIX
    return ::access(file.c_str(), W_OK) == 0;
#else
    return QFileInfo(nameOf(file)).isWritable();
#endif
}

Failure obstacle(const fs::path& target) {
    const QString path = nameOf(target);
    if (path.isEmpty()) return Text::tr("The file has no name. Choose one.");
    std::error_code error; // what cannot be asked about is not there
    const fs::file_status file = fs::status(target, error);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (fs::is_directory(file)) return Text::tr("“%1” is a folder. Choose a file name.").arg(shown(path));
    if (fs::exists(file) && !fs::is_regular_file(file))
        return Text::tr("“%1” is not an ordinary file and is not replaced. Choose another name.")
            .arg(shown(path));
    if (!fs::is_directory(folder, error))
        return Text::tr("The folder “%1” does not exist. Create it, or save somewhere else.")
            .arg(shown(QFileInfo(path).absolutePath()));
    if (fs::exists(file) && !isWritable(target))
        return Text::tr("“%1” is read-only. Save under another name, or change its permissions.")
            .arg(shown(path));
    return std::nullopt;
}

#ifdef Q_OS_UNIX

QString reason(int error, const QString& path) {
    const QString folder = shown(QFileInfo(path).absolutePath());
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return Text::tr(
                   "“%1” was not saved: the disk is full. Free some space and save again; the file on the "
                   "disk is as "
                   "it was.")
            .arg(shown(path));
    case EACCES:
    case EPERM:
    case EROFS:
        return Text::tr("“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.")
            .arg(shown(path), folder);
    case ENAMETOOLONG:
        return Text::tr("“%1” was not saved: the name is too long.").arg(shown(path));
    default:
        return Text::tr("“%1” was not saved: %2. The file on the disk is as it was.")
            .arg(shown(path), QString::fromLocal8Bit(std::strerror(error)));
    }
}

// An open file descriptor; closed at the end.
class Descriptor {
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor() {
        if (m_number >= 0) ::close(m_number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    bool isOpen() const { return m_number >= 0; }
    int number() const { return m_number; }

private:
    int m_number;
};

#ifdef Q_OS_LINUX

constexpr char accessList[] = "system.posix_acl_access";

// What call(room, size) writes, which says how much that is when there is no room; nullopt when it fails.
template <class Call> std::optional<QByteArray> written(Call call) {
    const ssize_t size = call(nullptr, 0);
    if (size < 0) return std::nullopt;
    QByteArray bytes(size, '\0');
    const ssize_t length = call(bytes.data(), std::size_t(size));
    if (length < 0) return std::nullopt;
    bytes.truncate(length);
    return bytes;
}

// They speak of the old bytes.
bool isOfContents(const QByteArray& attribute) {
    return attribute == "security.capability" || attribute == "security.ima" || attribute == "security.evm";
}

// The access control list, labels, and what else users and programs have attached to the old file. What the
// file system or our rights refuse is left out; the error when there is no room for it.
int keepExtendedAttributes(int file, const QByteArray& path) {
    const auto names =
        written([&](char* room, std::size_t size) { return ::listxattr(path.constData(), room, size); });
    for (const QByteArray& name : names.value_or(QByteArray()).split('\0')) {
        if (name.isEmpty() || isOfContents(name)) continue;
        const auto value = written([&](char* room, std::size_t size) {
            return ::getxattr(path.constData(), name.constData(), room, size);
        });
        if (value &&
            ::fsetxattr(file, name.constData(), value->constData(), std::size_t(value->size()), 0) != 0 &&
            (errno == ENOSPC || errno == EDQUOT))
            return errno;
    }
    return 0;
}

// One that the folder gives to every new file is not the old one's.
void dropAccessList(int file) {
    ::fremovexattr(file, accessList);
}

#else

int keepExtendedAttributes(int, const QByteArray&) {
    return 0;
}
void dropAccessList(int) {}

#endif

// Permissions, and owner and group as far as we may, of the file that is about to be replaced, and all else
// that the file system knows of it. The error when there is no room for that.
int keepAttributes(int file, const QByteArray& path) {
    struct stat old {};
    if (::stat(path.constData(), &old) != 0) return 0;
    if (::fchown(file, old.st_uid, old.st_gid) != 0 &&
        ::fchown(file, static_cast<uid_t>(-1), old.st_gid) != 0)
        old.st_mode &= static_cast<mode_t>(~(S_ISUID | S_ISGID));
    dropAccessList(file);
    ::fchmod(file, old.st_mode & 07777);
    return keepExtendedAttributes(file, path);
}

// Nothing is left out: "link/.." is not the folder that the link lies in.
QByteArray folderOf(const QByteArray& path) {
    const auto slash = path.lastIndexOf('/');
    return slash < 0 ? QByteArray(".") : slash == 0 ? QByteArray("/") : path.left(slash);
}

// Tries names in the folder until one is free: call(name) is then 0 or more. Empty when none is.
template <class Call> QByteArray freeName(const QByteArray& folder, Call call) {
    constexpr int attempts = 100;
    for (int i = 0; i < attempts; ++i) {
        const QByteArray name =
            folder + "/.barycage-" + QByteArray::number(QRandomGenerator::system()->generate64(), 36);
        if (call(name) >= 0) return name;
        if (errno != EEXIST) break;
    }
    return {};
}

QByteArray linkOf(int file) {
    return "/proc/self/fd/" + QByteArray::number(file);
}

// A new file beside `path` for what is to replace it; without a name where the system can do that, so that
// nothing stays of it whatever ends the program. What others may not read is theirs at no moment.
int createBeside(const QByteArray& folder, const QByteArray& path, QByteArray* name) {
    const mode_t mode = ::access(path.constData(), F_OK) == 0 ? 0600 : 0666; // the umask is taken from it
    int file = -1;
#ifdef O_TMPFILE
    file = ::open(folder.constData(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    if (file >= 0 && ::access(linkOf(file).constData(), F_OK) == 0) return file;
    if (file >= 0) ::close(file);
#endif
    *name = freeName(folder, [&](const QByteArray& candidate) {
        file = ::open(candidate.constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        return file;
    });
    return file;
}

} // namespace

struct NewFile::Temporary {
    explicit Temporary(const fs::path& path)
        : target(QByteArray::fromStdString(path.string())),
          folder(folderOf(target)),
          file(createBeside(folder, target, &name)) {
        error = file.isOpen() ? 0 : errno;
    }
    ~Temporary() {
        if (!name.isEmpty() && !isRenamed) ::unlink(name.constData());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    bool hasName() {
        if (name.isEmpty())
            name = freeName(folder, [this](const QByteArray& candidate) {
                return ::linkat(AT_FDCWD, linkOf(file.number()).constData(), AT_FDCWD, candidate.constData(),
                                AT_SYMLINK_FOLLOW);
            });
        return !name.isEmpty();
    }

    // Where there is no file yet, it needs no other name on the way.
    bool becomesTarget() {
        return name.isEmpty() && ::linkat(AT_FDCWD, linkOf(file.number()).constData(), AT_FDCWD,
                                          target.constData(), AT_SYMLINK_FOLLOW) == 0;
    }

    bool rename() {
        isRenamed = ::fsync(file.number()) == 0 &&
                    (becomesTarget() || (hasName() && ::rename(name.constData(), target.constData()) == 0));
        error = isRenamed ? 0 : errno;
        // The name must survive a power cut as well; some file systems refuse to sync a folder, which is no
        // failure.
        const Descriptor directory(::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (directory.isOpen()) ::fsync(directory.number());
        return isRenamed;
    }

    qint64 write(const char* data, qint64 size) {
        for (qint64 done = 0; done < size;) {
            const ssize_t count = ::write(file.number(), data + done, static_cast<std::size_t>(size - done));
            error = count < 0 ? errno : 0;
            if (count < 0 && error != EINTR) return -1;
            done += std::max<ssize_t>(count, 0);
        }
        return size;
    }

    QByteArray target, folder;
    QByteArray name; // none yet, perhaps
    Descriptor file;
    int error = 0; // of the last call
    bool isRenamed = false;
};

NewFile::NewFile(const QString& path) {
    const fs::path end = target(path);
    m_path = nameOf(end);
    m_failure = isLost(path) ? notUtf8(path) : obstacle(end);
    if (m_failure) return;
    m_temporary = std::make_unique<Temporary>(end);
    if (!m_temporary->file.isOpen()) {
        fail(m_temporary->error);
        return;
    }
    if (const int error = keepAttributes(m_temporary->file.number(), m_temporary->target)) {
        fail(error);
        return;
    }
    setOpenMode(WriteOnly | Unbuffered);
}

void NewFile::fail(int error) {
    if (!m_failure) m_failure = reason(error, m_path);
}

qint64 NewFile::writeData(const char* data, qint64 size) {
    const qint64 written = m_temporary->write(data, size);
    if (written < 0) {
        fail(m_temporary->error);
        setErrorString(*m_failure);
    }
    return written;
}

Failure NewFile::commit() {
    if (!m_failure && !m_temporary->rename()) fail(m_temporary->error);
    return m_failure;
}

#else

} // namespace

struct NewFile::Temporary {
    explicit Temporary(const fs::path& path) : file(nameOf(path)) {}
    QSaveFile file;
};

NewFile::NewFile(const QString& path) {
    const fs::path end = target(path);
    m_path = nameOf(end);
    m_failure = isLost(path) ? notUtf8(path) : obstacle(end);
    if (m_failure) return;
    m_temporary = std::make_unique<Temporary>(end);
    if (m_temporary->file.open(QIODevice::WriteOnly))
        setOpenMode(WriteOnly | Unbuffered);
    else
        fail(0);
}

void NewFile::fail(int) {
    if (!m_failure)
        m_failure = Text::tr("“%1” was not saved: %2. The file on the disk is as it was.")
                        .arg(shown(m_path), m_temporary->file.errorString());
}

qint64 NewFile::writeData(const char* data, qint64 size) {
    const qint64 written = m_temporary->file.write(data, size);
    if (written != size) {
        fail(0);
        setErrorString(*m_failure);
    }
    return written;
}

Failure NewFile::commit() {
    if (!m_failure && !m_temporary->file.commit()) fail(0);
    return m_failure;
}

#endif

NewFile::~NewFile() = default;

qint64 NewFile::readData(char*, qint64) {
    return -1;
}

Failure saveFile(const QString& path, const QByteArray& bytes) {
    NewFile file(path);
    if (!file.failure()) file.write(bytes);
    return file.commit();
}

Loaded loadFile(const QString& path) {
    QFile file(path);
    const QFileInfo info(path);
    if (isLost(path)) return {{}, notUtf8(path)};
    if (!info.exists()) return {{}, Text::tr("“%1” does not exist.").arg(shown(path))};
    if (info.isDir()) return {{}, Text::tr("“%1” is a folder, not a file.").arg(shown(path))};
    const QString tooLarge =
        Text::tr("“%1” is larger than 256 MB, which is the limit for a file.").arg(shown(path));
    if (info.size() > largestFile) return {{}, tooLarge};
    if (!file.open(QIODevice::ReadOnly))
        return {{}, Text::tr("“%1” cannot be read: %2.").arg(shown(path), file.errorString())};
    Loaded loaded;
    // A pipe does not know its size beforehand, and one read of the limit would reserve as much memory.
    const qint64 expected = std::max<qint64>(info.size(), 1 << 16);
    while (loaded.bytes.size() <= largestFile) {
        const QByteArray piece = file.read(expected);
        if (piece.isEmpty()) break;
        loaded.bytes += piece;
    }
    if (file.error() != QFileDevice::NoError)
        return {{}, Text::tr("“%1” cannot be read: %2.").arg(shown(path), file.errorString())};
    if (loaded.bytes.size() > largestFile) return {{}, tooLarge};
    return loaded;
}

} // namespace io
