// SPDX-License-Identifier: MIT
#include "bridges/render_bridge.h"

#include "document/edit_gesture.h"
#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QSignalSpy>
#include <QTimer>

using document::Document;
using ifs::Vector;
using view::RenderBridge;

namespace {

attractor::Camera camera() {
    return {Vector<2>(0.5, 0.4), 150, 240, 200, attractor::YAxis::Up};
}

document::Fractal placed(document::Fractal fractal, const Vector<2>& offset) {
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    cage.current[2] += offset;
    document::plane(fractal)->cage = cage;
    return fractal;
}

} // namespace

class RenderBridgeTest : public QObject {
    Q_OBJECT

private slots:
    void drawsNothingBeforeACamera() {
        Document document;
        RenderBridge bridge(&document);
        document.edit(QStringLiteral("Move"), placed(document.fractal(), {0.1, 0}));
        QCOMPARE(bridge.requested(), std::uint64_t{0});
        QVERIFY(!bridge.frame());
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QCOMPARE(bridge.frame()->camera, camera());
    }

    void aStreamOfChangesStarvesNoFrame() {
        Document document;
        RenderBridge bridge(&document);
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QSignalSpy frames(&bridge, &RenderBridge::frameChanged);
        document::EditGesture gesture = document.beginGesture(QStringLiteral("Move"));
        const document::Fractal before = gesture.before();
        int changes = 0;
        QTimer stream; // faster than any frame can be
        connect(&stream, &QTimer::timeout, this, [&] {
            gesture.preview(placed(before, {0.001 * (++changes % 100), 0}));
        });
        stream.start(1);
        QTRY_VERIFY_WITH_TIMEOUT(frames.count() >= 5, 60'000);
        stream.stop();
        gesture.commit();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QVERIFY(bridge.liveSamples() >= 1'000'000);
        QVERIFY(bridge.liveSamples() <= 10'000'000);
    }

    void aPlayheadThatIsDraggedStarvesNoFrame() {
        document::Fractal breathing = document::sierpinskiTriangle();
        auto& animation = document::plane(breathing)->animation.emplace();
        animation.length = 1000;
        animation.motions = {animation::Breathe<2>{{}, 0.5, 1, {0, 0}}};
        Document document;
        document.setFile(document::fileOf(breathing));
        RenderBridge bridge(&document);
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        document.setMoment(animation::moment(1));
        const std::uint64_t underWay = bridge.requested();
        for (int frame = 2; frame < 10; ++frame)
            document.setMoment(animation::moment(frame));
        QCOMPARE(bridge.requested(), underWay); // the others wait for its frame
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QCOMPARE(bridge.requested(), underWay + 1);
    }

    void exposureIsKeptWhileOnlyTheCageChanges() {
        Document document;
        RenderBridge bridge(&document);
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        const attractor::Exposure first = bridge.frame()->exposure;
        document.edit(QStringLiteral("Move"), placed(document.fractal(), {0.3, 0.2}));
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QCOMPARE(bridge.frame()->exposure.whitePoint, first.whitePoint);
        QCOMPARE(bridge.frame()->exposure.gain, first.gain);
        document::Fractal other = document.fractal();
        document::system2(other)->maps[0].map.linear *= 0.3;
        document.edit(QStringLiteral("Shrink"), other);
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QVERIFY(bridge.frame()->exposure.whitePoint != first.whitePoint);
    }

    void refinesUpToTheQuality() {
        Document document;
        RenderBridge bridge(&document);
        bridge.setQuality(25'000'000);
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent() && bridge.frame()->samples >= 25'000'000, 60'000);
        QVERIFY(bridge.frame()->passes > 1);
    }

    void anEntryThatIsNotPlanarHasNoPicture() {
        Document document;
        RenderBridge bridge(&document);
        bridge.setCamera(camera());
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        document::Fractal space = document.fractal();
        space.shape = document::Shape<3>();
        document.edit(QStringLiteral("Go to space"), space);
        QVERIFY(!bridge.frame());
        document.undoStack()->undo();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.frame() && bridge.isCurrent(), 60'000);
    }
};

BARYCAGE_TEST(RenderBridgeTest, QApplication);
#include "render_bridge_test.moc"
