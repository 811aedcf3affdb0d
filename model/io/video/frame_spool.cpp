// SPDX-License-Identifier: MIT
#include "io/video/frame_spool.h"

#include "document/text/text.h"
#include "io/file/standard_output.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace io {

FrameSpool::FrameSpool() : m_file(namelessFile()) {}

FrameSpool::~FrameSpool() {
    if (m_file >= 0) ::close(m_file);
}

Failure FrameSpool::add(const QImage& picture) {
    constexpr int fast = 1;
    const QByteArray packed = qCompress(picture.constBits(), picture.sizeInBytes(), fast);
    m_size = picture.size();
    const qint64 begin = m_ends.empty() ? 0 : m_ends.back();
    for (qint64 done = 0; done < packed.size();) {
        const ssize_t count = ::pwrite(m_file, packed.constData() + done, std::size_t(packed.size() - done),
                                       off_t(begin + done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0)
            return Text::tr("The folder for temporary files does not have enough space for the frames: %1.")
                .arg(QString::fromLocal8Bit(std::strerror(errno)));
        done += count;
    }
    m_ends.push_back(begin + packed.size());
    return std::nullopt;
}

QImage FrameSpool::read(int index) const {
    const auto at = std::size_t(index);
    const qint64 begin = at == 0 ? 0 : m_ends[at - 1];
    QByteArray packed(m_ends[at] - begin, Qt::Uninitialized);
    for (qint64 done = 0; done < packed.size();) {
        const ssize_t count =
            ::pread(m_file, packed.data() + done, std::size_t(packed.size() - done), off_t(begin + done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return {};
        done += count;
    }
    QImage picture(m_size, QImage::Format_ARGB32);
    const QByteArray pixels = qUncompress(packed);
    if (picture.isNull() || pixels.size() != picture.sizeInBytes()) return {};
    std::memcpy(picture.bits(), pixels.constData(), std::size_t(pixels.size()));
    return picture;
}

} // namespace io
