// SPDX-License-Identifier: MIT
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>

namespace document {

// Files that belong to the process that made them for as long as it lives, and to whoever comes first after
// that: windows and processes at the same time never use the same one.

// The lock of such a file, which lies beside it and is removed with this.
class ProcessLock {
public:
    ~ProcessLock();
    ProcessLock(const ProcessLock&) = delete;
    ProcessLock& operator=(const ProcessLock&) = delete;

private:
    friend std::unique_ptr<ProcessLock> processLock(const QString& path);
    ProcessLock() = default;

    QString m_path;
    int m_file = -1;                     // open file descriptor, which holds the system's lock
    std::unique_ptr<QLockFile> m_byName; // fallback if the system cannot lock files
};

// nullptr while another process, or another lock of this one, has it, and where it cannot be made.
std::unique_ptr<ProcessLock> processLock(const QString& path);
QString lockFileOf(const QString& path);

// Creates the folder, and those above it, where they are missing; only its owner may enter it and what was
// created.
void makePrivateFolder(const QString& folder);

} // namespace document
