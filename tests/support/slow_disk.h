// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include <chrono>

namespace support {

// A drive that answers late: while this lives, every call to the system that names a file below `folder` and
// comes from another thread waits. Those of the thread that made this are noted instead. One at a time.
class SlowDisk {
public:
    SlowDisk(const QString& folder, std::chrono::milliseconds delay);
    ~SlowDisk();
    SlowDisk(const SlowDisk&) = delete;
    SlowDisk& operator=(const SlowDisk&) = delete;

    // Calls of this thread since the last time this was asked, such as “stat /mnt/a.ifs from view::f()”.
    QStringList takeNoted();
    void answer();      // at once from now on, also to the calls that wait
    int waited() const; // how many calls of other threads have waited or are waiting
};

} // namespace support
