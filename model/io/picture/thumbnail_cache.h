// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QImage>
#include <QString>

namespace io {

// Small pictures of fractals in a folder, found again by what they show. The folder is kept below a size:
// what was not looked at for longest goes first, when pictures are added. Whatever goes wrong with the disk,
// pictures are drawn again.
class ThumbnailCache {
public:
    // Of this user, below the folder for caches of the desktop.
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
    qint64 m_bytes = -1; // in the folder, about; −1 until it was looked at
};

} // namespace io
