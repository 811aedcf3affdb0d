// SPDX-License-Identifier: MIT
#include "canvas/geometry/polygon_drag.h"
#include "canvas/items/cage_item.h"
#include "canvas/items/map_frames_item.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_handles.h"
#include "support/named_test.h"
#include "view/canvas/canvas_fixture.h"

#include <QSignalSpy>

namespace {

struct Calls {
    int results = 0;    // of a drag: where the points go
    int layouts = 0;    // of the cage
    int frames = 0;     // of the maps, laid out
    int placements = 0; // made to find where maps are
};
Calls calls;

} // namespace

// The linker leads every call between object files through these (--wrap, in CMakeLists.txt). A name that no
// longer exists fails to link.
#define BARYCAGE_WRAPPED(result, name, symbol, ...)                                                          \
    result real_##name(__VA_ARGS__) __asm__("__real_" symbol);                                               \
    result counted_##name(__VA_ARGS__) __asm__("__wrap_" symbol);                                            \
    result counted_##name(__VA_ARGS__)

#define BARYCAGE_VECTOR "N5Eigen6MatrixIdLi2ELi1ELi0ELi2ELi1EEE"

BARYCAGE_WRAPPED(view::DragResult, dragged,
                 "_ZN4view7draggedERKNS_11PolygonDragERK" BARYCAGE_VECTOR
                 "NS_10ConstraintERKNS_11SnapTargetsE",
                 const view::PolygonDrag& drag, const Vector<2>& offset, view::Constraint constraint,
                 const view::SnapTargets& targets) {
    ++calls.results;
    return real_dragged(drag, offset, constraint, targets);
}

BARYCAGE_WRAPPED(view::DragResult, moved, "_ZN4view5movedERKNS_11PolygonDragERK" BARYCAGE_VECTOR,
                 const view::PolygonDrag& drag, const Vector<2>& offset) {
    ++calls.results;
    return real_moved(drag, offset);
}

BARYCAGE_WRAPPED(void, setPolygon, "_ZN4view8CageItem10setPolygonERK9QPolygonF", view::CageItem* item,
                 const QPolygonF& polygon) {
    ++calls.layouts;
    real_setPolygon(item, polygon);
}

BARYCAGE_WRAPPED(void, setFrames,
                 "_ZN4view13MapFramesItem9setFramesESt6vectorINS_8MapFrameESaIS2_EENS0_4ModeE",
                 view::MapFramesItem* item, std::vector<view::MapFrame> frames,
                 view::MapFramesItem::Mode mode) {
    ++calls.frames;
    real_setFrames(item, std::move(frames), mode);
}

BARYCAGE_WRAPPED(ifs::Placement, placement, "_ZN8document9placementERKNS_7FractalE",
                 const document::Fractal& fractal) {
    ++calls.placements;
    return real_placement(fractal);
}

// One move of the pointer in the middle of a drag computes each thing once.
class DragCostTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void aMoveComputesEachThingOnce_data() {
        QTest::addColumn<CanvasView::Tool>("tool");
        QTest::addColumn<CanvasPart>("part");
        QTest::addColumn<bool>("ownPivot");
        QTest::addColumn<int>("placements");
        using Tool = CanvasView::Tool;
        QTest::newRow("vertex") << Tool::Cage << CanvasPart{Kind::Vertex, 1} << false << 0;
        QTest::newRow("edge") << Tool::Cage << CanvasPart{Kind::Edge, 0} << false << 0;
        QTest::newRow("knob") << Tool::Cage << CanvasPart{Kind::Rotate, 0} << false << 0;
        QTest::newRow("cage and pivot") << Tool::Cage << CanvasPart{Kind::Inside, 0} << true << 0;
        QTest::newRow("corner of a map") << Tool::Maps << CanvasPart{Kind::Vertex, 0, 1} << false << 1;
        QTest::newRow("map") << Tool::Maps << CanvasPart{Kind::Inside, 0, 1} << false << 1;
    }

    void aMoveComputesEachThingOnce() {
        QFETCH(CanvasView::Tool, tool);
        QFETCH(CanvasPart, part);
        QFETCH(bool, ownPivot);
        QFETCH(int, placements);
        m_canvas->setTool(tool);
        if (ownPivot) drag(at({Kind::Pivot, 0}), {30, 12});
        QPointF start = at(part);
        if (part.kind == Kind::Inside) start = start * 0.6 + at({Kind::Vertex, 2, part.map}) * 0.4;
        QCOMPARE(scene().partAt(start, view::Reach::Mouse), part);
        press(start);
        move(start + QPointF(6, 4));
        QSignalSpy changes(m_document.get(), &Document::changed);
        calls = {};
        move(start + QPointF(11, 9));
        QCOMPARE(changes.size(), 1);
        QCOMPARE(calls.results, 1);
        QCOMPARE(calls.layouts, 1);
        QCOMPARE(calls.frames, 1);
        QCOMPARE(calls.placements, placements);
        release(start + QPointF(11, 9));
        QCOMPARE(steps(), 1);
    }

    // Where the map is shown that the pointer is at in the table, it must be known where it is.
    void hintsAreMadeOnce() {
        m_canvas->pointAt(system().maps[0].id);
        const QPointF start = at({Kind::Vertex, 1});
        press(start);
        move(start + QPointF(6, 4));
        calls = {};
        move(start + QPointF(11, 9));
        QCOMPARE(calls.placements, 1);
        QCOMPARE(calls.frames, 1);
        release(start + QPointF(11, 9));
    }

    void anArrowKeyComputesEachThingOnce() {
        m_canvas->setTool(CanvasView::Tool::Maps);
        key(Qt::Key_Tab);
        QTest::keyPress(m_canvas.get(), Qt::Key_Right);
        QSignalSpy changes(m_document.get(), &Document::changed);
        calls = {};
        QTest::keyPress(m_canvas.get(), Qt::Key_Right);
        QCOMPARE(changes.size(), 1);
        QCOMPARE(calls.results, 1);
        QCOMPARE(calls.layouts, 1);
        QCOMPARE(calls.placements, 1);
        QTest::keyRelease(m_canvas.get(), Qt::Key_Right);
        QCOMPARE(steps(), 1);
    }
};

BARYCAGE_TEST(DragCostTest, QApplication);
#include "drag_cost_test.moc"
