// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "io/overlay/picture_overlay.h"
#include "io/overlay/space_overlay.h"
#include "support/named_test.h"

#include <QTest>

// A part of an overlay is one row: whatever the command line offers is drawn, in the plane and in space.
class OverlayPartsTest : public QObject {
    Q_OBJECT

private slots:
    void everyPartIsDrawn_data();
    void everyPartIsDrawn();
    void partsAddUp();
};

namespace {

io::OverlayMarks inPlane(const io::PictureOverlay& overlay) {
    document::Fractal fractal;
    fractal.shape = document::Shape<2>{canonical::system(canonical::sierpinskiRight())};
    attractor::Camera camera;
    camera.width = camera.height = 200;
    return io::overlayMarks(fractal, fitted(camera, ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 1)), overlay);
}

io::OverlayMarks inSpace(const io::PictureOverlay& overlay) {
    document::Fractal fractal;
    fractal.shape = document::Shape<3>{systems::menger()};
    attractor::OrbitCamera camera;
    camera.size = {200, 200};
    return io::spaceOverlayMarks(fractal, camera, overlay);
}

} // namespace

void OverlayPartsTest::everyPartIsDrawn_data() {
    QTest::addColumn<std::size_t>("row");
    for (std::size_t row = 0; row < io::overlayParts.size(); ++row)
        QTest::newRow(io::overlayParts[row].id) << row;
}

void OverlayPartsTest::everyPartIsDrawn() {
    QFETCH(const std::size_t, row);
    io::PictureOverlay overlay;
    overlay.*io::overlayParts[row].isShown = true;
    QVERIFY(!inPlane(overlay).empty());
    QVERIFY(!inSpace(overlay).empty());
}

void OverlayPartsTest::partsAddUp() {
    io::PictureOverlay all;
    std::size_t plane = 0, space = 0;
    for (const io::OverlayPart& part : io::overlayParts) {
        io::PictureOverlay one;
        one.*part.isShown = all.*part.isShown = true;
        plane += inPlane(one).size();
        space += inSpace(one).size();
    }
    QCOMPARE(inPlane(all).size(), plane);
    QCOMPARE(inSpace(all).size(), space);
    QVERIFY(inPlane({}).empty() && inSpace({}).empty());
}

BARYCAGE_TEST(OverlayPartsTest, QGuiApplication);
#include "overlay_parts_test.moc"
