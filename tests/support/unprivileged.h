// SPDX-License-Identifier: MIT
#pragma once

#include <QFile>
#include <QString>

#include <unistd.h>

namespace support {

// For root no file is read-only. During the lifetime of this object, a process of root runs as the user
// nobody, for the kernel and for access(), and the folder belongs to nobody too. For other users nothing
// changes.
class Unprivileged {
public:
    explicit Unprivileged(const QString& folder) {
        if (::geteuid() != 0) return;
        m_wasRoot = ::chown(QFile::encodeName(folder).constData(), nobody, nobody) == 0 &&
                    ::setresgid(nobody, nobody, 0) == 0 && ::setresuid(nobody, nobody, 0) == 0;
    }
    ~Unprivileged() {
        if (m_wasRoot && (::setresuid(0, 0, 0) != 0 || ::setresgid(0, 0, 0) != 0))
            qFatal("root could not become root again");
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;

    bool isInForce() const { return ::geteuid() != 0; }

private:
    static constexpr uid_t nobody = 65534;
    bool m_wasRoot = false;
};

} // namespace support
