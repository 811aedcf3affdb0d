// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"
#include "bars/construction_bar.h"
#include "bridges/construction.h"
#include "canvas/scene/canvas_scene.h"
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/system/branch.h"
#include "support/window_on_x.h"

#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <cmath>

using ifs::Vector;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// What is seen and how, and the canvas under the keys alone, with a real pointer and real keys.
class RealCanvasTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void cursorIsAHandOverAVertexAndACrossElsewhere();
    void arrowsNudge();
    void tabWalksTheHandles();
    void theWheelZoomsAtThePointer();
    void keysZoomAndShowLess();
    void theYAxisIsTurned();
    void thePlaneIsPanned();
    void theAddressUnderThePointerIsRead();
    void theStepsOfTheAlgorithmAreShown();
    void theChaosGameIsWatched();

private:
    double shareFilled() const; // of the picture
};

// The corner of the canvas is empty.
double RealCanvasTest::shareFilled() const {
    const QImage picture = canvas().picture();
    qint64 filled = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            filled += picture.pixel(x, y) != picture.pixel(0, 0);
    return double(filled) / (double(picture.width()) * picture.height());
}

void RealCanvasTest::cursorIsAHandOverAVertexAndACrossElsewhere() {
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
    hand().moveTo(insideTheCage());
    QTRY_COMPARE(shape(), Qt::CrossCursor);
}

void RealCanvasTest::arrowsNudge() {
    const std::vector<Vector<2>> held = vertices();
    hand().clickAt(onCanvas({10, 200}));
    hand().key("Tab"); // vertex 1
    hand().key("Right");
    QTRY_VERIFY(offsetInPixels(vertices()[0], held[0], {1, 0}) < 1e-6);
    hand().key("Shift+Up");
    QTRY_VERIFY(offsetInPixels(vertices()[0], held[0], {1, -10}) < 1e-6);
    hand().key("Alt+Left");
    QTRY_VERIFY(std::abs((vertices()[0].x() - held[0].x()) * pixelsPerUnit() - 0.9) < 1e-6);
    QTRY_COMPARE(steps(), 1); // they followed each other within a second
    QTest::qWait(1200);       // what comes sooner joins the step before, by the clock
    hand().hold("Down");      // long enough to repeat
    QVERIFY(support::waitFor([&] { return (vertices()[0].y() - held[0].y()) * pixelsPerUnit() < 5.5; }));
    hand().letUp("Down");
    QTRY_COMPARE(steps(), 2); // one step, however often it repeated
    QCOMPARE(vertices()[1], held[1]);
    hand().key("Control+z");
    hand().key("Control+z");
    QTRY_COMPARE(vertices(), held);
}

void RealCanvasTest::tabWalksTheHandles() {
    hand().clickAt(onCanvas({10, 200}));
    const std::vector<CanvasPart> handles = canvas().canvas().handles().parts();
    for (const CanvasPart& part : handles) {
        hand().key("Tab");
        QTRY_COMPARE(canvas().canvas().selection().focused(), part);
    }
    hand().key("Tab"); // out of the canvas
    QTRY_VERIFY(!canvas().hasFocus());
    QCOMPARE(canvas().canvas().selection().focused().kind, CanvasPart::Kind::None);
    hand().key("Shift+Tab"); // and back
    QTRY_VERIFY(canvas().hasFocus());
    hand().key("Shift+Tab");
    QTRY_COMPARE(canvas().canvas().selection().focused(), handles.back());
    hand().key("F6");
    QTRY_VERIFY(!canvas().hasFocus());
}

void RealCanvasTest::theWheelZoomsAtThePointer() {
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

void RealCanvasTest::thePlaneIsPanned() {
    const attractor::Camera fitted = canvas().camera();
    const std::vector<Vector<2>> held = vertices();
    const QPoint corner = vertex(0);
    hand().drag(vertex(1), {vertex(1) + QPoint(30, 12), vertex(1) + QPoint(90, -35)},
                support::XInput::Middle);
    QTRY_COMPARE(vertex(0), corner + QPoint(90, -35));

    const support::KeyPresses presses;
    hand().hold("space");
    QTRY_COMPARE(canvas().viewport()->cursor().shape(), Qt::OpenHandCursor);
    hand().moveTo(vertex(1));
    hand().press();
    QTRY_COMPARE(canvas().viewport()->cursor().shape(), Qt::ClosedHandCursor);
    QTRY_VERIFY(presses.count() > 3); // the key repeats
    hand().moveTo(vertex(1) + QPoint(-50, 5));
    hand().release();
    hand().letUp("space");
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

void RealCanvasTest::keysZoomAndShowLess() {
    const double fitted = pixelsPerUnit();
    hand().key("Control+minus");
    QTRY_VERIFY(pixelsPerUnit() < 0.9 * fitted);
    hand().key("1");
    QTRY_COMPARE(pixelsPerUnit(), 100.0);
    hand().key("f");
    QTRY_COMPARE(pixelsPerUnit(), fitted);

    hand().key("g");
    QTRY_VERIFY(!canvas().options().isGridVisible());
    hand().key("a");
    QTRY_VERIFY(!canvas().options().areAxesVisible());
    hand().key("h");
    QTRY_VERIFY(!canvas().options().overlaysVisible());
    dragBy(vertex(1), {20, 20}); // what is not seen is not taken
    QCOMPARE(steps(), 0);
    hand().key("h");
    QTRY_VERIFY(canvas().options().overlaysVisible());
    hand().key("g");
    hand().key("a");
    QTRY_VERIFY(canvas().options().isGridVisible() && canvas().options().areAxesVisible());
}

// The coordinates of the paper; the hand stays the hand.
void RealCanvasTest::theYAxisIsTurned() {
    const std::vector<Vector<2>> held = vertices();
    const int before = (vertex(0) - vertex(2)).y() + (vertex(0) - vertex(1)).y();
    hand().key("y");
    QTRY_COMPARE(canvas().navigation().yAxis(), attractor::YAxis::Down);
    QVERIFY(std::abs((vertex(0) - vertex(2)).y() + (vertex(0) - vertex(1)).y() + before) <= 2);
    dragBy(vertex(1), {-30, -40});
    QTRY_COMPARE(steps(), 1);
    const Vector<2> offset = (vertices()[1] - held[1]) * pixelsPerUnit();
    QVERIFY((offset - Vector<2>(-30, -40)).norm() < 1e-6);
}

void RealCanvasTest::theAddressUnderThePointerIsRead() {
    hand().key("Control+n"); // a Sierpiński triangle
    const auto maps = ifs::activeMaps(code()).maps;
    const Vector<2> point = *ifs::addressPoint<2>(maps, {2, 1, 0}, {0, 1, 2});
    hand().moveTo(onScreen(document::placement(fractal())(point)));
    const auto* bar = named<QLabel>(window(), QStringLiteral("Pointer position"));
    QTRY_VERIFY(bar->text().contains(QStringLiteral("address 3 2 1")));
    QVERIFY(bar->text().contains(QStringLiteral("barycentric (")));
    hand().moveTo(onCanvas({5, 5}));
    QTRY_VERIFY(!bar->text().contains(QStringLiteral("address")));
}

void RealCanvasTest::theStepsOfTheAlgorithmAreShown() {
    const auto* construction = window().findChild<view::Construction*>();
    hand().key("w");
    click(named<QToolButton>(window(), QStringLiteral("Step by Step")));
    QTRY_COMPARE(construction->mode(), view::Construction::Mode::Steps);
    auto* slider = window().findChild<view::ConstructionBar*>()->steps();
    click(slider);
    hand().key("Home");
    QTRY_COMPARE(construction->step(), 0);
    const Vector<2> a = vertices()[1] - vertices()[0];
    const Vector<2> b = vertices()[2] - vertices()[0];
    const double triangle = std::abs(a.x() * b.y() - a.y() * b.x()) / 2 * pixelsPerUnit() * pixelsPerUnit();
    const double expected = triangle / (double(canvas().camera().width) * canvas().camera().height);
    QTRY_VERIFY(std::abs(shareFilled() / expected - 1) < 0.02); // W⁰ is the cage itself
    photograph(QStringLiteral("step-0.png"));

    const auto onSlider = [&](double share) {
        return slider->mapToGlobal(QPoint(qRound(8 + share * (slider->width() - 16)), slider->height() / 2));
    };
    hand().drag(onSlider(0), {onSlider(0.4), onSlider(1.1)});
    QTRY_COMPARE(construction->step(), construction->deepest());
    QTRY_VERIFY(shareFilled() < 0.6 * expected);
    hand().key("Left");
    QTRY_COMPARE(construction->step(), construction->deepest() - 1);

    hand().clickAt(onCanvas({10, 200}));
    hand().key("w"); // put away, and the picture is its measure again
    QTRY_COMPARE(construction->mode(), view::Construction::Mode::Density);
    QCOMPARE(steps(), 0);
}

void RealCanvasTest::theChaosGameIsWatched() {
    const auto* construction = window().findChild<view::Construction*>();
    hand().key("w");
    click(named<QToolButton>(window(), QStringLiteral("Chaos Game")));
    const auto* one = named<QToolButton>(window(), QStringLiteral("One Jump"));
    for (int i = 0; i < 17; ++i)
        click(one);
    QTRY_COMPARE(construction->points(), std::uint64_t{3}); // without the first 14 jumps
    QCOMPARE(construction->trail().size(), std::size_t{17});
    QTRY_VERIFY(shareFilled() > 0);
    const double three = shareFilled();

    click(window().findChild<view::ConstructionBar*>()->run());
    QTRY_VERIFY(construction->points() > 12);
    click(window().findChild<view::ConstructionBar*>()->run());
    QTRY_VERIFY(!construction->isRunning());
    QTRY_VERIFY(shareFilled() > 2 * three);
    click(named<QToolButton>(window(), QStringLiteral("Restart")));
    QTRY_COMPARE(construction->points(), std::uint64_t{0});
}

BARYCAGE_TEST_ON_X(RealCanvasTest);

#include "real_canvas_test.moc"
