// SPDX-License-Identifier: MIT
#include "attractor/camera.h"
#include "canvas/canvas_scene.h"
#include "panels/maps_panel.h"
#include "support/window_on_x.h"

#include <QDialog>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

using ifs::Vector;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// The gestures of the paper, and all others on the canvas, with a real pointer and real keys.
class RealInputTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void draggingAVertexIsOneStep();
    void draggingAnEdgeMovesBothItsEnds();
    void draggingTheInsideMovesTheWholeCage();
    void theHandlesTurnAndScale();
    void controlTurnsAndAltScales();
    void aKeyPressedDuringTheDragCounts();
    void thePivotCanBeMoved();
    void shiftConstrains();
    void draggedVerticesSnap();
    void cursorIsAHandOverAVertexAndACrossElsewhere();
    void escapeTakesADragBack_data();
    void escapeTakesADragBack();
    void arrowsNudge();
    void tabWalksTheHandles();
    void squeezedFlatAndReopenedIsExactlyTheSame();
    void flatAndMirroredPicturesAreSavedAndOpened();
    void threeClicksDefineTheTriangle();
    void mapsAreDragged();
    void theWheelZoomsAtThePointer();
    void thePlaneIsPanned();
    void draggedFractalSavesAndReopens();
    void aNewFileGivesUpTheDrag();

private:
    double pixelsPerUnit() const { return canvas().camera().pixelsPerUnit; }
    std::vector<Vector<2>> vertices() const { return cage().current; }
    double offsetInPixels(const Vector<2>& after, const Vector<2>& before, const QPoint& by) const;
    void dragBy(const QPoint& start, const QPoint& by);
    QPoint inside() const { return (vertex(0) * 2 + vertex(1) * 3 + vertex(2) * 4) / 9; }
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

void RealInputTest::dragBy(const QPoint& start, const QPoint& by) {
    hand().drag(start, {start + by / 4, start + by * 2 / 3, start + by});
}

// How far the pointer's offset is from that of a point of the plane.
double RealInputTest::offsetInPixels(const Vector<2>& after, const Vector<2>& before,
                                     const QPoint& by) const {
    const Vector<2> offset = (after - before) * pixelsPerUnit();
    return std::hypot(offset.x() - by.x(), offset.y() + by.y()); // y is up in the plane
}

void RealInputTest::draggingAVertexIsOneStep() {
    const document::Fractal before = fractal();
    const std::vector<Vector<2>> held = vertices();
    dragBy(vertex(1), {60, -55});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {60, -55}) < 1e-6);
    QCOMPARE(vertices()[0], held[0]);
    QCOMPARE(vertices()[2], held[2]);
    QCOMPARE(fractal().system, before.system); // the code stays: the cage moves the picture
    const std::vector<Vector<2>> moved = vertices();

    hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
    hand().key("Control+y");
    QTRY_COMPARE(vertices(), moved);
    hand().key("Control+z");
    hand().key("Control+Shift+z");
    QTRY_COMPARE(vertices(), moved);
}

void RealInputTest::draggingAnEdgeMovesBothItsEnds() {
    const std::vector<Vector<2>> held = vertices();
    dragBy(handle({Kind::Edge, 1}), {-35, 48});
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Move edge 2–3"));
    QCOMPARE(vertices()[0], held[0]);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {-35, 48}) < 1e-6);
    QVERIFY(offsetInPixels(vertices()[2], held[2], {-35, 48}) < 1e-6);
}

void RealInputTest::draggingTheInsideMovesTheWholeCage() {
    const std::vector<Vector<2>> held = vertices();
    dragBy(inside(), {-50, -20});
    QTRY_COMPARE(steps(), 1);
    for (std::size_t i = 0; i < held.size(); ++i)
        QVERIFY(offsetInPixels(vertices()[i], held[i], {-50, -20}) < 1e-6);
}

void RealInputTest::theHandlesTurnAndScale() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().pivot();
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

void RealInputTest::controlTurnsAndAltScales() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().pivot();
    hand().hold("Control");
    dragBy(vertex(1), {10, -90});
    hand().letGo("Control");
    QTRY_COMPARE(steps(), 1);
    QVERIFY(std::abs(turn(held, vertices(), pivot)) > 0.1);

    const std::vector<Vector<2>> turned = vertices();
    hand().hold("Alt");
    dragBy(inside() + QPoint(20, 20), {60, 60});
    hand().letGo("Alt");
    QTRY_COMPARE(steps(), 2);
    const Vector<2> scale = factors(turned, vertices(), pivot);
    QVERIFY(std::abs(scale.x() - 1) > 0.05);
    QVERIFY(std::abs(scale.x() - scale.y()) < 1e-9);
    QVERIFY(canvas().hasFocus()); // and not the menu bar, though Alt was pressed
    hand().key("Escape");
    hand().key("Tab");
    QTRY_COMPARE(canvas().canvas().focused(), (CanvasPart{Kind::Vertex, 0}));
}

// For window managers that take a press with Alt for themselves.
void RealInputTest::aKeyPressedDuringTheDragCounts() {
    const std::vector<Vector<2>> held = vertices();
    const Vector<2> pivot = canvas().canvas().pivot();
    const QPoint start = vertex(2);
    hand().moveTo(start);
    hand().press();
    hand().moveTo(start + QPoint(-30, 10));
    QTRY_VERIFY(vertices()[2] != held[2] && vertices()[1] == held[1]);
    hand().hold("Alt");
    hand().moveTo(start + QPoint(-60, 20));
    QTRY_VERIFY(vertices()[1] != held[1]);
    hand().letGo("Alt"); // does not fall back to moving the vertex
    hand().moveTo(start + QPoint(-62, 20));
    hand().release();
    QTRY_COMPARE(steps(), 1);
    const Vector<2> scale = factors(held, vertices(), pivot);
    QVERIFY(std::abs(scale.x() - scale.y()) < 1e-9);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Scale the cage"));
}

void RealInputTest::thePivotCanBeMoved() {
    const std::vector<Vector<2>> held = vertices();
    const QPoint start = handle({Kind::Pivot, 0});
    hand().drag(start, {start + QPoint(20, 10), vertex(0) + QPoint(3, 2)}); // drawn to the vertex
    QCOMPARE(steps(), 0);                                                   // no part of the document
    QCOMPARE(canvas().canvas().pivot(), held[0]);
    dragBy(handle({Kind::Rotate, 0}), {-40, 120});
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(vertices()[0], held[0]);
    QVERIFY(std::abs(turn(held, vertices(), held[0])) > 0.1);
}

void RealInputTest::shiftConstrains() {
    std::vector<Vector<2>> held = vertices();
    hand().hold("Shift");
    dragBy(vertex(1), {70, -25}); // along one axis
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(vertices()[1].y(), held[1].y());
    QVERIFY(offsetInPixels(vertices()[1], held[1], {70, 0}) < 1e-6);

    held = vertices();
    dragBy(handle({Kind::Rotate, 0}), {-30, 210}); // steps of 15°
    QTRY_COMPARE(steps(), 2);
    const double fifteens = turn(held, vertices(), canvas().canvas().pivot()) / (std::numbers::pi / 12);
    QVERIFY(std::abs(fifteens) > 0.5);
    QVERIFY(std::abs(fifteens - std::round(fifteens)) < 1e-9);

    held = vertices();
    dragBy(handle({Kind::Scale, 0}), {80, 15}); // along one axis
    QTRY_COMPARE(steps(), 3);
    const Vector<2> scale = factors(held, vertices(), canvas().canvas().pivot());
    QVERIFY(scale.x() > 1.05);
    QVERIFY(std::abs(scale.y() - 1) < 1e-9);
    hand().letGo("Shift");
}

void RealInputTest::draggedVerticesSnap() {
    const std::vector<Vector<2>> held = vertices();
    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Vertices")});
    hand().drag(vertex(0), {vertex(0) + QPoint(10, 10), vertex(1) + QPoint(5, -4)});
    QTRY_COMPARE(vertices()[0], held[1]);
    hand().key("Control+z");

    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Vertices")});
    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Axes")});
    hand().drag(vertex(2),
                {vertex(2) + QPoint(10, 10), onScreen(Vector<2>(0, held[2].y() / 2)) + QPoint(4, 0)});
    QTRY_COMPARE(vertices()[2].x(), 0.0);
    QVERIFY(vertices()[2].y() != 0.0);
    hand().key("Control+z");

    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Axes")});
    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Grid")});
    const double grid = view::gridSpacing(pixelsPerUnit()).minor;
    const Vector<2> crossing = (held[1] / grid).array().round().matrix() * grid + Vector<2>(-2, 3) * grid;
    hand().drag(vertex(1), {vertex(1) + QPoint(-10, -10), onScreen(crossing) + QPoint(3, -3)});
    QTRY_VERIFY((vertices()[1] - crossing).norm() < 1e-9);
}

void RealInputTest::cursorIsAHandOverAVertexAndACrossElsewhere() {
    const auto shape = [this] { return canvas().viewport()->cursor().shape(); };
    hand().moveTo(vertex(0));
    QTRY_COMPARE(shape(), Qt::OpenHandCursor);
    photograph(QStringLiteral("cursor-over-vertex.png"));
    hand().press();
    hand().moveTo(vertex(0) + QPoint(8, 8));
    QTRY_COMPARE(shape(), Qt::ClosedHandCursor);
    hand().moveTo(onCanvas({12, canvas().viewport()->height() / 2}));
    QTRY_COMPARE(shape(), Qt::ClosedHandCursor); // wherever the pointer gets to
    hand().release();
    hand().moveTo(onCanvas({12, 60}));
    QTRY_COMPARE(shape(), Qt::CrossCursor);
    hand().moveTo(inside());
    QTRY_COMPARE(shape(), Qt::CrossCursor);
}

void RealInputTest::escapeTakesADragBack_data() {
    QTest::addColumn<CanvasPart>("part");
    QTest::newRow("vertex") << CanvasPart{Kind::Vertex, 2};
    QTest::newRow("edge") << CanvasPart{Kind::Edge, 0};
    QTest::newRow("inside") << CanvasPart{Kind::Inside, 0};
    QTest::newRow("rotate handle") << CanvasPart{Kind::Rotate, 0};
    QTest::newRow("scale handle") << CanvasPart{Kind::Scale, 0};
}

void RealInputTest::escapeTakesADragBack() {
    QFETCH(CanvasPart, part);
    const document::Fractal before = fractal();
    const QPoint start = part.kind == Kind::Inside ? inside() : handle(part);
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

void RealInputTest::arrowsNudge() {
    const std::vector<Vector<2>> held = vertices();
    hand().clickAt(onCanvas({10, 200}));
    hand().key("Tab"); // vertex 1
    hand().key("Right");
    QTRY_VERIFY(offsetInPixels(vertices()[0], held[0], {1, 0}) < 1e-6);
    hand().key("Shift+Up");
    QTRY_VERIFY(offsetInPixels(vertices()[0], held[0], {1, -10}) < 1e-6);
    hand().key("Alt+Left");
    QTRY_VERIFY(std::abs((vertices()[0].x() - held[0].x()) * pixelsPerUnit() - 0.9) < 1e-6);
    QTRY_COMPARE(steps(), 3);
    hand().hold("Down"); // long enough to repeat
    QVERIFY(support::waitFor([&] { return (vertices()[0].y() - held[0].y()) * pixelsPerUnit() < 5.5; }));
    hand().letGo("Down");
    QTRY_COMPARE(steps(), 4); // one step, however often it repeated
    QCOMPARE(vertices()[1], held[1]);
}

void RealInputTest::tabWalksTheHandles() {
    hand().clickAt(onCanvas({10, 200}));
    const std::vector<CanvasPart> handles = canvas().canvas().handles();
    for (const CanvasPart& part : handles) {
        hand().key("Tab");
        QTRY_COMPARE(canvas().canvas().focused(), part);
    }
    hand().key("Tab");
    QTRY_COMPARE(canvas().canvas().focused(), handles.front());
    hand().key("Shift+Tab");
    QTRY_COMPARE(canvas().canvas().focused(), handles.back());
    hand().key("F6");
    QTRY_VERIFY(!canvas().hasFocus());
}

void RealInputTest::squeezedFlatAndReopenedIsExactlyTheSame() {
    const document::Fractal before = fractal();
    const QPoint start = vertex(2);
    // Through the opposite edge (the middle of the other two vertices), to the mirror side, and home.
    const QPoint middle = (vertex(0) + vertex(1)) / 2;
    hand().drag(start, {middle, middle * 2 - start, middle, start + QPoint(20, 0), start});
    QVERIFY(fractal() == before);
    QCOMPARE(steps(), 0);
}

void RealInputTest::flatAndMirroredPicturesAreSavedAndOpened() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const std::vector<Vector<2>> held = vertices();
    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Vertices")});
    hand().drag(vertex(2), {vertex(2) + QPoint(10, 10), vertex(0) + QPoint(3, 3)}); // flat
    QTRY_COMPARE(vertices()[2], held[0]);
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(savedEntry(path).cage->current, vertices());

    window().openPath(path);
    QCOMPARE(vertices()[2], held[0]);
    hand().moveTo(middleOf(canvas().viewport()));
    hand().wheel(-4); // what is fitted is flat now
    hand().drag(vertex(2), {vertex(2) + QPoint(10, 10), onScreen(held[2])});
    QTRY_VERIFY((vertices()[2] - held[2]).norm() * pixelsPerUnit() < 1);
    choose({QStringLiteral("View"), QStringLiteral("Snap To"), QStringLiteral("Vertices")});
    hand().drag(vertex(0), {vertex(0) + QPoint(10, 10), onScreen(held[1] + held[2] - held[0])}); // mirrored
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(savedEntry(path).cage->current, vertices());
}

void RealInputTest::threeClicksDefineTheTriangle() {
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

void RealInputTest::mapsAreDragged() {
    hand().key("m");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Maps);
    const ifs::AffineMap<2> before = document::system2(fractal())->maps[2].map;
    const Vector<2> vertex = cage().rest[1];
    hand().moveTo(handle({Kind::Vertex, 1, 2}));
    QTRY_COMPARE(canvas().viewport()->cursor().shape(), Qt::OpenHandCursor);
    dragBy(handle({Kind::Vertex, 1, 2}), {14, -11});
    QTRY_COMPARE(steps(), 1);
    const auto& maps = document::system2(fractal())->maps;
    QVERIFY(offsetInPixels(maps[2].map(vertex), before(vertex), {14, -11}) < 1e-6);
    QCOMPARE(canvas().selectedMaps(), std::vector<ifs::MapId>{maps[2].id});
    const auto* table = window().findChild<view::MapsPanel*>();
    QVERIFY(table->selectedMaps() == canvas().selectedMaps());
    photograph(QStringLiteral("maps"));

    hand().key("Control+z");
    QTRY_VERIFY(document::system2(fractal())->maps[2].map == before);
    hand().key("c");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Cage);
}

void RealInputTest::theWheelZoomsAtThePointer() {
    const QPoint at = vertex(1) + QPoint(-40, 25);
    const QPoint pixel = canvas().viewport()->mapFromGlobal(at);
    const auto under = [&] { return attractor::toWorld(canvas().camera(), Vector<2>(pixel.x(), pixel.y())); };
    const Vector<2> point = under();
    const double before = pixelsPerUnit();
    hand().moveTo(at);
    hand().wheel(5);
    QTRY_VERIFY(pixelsPerUnit() > 2 * before);
    QVERIFY((under() - point).norm() * pixelsPerUnit() < 1e-6);
    hand().wheel(-5);
    QTRY_VERIFY(std::abs(pixelsPerUnit() / before - 1) < 1e-9);
    QCOMPARE(steps(), 0);
}

void RealInputTest::thePlaneIsPanned() {
    const attractor::Camera fitted = canvas().camera();
    const std::vector<Vector<2>> held = vertices();
    const QPoint corner = vertex(0);
    hand().drag(vertex(1), {vertex(1) + QPoint(30, 12), vertex(1) + QPoint(90, -35)},
                support::XInput::Middle);
    QTRY_COMPARE(vertex(0), corner + QPoint(90, -35));

    hand().hold("space");
    QTRY_COMPARE(canvas().viewport()->cursor().shape(), Qt::OpenHandCursor);
    hand().moveTo(vertex(1));
    hand().press();
    QTRY_COMPARE(canvas().viewport()->cursor().shape(), Qt::ClosedHandCursor);
    QTest::qWait(900); // the key repeats meanwhile
    hand().moveTo(vertex(1) + QPoint(-50, 5));
    hand().release();
    hand().letGo("space");
    QTRY_COMPARE(vertex(0), corner + QPoint(40, -30));
    QCOMPARE(vertices(), held);

    hand().moveTo(onCanvas({30, 30}));
    hand().press(support::XInput::Middle);
    hand().moveTo(onCanvas({80, 90}));
    hand().key("Escape");
    hand().release(support::XInput::Middle);
    QTRY_COMPARE(vertex(0), corner + QPoint(40, -30));

    hand().key("f");
    QTRY_VERIFY(canvas().camera() == fitted);
    QCOMPARE(steps(), 0);
}

void RealInputTest::draggedFractalSavesAndReopens() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    dragBy(vertex(1), {-60, -45});
    const std::vector<Vector<2>> placed = vertices();
    QVERIFY(window().isWindowModified());
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(savedEntry(path).cage->current, placed);
}

// What is only half done is not kept as an edit: no question about it, no step.
void RealInputTest::aNewFileGivesUpTheDrag() {
    hand().moveTo(vertex(1));
    hand().press();
    hand().moveTo(vertex(1) + QPoint(40, -30));
    QTRY_VERIFY(document().isModified());
    hand().key("Control+n");
    QTRY_COMPARE(fractal().name, document::sierpinskiTriangle().name);
    const document::Fractal fresh = fractal();
    hand().moveTo(vertex(1) + QPoint(-30, -60));
    hand().release();
    QVERIFY(fractal() == fresh);
    QCOMPARE(steps(), 0);
    QVERIFY(!visible<QDialog>());
}

int main(int argc, char** argv) {
    RealInputTest test;
    return support::run(test, argc, argv);
}

#include "real_input_test.moc"
