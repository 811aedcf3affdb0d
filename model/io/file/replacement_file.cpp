// SPDX-License-Identifier: MIT
#include "io/file/replacement_file.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QSaveFile>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <utility>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#ifdef Q_OS_LINUX
#include <sys/xattr.h>
#endif

namespace io {

namespace fs = std::filesystem;

#ifdef Q_OS_UNIX

namespace {

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

// Output of call(room, size), which returns the size needed when there is no room; nullopt when it fails.
template <class Call> std::optional<QByteArray> written(Call call) {
    const ssize_t size = call(nullptr, 0);
    if (size < 0) return std::nullopt;
    QByteArray bytes(size, '\0');
    const ssize_t length = call(bytes.data(), std::size_t(size));
    if (length < 0) return std::nullopt;
    bytes.truncate(length);
    return bytes;
}

// Returns true for attributes that describe the old bytes.
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

// Drops the access list that the folder gives to every new file: the old file may have none.
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

// The folder, unsimplified: "link/.." is not the folder that the link lies in.
QByteArray folderOf(const QByteArray& path) {
    const auto slash = path.lastIndexOf('/');
    return slash < 0 ? QByteArray(".") : slash == 0 ? QByteArray("/") : path.left(slash);
}

// The name of a file that is being written, for as long as it has one, in a place that lasts: the program may
// end at any moment, and must not leave it behind.
class PartName {
public:
    ~PartName() { clear(); }

    bool isEmpty() const { return m_name.isEmpty(); }
    const char* data() const { return m_name.constData(); }

    PartName& operator=(const QByteArray& name) {
        clear();
        m_name = name;
        for (Place& place : places()) {
            if (isEmpty() || std::size_t(name.size()) >= place.name.size() || place.isTaken.exchange(true))
                continue;
            std::ranges::copy(name, place.name.begin());
            place.name[std::size_t(name.size())] = 0;
            place.isWritten = true;
            m_place = &place;
            break;
        }
        return *this;
    }

    static void unlinkAll() {
        for (const Place& place : places())
            if (place.isWritten) ::unlink(place.name.data());
    }

private:
    struct Place {
        std::atomic<bool> isTaken = false, isWritten = false;
        std::array<char, 4096> name{};
    };

    static std::array<Place, 16>& places() {
        static constinit std::array<Place, 16> places;
        return places;
    }

    void clear() {
        if (!m_place) return;
        m_place->isWritten = false;
        std::exchange(m_place, nullptr)->isTaken = false;
    }

    QByteArray m_name;
    Place* m_place = nullptr;
};

constexpr char whole[] = ".barycage-";
constexpr char part[] = ".barycage-part-"; // infix of a file being written

// Tries names in the folder until one is free: call(name) is then 0 or more. Empty when none is.
template <class Call> QByteArray freeName(const QByteArray& folder, const char* beginning, Call call) {
    constexpr int attempts = 100;
    for (int i = 0; i < attempts; ++i) {
        const QByteArray name =
            folder + '/' + beginning + QByteArray::number(QRandomGenerator::system()->generate64(), 36);
        if (call(name) >= 0) return name;
        if (errno != EEXIST) break;
    }
    return {};
}

QByteArray linkOf(int file) {
    return "/proc/self/fd/" + QByteArray::number(file);
}

// Returns true for a partly written file of this user whose program has ended: nobody has it locked, nor has
// just made it.
bool isAbandoned(const QByteArray& name, time_t now) {
    constexpr time_t justNow = 60; // seconds; the clock may have been set back since
    const Descriptor file(::open(name.constData(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    return file.isOpen() && ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) &&
           status.st_uid == ::geteuid() && status.st_nlink == 1 &&
           std::abs(now - status.st_mtime) > justNow && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0;
}

// A file that has its name while it is written stays when the program is killed: the next one to need such a
// file in the folder removes it. `made` is that file.
void removeAbandoned(const QByteArray& folder, int made) {
    struct stat status {};
    if (::fstat(made, &status) != 0) return;
    const QDir entries(QFile::decodeName(folder));
    for (const QString& name : entries.entryList({QLatin1String(part) + u'*'}, QDir::Files | QDir::Hidden)) {
        const QByteArray path = folder + '/' + QFile::encodeName(name);
        if (isAbandoned(path, status.st_mtime)) ::unlink(path.constData());
    }
}

// Creates a file with a temporary name, locked for as long as it is open; negative when there is none.
int createPart(const QByteArray& folder, int access, mode_t mode, PartName& name) {
    int file = -1;
    name = freeName(folder, part, [&](const QByteArray& candidate) {
        file = ::open(candidate.constData(), access | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        return file;
    });
    const int error = errno;
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) removeAbandoned(folder, file);
    errno = error;
    return file;
}

// Creates the replacement of `path` beside it; without a name where the system can do that, so that nothing
// stays of it whatever ends the program. At no moment can others read what they may not.
int createBeside(const QByteArray& folder, const QByteArray& path, PartName& name) {
    const mode_t mode = ::access(path.constData(), F_OK) == 0 ? 0600 : 0666; // permissions before the umask
    int file = -1;
#ifdef O_TMPFILE
    file = ::open(folder.constData(), O_TMPFILE | O_RDWR | O_CLOEXEC, mode); // may need to be copied
    if (file >= 0 && ::access(linkOf(file).constData(), F_OK) == 0) return file;
    if (file >= 0) ::close(file);
#endif
    return createPart(folder, O_RDWR, mode, name);
}

bool copyAll(int from, int to) {
    std::array<char, 1 << 16> piece{};
    for (off_t at = 0;;) {
        const ssize_t size = ::pread(from, piece.data(), piece.size(), at);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return size == 0;
        at += size;
        for (ssize_t done = 0; done < size;) {
            const ssize_t count = ::write(to, piece.data() + done, std::size_t(size - done));
            if (count < 0 && errno != EINTR) return false;
            done += std::max<ssize_t>(count, 0);
        }
    }
}

SystemError errorOf(int number) {
    using Kind = SystemError::Kind;
    const QString text = QString::fromLocal8Bit(std::strerror(number));
    switch (number) {
    case 0:
        return {};
    case ENOSPC:
    case EDQUOT:
        return {Kind::DiskFull, text};
    case EACCES:
    case EPERM:
    case EROFS:
        return {Kind::Denied, text};
    case ENAMETOOLONG:
        return {Kind::NameTooLong, text};
    default:
        return {Kind::Other, text};
    }
}

} // namespace

struct ReplacementFile::State {
    explicit State(const fs::path& path)
        : target(QByteArray::fromStdString(path.string())),
          folder(folderOf(target)),
          file(createBeside(folder, target, name)) {
        error = file.isOpen() ? keepAttributes(file.number(), target) : errno;
    }
    ~State() {
        if (!name.isEmpty() && !isRenamed) ::unlink(name.data());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    bool hasName() {
        if (name.isEmpty())
            name = freeName(folder, whole, [this](const QByteArray& candidate) {
                return ::linkat(AT_FDCWD, linkOf(file.number()).constData(), AT_FDCWD, candidate.constData(),
                                AT_SYMLINK_FOLLOW);
            });
        return !name.isEmpty() || isCopiedUnderName();
    }

    // Returns true if the file needs a name from the start: some systems create files without a name, but
    // cannot name them later.
    bool isCopiedUnderName() {
        const int copy = createPart(folder, O_WRONLY, 0600, name);
        if (copy < 0) return false;
        struct stat made {};
        if (::fstat(file.number(), &made) == 0) ::fchmod(copy, made.st_mode & 07777);
        error = keepAttributes(copy, target);
        if (error == 0 && !(copyAll(file.number(), copy) && ::fsync(copy) == 0)) error = errno;
        ::close(copy);
        errno = error;
        return error == 0;
    }

    // A new file needs no temporary name.
    bool becomesTarget() {
        return name.isEmpty() && ::linkat(AT_FDCWD, linkOf(file.number()).constData(), AT_FDCWD,
                                          target.constData(), AT_SYMLINK_FOLLOW) == 0;
    }

    void replaceTarget() {
        isRenamed = ::fsync(file.number()) == 0 &&
                    (becomesTarget() || (hasName() && ::rename(name.data(), target.constData()) == 0));
        error = isRenamed ? 0 : errno;
        // Syncs the folder, so that the name survives a power cut. Some file systems refuse; that is no
        // failure.
        const Descriptor directory(::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (directory.isOpen()) ::fsync(directory.number());
    }

    void write(qint64 position, const char* data, qint64 size) {
        for (qint64 done = 0; done < size;) {
            const ssize_t count = ::pwrite(file.number(), data + done, static_cast<std::size_t>(size - done),
                                           static_cast<off_t>(position + done));
            error = count < 0 ? errno : 0;
            if (count < 0 && error != EINTR) return;
            done += std::max<ssize_t>(count, 0);
        }
    }

    qint64 read(qint64 position, char* data, qint64 size) {
        ssize_t count = 0;
        do
            count =
                ::pread(file.number(), data, static_cast<std::size_t>(size), static_cast<off_t>(position));
        while (count < 0 && errno == EINTR);
        error = count < 0 ? errno : 0;
        return count;
    }

    QByteArray target, folder;
    PartName name; // empty before naming
    Descriptor file;
    int error = 0; // error of the last call
    bool isRenamed = false;
};

ReplacementFile::ReplacementFile(const fs::path& target)
    : m_state(std::make_unique<State>(target)), m_error(errorOf(m_state->error)) {}

bool ReplacementFile::write(qint64 position, const char* data, qint64 size) {
    m_state->write(position, data, size);
    m_error = errorOf(m_state->error);
    return m_state->error == 0;
}

qint64 ReplacementFile::read(qint64 position, char* data, qint64 size) {
    const qint64 count = m_state->read(position, data, size);
    m_error = errorOf(m_state->error);
    return count;
}

bool ReplacementFile::replaceTarget() {
    m_state->replaceTarget();
    m_error = errorOf(m_state->error);
    return m_state->error == 0;
}

bool isWritable(const fs::path& file) {
    return ::access(file.c_str(), W_OK) == 0;
}

void removeUnfinished() {
    PartName::unlinkAll();
}

#else

namespace {

QString decodedName(const fs::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.string()));
}

} // namespace

struct ReplacementFile::State {
    explicit State(const fs::path& target) : file(decodedName(target)) {}

    SystemError errorUnless(bool isDone) const {
        return isDone ? SystemError() : SystemError{SystemError::Kind::Other, file.errorString()};
    }

    QSaveFile file;
};

ReplacementFile::ReplacementFile(const fs::path& target)
    : m_state(std::make_unique<State>(target)),
      m_error(m_state->errorUnless(m_state->file.open(QIODevice::WriteOnly))) {}

bool ReplacementFile::write(qint64 position, const char* data, qint64 size) {
    m_error = m_state->errorUnless(m_state->file.seek(position) && m_state->file.write(data, size) == size);
    return m_error.kind == SystemError::Kind::None;
}

qint64 ReplacementFile::read(qint64, char*, qint64) { // unsupported, as in QSaveFile
    m_error = m_state->errorUnless(false);
    return -1;
}

bool ReplacementFile::replaceTarget() {
    m_error = m_state->errorUnless(m_state->file.commit());
    return m_error.kind == SystemError::Kind::None;
}

bool isWritable(const fs::path& file) {
    return QFileInfo(decodedName(file)).isWritable();
}

void removeUnfinished() {}

#endif

ReplacementFile::~ReplacementFile() = default;

} // namespace io
