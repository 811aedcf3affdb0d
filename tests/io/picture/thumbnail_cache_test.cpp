// SPDX-License-Identifier: MIT
#include "io/picture/thumbnail_cache.h"
#include "support/file_size_limit.h"
#include "support/named_test.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

class ThumbnailCacheTest : public QObject {
    Q_OBJECT

private slots:
    void findsByWhatIsShown();
    void survivesDamage();
    void aFullDiskLeavesNoPart();
    void staysBelowItsSize();
    void onlyTheOwnerMayLookInside();
};

namespace {

QImage picture(int side, QRgb colour) {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(colour);
    return image;
}

// Hardly to be compressed: every picture takes about its size in bytes.
QImage noise(int side, unsigned seed) {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            seed = seed * 1664525u + 1013904223u;
            image.setPixel(x, y, 0xff000000u | (seed >> 8));
        }
    return image;
}

document::Fractal shifted(double x) {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::system2(fractal)->maps[0].map.translation.x() = x;
    return fractal;
}

} // namespace

void ThumbnailCacheTest::findsByWhatIsShown() {
    const QTemporaryDir folder;
    document::Fractal fractal = document::sierpinskiTriangle();
    io::ThumbnailCache(folder.path()).keep(fractal, 16, picture(16, 0xff336699));
    const io::ThumbnailCache cache(folder.path());
    QCOMPARE(cache.find(fractal, 16), picture(16, 0xff336699));
    QVERIFY(cache.find(fractal, 32).isNull());
    fractal.name = QStringLiteral("another");
    fractal.comments << QStringLiteral(" said about it");
    QVERIFY(!cache.find(fractal, 16).isNull());
    fractal.appearance.gamma = 1.5;
    QVERIFY(cache.find(fractal, 16).isNull());
    QVERIFY(cache.find(shifted(0.125), 16).isNull());
}

// The first picture fits into the memory of a file, which is written when the file is closed.
void ThumbnailCacheTest::aFullDiskLeavesNoPart() {
    for (const int side : {16, 128}) {
        const QTemporaryDir folder;
        const QImage shown = noise(side, 1);
        io::ThumbnailCache(folder.path()).keep(shifted(0), side, shown);
        const QStringList before = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(before.size(), 1);
        support::FileSizeLimit full(300);
        QVERIFY(full.isSet());
        io::ThumbnailCache(folder.path()).keep(shifted(0), side, noise(side, 2));
        io::ThumbnailCache(folder.path()).keep(shifted(1), side, noise(side, 3));
        full.lift();
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), before);
        QCOMPARE(io::ThumbnailCache(folder.path()).find(shifted(0), side), shown);
    }
}

void ThumbnailCacheTest::survivesDamage() {
    const QTemporaryDir folder;
    io::ThumbnailCache cache(folder.path());
    cache.keep(shifted(0), 16, picture(16, 0xff336699));
    const QStringList files = QDir(folder.path()).entryList(QDir::Files);
    QCOMPARE(files.size(), 1);
    QFile file(folder.filePath(files.first()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not a picture");
    file.close();
    QVERIFY(cache.find(shifted(0), 16).isNull());
    cache.keep(shifted(0), 16, picture(16, 0xff112233));
    QCOMPARE(cache.find(shifted(0), 16), picture(16, 0xff112233));
    io::ThumbnailCache nowhere(QStringLiteral("/proc/no/such/folder"));
    nowhere.keep(shifted(0), 16, picture(16, 0xff112233));
    QVERIFY(nowhere.find(shifted(0), 16).isNull());
}

void ThumbnailCacheTest::staysBelowItsSize() {
    const QTemporaryDir folder;
    constexpr qint64 maxBytes = 40'000;
    io::ThumbnailCache cache(folder.path(), maxBytes);
    for (int i = 0; i < 30; ++i)
        cache.keep(shifted(i), 32, noise(32, unsigned(i)));
    qint64 bytes = 0;
    for (const QFileInfo& file : QDir(folder.path()).entryInfoList(QDir::Files))
        bytes += file.size();
    QVERIFY(bytes <= maxBytes);
    QVERIFY(bytes > maxBytes / 2);
    QVERIFY(!cache.find(shifted(29), 32).isNull());
}

// Whatever the umask, and when the folder is there already.
void ThumbnailCacheTest::onlyTheOwnerMayLookInside() {
    const QTemporaryDir parent;
    const QString folder = parent.filePath(QStringLiteral("cache/thumbnails"));
    const auto mode = [](const QString& path) {
        struct stat status = {};
        return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? status.st_mode & 07777U : ~0U;
    };
    const mode_t before = ::umask(0);
    io::ThumbnailCache(folder).keep(shifted(0), 16, picture(16, 0xff336699));
    ::umask(before);
    QCOMPARE(mode(folder), 0700U);
    QCOMPARE(::chmod(QFile::encodeName(folder).constData(), 0755), 0);
    io::ThumbnailCache again(folder);
    again.keep(shifted(1), 16, picture(16, 0xff336699));
    QCOMPARE(mode(folder), 0700U);
    QVERIFY(!again.find(shifted(0), 16).isNull());
}

BARYCAGE_TEST(ThumbnailCacheTest, QCoreApplication);
#include "thumbnail_cache_test.moc"
