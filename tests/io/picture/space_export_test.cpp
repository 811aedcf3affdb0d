// SPDX-License-Identifier: MIT
#include "io/picture/space_export.h"

#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace io;

namespace {

SpaceExport spongeSeen(attractor::LookInSpace look, attractor::Look solid) {
    SpaceExport picture;
    auto& shape = picture.fractal.shape.emplace<document::Shape<3>>();
    shape.system = systems::menger();
    picture.fractal.name = QStringLiteral("sponge");
    picture.request = systems::spaceRequest(shape.system, 60, 200, 30, 20);
    picture.look = look;
    picture.solid = attractor::appearanceOf(solid);
    return picture;
}

QByteArray encoded(const SpaceExport& picture) {
    QByteArray bytes;
    const ExportOutcome outcome = drawSpaceFile(picture, bytes);
    return outcome.failure || outcome.stopped ? QByteArray() : bytes;
}

} // namespace

// A solid is drawn and written some rows at a time, whatever lies over it or beside it.
class SpaceExportTest : public QObject {
    Q_OBJECT

private slots:
    void bandsMakeNoDifference_data() {
        using attractor::LookInSpace;
        QTest::addColumn<SpaceExport>("picture");
        const SpaceExport stone = spongeSeen(LookInSpace::Stone, attractor::Look::Stone);
        QTest::newRow("plain") << stone;
        QTest::newRow("depths") << spongeSeen(LookInSpace::Depth, attractor::Look::Depth);
        SpaceExport changed = stone;
        changed.stereo = Stereo::SideBySide;
        QTest::newRow("stereo") << changed;
        changed.stereo = Stereo::Anaglyph;
        changed.depth = PictureFormat::Depth::Bits16;
        QTest::newRow("anaglyph") << changed;
        changed = stone;
        changed.moments = {stone.request, stone.request};
        changed.moments.back().camera.target.x() += 0.1;
        QTest::newRow("moments") << changed;
        changed = stone;
        changed.legend = QImage(30, 200, QImage::Format_ARGB32_Premultiplied);
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 30; ++x)
                changed.legend.setPixel(x, y, qRgb(x, y, 255 - y));
        QTest::newRow("legend") << changed;
        changed = stone;
        changed.page = ShapeFile::Svg;
        QTest::newRow("page") << changed;
    }

    void bandsMakeNoDifference() {
        QFETCH(SpaceExport, picture);
        const QByteArray whole = encoded(picture);
        QVERIFY(!whole.isEmpty());
        picture.bandBytes = 1;
        QVERIFY(encoded(picture) == whole);
    }

    void aHugeSolidNeedsLittleMemory() {
        SpaceExport picture = spongeSeen(attractor::LookInSpace::Stone, attractor::Look::Stone);
        picture.request.camera.size = {60'000, 60'000};
        QVERIFY(memoryFor(picture) < 1ULL << 30);
        picture.look = attractor::LookInSpace::Depth;
        QVERIFY(memoryFor(picture) < 1ULL << 30);
        picture.look = attractor::LookInSpace::Cloud; // which is counted as a whole
        QVERIFY(memoryFor(picture) > 4ULL << 30);
    }

    void theFileIsWhatIsDrawn() {
        const QTemporaryDir folder;
        const SpaceExport picture = spongeSeen(attractor::LookInSpace::Stone, attractor::Look::Stone);
        const QString path = folder.filePath(QStringLiteral("a.png"));
        const ExportOutcome outcome = exportSpace(picture, path);
        QVERIFY(!outcome.failure && !outcome.stopped);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll() == encoded(picture));
    }
};

BARYCAGE_TEST(SpaceExportTest, QGuiApplication);
#include "space_export_test.moc"
