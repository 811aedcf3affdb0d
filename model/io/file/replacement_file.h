// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <filesystem>
#include <memory>

namespace io {

// The reason why a system call failed.
struct SystemError {
    enum class Kind { None, DiskFull, Denied, NameTooLong, Other };
    Kind kind = Kind::None;
    QString text; // message of the system
};

// A new file in the folder of `target` that replaces it once it is complete. From the start it has the
// permissions, access control list and extended attributes of an old file there, and owner and group as far
// as we may set them; what others may not read is theirs at no moment. It has no name until then where the
// system can do that, so that nothing stays of it whatever ends the program; what has one is removed unless
// it replaces `target`.
class ReplacementFile {
public:
    explicit ReplacementFile(const std::filesystem::path& target);
    ~ReplacementFile();
    ReplacementFile(const ReplacementFile&) = delete;
    ReplacementFile& operator=(const ReplacementFile&) = delete;

    // The error of the last call, the constructor included.
    const SystemError& error() const { return m_error; }

    // Writes all of it, from a position on; false with an error.
    bool write(qint64 position, const char* data, qint64 size);
    // Reads at most `size` bytes that were written there; -1 with an error.
    qint64 read(qint64 position, char* data, qint64 size);

    // Flushes the bytes to the disk, then gives them the name; the folder is flushed as well. `target` holds
    // the old bytes or the new ones at every moment. False with an error: it holds the old ones.
    bool replaceTarget();

private:
    struct State;

    std::unique_ptr<State> m_state;
    SystemError m_error;
};

// Before the program ends in the middle of its work: removes the files that are being written and have a name
// already. Needs no memory and waits for nothing.
void removeUnfinished();

bool isWritable(const std::filesystem::path& file);

} // namespace io
