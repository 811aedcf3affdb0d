// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "io/video/video_system.h"
#include "io/video/video_writer.h"
#include "support/named_test.h"

#include <QFile>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

// The text in a video: written, read, and damaged in every way.
class VideoSystemTest : public QObject {
    Q_OBJECT

private slots:
    void textsComeBack_data();
    void textsComeBack();
    void damageIsNeverBelieved_data();
    void damageIsNeverBelieved();
    void otherFilesCarryNothing_data();
    void otherFilesCarryNothing();
    void lengthsAreNotTrusted_data();
    void lengthsAreNotTrusted();
    void settingsThatNoFormatHasAreRefused();
};

namespace {

void formats() {
    QTest::addColumn<QString>("suffix");
    for (const char* suffix : {"mp4", "webm", "mkv", "gif", "webp", "apng"})
        QTest::newRow(suffix) << QString::fromLatin1(suffix);
}

QByteArray video(const QString& suffix, const QByteArray& text) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("v.") + suffix);
    io::VideoSettings settings;
    settings.format = *io::videoFormat(suffix);
    settings.width = 32;
    settings.height = 16;
    settings.systemText = text;
    io::VideoWriter writer(path, settings);
    QImage picture(32, 16, QImage::Format_RGB32);
    for (const QColor colour : {Qt::red, Qt::blue, Qt::black}) {
        picture.fill(colour);
        if (writer.writeFrame(picture)) return {};
    }
    if (writer.finish()) return {};
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray textIn(const QByteArray& bytes) {
    const auto file = io::readCollection(bytes).file;
    return file.entries.isEmpty() ? QByteArray() : file.entries.first().fractal->name.toUtf8();
}

const QByteArray entry = "wind {\n; barycage: gamma 3\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";

} // namespace

void VideoSystemTest::textsComeBack_data() {
    formats();
}

void VideoSystemTest::textsComeBack() {
    QFETCH(QString, suffix);
    const QByteArray large = QByteArray("ü & <é> \"{}\" \\ ; … 分形\n").repeated(20'000);
    for (const QByteArray& text : {entry, QByteArray("x"), large}) {
        const QByteArray bytes = video(suffix, text);
        QVERIFY(!bytes.isEmpty());
        QCOMPARE(video(suffix, text), bytes);
        if (suffix == u"apng") continue; // a PNG picture
        QCOMPARE(io::looksLikeVideo(bytes), suffix);
        const io::EmbeddedSystem system = io::readVideoSystem(bytes);
        QVERIFY(!system.failure);
        QCOMPARE(system.text, text);
    }
    QCOMPARE(textIn(video(suffix, entry)), QByteArray("wind"));
}

void VideoSystemTest::damageIsNeverBelieved_data() {
    formats();
}

// Nothing crashes, and what is read is the text or a failure.
void VideoSystemTest::damageIsNeverBelieved() {
    QFETCH(QString, suffix);
    if (suffix == u"apng") return;
    const QByteArray whole = video(suffix, entry);
    for (qsizetype size = 0; size < whole.size(); ++size) {
        const io::EmbeddedSystem system = io::readVideoSystem(whole.first(size));
        QVERIFY(system.failure ? system.text.isEmpty() : system.text == entry);
    }
    QRandomGenerator random(7);
    for (int n = 0; n < 4000; ++n) {
        QByteArray damaged = whole;
        for (int k = 0; k <= n % 4; ++k)
            damaged[random.bounded(int(whole.size()))] = char(random.bounded(256));
        const io::EmbeddedSystem system = io::readVideoSystem(damaged);
        QVERIFY(!system.failure || system.text.isEmpty());
        QVERIFY(system.text.size() <= whole.size());
    }
}

void VideoSystemTest::otherFilesCarryNothing_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("text") << entry;
    for (const char* suffix : {"mp4", "webm", "mkv", "gif", "webp"})
        QTest::addRow("%s without text", suffix) << video(QString::fromLatin1(suffix), {});
}

void VideoSystemTest::otherFilesCarryNothing() {
    QFETCH(QByteArray, bytes);
    const io::EmbeddedSystem system = io::readVideoSystem(bytes);
    QVERIFY(system.failure && !system.failure->isEmpty());
    QVERIFY(system.text.isEmpty());
}

void VideoSystemTest::lengthsAreNotTrusted_data() {
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char* name, const char* bytes, qsizetype size) {
        QTest::newRow(name) << QByteArray(bytes, size);
    };
    row("a box without end", "\0\0\0\1ftyp\xff\xff\xff\xff\xff\xff\xff\xff", 16);
    row("a box of nothing", "\0\0\0\4ftypisom\0\0\0\0", 16);
    row("an element without end", "\x1a\x45\xdf\xa3\x01\xff\xff\xff\xff\xff\xff\xff\x18\x53\x80\x67\xff", 17);
    row("a number without end", "\x1a\x45\xdf\xa3\x00", 5);
    row("an image without end", "GIF89a\1\0\1\0\0\0\0,\0\0\0\0\1\0\1\0\0\2\xff", 25);
    row("a colour table without end", "GIF89a\1\0\1\0\xf7\0\0", 13);
    row("a chunk without end", "RIFF\xff\xff\xff\xffWEBPXMP \xff\xff\xff\xff", 20);
    QTest::newRow("boxes in boxes") << "\0\0\0\x10"
                                       "ftypisom\0\0\0\0" +
                                           QByteArray("\0\1\0\0moov", 8).repeated(10'000);
    QTest::newRow("empty blocks") << QByteArray("GIF89a\1\0\1\0\0\0\0", 13) +
                                         QByteArray("!\xfe\0", 3).repeated(1'000'000);
    QTest::newRow("empty elements") << QByteArray("\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\xff", 10) +
                                           QByteArray("\x12\x54\xc3\x67\x80").repeated(1'000'000);
}

void VideoSystemTest::lengthsAreNotTrusted() {
    QFETCH(QByteArray, bytes);
    QVERIFY(io::readVideoSystem(bytes).failure);
    QVERIFY(io::readCollection(bytes).file.entries.isEmpty());
}

void VideoSystemTest::settingsThatNoFormatHasAreRefused() {
    io::VideoSettings settings;
    QVERIFY(!io::videoObstacle(settings));
    settings.width = 20'000;
    QVERIFY(io::videoObstacle(settings));
    settings.width = 100;
    settings.format = io::VideoFormat::Gif;
    settings.rate = {50, 1};
    QVERIFY(!io::videoObstacle(settings));
    settings.rate = {50'001, 1000};
    QVERIFY(io::videoObstacle(settings));
    QVERIFY(!io::videoFormat(QStringLiteral("avi")) && io::videoFormat(QStringLiteral("WebM")));
}

BARYCAGE_TEST(VideoSystemTest, QCoreApplication);
#include "video_system_test.moc"
