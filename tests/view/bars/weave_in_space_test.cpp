// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "bridges/render_bridge.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/maps/space_map_handles.h"
#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace space_window;

namespace {

// The window into space beside the canvas that it takes its tool from.
struct Weaving : Window {
    view::RenderBridge render{&document};
    view::CanvasView canvas{&document, &render};
    view::BranchBar bar{&document, &canvas};

    explicit Weaving(const document::Fractal& fractal = cubeOfEight()) : Window(fractal) {
        bar.setSpace(view.get(), QStringLiteral("Click a corner"));
        view->setTarget(view::SpaceView::Target::Maps);
        canvas.setTool(view::CanvasView::Tool::Maps);
        bar.show();
    }
    const document::System3& system() const { return *document::system3(document.fractal()); }
    // Pulled with the mouse, so that it stays until it is let go.
    void pull(int degrees) const {
        bar.swing()->setSliderDown(true);
        bar.swing()->setValue(degrees);
    }
    void letGo() const { bar.swing()->setSliderDown(false); }
};

} // namespace

// The held map swings about its root, as it is seen, in one step.
class WeaveInSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void theHeldMapSwingsAboutTheLineOfSight() {
        Weaving window;
        QVERIFY(window.bar.swing()->isEnabled());
        const document::Fractal before = window.document.fractal();
        window.view->holdMap(6);
        const auto& camera = window.camera();
        const ifs::Vector<3> root = *document::rootInSpace(before, ifs::Vector<3>::UnitY());
        const ifs::Vector<3> pivot = document::system3(before)->maps[6].map(root);
        const ifs::Vector<3> tip = document::system3(before)->maps[6].map(root + ifs::Vector<3>(0, 1, 0));
        const auto seen = [&](const ifs::Vector<3>& point) { return toScreen(camera, point); };
        window.pull(10);
        QCOMPARE(window.bar.swing()->value(), 10);
        const ifs::AffineMap<3> swung = window.system().maps[6].map;
        QVERIFY((swung(root) - pivot).norm() < 1e-12);
        // What it moves keeps its distance from the eye, and turns by so much, counter-clockwise.
        const ifs::Vector<3> moved = swung(root + ifs::Vector<3>(0, 1, 0));
        QVERIFY(std::abs(seen(moved).depth - seen(tip).depth) < 1e-12);
        const auto inView = [&](const ifs::Vector<3>& way) {
            return ifs::Vector<3>(camera.orientation.conjugate() * way);
        };
        const ifs::Vector<3> was = inView(tip - pivot), is = inView(moved - pivot);
        const double turned = std::atan2(is.y(), is.x()) - std::atan2(was.y(), was.x());
        QVERIFY(std::abs(turned - 10 * std::numbers::pi / 180) < 1e-9);
        window.pull(4); // counted from the middle
        window.pull(10);
        QVERIFY((window.system().maps[6].map.linear - swung.linear).norm() < 1e-12);
        QCOMPARE(window.document.undoStack()->count(), 0);
        window.letGo();
        QCOMPARE(window.document.undoStack()->count(), 1);
        QCOMPARE(window.bar.swing()->value(), 0);
        for (std::size_t i = 0; i < 8; ++i)
            QCOMPARE(window.system().maps[i].map == document::system3(before)->maps[i].map, i != 6);
        window.document.undoStack()->undo();
        QVERIFY(window.document.fractal() == before);
    }

    // Each about its own root, but for those that are locked.
    void allSelectedMapsSwing() {
        document::Fractal fractal = cubeOfEight();
        const auto idOf = [&](std::size_t index) { return document::system3(fractal)->maps[index].id; };
        auto label = fractal.mapLabels.of(idOf(1));
        label.isLocked = true;
        fractal.mapLabels.set(idOf(1), label);
        Weaving window(fractal);
        window.view->holdMap(6, {idOf(6), idOf(1), idOf(3)});
        QCOMPARE(window.view->selectedMaps(), (std::vector<std::size_t>{1, 3, 6}));
        const ifs::Vector<3> root = *document::rootInSpace(fractal, ifs::Vector<3>::UnitY());
        window.pull(10);
        QCOMPARE(window.bar.swing()->value(), 10);
        window.letGo();
        QCOMPARE(window.document.undoStack()->count(), 1);
        for (std::size_t i = 0; i < 8; ++i) {
            const auto& was = document::system3(fractal)->maps[i].map;
            QCOMPARE(window.system().maps[i].map == was, i != 3 && i != 6);
            QVERIFY((window.system().maps[i].map(root) - was(root)).norm() < 1e-12);
        }
        window.document.undoStack()->undo();
        QVERIFY(window.document.fractal() == fractal);
        // Another selection ends the swing of the one before.
        window.pull(5);
        window.view->holdMap(6, {idOf(6)});
        QCOMPARE(window.document.undoStack()->count(), 1);
        QCOMPARE(window.bar.swing()->value(), 0);
        window.letGo();
        window.document.undoStack()->undo();
        // Only locked ones: that is said.
        QSignalSpy said(&window.canvas, &view::CanvasView::message);
        window.view->holdMap(1);
        window.pull(10);
        QVERIFY(!said.isEmpty() && said.last().first().toString().contains(QStringLiteral("locked")));
        QVERIFY(window.document.fractal() == fractal);
        window.letGo();
    }

    // As every drag does.
    void escapeBringsTheMapBack() {
        Weaving window;
        const document::Fractal before = window.document.fractal();
        window.view->holdMap(6);
        window.pull(10);
        QVERIFY(!(window.document.fractal() == before));
        QTest::keyClick(window.bar.swing(), Qt::Key_Escape);
        QVERIFY(window.document.fractal() == before);
        QCOMPARE(window.bar.swing()->value(), 0);
        window.pull(20); // the mouse goes on
        QVERIFY(window.document.fractal() == before);
        window.letGo();
        QCOMPARE(window.document.undoStack()->count(), 0);
        window.pull(5);
        window.letGo();
        QCOMPARE(window.document.undoStack()->count(), 1);
    }

    // A shear that contracts only when it comes several times: turned, it does no more.
    void itStopsWhereTheAttractorWouldBeLost() {
        document::Fractal sheared;
        document::Shape<3> shape;
        ifs::AffineMap<3> map{0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>::Zero()};
        map.linear(0, 1) = 2;
        ifs::append<3>(shape.system, map);
        ifs::append<3>(shape.system, {0.3 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(1, 0, 0)});
        ifs::append<3>(shape.system, {0.3 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(0, 0, 1)});
        sheared.shape = shape;
        Weaving window(sheared);
        window.view->navigation().lookFrom(view::directions::front);
        QTRY_VERIFY((window.camera().orientation * ifs::Vector<3>::UnitZ() - ifs::Vector<3>::UnitZ()).norm() <
                    1e-9);
        QSignalSpy said(&window.canvas, &view::CanvasView::message);
        window.pull(60);
        const int reached = window.bar.swing()->value();
        // As in the plane, 7.5° is where the spectral radius comes to 1.
        QVERIFY2(reached < 8, qPrintable(QString::number(reached)));
        QVERIFY(!said.isEmpty() && said.last().first().toString().startsWith(QStringLiteral("Stopped")));
        window.letGo();
        window.canvas.tools().setAllowsNoAttractor(true);
        window.pull(60);
        QCOMPARE(window.bar.swing()->value(), 60);
        window.letGo();
    }

    // Where the cage bends, it swings as it is seen, to first order.
    void itSwingsWhereTheCageBends() {
        Weaving window;
        document::Fractal bent =
            *document::withPolyhedronFitted(window.document.fractal(), document::SpacePolyhedron::Box);
        document::space(bent)->cage->current[7] += ifs::Vector<3>(0.2, 0.3, 0.1);
        window.document.edit(QStringLiteral("Bend"), bent);
        QVERIFY(ifs::bends(*document::space(window.document.fractal())->cage));
        window.view->holdMap(6);
        const auto before = ifs::mapsOf(window.system());
        window.pull(2);
        const auto after = ifs::mapsOf(window.system());
        QVERIFY(after[6] != before[6]);
        const ifs::CageDeformation bend(document::space(bent)->cage->rest,
                                        document::space(bent)->cage->current);
        const ifs::Vector<3> root = *document::rootInSpace(bent, ifs::Vector<3>::UnitY());
        QVERIFY((bend(after[6](root)) - bend(before[6](root))).norm() < 0.02); // about its root
        QVERIFY((after[6].linear - before[6].linear).norm() > 0.01);
        window.letGo();
    }

    // Branches that a file shows elsewhere go back, one or all.
    void movedBranchesArePutBack() {
        document::Fractal moved = cubeOfEight();
        const auto& maps = document::system3(moved)->maps;
        ifs::AffineMap<3> change;
        change.translation = {0.5, 1, 0};
        document::space(moved)->moved = {{{maps[3].id}, change}, {{maps[3].id, maps[5].id}, change}};
        Weaving window(moved);
        window.canvas.setTool(view::CanvasView::Tool::Branch);
        view::BranchChoice& choice = window.canvas.tools().branchTool().choice();
        QPushButton* putBack = window.bar.putBackButton();
        QVERIFY(putBack->isVisibleTo(&window.bar));
        choice.choose({3, 5, 1});
        QVERIFY(document::isMoved(window.document.fractal(), choice.branch()));
        putBack->click();
        QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Put branch 4 6 back"));
        QCOMPARE(document::space(window.document.fractal())->moved.size(), std::size_t(1));
        QVERIFY(putBack->isVisibleTo(&window.bar));
        putBack->click();
        QVERIFY(window.document.fractal() == cubeOfEight());
        QVERIFY(!putBack->isVisibleTo(&window.bar));
        window.document.undoStack()->undo();
        window.document.undoStack()->undo();
        QVERIFY(window.document.fractal() == moved);
    }

    void aFlatCageIsSaid() {
        Weaving window;
        document::Fractal flat = window.document.fractal();
        auto cage = *document::spaceCage(flat);
        for (ifs::Vector<3>& vertex : cage.current)
            vertex.z() = 0;
        flat = document::withCageMoved(flat, cage, document::CageMode::Place);
        window.document.edit(QStringLiteral("Squeeze"), flat);
        QSignalSpy said(&window.canvas, &view::CanvasView::message);
        window.pull(10);
        QVERIFY(!said.isEmpty() && said.last().first().toString().contains(QStringLiteral("flat")));
        QCOMPARE(window.bar.swing()->value(), 0);
        QVERIFY(window.document.fractal() == flat);
    }
};

BARYCAGE_TEST(WeaveInSpaceTest, QApplication);
#include "weave_in_space_test.moc"
