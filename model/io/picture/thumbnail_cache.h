// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/work_in_order.h"
#include "document/fractal/fractal.h"

#include <QImage>
#include <QString>

#include <memory>

namespace io {

// Small pictures of fractals in a folder, found again by their content. The folder is kept below a size: the
// pictures unused for longest go first, when pictures are added. If the disk fails in any way, pictures are
// drawn again.
class ThumbnailCache {
public:
    // The folder of this user, below that for caches of the desktop.
    static QString usualFolder();

    explicit ThumbnailCache(const QString& folder, qint64 maxBytes = 64 * 1024 * 1024);

    // Null when there is none. What stands for "nothing to draw" is 1 × 1.
    QImage find(const document::Fractal& fractal, int side) const;
    void keep(const document::Fractal& fractal, int side, const QImage& picture);

private:
    QString pathOf(const document::Fractal& fractal, int side) const;
    void makeRoom(qint64 added);

    QString m_folder;
    qint64 m_maxBytes;
    qint64 m_bytes = -1; // approximate bytes in the folder; −1: unknown
};

// The same for a thread that has to go on: what the disk does not answer soon counts as not there, and
// nothing is asked or kept until it has answered.
class ImpatientCache {
public:
    explicit ImpatientCache(std::unique_ptr<ThumbnailCache> cache);

    QImage find(const std::shared_ptr<const document::Fractal>& fractal, int side);
    void keep(const std::shared_ptr<const document::Fractal>& fractal, int side, const QImage& picture);

private:
    struct Search;
    bool isLate();

    std::shared_ptr<ThumbnailCache> m_cache; // guarded: one thread at a time
    document::WorkInOrder m_disk;
    std::shared_ptr<Search> m_late;
};

} // namespace io
