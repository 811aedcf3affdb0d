// SPDX-License-Identifier: MIT
#include "document/edits/timeline/motion_edits.h"
#include "io/animation/animation_export.h"
#include "io/video/video_writer.h"
#include "support/named_test.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

// What a program says that was built with BARYCAGE_VIDEO=OFF: the writer is compiled into this test so.
class NoVideoTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormatSaysWhatIsMissing();
    void nothingIsWritten();
    void picturesNeedNoLibraries();
};

namespace {

const QString words = QStringLiteral("does not include FFmpeg's libraries");

io::AnimationExport moving() {
    io::AnimationExport what;
    what.entry = *document::withPaletteCycle(document::sierpinskiTriangle());
    what.size = {32, 24};
    what.points = 1000;
    return what;
}

} // namespace

void NoVideoTest::everyFormatSaysWhatIsMissing() {
    for (const io::VideoFormat format : {io::VideoFormat::Mp4, io::VideoFormat::WebM, io::VideoFormat::Gif}) {
        io::AnimationExport what = moving();
        what.format = format;
        const io::Failure obstacle = io::animationObstacle(what);
        QVERIFY(obstacle);
        QVERIFY2(obstacle->contains(words), qPrintable(*obstacle));
        QVERIFY2(obstacle->contains(QStringLiteral("PNG")), qPrintable(*obstacle)); // what can be done
    }
}

void NoVideoTest::nothingIsWritten() {
    const QTemporaryDir folder;
    io::VideoSettings settings;
    settings.width = 32;
    settings.height = 24;
    io::VideoWriter writer(folder.filePath(QStringLiteral("a.mp4")), settings);
    QVERIFY(writer.failure() && writer.failure()->contains(words));
    QVERIFY(writer.writeFrame(QImage(32, 24, QImage::Format_RGB32)).has_value());
    QVERIFY(writer.finish().has_value());
    QVERIFY(QDir(folder.path()).isEmpty());
}

void NoVideoTest::picturesNeedNoLibraries() {
    const QTemporaryDir folder;
    const io::AnimationExport what = moving();
    QVERIFY(!io::animationObstacle(what));
    const io::ExportOutcome outcome = io::exportAnimation(what, folder.filePath(QStringLiteral("a.png")));
    QVERIFY(!outcome.failure && !outcome.stopped);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("a.0001.png")});
}

BARYCAGE_TEST(NoVideoTest, QCoreApplication);
#include "no_video_test.moc"
