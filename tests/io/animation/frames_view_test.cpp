// SPDX-License-Identifier: MIT
#include "io/animation/frames_view.h"

#include "attractor/space_systems.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/edits/timeline/orbit_edits.h"
#include "document/moments/animated_fractal.h"
#include "io/animation/animation_export.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <vector>

namespace {

constexpr attractor::RasterSize size{640, 360};

// The sponge from (5, −3, 2) to (7, −1, 4), which turns about its middle.
document::Fractal spongeThatTurns() {
    document::Fractal solid;
    document::Shape<3> shape{systems::menger()};
    shape.system =
        *ifs::conjugate(ifs::AffineMap<3>{2 * ifs::Matrix<3>::Identity(), {5, -3, 2}}, shape.system);
    solid.shape = shape;
    return *document::withOrbit(solid);
}

attractor::OrbitCamera cameraAtAnAngle(attractor::OrbitCamera::Projection projection) {
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(40, 25);
    camera.projection = projection;
    camera.size = size;
    return camera;
}

// How far from the nearest edge the corners of the sponge are seen, in pixels.
double roomAround(const attractor::OrbitCamera& camera) {
    double room = size.width;
    for (int k = 0; k < 8; ++k) {
        const ifs::Vector<3> corner(5 + 2 * (k & 1), -3 + (k & 2), 2 + 2 * (k >> 2));
        const ifs::Vector<2> at = toScreen(camera, corner).pixel;
        room = std::min({room, at.x(), at.y(), size.width - at.x(), size.height - at.y()});
    }
    return room;
}

} // namespace

// What the frames of an animation in space show.
class FramesViewTest : public QObject {
    Q_OBJECT

private slots:
    void nothingGrowsWhileTheCameraGoesRound();
    void keyedViewsShowEverything_data();
    void keyedViewsShowEverything();
};

void FramesViewTest::nothingGrowsWhileTheCameraGoesRound() {
    const document::Fractal entry = spongeThatTurns();
    const attractor::Support all = io::supportOfFrames(entry);
    const ifs::Vector<3> middle = document::orbitPlace(entry, 0)->centre;
    for (const auto projection : {attractor::OrbitCamera::Projection::Orthographic,
                                  attractor::OrbitCamera::Projection::Perspective}) {
        const attractor::OrbitCamera start = cameraAtAnAngle(projection);
        const auto first = io::cameraOfFrame(start, {}, all);
        const ifs::Vector<2> seen = toScreen(first, middle).pixel;
        double least = size.width;
        for (int frame = 0; frame < 120; ++frame) {
            const auto turns = document::frameAt(entry, animation::moment(frame)).orbit;
            const attractor::OrbitCamera camera = io::cameraOfFrame(start, turns, all);
            QCOMPARE(camera.height, first.height);
            QVERIFY((toScreen(camera, middle).pixel - seen).norm() < 1e-9);
            least = std::min(least, roomAround(camera));
        }
        QVERIFY(least > 0.04 * size.height && least < 0.08 * size.height); // a margin of a twentieth
    }
}

void FramesViewTest::keyedViewsShowEverything_data() {
    QTest::addColumn<bool>("isAboutTarget");
    QTest::newRow("about the middle") << false;
    QTest::newRow("about the target") << true;
}

// A key that looks as the window did, in which every frame shows all of the solid.
void FramesViewTest::keyedViewsShowEverything() {
    QFETCH(bool, isAboutTarget);
    io::AnimationExport what;
    what.entry = spongeThatTurns();
    if (isAboutTarget)
        what.entry = document::withOrbitPlace(
            what.entry, 0, {ifs::Vector<3>::UnitY(), animation::OrbitPivot::Target, {0, 0, 0}});
    what.size = {size.width, size.height};
    const auto projection = attractor::OrbitCamera::Projection::Perspective;
    what.seenFrom = cameraAtAnAngle(projection);
    const io::AnimationExport keyed = io::withViewKeyed(what);
    QVERIFY(io::hasCameraKeys(keyed.entry) && !keyed.seenFrom);
    double least = size.width;
    for (int frame = 0; frame < 120; ++frame) {
        const document::AnimatedFrame shown = document::frameAt(keyed.entry, animation::moment(frame));
        QVERIFY(shown.camera.has_value());
        QVERIFY(shown.camera->orientation.angularDistance(attractor::orbit(40, 25)) < 1e-7);
        QVERIFY(shown.camera->projection == projection);
        attractor::OrbitCamera camera = animation::orbited(*shown.camera, shown.orbit);
        camera.size = size;
        least = std::min(least, roomAround(camera));
    }
    QVERIFY2(least > 0.04 * size.height && least < 0.12 * size.height, qPrintable(QString::number(least)));
    what.seenFrom.reset();
    QCOMPARE(io::withViewKeyed(what).entry, what.entry);
}

BARYCAGE_TEST(FramesViewTest, QCoreApplication);
#include "frames_view_test.moc"
