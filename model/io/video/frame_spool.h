// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"

#include <QImage>

#include <vector>

namespace io {

// Pictures that wait, compressed, in a file without a name: nothing of it stays whatever ends the program.
class FrameSpool {
public:
    FrameSpool();
    ~FrameSpool();
    FrameSpool(const FrameSpool&) = delete;
    FrameSpool& operator=(const FrameSpool&) = delete;

    Failure add(const QImage& picture); // requires ARGB32 pictures of one size
    int count() const { return int(m_ends.size()); }
    QImage read(int index) const; // null if it cannot be read

private:
    int m_file;
    std::vector<qint64> m_ends; // end of each frame in the file
    QSize m_size;
};

} // namespace io
