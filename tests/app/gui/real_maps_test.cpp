// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"
#include "bars/branch_bar.h"
#include "canvas/items/note_item.h"
#include "canvas/scene/canvas_scene.h"
#include "ifs/existence/attractor_existence.h"
#include "panels/maps/maps_panel.h"
#include "support/window_on_x.h"
#include "widgets/numbers/number_field.h"

#include <QLabel>
#include <QSlider>

#include <Eigen/LU>

#include <cmath>

using ifs::Vector;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// Maps taken on the canvas, with a real pointer and real keys.
class RealMapsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() {
        openWindow();
        if (QTest::currentTestFailed()) return;
        hand().key("m");
        QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Maps);
    }
    void cleanup() { closeWindow(); }

    void mapsAreDragged();
    void theInsideMovesAMap();
    void theHandlesTurnAndScaleAMap();
    void mapsAreSelectedTogether();
    void aRectangleSelectsMaps();
    void keysSelectDuplicateAndDelete();
    void aDragStopsWhereTheAttractorWouldBeLost();
    void orGoesOnWhenThatIsAllowed();
    void theSelectedMapsWeave();
    void theNameOfANumberIsDragged();
    void theMapsMenuArranges();

private:
    ifs::AffineMap<2> map(std::size_t place) const { return code().maps[place].map; }
    QPoint inside(int place) const { // beside the pivot
        return (handle({Kind::Vertex, 0, place}) + handle({Kind::Vertex, 1, place}) +
                handle({Kind::Vertex, 2, place}) * 4) /
               6;
    }
    QString stopNote() const {
        for (const QGraphicsItem* item : canvas().canvas().items())
            if (const auto* note = dynamic_cast<const view::NoteItem*>(item);
                note && note->text().startsWith(QStringLiteral("Stopped")))
                return note->text();
        return {};
    }
    ifs::Verdict verdict() const { return ifs::classify<2>(ifs::activeMaps(code()).maps).verdict; }
};

void RealMapsTest::mapsAreDragged() {
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

void RealMapsTest::theInsideMovesAMap() {
    const ifs::AffineMap<2> before = map(2);
    hand().key("Alt+3"); // its image overlaps others
    dragBy(inside(2), {12, 9});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Move map 3 ")));
    QCOMPARE(map(2).linear, before.linear);
    QVERIFY(offsetInPixels(map(2).translation, before.translation, {12, 9}) < 1e-6);
}

void RealMapsTest::theHandlesTurnAndScaleAMap() {
    hand().key("Alt+3");
    QTRY_COMPARE(canvas().selectedMaps(), std::vector{code().maps[2].id});
    const ifs::AffineMap<2> before = map(2);
    const QPoint arm = handle({Kind::Rotate, 0}) - handle({Kind::Pivot, 0});
    dragBy(handle({Kind::Rotate, 0}), QPoint(-arm.y(), arm.x()) / 3);
    QTRY_VERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Rotate map 3 ")));
    const ifs::Matrix<2> turn = map(2).linear * before.linear.inverse();
    QVERIFY((turn.transpose() * turn - ifs::Matrix<2>::Identity()).norm() < 1e-9);
    QVERIFY(std::abs(turn(0, 1)) > 0.05);

    const ifs::AffineMap<2> turned = map(2);
    dragBy(handle({Kind::Scale, 0}), {-20, -20});
    QTRY_VERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Scale map 3 ")));
    const ifs::Matrix<2> scale = map(2).linear * turned.linear.inverse();
    QVERIFY((scale - scale(0, 0) * ifs::Matrix<2>::Identity()).norm() < 1e-9);
    QVERIFY(scale(0, 0) < 0.95);
    QCOMPARE(steps(), 2);
}

void RealMapsTest::mapsAreSelectedTogether() {
    hand().key("Alt+2");
    QTRY_COMPARE(canvas().selectedMaps(), std::vector{code().maps[1].id});
    hand().hold("Shift");
    hand().clickAt(handle({Kind::Vertex, 1, 3}));
    hand().letUp("Shift");
    const std::vector<ifs::MapId> both{code().maps[1].id, code().maps[3].id};
    QTRY_COMPARE(canvas().selectedMaps(), both);
    QVERIFY(window().findChild<view::MapsPanel*>()->selectedMaps() == both);
    const document::System2 before = code();
    dragBy(inside(1), {9, -7});
    QTRY_COMPARE(steps(), 1);
    for (const std::size_t place : {1U, 3U})
        QVERIFY(offsetInPixels(map(place).translation, before.maps[place].map.translation, {9, -7}) < 1e-6);
    QVERIFY(code().maps[0] == before.maps[0] && code().maps[2] == before.maps[2]);
}

void RealMapsTest::aRectangleSelectsMaps() {
    zoomOut(3); // room around the maps
    QRect all;
    for (int place = 0; place < 4; ++place)
        for (int i = 0; i < 3; ++i)
            all |= QRect(handle({Kind::Vertex, i, place}), QSize(1, 1));
    const QPoint corner = all.topLeft() - QPoint(20, 20);
    hand().drag(corner, {all.center(), all.bottomRight() + QPoint(20, 20)});
    QTRY_COMPARE(canvas().selectedMaps().size(), std::size_t{4});
    hand().clickAt(corner);
    QTRY_VERIFY(canvas().selectedMaps().empty());
    QCOMPARE(steps(), 0);
}

void RealMapsTest::keysSelectDuplicateAndDelete() {
    const document::System2 before = code();
    hand().key("Alt+1");
    QTRY_COMPARE(canvas().selectedMaps(), std::vector{before.maps[0].id});
    hand().key("Delete");
    QTRY_COMPARE(code().maps.size(), std::size_t{3});
    QCOMPARE(code().maps[0].id, before.maps[1].id);
    hand().key("Control+z");
    QTRY_VERIFY(code() == before);
    hand().key("Alt+4");
    hand().key("Insert");
    QTRY_COMPARE(code().maps.size(), std::size_t{5});
    QVERIFY(canvas().selectedMaps() != std::vector{before.maps[3].id}); // the copy
    QCOMPARE(canvas().selectedMaps().size(), std::size_t{1});
}

void RealMapsTest::aDragStopsWhereTheAttractorWouldBeLost() {
    zoomOut(5); // far enough to drag a map out of all bounds
    const QPoint start = handle({Kind::Vertex, 1, 2});
    const QPoint far(onCanvas({8, 8}));
    hand().moveTo(start);
    hand().press();
    hand().moveTo((start + far) / 2);
    hand().moveTo(far);
    QTRY_VERIFY(stopNote().contains(QStringLiteral("map 3")));
    photograph(QStringLiteral("stopped.png"));
    QVERIFY(verdict() == ifs::Verdict::Hyperbolic || verdict() == ifs::Verdict::EventuallyContractive);
    QVERIFY(handle({Kind::Vertex, 1, 2}) != far);
    hand().release();
    QTRY_COMPARE(steps(), 1);
    QVERIFY(stopNote().isEmpty());
}

void RealMapsTest::orGoesOnWhenThatIsAllowed() {
    choose({QStringLiteral("Edit"), QStringLiteral("Fractal"),
            QStringLiteral("Allow Systems without an Attractor")});
    zoomOut(5);
    const QPoint far(onCanvas({8, 8}));
    const QPoint start = handle({Kind::Vertex, 1, 2});
    hand().drag(start, {(start + far) / 2, far});
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(verdict(), ifs::Verdict::None);
    QVERIFY((handle({Kind::Vertex, 1, 2}) - far).manhattanLength() <= 2);
    QTRY_VERIFY(canvas().note().contains(QStringLiteral("No attractor: map 3")));
}

void RealMapsTest::theSelectedMapsWeave() {
    hand().key("Alt+3");
    auto* slider = window().findChild<view::BranchBar*>()->swing();
    QTRY_VERIFY(slider->isEnabled());
    const document::System2 before = code();
    const Vector<2> root = *document::root(fractal());
    const QPoint knob = middleOf(slider);
    hand().moveTo(knob);
    hand().press();
    hand().moveTo(knob + QPoint(slider->width() / 40, 0));
    hand().moveTo(knob + QPoint(slider->width() / 12, 0));
    QTRY_VERIFY(slider->value() > 3);
    const double angle = slider->value() * M_PI / 180;
    hand().release();
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(slider->value(), 0); // back in the middle
    const ifs::Matrix<2> turn = map(2).linear * before.maps[2].map.linear.inverse();
    QVERIFY(std::abs(std::abs(std::atan2(turn(1, 0), turn(0, 0))) - angle) < 1e-9);
    QVERIFY((map(2)(root) - before.maps[2].map(root)).norm() < 1e-9);
    for (const std::size_t other : {0U, 1U, 3U})
        QVERIFY(code().maps[other] == before.maps[other]);
}

// Left and right, finely with Shift and coarsely with Ctrl; one step, and none after Esc.
void RealMapsTest::theNameOfANumberIsDragged() {
    const auto* field = named<view::NumberField>(window(), QStringLiteral("Shift x"));
    const QLabel* name = nullptr;
    for (const auto* label : window().findChildren<QLabel*>())
        if (label->buddy() == field) name = label;
    QVERIFY(name);
    const double before = map(0).translation.x();
    const auto drag = [&](const char* key, int pixels) {
        hand().moveTo(middleOf(name));
        if (key) hand().hold(key);
        hand().press();
        hand().moveTo(middleOf(name) + QPoint(pixels / 2, 0));
        hand().moveTo(middleOf(name) + QPoint(pixels, 0));
    };
    drag(nullptr, 20);
    QTRY_VERIFY(std::abs(map(0).translation.x() - before - 0.05) < 1e-9);
    QCOMPARE(steps(), 0); // it is live, and no step yet
    hand().release();
    QTRY_COMPARE(steps(), 1);
    for (const auto& [key, change] : {std::pair{"Shift", 0.005}, {"Control", 0.5}}) {
        hand().key("Control+z");
        QTRY_COMPARE(map(0).translation.x(), before);
        drag(key, 20);
        QTRY_VERIFY(std::abs(map(0).translation.x() - before - change) < 1e-9);
        hand().release();
        hand().letUp(key);
        QTRY_COMPARE(document().undoStack()->index(), 1);
    }
    hand().key("Control+z");
    QTRY_COMPARE(map(0).translation.x(), before);
    drag(nullptr, -40);
    QTRY_VERIFY(map(0).translation.x() < before);
    hand().key("Escape");
    QTRY_COMPARE(map(0).translation.x(), before);
    hand().release();
    QCOMPARE(document().undoStack()->index(), 0);
}

void RealMapsTest::theMapsMenuArranges() {
    const document::System2 before = code();
    choose({QStringLiteral("Maps"), QStringLiteral("Select All Maps")});
    QTRY_COMPARE(canvas().selectedMaps().size(), before.maps.size());
    choose({QStringLiteral("Maps"), QStringLiteral("Selected Maps"), QStringLiteral("Flip Horizontally")});
    QTRY_COMPARE(steps(), 1);
    for (std::size_t k = 0; k < before.maps.size(); ++k)
        QVERIFY(map(k).linear.determinant() * before.maps[k].map.linear.determinant() < 0);
    choose({QStringLiteral("Maps"), QStringLiteral("Selected Maps"), QStringLiteral("Flip Horizontally")});
    QTRY_COMPARE(steps(), 2);
    for (std::size_t k = 0; k < before.maps.size(); ++k)
        QVERIFY((map(k).linear - before.maps[k].map.linear).norm() < 1e-12);
}

BARYCAGE_TEST_ON_X(RealMapsTest);

#include "real_maps_test.moc"
