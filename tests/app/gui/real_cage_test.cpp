// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"
#include "canvas/scene/canvas_scene.h"
#include "canvas/scene/transient_marks.h"
#include "support/window_on_x.h"

#include <Eigen/Geometry>

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <numbers>

using ifs::Vector;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// The gestures of the paper, and all others that take the cage, with a real pointer and real keys.
class RealCageTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void draggingAVertexIsOneStep();
    void undoInMidDragTakesBackTheDragAlone();
    void draggingAnEdgeMovesBothItsEnds();
    void draggingTheInsideMovesTheWholeCage();
    void theHandlesTurnAndScale();
    void controlTurnsAndAltScales();
    void aKeyPressedDuringTheDragCounts();
    void whatADragHasComeToIsSaidAtThePointer();
    void thePivotCanBeMoved();
    void shiftConstrains();
    void draggedVerticesSnap();
    void escapeTakesADragBack_data();
    void escapeTakesADragBack();
    void squeezedFlatAndReopenedIsExactlyTheSame();
    void flatAndMirroredPicturesAreSavedAndOpened();
    void threeClicksDefineTheTriangle();
};

namespace {

double angleBetween(const Vector<2>& a, const Vector<2>& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// The turn about `pivot` that leads from one triangle to the other; NaN when it is none.
double turn(const std::vector<Vector<2>>& from, const std::vector<Vector<2>>& to, const Vector<2>& pivot) {
    std::size_t far = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        if ((from[i] - pivot).norm() > (from[far] - pivot).norm()) far = i;
    const double angle = angleBetween(from[far] - pivot, to[far] - pivot);
    const ifs::Matrix<2> rotation = Eigen::Rotation2D<double>(angle).toRotationMatrix();
    for (std::size_t i = 0; i < from.size(); ++i)
        if ((pivot + rotation * (from[i] - pivot) - to[i]).norm() > 1e-9) return NAN;
    return angle;
}

// The positive factors about `pivot` that lead from one triangle to the other; NaN when it is no scaling.
Vector<2> factors(const std::vector<Vector<2>>& from, const std::vector<Vector<2>>& to,
                  const Vector<2>& pivot) {
    const auto extent = [](const std::vector<Vector<2>>& vertices) {
        const Vector<2> a = vertices[0].cwiseMax(vertices[1]).cwiseMax(vertices[2]);
        const Vector<2> b = vertices[0].cwiseMin(vertices[1]).cwiseMin(vertices[2]);
        return Vector<2>(a - b);
    };
    const Vector<2> found = extent(to).cwiseQuotient(extent(from));
    for (std::size_t i = 0; i < from.size(); ++i)
        if ((pivot + (from[i] - pivot).cwiseProduct(found) - to[i]).norm() > 1e-9) return {NAN, NAN};
    return found;
}

} // namespace

void RealCageTest::draggingAVertexIsOneStep() {
    const document::Fractal before = fractal();
    const std::vector<Vector<2>> held = vertices();
    dragBy(vertex(1), {60, -55});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {60, -55}) < 1e-6);
    QCOMPARE(vertices()[0], held[0]);
    QCOMPARE(vertices()[2], held[2]);
    QVERIFY(document::isSameSystem(fractal(), before)); // the code stays: the cage moves the picture
    const std::vector<Vector<2>> moved = vertices();

    hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
    hand().key("Control+y");
    QTRY_COMPARE(vertices(), moved);
    hand().key("Control+z");
    hand().key("Control+Shift+z");
    QTRY_COMPARE(vertices(), moved);
}

void RealCageTest::undoInMidDragTakesBackTheDragAlone() {
    dragBy(vertex(1), {60, -55});
    QTRY_COMPARE(steps(), 1);
    const std::vector<Vector<2>> moved = vertices();
    hand().moveTo(vertex(2));
    hand().press();
    hand().moveTo(vertex(2) + QPoint(20, 30));
    QTRY_VERIFY(vertices() != moved);
    hand().key("Control+z");
    QTRY_COMPARE(vertices(), moved);
    hand().moveTo(vertex(2) + QPoint(-30, 10));
    hand().release();
    hand().settle();
    QCOMPARE(vertices(), moved);
    QCOMPARE(document().undoStack()->index(), 1);
    hand().key("Control+z");
    QTRY_COMPARE(document().undoStack()->index(), 0);
}

void RealCageTest::draggingAnEdgeMovesBothItsEnds() {
    const std::vector<Vector<2>> held = vertices();
    dragBy(handle({Kind::Edge, 1}), {-35, 48});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Move edge 2–3 ")));
    QCOMPARE(vertices()[0], held[0]);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {-35, 48}) < 1e-6);
    QVERIFY(offsetInPixels(vertices()[2], held[2], {-35, 48}) < 1e-6);
}

void RealCageTest::draggingTheInsideMovesTheWholeCage() {
    const std::vector<Vector<2>> held = vertices();
    dragBy(insideTheCage(), {-50, -20});
    QTRY_COMPARE(steps(), 1);
    for (std::size_t i = 0; i < held.size(); ++i)
        QVERIFY(offsetInPixels(vertices()[i], held[i], {-50, -20}) < 1e-6);
}

void RealCageTest::theHandlesTurnAndScale() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().handles().pivot();
    const QPoint from = handle({Kind::Rotate, 0});
    const QPoint about = handle({Kind::Pivot, 0});
    dragBy(from, {-70, 90});
    QTRY_COMPARE(steps(), 1);
    const QPoint to = from + QPoint(-70, 90);
    const double hand = angleBetween({double((from - about).x()), -double((from - about).y())},
                                     {double((to - about).x()), -double((to - about).y())});
    QVERIFY(std::abs(turn(held, vertices(), pivot) - hand) < 0.01);

    const std::vector<Vector<2>> turned = vertices();
    dragBy(handle({Kind::Scale, 0}), {70, 70});
    QTRY_COMPARE(steps(), 2);
    const Vector<2> scale = factors(turned, vertices(), pivot);
    QVERIFY(scale.x() > 1.05);
    QVERIFY(std::abs(scale.x() - scale.y()) < 1e-9);
}

void RealCageTest::controlTurnsAndAltScales() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().handles().pivot();
    hand().hold("Control");
    dragBy(vertex(1), {10, -90});
    hand().letUp("Control");
    QTRY_COMPARE(steps(), 1);
    QVERIFY(std::abs(turn(held, vertices(), pivot)) > 0.1);

    const std::vector<Vector<2>> turned = vertices();
    hand().hold("Alt");
    dragBy(insideTheCage() + QPoint(20, 20), {60, 60});
    hand().letUp("Alt");
    QTRY_COMPARE(steps(), 2);
    const Vector<2> scale = factors(turned, vertices(), pivot);
    QVERIFY(std::abs(scale.x() - 1) > 0.05);
    QVERIFY(std::abs(scale.x() - scale.y()) < 1e-9);
    QVERIFY(canvas().hasFocus()); // and not the menu bar, though Alt was pressed
    hand().key("Escape");
    hand().key("Tab");
    QTRY_COMPARE(canvas().canvas().selection().focused(), (CanvasPart{Kind::Vertex, 0}));
}

// For window managers that take a press with Alt for themselves.
void RealCageTest::aKeyPressedDuringTheDragCounts() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().handles().pivot();
    const QPoint start = vertex(2);
    hand().moveTo(start);
    hand().press();
    hand().moveTo(start + QPoint(-30, 10));
    QTRY_VERIFY(vertices()[2] != held[2] && vertices()[1] == held[1]);
    hand().hold("Alt");
    hand().moveTo(start + QPoint(-60, 20));
    QTRY_VERIFY(vertices()[1] != held[1]);
    hand().letUp("Alt"); // does not fall back to moving the vertex
    hand().moveTo(start + QPoint(-62, 20));
    hand().release();
    QTRY_COMPARE(steps(), 1);
    const Vector<2> scale = factors(held, vertices(), pivot);
    QVERIFY(std::abs(scale.x() - scale.y()) < 1e-9);
    QVERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Scale the cage ")));
}

// How far, by what angle or factor: beside the pointer, and only during the drag.
void RealCageTest::whatADragHasComeToIsSaidAtThePointer() {
    const view::TransientMarks& marks = static_cast<view::CanvasScene*>(canvas().scene())->marks();
    const auto said = [&](const CanvasPart& part, const QPoint& by) {
        const QPoint start = handle(part);
        hand().moveTo(start);
        hand().press();
        hand().moveTo(start + by / 2);
        hand().moveTo(start + by);
        support::waitFor([&] { return !marks.readout().isEmpty(); });
        const QString text = marks.readout();
        photograph(QStringLiteral("readout-%1.png").arg(int(part.kind)));
        hand().release();
        return support::waitFor([&] { return marks.readout().isEmpty(); }) ? text : QString();
    };
    const std::vector<Vector<2>> held = vertices();
    QVERIFY(said({Kind::Vertex, 1}, {60, -55}).startsWith(QStringLiteral("Δ (")));
    QTRY_COMPARE(steps(), 1);
    const Vector<2> offset = vertices()[1] - held[1];
    const QString moved = said({Kind::Vertex, 1}, {-60, 55});
    const double length = offset.norm();
    const auto isSaid = [&](double value) {
        return std::ranges::any_of(
            moved.split(QRegularExpression(QStringLiteral("[^0-9.]+"))),
            [&](const QString& word) { return std::abs(word.toDouble() - value) <= 0.001 * value; });
    };
    QVERIFY2(isSaid(length), qPrintable(moved));
    QVERIFY2(isSaid((held[1] - held[0]).norm()), qPrintable(moved));
    QVERIFY(said({Kind::Edge, 1}, {20, 20}).contains(QStringLiteral("edge ")));
    const QString turned = said({Kind::Rotate, 0}, {-70, 90});
    QVERIFY2(turned.endsWith(u'°'), qPrintable(turned));
    const QString scaled = said({Kind::Scale, 0}, {40, 0});
    QVERIFY2(scaled.startsWith(QStringLiteral("× 1.")), qPrintable(scaled));
}

void RealCageTest::thePivotCanBeMoved() {
    const std::vector<Vector<2>> held = vertices();
    const QPoint start = handle({Kind::Pivot, 0});
    hand().drag(start, {start + QPoint(20, 10), vertex(0) + QPoint(3, 2)}); // drawn to the vertex
    QCOMPARE(steps(), 0);                                                   // no part of the document
    QCOMPARE(canvas().canvas().handles().pivot(), held[0]);
    dragBy(handle({Kind::Rotate, 0}), {-40, 120});
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(vertices()[0], held[0]);
    QVERIFY(std::abs(turn(held, vertices(), held[0])) > 0.1);
}

void RealCageTest::shiftConstrains() {
    std::vector<Vector<2>> held = vertices();
    hand().hold("Shift");
    dragBy(vertex(1), {70, -25}); // along one axis
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(vertices()[1].y(), held[1].y());
    QVERIFY(offsetInPixels(vertices()[1], held[1], {70, 0}) < 1e-6);

    held = vertices();
    dragBy(handle({Kind::Rotate, 0}), {-30, 210}); // steps of 15°
    QTRY_COMPARE(steps(), 2);
    const double fifteens =
        turn(held, vertices(), canvas().canvas().handles().pivot()) / (std::numbers::pi / 12);
    QVERIFY(std::abs(fifteens) > 0.5);
    QVERIFY(std::abs(fifteens - std::round(fifteens)) < 1e-9);

    held = vertices();
    dragBy(handle({Kind::Scale, 0}), {80, 15}); // along one axis
    QTRY_COMPARE(steps(), 3);
    const Vector<2> scale = factors(held, vertices(), canvas().canvas().handles().pivot());
    QVERIFY(scale.x() > 1.05);
    QVERIFY(std::abs(scale.y() - 1) < 1e-9);
    hand().letUp("Shift");
}

void RealCageTest::draggedVerticesSnap() {
    const std::vector<Vector<2>> held = vertices();
    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Vertices")});
    hand().drag(vertex(0), {vertex(0) + QPoint(10, 10), vertex(1) + QPoint(5, -4)});
    QTRY_COMPARE(vertices()[0], held[1]);
    hand().key("Control+z");

    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Vertices")});
    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Axes")});
    hand().drag(vertex(2),
                {vertex(2) + QPoint(10, 10), onScreen(Vector<2>(0, held[2].y() / 2)) + QPoint(4, 0)});
    QTRY_COMPARE(vertices()[2].x(), 0.0);
    QVERIFY(vertices()[2].y() != 0.0);
    hand().key("Control+z");

    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Axes")});
    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Grid")});
    const double grid = view::gridSpacing(pixelsPerUnit()).minor;
    const Vector<2> crossing = (held[1] / grid).array().round().matrix() * grid + Vector<2>(-2, 3) * grid;
    hand().drag(vertex(1), {vertex(1) + QPoint(-10, -10), onScreen(crossing) + QPoint(3, -3)});
    QTRY_VERIFY((vertices()[1] - crossing).norm() < 1e-9);
}

void RealCageTest::escapeTakesADragBack_data() {
    QTest::addColumn<CanvasPart>("part");
    QTest::newRow("vertex") << CanvasPart{Kind::Vertex, 2};
    QTest::newRow("edge") << CanvasPart{Kind::Edge, 0};
    QTest::newRow("inside") << CanvasPart{Kind::Inside, 0};
    QTest::newRow("rotate handle") << CanvasPart{Kind::Rotate, 0};
    QTest::newRow("scale handle") << CanvasPart{Kind::Scale, 0};
}

void RealCageTest::escapeTakesADragBack() {
    QFETCH(CanvasPart, part);
    const document::Fractal before = fractal();
    const QPoint start = part.kind == Kind::Inside ? insideTheCage() : handle(part);
    hand().moveTo(start);
    hand().press();
    hand().moveTo(start + QPoint(50, 20));
    QTRY_VERIFY(fractal() != before);
    hand().key("Escape");
    QTRY_VERIFY(fractal() == before);
    hand().moveTo(start + QPoint(70, 40)); // the button is still down
    QVERIFY(fractal() == before);
    hand().release();
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(steps(), 0);
    dragBy(start, {30, 30}); // and the next drag is as good as any
    QTRY_COMPARE(steps(), 1);
}

void RealCageTest::squeezedFlatAndReopenedIsExactlyTheSame() {
    const document::Fractal before = fractal();
    const QPoint start = vertex(2);
    // Through the opposite edge (the middle of the other two vertices), to the mirror side, and home.
    const QPoint middle = (vertex(0) + vertex(1)) / 2;
    hand().drag(start, {middle, middle * 2 - start, middle, start + QPoint(20, 0), start});
    QVERIFY(fractal() == before);
    QCOMPARE(steps(), 0);
}

void RealCageTest::flatAndMirroredPicturesAreSavedAndOpened() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const std::vector<Vector<2>> held = vertices();
    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Vertices")});
    hand().drag(vertex(2), {vertex(2) + QPoint(10, 10), vertex(0) + QPoint(3, 3)}); // flat
    QTRY_COMPARE(vertices()[2], held[0]);
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::plane(savedEntry(path))->cage->current, vertices());

    window().openPath(path);
    QCOMPARE(vertices()[2], held[0]);
    hand().moveTo(middleOf(canvas().viewport()));
    hand().wheel(-4); // what is fitted is flat now
    hand().drag(vertex(2), {vertex(2) + QPoint(10, 10), onScreen(held[2])});
    QTRY_VERIFY((vertices()[2] - held[2]).norm() * pixelsPerUnit() < 1);
    choose({QStringLiteral("View"), QStringLiteral("Canvas"), QStringLiteral("Snap To"),
            QStringLiteral("Vertices")});
    hand().drag(vertex(0), {vertex(0) + QPoint(10, 10), onScreen(held[1] + held[2] - held[0])}); // mirrored
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::plane(savedEntry(path))->cage->current, vertices());
}

void RealCageTest::threeClicksDefineTheTriangle() {
    const QPoint middle = middleOf(canvas().viewport());
    hand().key("d");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::DefineTriangle);
    const QList<QPoint> corners{middle + QPoint(-150, 120), middle + QPoint(160, 130),
                                middle + QPoint(10, -180)};
    hand().clickAt(corners[0]);
    hand().clickAt(corners[2]);
    hand().key("BackSpace");
    hand().clickAt(corners[1]);
    hand().clickAt(corners[2]);
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Cage);
    QTRY_COMPARE(steps(), 1);
    for (int i = 0; i < 3; ++i)
        QVERIFY((vertex(i) - corners[i]).manhattanLength() <= 2);
    QVERIFY(cage().current == cage().rest); // the picture stays: only what holds it is new

    hand().key("d");
    hand().clickAt(corners[0]);
    hand().key("Escape");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Cage);
    QCOMPARE(steps(), 1);
}

BARYCAGE_TEST_ON_X(RealCageTest);

#include "real_cage_test.moc"
