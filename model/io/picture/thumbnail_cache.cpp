// SPDX-License-Identifier: MIT
#include "io/picture/thumbnail_cache.h"

#include "document/disk/regular_file.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/decoding/picture_decoder.h"
#include "io/picture/png/png_check.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <chrono>
#include <future>
#include <utility>

namespace io {

namespace {

// Version of the pictures, to be raised when the same fractal is drawn differently.
constexpr char generation[] = "1 " BARYCAGE_VERSION;

QFileInfoList picturesIn(const QString& folder) {
    return QDir(folder).entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time | QDir::Reversed);
}

} // namespace

QString ThumbnailCache::usualFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
           QStringLiteral("/barycage/thumbnails");
}

ThumbnailCache::ThumbnailCache(const QString& folder, qint64 maxBytes)
    : m_folder(folder), m_maxBytes(maxBytes) {}

QString ThumbnailCache::pathOf(const document::Fractal& fractal, int side) const {
    document::Fractal shown = fractal; // without names, which change no pixel
    shown.name = QStringLiteral("x");
    shown.headerComment.clear();
    shown.comments.clear();
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray(generation) + ' ' + QByteArray::number(side) + '\n' + writeEntry(shown));
    return m_folder + QLatin1Char('/') + QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png");
}

QImage ThumbnailCache::find(const document::Fractal& fractal, int side) const {
    const QString path = pathOf(fractal, side);
    QFile file;
    if (!document::openRegular(file, QFile::encodeName(path)).isOpen()) return {};
    const auto fits = [side](const QSize& size) { return size == QSize(side, side) || size == QSize(1, 1); };
    const qint64 largest = qint64{8} * side * side + (1 << 16); // upper bound of the size of a file
    const QByteArray bytes = file.read(largest);
    if (!fits(pngSize(bytes))) return {};
    const QImage picture = decodedPicture(bytes).image;
    if (!fits(picture.size())) return {};
    file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
    return picture.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

void ThumbnailCache::keep(const document::Fractal& fractal, int side, const QImage& picture) {
    QBuffer png;
    if (!picture.save(&png, "PNG")) return;
    if (m_bytes < 0) { // first call; in this thread, because the GUI thread must not wait for the disk
        QDir().mkpath(m_folder);
        QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    // Renamed when complete, so that no reader sees a part. A cache need not survive a power cut.
    const QString path = pathOf(fractal, side);
    QFile file(path + QStringLiteral(".part"));
    if (!file.open(QIODevice::WriteOnly)) return;
    bool isWritten = file.write(png.data()) == png.size();
    file.close(); // writes buffered bytes
    isWritten = isWritten && file.error() == QFileDevice::NoError;
    if (isWritten) QFile::remove(path);
    if (isWritten && file.rename(path))
        makeRoom(png.size());
    else
        file.remove();
}

void ThumbnailCache::makeRoom(qint64 added) {
    if (m_bytes < 0) { // unknown; the new file is included
        m_bytes = 0;
        for (const QFileInfo& file : picturesIn(m_folder))
            m_bytes += file.size();
    } else {
        m_bytes += added;
    }
    if (m_bytes <= m_maxBytes) return;
    for (const QFileInfo& file : picturesIn(m_folder)) { // oldest first
        if (m_bytes <= m_maxBytes - m_maxBytes / 4) break;
        if (QFile::remove(file.filePath())) m_bytes -= file.size();
    }
}

struct ImpatientCache::Search {
    std::promise<QImage> found;
    std::future<QImage> answer = found.get_future();
};

ImpatientCache::ImpatientCache(std::unique_ptr<ThumbnailCache> cache)
    : m_cache(std::move(cache)), m_disk(document::Lane::Reading) {}

bool ImpatientCache::isLate() {
    if (m_late && m_late->answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        m_late.reset();
    return m_late != nullptr;
}

QImage ImpatientCache::find(const std::shared_ptr<const document::Fractal>& fractal, int side) {
    constexpr std::chrono::seconds patience(1);
    if (isLate()) return {};
    const auto search = std::make_shared<Search>();
    m_disk.start(
        [search, cache = m_cache, fractal, side] { search->found.set_value(cache->find(*fractal, side)); });
    if (search->answer.wait_for(patience) == std::future_status::ready) return search->answer.get();
    m_late = search;
    return {};
}

void ImpatientCache::keep(const std::shared_ptr<const document::Fractal>& fractal, int side,
                          const QImage& picture) {
    if (isLate()) return;
    m_disk.start([cache = m_cache, fractal, side, picture] { cache->keep(*fractal, side, picture); });
}

} // namespace io
