// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/picture/plane_export.h"
#include "io/picture/png/png_system.h"
#include "support/named_test.h"

#include <QColorSpace>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace io;

namespace {

PlaneExport picture(int width, int height) {
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    PlaneExport result;
    result.fractal = document::sierpinskiTriangle();
    result.request = document::renderRequest(result.fractal, fitted(camera, {0, 0}, {1, 0.9}));
    result.request.samples = 3'000'000;
    result.request.threads = 2;
    return result;
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class PlaneExportTest : public QObject {
    Q_OBJECT

private slots:
    void bandsGiveTheSameFile();
    void theClipboardsPictureIsTheSame();
    void progressGrowsToTheEnd();
    void stoppingLeavesNothing();
    void aPictureIsSavedAsOtherFilesAre();
    void memoryIsThatOfABand();

private:
    QByteArray exported(const PlaneExport& what) {
        const QString path = m_folder.filePath(QStringLiteral("a.png"));
        const ExportOutcome outcome = exportPlane(what, path);
        return outcome.failure || outcome.stopped ? QByteArray() : bytesOf(path);
    }
    QTemporaryDir m_folder;
};

void PlaneExportTest::bandsGiveTheSameFile() {
    for (const auto depth : {PictureFormat::Depth::Bits8, PictureFormat::Depth::Bits16})
        for (const auto cage : {CageVisibility::Hidden, CageVisibility::Shown}) {
            PlaneExport what = picture(300, 211);
            what.depth = depth;
            what.cage = cage;
            const QByteArray whole = exported(what);
            QVERIFY(!whole.isEmpty());
            what.bandBytes = 7 * attractor::BandedRendering::bytesPerRow(what.request);
            QVERIFY(exported(what) == whole);
            const QImage image = QImage::fromData(whole, "PNG");
            QCOMPARE(image.depth(), depth == PictureFormat::Depth::Bits16 ? 64 : 32);
            QVERIFY(!readPngSystem(whole).failure);
        }
}

void PlaneExportTest::theClipboardsPictureIsTheSame() {
    const PlaneExport what = picture(300, 211);
    QImage file = QImage::fromData(exported(what), "PNG").convertToFormat(QImage::Format_RGB32);
    file.setColorSpace({});
    QCOMPARE(drawPicture(what).image.convertToFormat(QImage::Format_RGB32), file);
}

void PlaneExportTest::progressGrowsToTheEnd() {
    PlaneExport what = picture(200, 150);
    what.bandBytes = 20 * attractor::BandedRendering::bytesPerRow(what.request);
    double told = 0;
    int calls = 0;
    const auto outcome = exportPlane(what, m_folder.filePath(QStringLiteral("b.png")), [&](double fraction) {
        QVERIFY(fraction >= told && fraction <= 1);
        told = fraction;
        ++calls;
    });
    QVERIFY(!outcome.failure);
    QVERIFY(told > 0.95);
    QVERIFY(calls > 16);
}

void PlaneExportTest::stoppingLeavesNothing() {
    PlaneExport what = picture(200, 150);
    what.bandBytes = 20 * attractor::BandedRendering::bytesPerRow(what.request);
    const QString path = m_folder.filePath(QStringLiteral("never.png"));
    for (const double when : {0.0, 0.3, 0.85}) {
        std::stop_source stop;
        const auto outcome = exportPlane(
            what, path,
            [&](double fraction) {
                if (fraction >= when) stop.request_stop();
            },
            stop.get_token());
        QVERIFY(outcome.stopped);
        QVERIFY(!outcome.failure);
        QVERIFY(!QFile::exists(path));
    }
}

// Symbolic links and permissions stay, and what is no ordinary file is refused before anything is drawn.
void PlaneExportTest::aPictureIsSavedAsOtherFilesAre() {
    const PlaneExport what = picture(20, 15);
    const QString path = m_folder.filePath(QStringLiteral("kept.png"));
    const QString link = m_folder.filePath(QStringLiteral("link.png"));
    QVERIFY(!exportPlane(what, path).failure);
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
    QVERIFY(QFile::link(path, link));
    const QByteArray before = bytesOf(path);
    QVERIFY(QFile::resize(path, 0));
    QVERIFY(!exportPlane(what, link).failure);
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(bytesOf(path), before);
    QVERIFY(!(QFile::permissions(path) & (QFile::ReadGroup | QFile::ReadOther)));
    bool hasBegun = false;
    const auto outcome = exportPlane(what, m_folder.path(), [&](double) { hasBegun = true; });
    QVERIFY(outcome.failure && outcome.failure->contains(QStringLiteral("is a folder")));
    QVERIFY(!hasBegun);
}

void PlaneExportTest::memoryIsThatOfABand() {
    PlaneExport what = picture(30'000, 30'000);
    QVERIFY(memoryFor(what) < 400U << 20);
    what.depth = PictureFormat::Depth::Bits16;
    what.request.appearance.supersample = 4;
    QVERIFY(memoryFor(what) < 400U << 20);
    QVERIFY(memoryFor(picture(300, 200)) < 4U << 20);
}

BARYCAGE_TEST(PlaneExportTest, QGuiApplication);
#include "plane_export_test.moc"
