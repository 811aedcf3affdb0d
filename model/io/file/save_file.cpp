// SPDX-License-Identifier: MIT
#include "io/file/save_file.h"

#include "document/disk/regular_file.h"
#include "document/text/text.h"
#include "io/file/native_path.h"
#include "io/file/replacement_file.h"
#include "io/file/standard_output.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace io {

namespace {

namespace fs = std::filesystem;

constexpr qint64 maxFile = 256LL * 1024 * 1024;

QString shown(const QString& path) {
    return QDir::toNativeSeparators(path);
}

// A name whose bytes Qt could not read.
bool isLost(const QString& path) {
    return path.contains(QChar::ReplacementCharacter) && !QFileInfo::exists(path);
}

QString notUtf8(const QString& path) {
    return Text::tr("The name “%1” is not valid UTF-8. Rename the file, or open it through a symbolic link.")
        .arg(shown(path));
}

// The file that a path leads to through symbolic links, or why the system does not follow them.
struct End {
    fs::path file;
    bool isRefused = false;
};

// Resolves links that the system may follow. Step by step as the system does it: "..", after a link to a
// folder, is not the folder that the link lies in.
fs::path followed(const fs::path& given) {
    constexpr int maxLinks = 40; // limit of the kernel
    std::error_code error;
    fs::path at = given;
    for (int i = 0; i < maxLinks && fs::is_symlink(fs::symlink_status(at, error)); ++i) {
        const fs::path folder = fs::canonical(at.has_parent_path() ? at.parent_path() : ".", error);
        if (error) return given;
        const fs::path link = fs::read_symlink(at, error);
        if (error) return given;
        at = folder / link; // equals `link` for an absolute one
    }
    return at;
}

// Returns true if the last part of the path is a link, wherever it leads.
bool endsInLink(const fs::path& path) {
    std::error_code error;
    return fs::is_symlink(fs::symlink_status(path, error));
}

// The kernel follows the links, so that its protection against links that others plant in shared folders
// (fs.protected_symlinks) holds; a dangling link leads to the file it names. Names stay bytes on the way: not
// all of them are UTF-8. The name of a device or a pipe leads to itself.
End target(const QString& path) {
    const fs::path given(nativeName(path).toStdString());
    if (!endsInLink(given)) return {given};
    std::error_code error;
#ifdef O_PATH
    const int end = ::open(given.c_str(), O_PATH | O_CLOEXEC);
    if (end < 0) {
        if (errno == ENOENT) return {followed(given)}; // dangling link
        return {given, errno == EACCES};
    }
    const fs::path resolved = fs::read_symlink("/proc/self/fd/" + std::to_string(end), error);
    struct stat opened {};
    struct stat named {};
    const bool isRegular = ::fstat(end, &opened) == 0 && S_ISREG(opened.st_mode);
    // False without /proc, and after the file was removed.
    const bool isNamed = !error && ::stat(resolved.c_str(), &named) == 0 && named.st_dev == opened.st_dev &&
                         named.st_ino == opened.st_ino;
    ::close(end);
    if (!isRegular) return {given};
    return {isNamed ? resolved : followed(given)};
#else
    const fs::file_status end = fs::status(given, error);
    if (fs::exists(end) && !fs::is_regular_file(end)) return {given};
    return {error == std::errc::too_many_symbolic_link_levels ? given : followed(given)};
#endif
}

QString nameOf(const fs::path& path) {
    return pathOf(QByteArray::fromStdString(path.string()));
}

// The shortest beginning of the path about which nothing can be known.
fs::path closedPart(const fs::path& path) {
    fs::path at;
    for (const fs::path& part : path) {
        at /= part;
        std::error_code error;
        if (fs::status(at, error).type() == fs::file_type::none) break;
    }
    return at;
}

QString leadsNowhere(const QString& link) {
    return Text::tr("“%1” is a symbolic link that leads back to itself, or through too many others.")
        .arg(shown(link));
}

// Why nothing can be known of what the path leads to, if that is so for reasons that the user can change.
Failure whyClosed(const fs::path& path) {
    std::error_code error;
    if (fs::status(path, error).type() != fs::file_type::none) return std::nullopt;
    const QString name = nameOf(closedPart(path));
    if (error == std::errc::too_many_symbolic_link_levels) return leadsNowhere(name);
    if (error == std::errc::permission_denied)
        return Text::tr("You do not have permission to enter the folder “%1”.")
            .arg(shown(QFileInfo(name).absolutePath()));
    return std::nullopt;
}

// The sentence, and what becomes of the file that is there, if one is.
QString butKept(const QString& sentence, const QString& path) {
    const bool isThere = QFileInfo::exists(path);
    return isThere ? sentence + u' ' + Text::tr("The file on disk is unchanged.") : sentence;
}

QString notSaved(const QString& path, const QString& why) {
    return butKept(Text::tr("“%1” was not saved: %2.").arg(shown(path), why), path);
}

// Why the end of the links cannot be known, if that is so for reasons that the user can change.
Failure whyClosed(const End& end) {
    if (!end.isRefused) return whyClosed(end.file);
    const fs::path hidden = followed(end.file);
    const Failure closed = endsInLink(hidden) ? std::nullopt : whyClosed(hidden); // folder on the way
    if (closed) return closed;
    return Text::
        tr("The system does not follow the symbolic link “%1”, because another user may have put it there. "
           "Choose another name.")
            .arg(shown(nameOf(end.file)));
}

Failure obstacle(const End& end) {
    const fs::path& target = end.file;
    const QString path = nameOf(target);
    if (path.isEmpty()) return Text::tr("The file has no name. Choose one.");
    if (const Failure closed = whyClosed(end)) return closed;
    std::error_code error;
    const fs::file_status file = fs::status(target, error);
    const bool isUnknown = file.type() == fs::file_type::none && error != std::errc::filename_too_long;
    if (isUnknown) return notSaved(path, QString::fromLocal8Bit(error.message().c_str()));
    if (!fs::exists(file) && fs::is_symlink(fs::symlink_status(target, error))) return leadsNowhere(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (fs::is_directory(file)) return Text::tr("“%1” is a folder. Choose a file name.").arg(shown(path));
    if (fs::exists(file) && !fs::is_regular_file(file))
        return Text::tr("“%1” is not a regular file and will not be replaced. Choose another name.")
            .arg(shown(path));
    if (!fs::is_directory(folder, error))
        return Text::tr("The folder “%1” does not exist. Create it, or save somewhere else.")
            .arg(shown(QFileInfo(path).absolutePath()));
    if (fs::exists(file) && !isWritable(target))
        return Text::tr("“%1” is read-only. Save under another name, or change its permissions.")
            .arg(shown(path));
    return std::nullopt;
}

QString reason(const SystemError& error, const QString& path) {
    const QString folder = shown(QFileInfo(path).absolutePath());
    switch (error.kind) {
    case SystemError::Kind::DiskFull:
        return butKept(Text::tr("“%1” was not saved: the disk is full. Free some space and save again.")
                           .arg(shown(path)),
                       path);
    case SystemError::Kind::Denied:
        return Text::tr("“%1” was not saved: you do not have permission to write to the folder “%2”. Save "
                        "somewhere else.")
            .arg(shown(path), folder);
    case SystemError::Kind::NameTooLong:
        return Text::tr("“%1” was not saved: the name is too long.").arg(shown(path));
    case SystemError::Kind::None:
    case SystemError::Kind::Other:
        break;
    }
    return notSaved(path, error.text);
}

} // namespace

NewFile::NewFile(const QString& path) {
    if (path == standardOutputPath()) {
        m_waiting = namelessFile();
        if (m_waiting < 0)
            fail();
        else
            setOpenMode(ReadWrite | Unbuffered);
        return;
    }
    const End end = target(path);
    m_path = nameOf(end.file);
    m_failure = isLost(path) ? notUtf8(path) : obstacle(end);
    if (m_failure) return;
    m_replacement = std::make_unique<ReplacementFile>(end.file);
    if (m_replacement->error().kind == SystemError::Kind::None)
        setOpenMode(ReadWrite | Unbuffered);
    else
        fail();
}

NewFile::~NewFile() {
    if (m_waiting >= 0) ::close(m_waiting);
}

void NewFile::fail() {
    if (!m_failure) m_failure = m_replacement ? reason(m_replacement->error(), m_path) : cannotPrint(errno);
}

bool NewFile::seek(qint64 position) {
    if (position >= 0 && QIODevice::seek(position)) return true;
    if (!m_failure) {
        const QString why = QString::fromLocal8Bit(std::strerror(EINVAL));
        m_failure = m_waiting < 0 ? notSaved(m_path, why) : cannotPrint(EINVAL);
        setErrorString(*m_failure);
    }
    return false;
}

qint64 NewFile::readData(char* data, qint64 size) {
    qint64 count = 0;
    if (m_waiting < 0) {
        count = m_replacement->read(pos(), data, size);
    } else {
        do
            count = ::pread(m_waiting, data, std::size_t(size), off_t(pos()));
        while (count < 0 && errno == EINTR);
    }
    // Sets the failure, since callers that read their own output may ignore the result, as FFmpeg's writer of
    // MP4 does.
    if (count < 0) fail();
    return count;
}

qint64 NewFile::writeData(const char* data, qint64 size) {
    bool isWritten = m_waiting < 0 && m_replacement->write(pos(), data, size);
    for (qint64 done = 0; m_waiting >= 0 && done < size && !isWritten;) {
        const ssize_t piece = ::pwrite(m_waiting, data + done, std::size_t(size - done), off_t(pos() + done));
        if (piece < 0 && errno != EINTR) break;
        done += std::max<ssize_t>(piece, 0);
        isWritten = done == size;
    }
    if (isWritten || size == 0) return size;
    fail();
    setErrorString(*m_failure);
    return -1;
}

Failure NewFile::commit() {
    if (!m_failure && !(m_waiting < 0 ? m_replacement->replaceTarget() : printFile(m_waiting))) fail();
    return m_failure;
}

Failure saveFile(const QString& path, const QByteArray& bytes) {
    NewFile file(path);
    if (!file.failure()) file.write(bytes);
    return file.commit();
}

namespace {

using Opening = document::Opened(QFile& file, const QString& path);

document::Opened openAny(QFile& file, const QString& path) {
    const auto open = [&] {
        if (isUtf8Name(path)) return file.open(QIODevice::ReadOnly);
        const int descriptor = ::open(nativeName(path).constData(), O_RDONLY | O_CLOEXEC);
        return descriptor >= 0 && file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle);
    };
    if (open()) return {};
    return {document::Opened::State::Closed, file.errorString()};
}

document::Opened openRegular(QFile& file, const QString& path) {
    return path.startsWith(u':') ? openAny(file, path) : document::openRegular(file, nativeName(path));
}

Loaded load(const QString& path, Opening* open) {
    const fs::path native(nativeName(path).toStdString());
    std::error_code error; // ignored: unreadable paths count as missing
    if (isLost(path)) return {{}, notUtf8(path)};
    const bool isResource = path.startsWith(u':');
    if (const Failure closed = isResource ? std::nullopt : whyClosed(target(path))) return {{}, closed};
    const fs::file_status status = fs::status(native, error);
    const bool isUnknown =
        status.type() == fs::file_type::none && error != std::errc::filename_too_long && !isResource;
    if (isUnknown)
        return {{},
                Text::tr("“%1” cannot be read: %2.")
                    .arg(shown(path), QString::fromLocal8Bit(error.message().c_str()))};
    if (!isResource && !fs::exists(status)) return {{}, Text::tr("“%1” does not exist.").arg(shown(path))};
    if (fs::is_directory(native, error))
        return {{}, Text::tr("“%1” is a folder, not a file.").arg(shown(path))};
    const QString tooLarge =
        Text::tr("“%1” is larger than 256 MB, which is the limit for a file.").arg(shown(path));
    const qint64 size = fs::is_regular_file(native, error) ? qint64(fs::file_size(native, error)) : 0;
    if (size > maxFile) return {{}, tooLarge};
    QFile file(path);
    const document::Opened opened = open(file, path);
    if (opened.isSpecial())
        return {{}, Text::tr("“%1” is not a regular file and cannot be opened.").arg(shown(path))};
    if (!opened.isOpen()) return {{}, Text::tr("“%1” cannot be read: %2.").arg(shown(path), opened.error)};
    Loaded loaded;
    // Initial size: pipes do not know theirs, and one read of the limit would reserve as much memory.
    const qint64 expected = std::max<qint64>(size, 1 << 16);
    while (loaded.bytes.size() <= maxFile) {
        const QByteArray piece = file.read(expected);
        if (piece.isEmpty()) break;
        loaded.bytes += piece;
    }
    if (file.error() != QFileDevice::NoError)
        return {{}, Text::tr("“%1” cannot be read: %2.").arg(shown(path), file.errorString())};
    if (loaded.bytes.size() > maxFile) return {{}, tooLarge};
    return loaded;
}

} // namespace

Loaded loadFile(const QString& path) {
    return load(path, &openRegular);
}

Loaded loadSource(const QString& path) {
    return load(path, &openAny);
}

} // namespace io
