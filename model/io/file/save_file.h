// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QString>

#include <memory>
#include <optional>

namespace io {

class ReplacementFile;

// The user's sentence when something went wrong; nullopt on success.
using Failure = std::optional<QString>;

// The one way in which files of the user are written: into a temporary file in the same folder, which
// commit() flushes to the disk and renames: `path` holds the old bytes or the new ones, never a part.
// Permissions, access control lists, extended attributes and a symbolic link at `path` are kept, unless the
// system refuses to follow the link; what is no ordinary file is not replaced. commit() refuses after any
// read, write or seek that failed, whether or not its caller noticed. It is open from the start, unless
// failure() says why not; what is not committed leaves nothing behind. Until then, seek() and read() work as
// on any file.
class NewFile : public QIODevice {
public:
    explicit NewFile(const QString& path); // `path` may be standardOutputPath()
    ~NewFile() override;

    const Failure& failure() const { return m_failure; } // first failure
    [[nodiscard]] Failure commit();
    bool seek(qint64 position) override;

protected:
    qint64 readData(char* data, qint64 maxSize) override;
    qint64 writeData(const char* data, qint64 size) override;

private:
    void fail();

    QString m_path; // path behind symbolic links
    std::unique_ptr<ReplacementFile> m_replacement;
    int m_waiting = -1; // descriptor of a file without a name, for standard output; −1: none
    Failure m_failure;
};

// Saves all bytes at once.
Failure saveFile(const QString& path, const QByteArray& bytes);

struct Loaded {
    QByteArray bytes;
    Failure failure;
};
// Both refuse more than 256 MB with a message.
Loaded loadFile(const QString& path);   // refuses files that are not regular, which might never end
Loaded loadSource(const QString& path); // named by a user of the command line, who may give a pipe

} // namespace io
