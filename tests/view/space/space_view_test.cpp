// SPDX-License-Identifier: MIT
#include "space/space_view.h"

#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/note_item.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QtTest>

using view::SpaceView;
using namespace space_window;

class SpaceViewTest : public QObject {
    Q_OBJECT

private slots:
    void itShowsTheSolidInItsTetrahedron();
    void anEmptyPlaceOrbits();
    void theSolidOrbitsAboutThePointUnderThePointer();
    void theAddressUnderThePointerIsRead();
    void theRightButtonOrbitsOverHandles();
    void aVertexIsDraggedInOneStep();
    void escapeBringsItAllBack();
    void keysLockAnAxis();
    void theWheelZoomsAtThePointer();
    void theBallLooksAlongAnAxis();
    void theKeypadChoosesViews();
    void keysMoveTheCamera();
    void anotherEntryIsSeenAsItsKeysSay();
    void withoutKeysAnOrbitGoesOnFromTheView();
    void zUpTurnsTheViewsAndNotTheFractal();
    void aTrackballGoesOverThePole();
    void bothEyesAreShown_data();
    void bothEyesAreShown();
    void fourClicksDefineTheTetrahedron();
    void aDoubleClickTakesThePointToTheMiddle();
    void theKeyboardMovesAVertex();
    void cursorsSayWhatCanBeHeld();
    void squeezedFlatAndOpenedItIsTheSame();
    void anotherEntryEndsADrag();
    void thePlaneOfASliceIsDraggedInOneStep();
    void rewritingChangesTheCode();
    void cloudsAreShownAndAnswerWhatIsUnderThePointer();
};

void SpaceViewTest::itShowsTheSolidInItsTetrahedron() {
    Window window;
    QVERIFY(window.rests());
    const QImage picture = window.view->picture();
    const auto at = [&](const ifs::Vector<3>& world) {
        return view::toPoint(toScreen(window.bridge->camera(), world).pixel).toPoint();
    };
    QVERIFY(lightness(picture, at({0.5, 0.5, 0.5})) > 60);
    QVERIFY(lightness(picture, at({1.5, 1.2, 0.2})) < 40); // in the tetrahedron, not in the cube
    QCOMPARE(window.view->cageItem().count(), std::size_t(4));
    for (std::size_t vertex = 0; vertex < 4; ++vertex) // fitted: all handles are in the view
        QVERIFY(window.view->viewport()->rect().contains(window.handle(vertex)));
    QCOMPARE(window.view->note(), QString());
}

void SpaceViewTest::thePlaneOfASliceIsDraggedInOneStep() {
    Window window;
    document::Fractal cut = window.document.fractal();
    cut.inSpace.clip = attractor::SpaceClip{{0, 0, 2}, -HUGE_VAL, 1};
    window.document.edit(QStringLiteral("Cut"), cut);
    QVERIFY(window.rests());
    const QPointF handle = window.view->sliceItem().handle();
    const QPointF towards = view::toPoint(
        toScreen(window.camera(), window.view->sliceItem().plane()->centre + ifs::Vector<3>(0, 0, 0.25))
            .pixel);
    const int steps = window.document.undoStack()->count();
    window.drag(handle, towards);
    QCOMPARE(window.document.undoStack()->count(), steps + 1);
    const auto& clip = window.document.fractal().inSpace.clip;
    QVERIFY(std::abs(clip->highest - 1.5) < 0.02); // a quarter farther, in units of a normal of length 2
    QVERIFY(std::isinf(clip->lowest));
    window.send(QEvent::MouseButtonPress, window.view->sliceItem().handle(), Qt::LeftButton);
    window.send(QEvent::MouseMove, window.view->sliceItem().handle() + QPointF(30, 30), Qt::LeftButton);
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QCOMPARE(window.document.undoStack()->count(), steps + 1);
    QVERIFY(std::abs(window.document.fractal().inSpace.clip->highest - 1.5) < 0.02);
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == cut);
}

void SpaceViewTest::rewritingChangesTheCode() {
    Window window;
    QVERIFY(window.rests());
    QVERIFY(window.view->note().isEmpty());
    window.document.setCageMode(document::CageMode::Rewrite);
    QVERIFY(!window.view->note().isEmpty()); // a sign that says so
    const document::Fractal before = window.document.fractal();
    window.drag(window.handle(1), window.handle(1) + QPoint(40, -30));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(!document::isSameSystem(before, window.document.fractal()));
    const auto& cage = document::space(window.document.fractal())->cage;
    QVERIFY(cage && cage->rest == cage->current);
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == before);
}

void SpaceViewTest::cloudsAreShownAndAnswerWhatIsUnderThePointer() {
    Window window;
    QVERIFY(window.rests());
    const QImage solid = window.view->picture();
    for (const attractor::LookInSpace look : {attractor::LookInSpace::Cloud, attractor::LookInSpace::XRay}) {
        document::Fractal cloud = window.document.fractal();
        cloud.inSpace.look = look;
        window.document.edit(QStringLiteral("Look"), cloud);
        QVERIFY(window.rests());
        QVERIFY(window.view->picture() != solid);
        const QPoint middle =
            view::toPoint(toScreen(window.camera(), ifs::Vector<3>(0.5, 0.5, 0.5)).pixel).toPoint();
        QVERIFY(lightness(window.view->picture(), middle) > 20);
        QVERIFY(window.view->navigation().pointUnder(middle));
    }
}

void SpaceViewTest::anEmptyPlaceOrbits() {
    Window window;
    QVERIFY(window.rests());
    const attractor::OrbitCamera before = window.camera();
    window.drag({20, 480}, {120, 470});
    const attractor::OrbitCamera after = window.camera();
    QVERIFY(after.orientation.coeffs() != before.orientation.coeffs());
    const ifs::Vector<3> middle(0.5, 0.5, 0.5); // about the solid
    QVERIFY((toScreen(after, middle).pixel - toScreen(before, middle).pixel).norm() < 1e-3);
    QCOMPARE(after.height, before.height);
    QVERIFY(!window.document.isModified());
}

void SpaceViewTest::theSolidOrbitsAboutThePointUnderThePointer() {
    Window window;
    QVERIFY(window.rests());
    const QPointF press = view::toPoint(toScreen(window.camera(), ifs::Vector<3>(1, 0.6, 0.6)).pixel);
    const auto point = window.view->navigation().pointUnder(press);
    QVERIFY(point.has_value());
    QVERIFY((*point - ifs::Vector<3>(1, 0.6, 0.6)).norm() < 0.05); // on the face x = 1
    window.drag(press, press + QPointF(60, 30));
    QVERIFY((view::toPoint(toScreen(window.camera(), *point).pixel) - press).manhattanLength() < 1e-6);
}

void SpaceViewTest::theAddressUnderThePointerIsRead() {
    Window window;
    QVERIFY(window.rests());
    ifs::Word address;
    connect(window.view.get(), &SpaceView::pointerMoved, this,
            [&address](const view::SpacePosition& at) { address = at.address; });
    const ifs::Vector<3> onTheFace(1, 0.6, 0.3);
    window.send(QEvent::MouseMove, view::toPoint(toScreen(window.camera(), onTheFace).pixel), Qt::NoButton);
    QVERIFY(address.size() >= 4);
    QCOMPARE(address[0], 3); // in the eighth at (1, 1, 0), and of that at (1, 0.2, 0.6)
    QCOMPARE(address[1], 5);
    window.send(QEvent::MouseMove, {5, 495}, Qt::NoButton);
    QVERIFY(address.empty());
}

void SpaceViewTest::theRightButtonOrbitsOverHandles() {
    Window window;
    QVERIFY(window.rests());
    const auto before = window.camera().orientation.coeffs().eval();
    const QPointF handle = window.handle(1);
    window.drag(handle, handle + QPointF(50, 0), Qt::RightButton);
    QVERIFY(window.camera().orientation.coeffs() != before);
    QVERIFY(!window.document.isModified());
}

void SpaceViewTest::aVertexIsDraggedInOneStep() {
    Window window;
    QVERIFY(window.rests());
    const auto before = window.vertices();
    const QPointF handle = window.handle(2);
    window.drag(handle, handle + QPointF(30, -20));
    const auto after = window.vertices();
    QCOMPARE(window.document.undoStack()->count(), 1);
    QCOMPARE(window.document.undoStack()->text(0), QStringLiteral("Move Vertex 3"));
    QVERIFY((view::toPoint(toScreen(window.camera(), after[2]).pixel) -
             view::toPoint(toScreen(window.camera(), before[2]).pixel) - QPointF(30, -20))
                .manhattanLength() < 1e-6);
    for (const std::size_t other : {0, 1, 3})
        QVERIFY(after[other] == before[other]);
    QVERIFY(window.rests()); // the picture follows
    window.document.undoStack()->undo();
    QVERIFY(window.vertices() == before);
    QVERIFY(!document::space(window.document.fractal())->cage);
}

void SpaceViewTest::escapeBringsItAllBack() {
    Window window;
    QVERIFY(window.rests());
    const document::Fractal before = window.document.fractal();
    const QPointF handle = window.handle(0);
    window.send(QEvent::MouseButtonPress, handle, Qt::LeftButton);
    window.send(QEvent::MouseMove, handle + QPointF(40, 40), Qt::LeftButton);
    QVERIFY(!(window.document.fractal() == before));
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(window.document.fractal() == before);
    QCOMPARE(window.document.undoStack()->count(), 0);
}

void SpaceViewTest::keysLockAnAxis() {
    Window window;
    QVERIFY(window.rests());
    const auto before = window.vertices();
    const QPointF handle = window.handle(1);
    view::SpacePosition shown;
    connect(window.view.get(), &SpaceView::pointerMoved, this,
            [&shown](const view::SpacePosition& position) { shown = position; });
    window.send(QEvent::MouseButtonPress, handle, Qt::LeftButton);
    QTest::keyClick(window.view.get(), Qt::Key_X);
    window.send(QEvent::MouseMove, handle + QPointF(35, 25), Qt::LeftButton);
    auto held = window.vertices()[1];
    const view::AxisLock alongX{view::AxisLock::Kind::Axis, 0};
    QVERIFY(shown.lock == alongX);
    QCOMPARE(shown.world, held); // where the corner is, not the pointer
    QTest::keyClick(window.view.get(), Qt::Key_Z, Qt::ControlModifier); // a shortcut, and no axis
    QTest::keyClick(window.view.get(), Qt::Key_Y, Qt::AltModifier);
    QVERIFY(shown.lock == alongX);
    QCOMPARE(window.vertices()[1], held);
    QVERIFY(held.x() != before[1].x());
    QCOMPARE(held.y(), before[1].y());
    QCOMPARE(held.z(), before[1].z());
    QTest::keyClick(window.view.get(), Qt::Key_X, Qt::ShiftModifier); // in the plane across x
    held = window.vertices()[1];
    QCOMPARE(held.x(), before[1].x());
    QVERIFY(held.y() != before[1].y());
    QTest::keyClick(window.view.get(), Qt::Key_X, Qt::ShiftModifier); // free again
    held = window.vertices()[1];
    QVERIFY(held.x() != before[1].x() && held.y() != before[1].y());
    window.send(QEvent::MouseButtonRelease, handle + QPointF(35, 25), Qt::LeftButton);
    QVERIFY(shown.lock == view::AxisLock{});
    QCOMPARE(window.document.undoStack()->count(), 1);
}

void SpaceViewTest::theWheelZoomsAtThePointer() {
    Window window;
    QVERIFY(window.rests());
    const QPointF at(150, 120);
    const ifs::Vector<3> seen = toWorld(window.camera(), {view::toVector(at), 0});
    const double height = window.camera().height;
    QWheelEvent wheel(at, window.view->viewport()->mapToGlobal(at), {}, {0, 240}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(window.view->viewport(), &wheel);
    QVERIFY(window.camera().height < height);
    QVERIFY((view::toPoint(toScreen(window.camera(), seen).pixel) - at).manhattanLength() < 1e-6);
}

void SpaceViewTest::theBallLooksAlongAnAxis() {
    Window window;
    QVERIFY(window.rests());
    // Where the ball shows the end of an axis, a click looks along it; the next one from behind.
    std::optional<QPoint> end;
    for (int y = 0; y < 150 && !end; ++y)
        for (int x = 400; x < 600 && !end; ++x)
            if (window.view->ball().endAt(QPointF(x, y)) == view::AxisBall::End{1, true}) end = QPoint(x, y);
    QVERIFY(end.has_value());
    QTest::mouseClick(window.view->viewport(), Qt::LeftButton, {}, *end + QPoint(3, 6));
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {1, true}));
    QTest::mouseClick(window.view->viewport(), Qt::LeftButton, {}, QPoint(600 - 64, 64)); // Y is in front
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {1, false}));
}

void SpaceViewTest::theKeypadChoosesViews() {
    Window window;
    QVERIFY(window.rests());
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers more = {}) {
        QTest::keyClick(window.view.get(), key, Qt::KeypadModifier | more);
    };
    press(Qt::Key_3);
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {0, true}));
    press(Qt::Key_1, Qt::ControlModifier);
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {2, false}));
    QVERIFY(!window.view->navigation().isPerspective());
    press(Qt::Key_5);
    QVERIFY(window.view->navigation().isPerspective());
    press(Qt::Key_7); // a view along an axis is orthographic until one orbits
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {1, true}));
    QVERIFY(!window.view->navigation().isPerspective());
    window.drag({20, 480}, {80, 400});
    QVERIFY(window.view->navigation().isPerspective());
}

namespace {

// A cube that is flown into while the camera goes round.
document::Fractal flight() {
    document::Fractal fractal = cubeOfEight();
    attractor::OrbitCamera from, to;
    from.target = {0.5, 0.5, 0.5};
    from.height = 3;
    from.orientation = attractor::orbit(30, 20);
    to.target = {0.5, 0.5, 1};
    to.height = 0.5;
    to.fieldOfView = 60;
    from.projection = attractor::OrbitCamera::Projection::Perspective;
    to.projection = from.projection;
    auto& moving = document::space(fractal)->animation.emplace();
    moving.length = 24;
    moving.camera = {{0, from, {}}, {24, to, {}}};
    moving.motions = {animation::Orbit<3>{1, {0, 0, 0}}};
    return fractal;
}

// Of the frame, in the size of the window.
bool looksAsKeyed(const Window& window) {
    const document::AnimatedFrame frame =
        document::frameAt(window.document.entryFractal(), window.document.moment());
    attractor::OrbitCamera keyed = animation::orbited(*frame.camera, frame.orbit);
    keyed.size = window.camera().size;
    return window.camera() == keyed;
}

} // namespace

void SpaceViewTest::keysMoveTheCamera() {
    Window window(flight());
    const QSignalSpy perspective(&window.view->navigation(), &view::SpaceNavigation::perspectiveChanged);
    QVERIFY(window.rests());
    QVERIFY(looksAsKeyed(window)); // as soon as it is shown
    for (const int frame : {6, 24, 11, 0}) {
        window.document.setMoment(animation::moment(frame));
        QVERIFY(looksAsKeyed(window));
    }
    window.document.setMoment(animation::moment(5), document::Document::Pace::Running);
    QVERIFY(looksAsKeyed(window));
    window.document.setMoment(animation::moment(5));
    QVERIFY(window.rests());
    const attractor::OrbitCamera drawn = window.bridge->camera();
    QCOMPARE(drawn.height, window.camera().height);
    window.drag({20, 480}, {120, 440}, Qt::RightButton); // free while the playhead rests
    QVERIFY(!looksAsKeyed(window));
    window.view->resize(500, 500);
    QVERIFY(!looksAsKeyed(window));
    window.view->navigation().setPerspective(false);
    window.document.setMoment(animation::moment(6));
    QVERIFY(looksAsKeyed(window));
    QVERIFY(window.view->navigation().isPerspective());
    QVERIFY(!perspective.isEmpty() && perspective.last().front().toBool());
}

void SpaceViewTest::anotherEntryIsSeenAsItsKeysSay() {
    Window window;
    QVERIFY(window.rests());
    window.document.setFile(document::fileOf(flight()));
    QVERIFY(looksAsKeyed(window));
    window.document.setFile(document::fileOf(cubeOfEight()));
    QVERIFY(window.view->navigation().isFitted());
}

void SpaceViewTest::withoutKeysAnOrbitGoesOnFromTheView() {
    document::Fractal turning = flight();
    document::space(turning)->animation->camera.clear();
    Window window(turning);
    QVERIFY(window.rests());
    window.drag({20, 480}, {120, 470});
    const attractor::OrbitCamera before = window.camera();
    window.document.setMoment(animation::moment(6));
    const attractor::OrbitCamera turned = animation::orbited(before, animation::CameraTurn{90});
    QVERIFY(window.camera().orientation.angularDistance(turned.orientation) < 1e-12);
    QCOMPARE(window.camera().height, before.height);
    window.document.setMoment(animation::moment(0));
    QVERIFY(window.camera().orientation.angularDistance(before.orientation) < 1e-12);
}

void SpaceViewTest::zUpTurnsTheViewsAndNotTheFractal() {
    Window window;
    QVERIFY(window.rests());
    const document::Fractal before = window.document.fractal();
    view::SpaceNavigation& navigation = window.view->navigation();
    navigation.setUpAxis(attractor::UpAxis::Z);
    const auto up = [&] { return window.camera().orientation.toRotationMatrix().col(1).eval(); };
    QVERIFY(std::abs(window.camera().orientation.toRotationMatrix().col(0).z()) < 1e-9); // level
    QTest::keyClick(window.view.get(), Qt::Key_1, Qt::KeypadModifier);
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {1, false})); // the front is −y
    QTRY_VERIFY((up() - ifs::Vector<3>::UnitZ()).norm() < 1e-9);
    QTest::keyClick(window.view.get(), Qt::Key_7, Qt::KeypadModifier);
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {2, true}));
    QTRY_VERIFY((up() - ifs::Vector<3>::UnitY()).norm() < 1e-9); // the view has come to rest
    std::optional<attractor::Direction> shown;
    connect(window.view.get(), &SpaceView::pointerMoved, this,
            [&shown](const view::SpacePosition& at) { shown = at.direction ? at.direction : shown; });
    window.drag({20, 480}, {70, 430});
    QVERIFY(std::abs(window.camera().orientation.toRotationMatrix().col(0).z()) < 1e-9);
    QVERIFY(shown && std::abs(shown->azimuth + 20) < 1e-6 && std::abs(shown->elevation - 70) < 1e-6);
    QVERIFY(window.document.fractal() == before);
}

void SpaceViewTest::aTrackballGoesOverThePole() {
    Window window;
    QVERIFY(window.rests());
    window.view->navigation().setTrackball(true);
    const auto eye = [&] { return window.camera().orientation.toRotationMatrix().col(2).eval(); };
    window.drag({20, 100}, {20, 450});                                      // 140°
    QVERIFY(window.camera().orientation.toRotationMatrix().col(1).y() < 0); // upside down
    window.drag({20, 450}, {200, 300});
    const auto before = eye();
    window.view->navigation().setTrackball(false); // level again, seen from the same side
    QTRY_VERIFY(std::abs(window.camera().orientation.toRotationMatrix().col(0).y()) < 1e-9);
    QTRY_VERIFY((eye() - before).norm() < 1e-6);
}

void SpaceViewTest::bothEyesAreShown_data() {
    QTest::addColumn<attractor::LookInSpace>("look");
    QTest::newRow("stone") << attractor::LookInSpace::Stone;
    QTest::newRow("cloud") << attractor::LookInSpace::Cloud;
}

void SpaceViewTest::bothEyesAreShown() {
    QFETCH(const attractor::LookInSpace, look);
    document::Fractal cube = cubeOfEight();
    cube.inSpace.look = look;
    Window window(cube);
    QVERIFY(window.rests());
    const QImage alone = window.view->picture();
    window.view->setStereo(attractor::Stereo::SideBySide);
    QVERIFY(window.rests());
    const QImage sides = window.view->picture();
    QCOMPARE(sides.size(), alone.size());
    QVERIFY(sides.copy(0, 0, 300, 500) != sides.copy(300, 0, 300, 500));
    QVERIFY(!window.view->cageItem().isVisible()); // it would be in one half only
    const ifs::Vector<3> face(1, 0.5, 0.5);
    const QPointF seen = view::toPoint(toScreen(window.camera(), face).pixel);
    for (const QPointF& at : {seen, seen + QPointF(300, 0)}) { // in either half
        const auto point = window.view->navigation().pointUnder(at);
        QVERIFY(point && (*point - face).norm() < 0.05);
    }
    window.view->setStereo(attractor::Stereo::Anaglyph);
    QVERIFY(window.rests());
    const QImage glasses = window.view->picture();
    QCOMPARE(glasses.size(), alone.size());
    QVERIFY(glasses != alone);
    QVERIFY(window.view->cageItem().isVisible());
    const auto point =
        window.view->navigation().pointUnder(view::toPoint(toScreen(window.camera(), face).pixel));
    QVERIFY(point && (*point - face).norm() < 0.05);
    window.view->setStereo(attractor::Stereo::None);
    QVERIFY(window.rests());
    if (look == attractor::LookInSpace::Stone) QVERIFY(window.view->picture() == alone);
}

// Three in the plane of the target, the fourth in front of it; the picture stays.
void SpaceViewTest::fourClicksDefineTheTetrahedron() {
    Window window;
    QVERIFY(window.rests());
    const QImage picture = window.view->picture();
    const auto plane = [&](const QPoint& at) { return toWorld(window.camera(), {view::toVector(at), 0}); };
    int finished = 0;
    connect(window.view.get(), &SpaceView::defined, this, [&finished] { ++finished; });
    window.view->setTarget(SpaceView::Target::Definition);
    const QPoint corners[] = {{100, 400}, {480, 420}, {250, 80}};
    const ifs::Vector<3> expected[] = {plane(corners[0]), plane(corners[1]), plane(corners[2])};
    const auto click = [&](const QPoint& at) {
        QTest::mouseClick(window.view->viewport(), Qt::LeftButton, {}, at);
    };
    QVERIFY(window.view->note().contains(QStringLiteral("first")));
    click(corners[0]);
    click(corners[0]); // a double click is one corner
    QVERIFY(window.view->note().contains(QStringLiteral("second")));
    click({300, 300});
    QTest::keyClick(window.view.get(), Qt::Key_Backspace);
    click(corners[1]);
    click(corners[2]);
    QVERIFY(window.view->note().contains(QStringLiteral("fourth")));
    click({280, 300});
    QCOMPARE(finished, 1);
    QCOMPARE(window.document.undoStack()->count(), 1);
    const auto& cage = document::space(window.document.fractal())->cage;
    QVERIFY(cage && cage->rest == cage->current && cage->rest.size() == 4);
    for (std::size_t k = 0; k < 3; ++k)
        QVERIFY((cage->current[k] - expected[k]).norm() < 1e-9);
    const attractor::ScreenPoint fourth = toScreen(window.camera(), cage->current[3]);
    QVERIFY((fourth.pixel - ifs::Vector<2>(280, 300)).norm() < 1e-6);
    QVERIFY(fourth.depth < -0.1); // towards the eye
    QVERIFY(window.rests());
    QVERIFY(window.view->picture() == picture);
    QTest::keyClick(window.view.get(), Qt::Key_Escape); // leaves it
    QCOMPARE(finished, 2);
}

void SpaceViewTest::aDoubleClickTakesThePointToTheMiddle() {
    Window window;
    QVERIFY(window.rests());
    const QPointF at = view::toPoint(toScreen(window.camera(), ifs::Vector<3>(1, 0.3, 0.6)).pixel);
    const auto point = window.view->navigation().pointUnder(at);
    QVERIFY(point.has_value());
    QTest::mouseDClick(window.view->viewport(), Qt::LeftButton, {}, at.toPoint());
    QTRY_VERIFY((window.camera().target - *point).norm() < 0.02);
}

void SpaceViewTest::theKeyboardMovesAVertex() {
    Window window;
    QVERIFY(window.rests());
    const auto before = window.vertices();
    QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QTest::keyClick(window.view.get(), Qt::Key_Right, Qt::ShiftModifier);
    const auto after = window.vertices();
    QVERIFY(after[0] == before[0]);
    const ifs::Vector<2> moved =
        toScreen(window.camera(), after[1]).pixel - toScreen(window.camera(), before[1]).pixel;
    QVERIFY((moved - ifs::Vector<2>(10, 0)).norm() < 1e-6);
    QVERIFY(window.view->accessibleDescription().contains(QStringLiteral("Vertex 2")));
}

void SpaceViewTest::cursorsSayWhatCanBeHeld() {
    Window window;
    QVERIFY(window.rests());
    const QPointF handle = window.handle(3);
    window.send(QEvent::MouseMove, {20, 480}, Qt::NoButton);
    QCOMPARE(window.view->viewport()->cursor().shape(), Qt::CrossCursor);
    window.send(QEvent::MouseMove, handle, Qt::NoButton);
    QCOMPARE(window.view->viewport()->cursor().shape(), Qt::OpenHandCursor);
    window.send(QEvent::MouseButtonPress, handle, Qt::LeftButton);
    QCOMPARE(window.view->viewport()->cursor().shape(), Qt::ClosedHandCursor);
    window.send(QEvent::MouseButtonRelease, handle, Qt::LeftButton);
    QCOMPARE(window.view->viewport()->cursor().shape(), Qt::OpenHandCursor);
}

void SpaceViewTest::squeezedFlatAndOpenedItIsTheSame() {
    Window window;
    QVERIFY(window.rests());
    const QImage before = window.view->picture();
    const auto cage = *document::spaceCage(window.document.fractal());
    auto flat = cage;
    for (ifs::Vector<3>& vertex : flat.current)
        vertex.z() = 0;
    window.document.edit(QStringLiteral("Squeeze"),
                         document::withCageMoved(window.document.fractal(), flat, document::CageMode::Place));
    QVERIFY(window.rests());
    QVERIFY(!window.view->note().isEmpty()); // and it says so
    window.document.edit(QStringLiteral("Open"),
                         document::withCageMoved(window.document.fractal(), cage, document::CageMode::Place));
    QVERIFY(window.rests());
    QVERIFY(window.view->picture() == before); // to the bit
    QCOMPARE(window.view->note(), QString());
}

void SpaceViewTest::anotherEntryEndsADrag() {
    Window window;
    QVERIFY(window.rests());
    const QPointF handle = window.handle(0);
    window.send(QEvent::MouseButtonPress, handle, Qt::LeftButton);
    window.send(QEvent::MouseMove, handle + QPointF(40, 40), Qt::LeftButton);
    window.document.setFile(document::FractalFile());
    window.send(QEvent::MouseMove, handle + QPointF(60, 40), Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, handle, Qt::LeftButton);
    QVERIFY(!window.document.isModified());
    QTRY_VERIFY(window.view->picture().isNull());
}

BARYCAGE_TEST(SpaceViewTest, QApplication);
#include "space_view_test.moc"
