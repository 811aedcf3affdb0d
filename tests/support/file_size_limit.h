// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace support {

// No file of this process can grow beyond the size, as on a full disk, until lift() or the end of the scope.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        if (::getrlimit(RLIMIT_FSIZE, &m_before) != 0) return;
        rlimit limit = m_before;
        limit.rlim_cur = bytes;
        m_isSet = ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        lift();
        std::signal(SIGXFSZ, m_handler);
    }

    bool isSet() const { return m_isSet; }
    void lift() {
        if (m_isSet) m_isSet = ::setrlimit(RLIMIT_FSIZE, &m_before) != 0;
    }

private:
    rlimit m_before{};
    void (*m_handler)(int);
    bool m_isSet = false;
};

} // namespace support
