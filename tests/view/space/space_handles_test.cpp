// SPDX-License-Identifier: MIT
#include "bridges/extent_finder.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/border_arrows_item.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/moments/animated_fractal.h"
#include "ifs/cage/map_handles.h"
#include "space/four_views.h"
#include "space/seen_line.h"
#include "support/background_rest.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>

using view::SpaceView;
using namespace space_window;

class SpaceHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void theBallNeverWinsOverACorner();
    void commandsKeepTheCageInTheView();
    void anArrowLeadsToACornerOutside();
    void fitTakesInTheWholeMotion();
    void theCageOfVeryManyMapsIsFoundInTheBackground();
    void theExtentIsAnnouncedAfterAGesture();
    void aCornerOfAMapIsDraggedInOneStep();
    void theMiddleOfAMapMovesItAsAWhole();
    void aMapIsDraggedNoFartherThanItsAttractor();
    void linkedMapsAreDraggedFreely();
    void keysSelectAndDeleteMaps();
    void fourViewsShowTheSameDrag();
    void aCornerOfABoxBendsTheSolid();
    void aFaceTakesItsCornersAlong();
    void theCentreOfASymmetryIsDragged();
};

// The simplex is not asked for in this thread: the cage comes with the finder, and the view then fits it.
namespace {

document::Fractal ofVeryManyMaps() {
    document::Fractal many = cubeOfEight();
    document::System3& system = *document::system3(many);
    const auto eight = system.maps;
    for (std::size_t k = 8; k <= document::manyMapsInSpace; ++k)
        ifs::append<3>(system, eight[k % 8].map);
    return many;
}

} // namespace

// Also where it lies over the corner; beside the corner the ball turns the view.
void SpaceHandlesTest::theBallNeverWinsOverACorner() {
    Window window;
    QVERIFY(window.rests());
    const QPoint ball(600 - 20 - 44, 20 + 44); // its middle, as AxisBall::layOut() places it
    attractor::OrbitCamera moved = window.camera();
    moved.height /= 4;
    window.view->navigation().moveTo(moved);
    const QPointF shift = QPointF(ball) - QPointF(window.handle(1));
    window.view->navigation().moveTo(attractor::panned(window.camera(), {shift.x(), shift.y()}));
    QVERIFY(window.rests());
    QVERIFY((window.handle(1) - ball).manhattanLength() <= 2);
    const attractor::OrbitCamera before = window.camera();
    window.drag(ball, ball + QPoint(-60, 40));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QCOMPARE(window.camera(), before);
    window.drag(ball + QPoint(25, 25), ball + QPoint(-60, 40));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(window.camera() != before);
}

// As in the plane: a drag may take a corner out of sight, a command may not.
void SpaceHandlesTest::commandsKeepTheCageInTheView() {
    Window window;
    QVERIFY(window.rests());
    const auto areAllSeen = [&] {
        for (std::size_t vertex = 0; vertex < window.view->cageItem().count(); ++vertex)
            if (!window.view->viewport()->rect().contains(window.handle(vertex))) return false;
        return true;
    };
    QVERIFY(areAllSeen());
    document::Fractal fractal = window.document.fractal();
    ifs::ControlCage<3> cage = *document::spaceCage(fractal);
    for (ifs::Vector<3>& corner : cage.current)
        corner += ifs::Vector<3>(7, 0, 3);
    document::space(fractal)->cage = cage;
    window.document.edit(QStringLiteral("Move the cage"), fractal);
    QTRY_VERIFY(areAllSeen());
    QVERIFY(window.view->navigation().isFitted());
}

// Of a corner that a zoom has taken out of the view; a click on it fits.
void SpaceHandlesTest::anArrowLeadsToACornerOutside() {
    Window window;
    QVERIFY(window.rests());
    const auto arrows = [&]() -> std::vector<view::BorderArrow> {
        for (const QGraphicsItem* item : window.view->scene()->items())
            if (const auto* found = dynamic_cast<const view::BorderArrowsItem*>(item))
                return found->isVisible() ? found->arrows() : std::vector<view::BorderArrow>();
        return {};
    };
    QVERIFY(arrows().empty());
    attractor::OrbitCamera near = window.camera();
    near.height /= 2;
    window.view->navigation().moveTo(near);
    QVERIFY(window.rests());
    QVERIFY(!arrows().empty());
    const QSignalSpy said(window.view.get(), &SpaceView::message);
    const QPointF at = arrows().front().at;
    window.send(QEvent::MouseMove, at, Qt::NoButton);
    QCOMPARE(window.view->viewport()->cursor().shape(), Qt::PointingHandCursor);
    QVERIFY(!said.isEmpty());
    window.send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
    QVERIFY(arrows().empty());
    QVERIFY(window.view->navigation().isFitted());
    for (std::size_t vertex = 0; vertex < window.view->cageItem().count(); ++vertex)
        QVERIFY(window.view->viewport()->rect().contains(window.handle(vertex)));
    QCOMPARE(window.document.undoStack()->count(), 0);
    window.view->setOverlaysVisible(false);
    window.view->navigation().moveTo(near);
    QVERIFY(arrows().empty());
}

void SpaceHandlesTest::fitTakesInTheWholeMotion() {
    document::Fractal swelling = cubeOfEight();
    animation::Animation<3> animation;
    animation.length = 48;
    animation.motions.push_back(animation::Breathe<3>{{}, 0.8, 1});
    document::space(swelling)->animation = animation;
    const Window window(swelling);
    QVERIFY(support::backgroundRests());
    const auto leaves = [&](int frame) { // the view
        const document::Fractal shown =
            document::frameAt(window.document.entryFractal(), animation::moment(frame)).fractal;
        for (int way = 0; way < 8; ++way) {
            ifs::Vector<3> corner;
            for (int i = 0; i < 3; ++i) {
                const document::Extent extent = document::extentAlong(shown, ifs::Vector<3>::Unit(i));
                corner[i] = (way >> i & 1) != 0 ? extent.high : extent.low;
            }
            const QPointF seen = view::seenPoint(window.camera(), corner);
            if (!QRectF(window.view->viewport()->rect()).contains(seen)) return true;
        }
        return false;
    };
    window.view->navigation().moveTo(document::fittedTo(window.document.fractal(), window.camera(), 0.09));
    QVERIFY(leaves(12)); // where the moment alone is fitted
    window.view->navigation().fit();
    QVERIFY(support::backgroundRests());
    for (const int frame : {0, 12, 24, 36, 47})
        QVERIFY2(!leaves(frame), qPrintable(QString::number(frame)));
}

void SpaceHandlesTest::theCageOfVeryManyMapsIsFoundInTheBackground() {
    const document::Fractal many = ofVeryManyMaps();
    Window window(many);
    QCOMPARE(window.view->cageItem().count(), std::size_t(0));
    QVERIFY(window.view->cageItem().handlesAt({100, 100}).empty());
    const view::ExtentFinder finder(&window.document);
    QTRY_COMPARE_WITH_TIMEOUT(window.view->cageItem().count(), std::size_t(4), 60000);
    for (std::size_t vertex = 0; vertex < 4; ++vertex)
        QVERIFY(window.view->viewport()->rect().contains(window.handle(vertex)));
    // A drag now stores the cage; one undo brings the whole back.
    const QPoint before = window.handle(1);
    window.drag(before, before + QPoint(40, -30));
    QVERIFY(QLineF(window.handle(1), before + QPoint(40, -30)).length() < 2);
    window.document.undoStack()->undo();
    QCOMPARE(window.handle(1), before);
    QVERIFY(window.document.fractal() == many);
    QVERIFY(document::isSpaceExtentKnown(window.document.fractal()));
}

// What is told in the middle of a gesture would seem to end it.
void SpaceHandlesTest::theExtentIsAnnouncedAfterAGesture() {
    Window window(ofVeryManyMaps());
    document::Document& document = window.document;
    const view::ExtentFinder finder(&document);
    document::EditGesture gesture = document.beginGesture(QStringLiteral("Move"));
    document::Fractal moved = document.fractal();
    document::system3(moved)->maps[0].map.translation.x() -= 0.25;
    gesture.preview(moved);
    QList<document::Change> changes;
    connect(&document, &document::Document::changed, this,
            [&](const document::Change& change) { changes << change; });
    QTRY_VERIFY_WITH_TIMEOUT(document::isSpaceExtentKnown(document.fractal()), 60000);
    QVERIFY(support::backgroundRests());
    QVERIFY(changes.isEmpty());
    gesture.commit();
    QTRY_COMPARE(changes.size(), 2);
    QVERIFY(!changes[0].live && changes[1].parts == document::Change::Cage && !changes[1].live);
    QVERIFY(support::backgroundRests());
    QCOMPARE(changes.size(), 2);
    document.disconnect(this);
}

void SpaceHandlesTest::aCornerOfAMapIsDraggedInOneStep() {
    Window window;
    const document::Fractal before = window.document.fractal();
    window.view->setTarget(SpaceView::Target::Maps);
    const view::SpaceCageItem& map = window.view->mapItem();
    QCOMPARE(map.count(), std::size_t(5)); // and the middle
    QVERIFY(window.rests());
    // A corner of another map is pressed: that map is held from then on.
    const ifs::AffineMap<3>& third = document::system3(before)->maps[2].map;
    const ifs::Vector<3> top = third(document::spaceCage(before)->rest[2]);
    const QPointF press = view::toPoint(toScreen(window.camera(), top).pixel);
    window.drag(press, press + QPointF(12, -9));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 3 of map 3"));
    const auto& maps = document::system3(window.document.fractal())->maps;
    const auto cage = *document::spaceCage(window.document.fractal());
    QVERIFY(cage == *document::spaceCage(before)); // it stays where the code changes under it
    for (std::size_t i = 0; i < maps.size(); ++i)
        QCOMPARE(maps[i].map == document::system3(before)->maps[i].map, i != 2);
    for (const std::size_t corner : {0, 1, 3})
        QVERIFY((maps[2].map(cage.rest[corner]) - third(cage.rest[corner])).norm() < 1e-12);
    const QPointF moved = view::toPoint(toScreen(window.camera(), maps[2].map(cage.rest[2])).pixel);
    QVERIFY(QLineF(moved, press + QPointF(12, -9)).length() < 1);
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == before);

    window.send(QEvent::MouseButtonPress, press, Qt::LeftButton);
    window.send(QEvent::MouseMove, press + QPointF(30, 30), Qt::LeftButton);
    QVERIFY(!(window.document.fractal() == before));
    QVERIFY(window.view->cancelGesture());
    QVERIFY(window.document.fractal() == before);
}

void SpaceHandlesTest::theMiddleOfAMapMovesItAsAWhole() {
    Window window;
    window.view->setTarget(SpaceView::Target::Maps);
    const document::Fractal before = window.document.fractal();
    const QPointF middle = window.view->mapItem().handle(view::SpaceMaps::middle);
    window.drag(middle, middle + QPointF(10, 5));
    const auto& was = document::system3(before)->maps[0].map;
    const auto& is = document::system3(window.document.fractal())->maps[0].map;
    QVERIFY((was.linear - is.linear).norm() < 1e-12);
    QVERIFY((was.translation - is.translation).norm() > 0.01);
    // Ctrl turns it about its middle.
    const QPointF corner = window.view->mapItem().handle(1);
    window.drag(corner, corner + QPointF(0, -25), Qt::LeftButton, Qt::ControlModifier);
    const auto& turned = document::system3(window.document.fractal())->maps[0].map;
    const auto rest = document::spaceCage(before)->rest;
    const ifs::Vector<3> centre = (rest[0] + rest[1] + rest[2] + rest[3]) / 4;
    QVERIFY((turned(centre) - is(centre)).norm() < 1e-12);
    QVERIFY((turned.linear - is.linear).norm() > 0.01);
    QVERIFY((turned.linear * turned.linear.transpose() - 0.25 * ifs::Matrix<3>::Identity()).norm() < 1e-9);
    QCOMPARE(window.document.undoStack()->count(), 2);
}

void SpaceHandlesTest::aMapIsDraggedNoFartherThanItsAttractor() {
    Window window;
    window.view->setTarget(SpaceView::Target::Maps);
    const QPointF corner = window.view->mapItem().handle(1);
    const QPointF far = corner + 3 * (corner - window.view->mapItem().handle(0));
    window.send(QEvent::MouseButtonPress, corner, Qt::LeftButton);
    window.send(QEvent::MouseMove, far, Qt::LeftButton);
    const auto maps = [&] { return ifs::activeMaps(*document::system3(window.document.fractal())).maps; };
    QVERIFY(ifs::hasAttractor(ifs::classify<3>(maps())));
    QVERIFY2(window.view->note().contains(QStringLiteral("map 1")), qPrintable(window.view->note()));
    window.send(QEvent::MouseButtonRelease, far, Qt::LeftButton);
    QVERIFY(!window.view->note().contains(QStringLiteral("Stopped")));

    window.document.undoStack()->undo();
    window.view->setAllowsNoAttractor(true);
    window.drag(corner, far);
    QVERIFY(!ifs::hasAttractor(ifs::classify<3>(maps())));
}

// As in the plane: the first map may stretch, since it never follows itself.
void SpaceHandlesTest::linkedMapsAreDraggedFreely() {
    document::Fractal linked = cubeOfEight();
    document::System3& system = *document::system3(linked);
    system.links = {{system.maps[0].id, system.maps[0].id, 0}};
    Window window(linked);
    window.view->setTarget(SpaceView::Target::Maps);
    const QPointF middle = window.view->mapItem().handle(view::SpaceMaps::middle);
    const QPointF corner = window.view->mapItem().handle(1);
    window.drag(corner, middle + 3 * (corner - middle), Qt::LeftButton,
                Qt::AltModifier); // to three times the size
    const auto& map = document::system3(window.document.fractal())->maps[0].map;
    QVERIFY(std::abs(ifs::spectralNorm<3>(map.linear) - 1.5) < 0.1);
}

void SpaceHandlesTest::keysSelectAndDeleteMaps() {
    Window window;
    window.view->setTarget(SpaceView::Target::Maps);
    const auto third = document::system3(window.document.fractal())->maps[2].id;
    QTest::keyClick(window.view.get(), Qt::Key_3, Qt::AltModifier);
    QTest::keyClick(window.view.get(), Qt::Key_Delete);
    const auto& maps = document::system3(window.document.fractal())->maps;
    QCOMPARE(maps.size(), std::size_t(7));
    for (const auto& map : maps)
        QVERIFY(map.id != third);
    for (int corner = 0; corner < 6; ++corner) // past the fifth handle lies the next map
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QVERIFY(window.view->accessibleDescription().startsWith(QStringLiteral("Map 4, corner 1")));
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 1 of map 4"));
}

void SpaceHandlesTest::fourViewsShowTheSameDrag() {
    document::Document document;
    document.edit(QStringLiteral("Begin"), cubeOfEight());
    view::SolidBridge bridge(&document);
    view::FourViews views(&document, &bridge);
    views.resize(800, 600);
    views.show();
    QVERIFY(views.others().empty());
    views.showFour(true);
    QCOMPARE(views.others().size(), std::size_t(3));
    QTRY_VERIFY(views.others()[0]->width() > 300 && views.others()[0]->height() > 200);
    views.fit();
    // From the top, x is seen to the right and −z upwards.
    SpaceView* top = views.others()[0];
    const auto& camera = top->navigation().camera();
    const auto seen = [&](const ifs::Vector<3>& at) { return toScreen(camera, at).pixel; };
    QVERIFY((seen({0, 5, 0}) - seen({0, 0, 0})).norm() < 1e-9);
    QVERIFY(seen({1, 0, 0}).x() > seen({0, 0, 0}).x() && seen({0, 0, 1}).y() > seen({0, 0, 0}).y());
    // A vertex dragged there keeps its y, and all see it.
    const auto before = document::spaceCage(document.fractal())->current;
    const QPointF handle = top->cageItem().handle(1);
    const auto send = [&](QEvent::Type type, const QPointF& at) {
        const auto own = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        const auto held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, top->viewport()->mapToGlobal(at), own, held, Qt::NoModifier);
        QCoreApplication::sendEvent(top->viewport(), &event);
    };
    send(QEvent::MouseButtonPress, handle);
    send(QEvent::MouseMove, handle + QPointF(-40, 25));
    send(QEvent::MouseButtonRelease, handle + QPointF(-40, 25));
    const auto after = document::spaceCage(document.fractal())->current;
    QVERIFY(std::abs(after[1].y() - before[1].y()) < 1e-12 && after[1].x() < before[1].x());
    QVERIFY(views.main()->cageItem().vertices() == after);
    // An empty place pans: the direction stays.
    const attractor::OrbitCamera was = camera;
    send(QEvent::MouseButtonPress, {5, 150});
    send(QEvent::MouseMove, {60, 170});
    send(QEvent::MouseButtonRelease, {60, 170});
    QVERIFY(camera.orientation.coeffs() == was.orientation.coeffs() && camera.target != was.target);
    // What there is to say of the picture is said once.
    document::Fractal flat = document.fractal();
    for (ifs::Vector<3>& vertex : document::space(flat)->cage->current)
        vertex.z() = 0;
    document.edit(QStringLiteral("Squeeze"), flat);
    QTRY_VERIFY(!views.main()->note().isEmpty());
    for (const SpaceView* other : views.others())
        QCOMPARE(other->note(), QString());
    document.undoStack()->undo();
    QTRY_COMPARE(views.main()->note(), QString());
    views.setTarget(SpaceView::Target::Definition);
    QVERIFY(views.main()->note().contains(QStringLiteral("first")));
    for (const SpaceView* other : views.others())
        QCOMPARE(other->note(), QString());
    send(QEvent::MouseButtonPress, {60, 60});
    send(QEvent::MouseButtonRelease, {60, 60});
    QVERIFY(top->note().contains(QStringLiteral("second"))); // what goes on there, there
    views.setTarget(SpaceView::Target::Cage);
    views.showFour(false);
    QVERIFY(views.others().empty());
}

void SpaceHandlesTest::aCornerOfABoxBendsTheSolid() {
    Window window;
    document::Fractal boxed =
        *document::withPolyhedronFitted(window.document.fractal(), document::SpacePolyhedron::Box);
    window.document.edit(QStringLiteral("Box"), boxed);
    window.view->navigation().fit();
    QCOMPARE(window.view->cageItem().count(), std::size_t(8));
    QVERIFY(window.rests());
    const QImage before = window.view->picture();
    const QPointF corner = window.view->cageItem().handle(7); // (1, 1, 1)
    window.drag(corner, corner + QPointF(30, -30));
    const auto cage = *document::spaceCage(window.document.fractal());
    QVERIFY(ifs::bends(cage));
    QCOMPARE(cage.current[0], document::space(boxed)->cage->current[0]);
    QVERIFY(window.rests());
    const QPoint inTheCorner = (corner + QPointF(12, -12)).toPoint(); // where nothing was
    QVERIFY(lightness(window.view->picture(), inTheCorner) > 60);
    QVERIFY(window.view->picture().pixel(inTheCorner) != before.pixel(inTheCorner));
    // Its maps are dragged meanwhile, and stay under the pointer.
    window.view->setTarget(SpaceView::Target::Maps);
    const QPointF held = window.view->mapItem().handle(3);
    const auto maps = ifs::mapsOf(*document::system3(window.document.fractal()));
    window.drag(held, held + QPointF(-9, 7));
    const auto after = ifs::mapsOf(*document::system3(window.document.fractal()));
    QVERIFY(after[0] != maps[0]);
    QVERIFY(std::equal(maps.begin() + 1, maps.end(), after.begin() + 1));
    QVERIFY(QLineF(window.view->mapItem().handle(3), held + QPointF(-9, 7)).length() < 0.01);
    window.document.undoStack()->undo();
    window.view->setTarget(SpaceView::Target::Cage);
    window.document.undoStack()->undo();
    QVERIFY(window.rests());
    QCOMPARE(window.view->picture(), before);
}

void SpaceHandlesTest::aFaceTakesItsCornersAlong() {
    Window window;
    document::Fractal boxed =
        *document::withPolyhedronFitted(window.document.fractal(), document::SpacePolyhedron::Box);
    window.document.edit(QStringLiteral("Box"), boxed);
    window.view->navigation().fit();
    const view::SpaceCageItem& cage = window.view->cageItem();
    const auto before = cage.vertices();
    std::optional<std::size_t> top; // y = 1, seen from above
    for (std::size_t i = 0; i < 6; ++i)
        if (std::ranges::all_of(cage.face(i), [&](int k) { return before[std::size_t(k)].y() > 0.5; }))
            top = i;
    QVERIFY(top && cage.faceAt(cage.faceHandle(*top)) == top);
    const QPointF middle = cage.faceHandle(*top);
    window.drag(middle, middle + QPointF(7, -40), Qt::LeftButton, Qt::ShiftModifier); // along its normal
    const auto after = cage.vertices();
    for (std::size_t k = 0; k < 8; ++k) {
        const ifs::Vector<3> by = after[k] - before[k];
        QVERIFY(std::abs(by.x()) < 1e-9 && std::abs(by.z()) < 1e-9);
        QVERIFY(before[k].y() > 0.5 ? by.y() > 0.1 : by.isZero(0));
    }
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move Face %1").arg(*top + 1));
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == boxed);
}

// Under a cage that has been pulled, too. Nothing is there to be held without a symmetry.
void SpaceHandlesTest::theCentreOfASymmetryIsDragged() {
    document::Fractal twice = cubeOfEight();
    ifs::Symmetry<3>& symmetry = document::system3(twice)->symmetry;
    symmetry.group = ifs::SymmetryGroup::Rotation;
    symmetry.order = 2;
    symmetry.centre = {0.3, 0.6, 0.2};
    ifs::ControlCage<3> cage = *document::spaceCage(cubeOfEight());
    for (ifs::Vector<3>& vertex : cage.current)
        vertex.x() *= 1.25;
    document::space(twice)->cage = cage;
    Window window(twice);
    const auto centre = [&] { return document::system3(window.document.fractal())->symmetry.centre; };
    const auto pixel = [&] {
        const ifs::Vector<3> shown(1.25 * centre().x(), centre().y(), centre().z());
        return view::toPoint(toScreen(window.camera(), shown).pixel);
    };
    const auto knob = window.view->symmetryItem().knob();
    QVERIFY(knob && window.view->viewport()->rect().contains(knob->toPoint()));
    QVERIFY(window.view->cageItem().handlesAt(*knob).empty());
    const QPointF before = pixel(), way(36, -20);
    window.drag(*knob, *knob + way);
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(QLineF(pixel(), before + way).length() < 1);
    QVERIFY(QLineF(*window.view->symmetryItem().knob(), *knob + way).length() < 1);
    QVERIFY(window.vertices() == cage.current);
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == twice);

    // Z keeps it on the axis.
    window.send(QEvent::MouseButtonPress, *knob, Qt::LeftButton);
    window.send(QEvent::MouseMove, *knob + QPointF(0, -30), Qt::LeftButton);
    QTest::keyClick(window.view.get(), Qt::Key_Z);
    window.send(QEvent::MouseMove, *knob + QPointF(0, -40), Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, *knob + QPointF(0, -40), Qt::LeftButton);
    QVERIFY(std::abs(centre().x() - 0.3) < 1e-9 && std::abs(centre().y() - 0.6) < 1e-9);
    QVERIFY(std::abs(centre().z() - 0.2) > 1e-3);

    document::Fractal plain = twice;
    document::system3(plain)->symmetry = {};
    window.document.edit(QStringLiteral("None"), plain);
    QVERIFY(!window.view->symmetryItem().knob());
}

BARYCAGE_TEST(SpaceHandlesTest, QApplication);
#include "space_handles_test.moc"
