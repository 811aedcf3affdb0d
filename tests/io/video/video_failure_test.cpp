// SPDX-License-Identifier: MIT
#include "io/video/video_writer.h"
#include "support/named_test.h"
#include "support/refusing_kernel.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

// A video is written by a library that reads back some of what it wrote, and does not pass on every error.
class VideoFailureTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { support::readsFail = false; }
    void failedReadsLeaveTheOldFile_data();
    void failedReadsLeaveTheOldFile();
};

void VideoFailureTest::failedReadsLeaveTheOldFile_data() {
    QTest::addColumn<bool>("readsBack");
    for (const char* suffix : {"mp4", "gif", "webp", "apng"})
        QTest::newRow(suffix) << true;
    for (const char* suffix : {"webm", "mkv"})
        QTest::newRow(suffix) << false;
}

void VideoFailureTest::failedReadsLeaveTheOldFile() {
    QFETCH(bool, readsBack);
    const QString suffix = QString::fromLatin1(QTest::currentDataTag());
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("v.") + suffix);
    QFile old(path);
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    io::VideoSettings settings;
    settings.format = *io::videoFormat(suffix);
    settings.width = 32;
    settings.height = 16;
    settings.systemText = "x";
    io::VideoWriter writer(path, settings);
    QImage picture(32, 16, QImage::Format_RGB32);
    for (const QColor colour : {Qt::red, Qt::blue, Qt::black}) {
        picture.fill(colour);
        QVERIFY(!writer.writeFrame(picture));
    }
    QVERIFY(!writer.failure()); // all frames are encoded
    support::failedReads = 0;
    support::readsFail = true;
    const io::Failure failure = writer.finish();
    support::readsFail = false;
    if (readsBack) QVERIFY(support::failedReads > 0);
    QCOMPARE(failure.has_value(), support::failedReads > 0);
    QCOMPARE(contents(path) == "old", failure.has_value());
}

BARYCAGE_TEST(VideoFailureTest, QCoreApplication);
#include "video_failure_test.moc"
